// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Unusual rigs: a bone with two meshes from different places, bones without points, mirroring keys,
// missing textures; the bind pose; and a voxel shell of the moved mesh.
#include "Check.h"
#include "ModelScenes.h"
#include "Session.h"
#include "SkinScenes.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>
#include <vtkRelievoSkin.h>
#include <vtkRelievoVoxelShell.h>
#include <vtkStringArray.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testModelRigs
{
namespace
{
using namespace relievoTest;

vtkPolyData* BlockOf(vtkRelievoModelReader* reader, unsigned int block)
{
  return vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(block));
}

void CheckPoint(vtkPolyData* mesh, vtkIdType i, const glm::dvec3& expected, const std::string& what)
{
  const glm::dvec3 p = PointOf(mesh, i);
  RELIEVO_CHECK_AT_MOST(glm::distance(p, expected), 1e-5, what);
}

// A second mesh like the first, bound to the same bone 3 further along x.
void TestSharedBone()
{
  const auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  const auto other = MakeScene({ { 0., AboutZ(0.) } });
  aiMesh* meshes[2] = { scene->mMeshes[0], other->mMeshes[0] };
  other->mMeshes[0] = nullptr;
  other->mNumMeshes = 0;
  meshes[1]->mName = "other";
  meshes[1]->mBones[0]->mOffsetMatrix.a4 = -3.f;
  delete[] scene->mMeshes;
  scene->mNumMeshes = 2;
  scene->mMeshes = new aiMesh* [2] { meshes[0], meshes[1] };
  aiNode* body = scene->mRootNode->mChildren[0];
  delete[] body->mMeshes;
  body->mNumMeshes = 2;
  body->mMeshes = new unsigned int[2]{ 0, 1 };
  const auto reader = Read(*scene, "shared");
  reader->UpdateTimeStep(1.);
  if (RELIEVO_CHECK(reader->GetOutput()->GetNumberOfBlocks() == 2))
  {
    // (1, 0, 0) and (1 - 3, 0, 0), turned by 90 degrees.
    CheckPoint(BlockOf(reader, 0), 0, { 0., 1., 0. }, "the first mesh of a shared bone");
    CheckPoint(BlockOf(reader, 1), 0, { 0., -2., 0. }, "the second, with another offset");
  }
}

// Bones that hold no point change nothing, wherever they stand in the list.
void TestIdleBones()
{
  const auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  aiMesh* mesh = scene->mMeshes[0];
  aiBone* arm = mesh->mBones[0];
  delete[] mesh->mBones;
  mesh->mNumBones = 3;
  mesh->mBones = new aiBone* [3] { new aiBone, arm, new aiBone };
  mesh->mBones[0]->mName = "root";
  mesh->mBones[2]->mName = "body";
  const auto reader = Read(*scene, "idle");
  reader->UpdateTimeStep(1.);
  CheckPoint(MeshOf(reader), 0, { 0., 1., 0. }, "beside bones without points");
  reader->SetMethod(vtkRelievoSkin::DUAL_QUATERNION);
  reader->UpdateTimeStep(1.);
  CheckPoint(MeshOf(reader), 0, { 0., 1., 0. }, "the same by dual quaternions");
}

// Keys of a scale mirror, and pass through 0 on the way.
void TestMirroringKeys()
{
  const auto scene = MakeScene({ { 0., AboutZ(90.) } });
  aiNodeAnim* channel = scene->mAnimations[0]->mChannels[0];
  delete[] channel->mScalingKeys;
  channel->mNumScalingKeys = 2;
  channel->mScalingKeys = new aiVectorKey[2]{ aiVectorKey(0., aiVector3D(1.f, 1.f, 1.f)),
    aiVectorKey(10., aiVector3D(-2.f, 1.f, 3.f)) };
  scene->mAnimations[0]->mDuration = 10.;
  const auto reader = Read(*scene, "mirror");
  for (const int method : { 0, 1, 2 })
  {
    reader->SetMethod(method);
    for (const double time : { 0., 1. / 3., 0.5, 1. })
    {
      reader->UpdateTimeStep(time);
      const double along = 1. - 3. * time;
      const double up = 1. + 2. * time;
      const std::string what = "mirrored, method " + std::to_string(method);
      CheckPoint(MeshOf(reader), 0, { 0., along, 0. }, what);
      CheckPoint(MeshOf(reader), 2, { 0., 2. * along, up }, what);
    }
  }
}

// The reader gives the name; code that draws the texture reports a missing file.
void TestNoTexture()
{
  const auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  const aiString path("nowhere/skin.png");
  scene->mMaterials[0]->AddProperty(&path, AI_MATKEY_TEXTURE_DIFFUSE(0));
  const auto reader = Read(*scene, "textured");
  RELIEVO_CHECK(reader->GetErrorCode() == 0);
  auto* names = vtkStringArray::SafeDownCast(
    MeshOf(reader)->GetFieldData()->GetAbstractArray("base_color_texture"));
  RELIEVO_CHECK(names && names->GetValue(0) == "nowhere/skin.png");
}

// The skeleton of the bind pose moves no mesh.
void TestBind(const std::string& name)
{
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(DataFile("models/" + name).c_str());
  reader->SetPose(vtkRelievoModelReader::POSE_BIND);
  reader->UpdateTimeStep(0.7);
  auto* skeleton = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1));
  double off = 0.;
  double size = 0.;
  vtkIdType count = 0;
  for (unsigned int block = 0; block < reader->GetOutput()->GetNumberOfBlocks(); ++block)
  {
    vtkPolyData* rest = BlockOf(reader, block);
    double b[6];
    rest->GetBounds(b);
    size = std::max({ size, b[1] - b[0], b[3] - b[2], b[5] - b[4] });
    for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
    {
      const auto moved = Skin(rest, skeleton, method);
      RELIEVO_CHECK(moved->GetNumberOfPoints() == rest->GetNumberOfPoints());
      for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
      {
        off = Larger(off, glm::distance(PointOf(moved, i), PointOf(rest, i)));
      }
      count += moved->GetNumberOfPoints();
    }
  }
  RELIEVO_CHECK(count > 100);
  RELIEVO_CHECK_AT_MOST(off / size, 2e-6, name + ": the bind pose's skeleton, of the size");
}

// A cube of 4 cells a side, moved by whole cells: the shell's cells are those, moved.
void TestVoxels()
{
  vtkNew<vtkPolyData> cube;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(4. * (i & 1), 2. * (i & 2), i & 4);
  }
  const vtkIdType quads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  for (const auto& quad : quads)
  {
    faces->InsertNextCell(4, quad);
  }
  cube->SetPoints(points);
  cube->SetPolys(faces);
  SetBones(cube, { glm::dmat4(1.) }, 1, std::vector<int>(8, 0), std::vector<float>(8, 1.f));
  vtkNew<vtkRelievoSkin> skin;
  skin->SetInputData(0, cube);
  vtkNew<vtkRelievoVoxelShell> shell;
  shell->SetInputConnection(skin->GetOutputPort());
  shell->SetBounds(-0.5, 19.5, -0.5, 9.5, -0.5, 9.5);
  shell->SetDimensions(20, 10, 10);
  glm::dmat4 wide(1.);
  wide[0][0] = 2.;
  const struct
  {
    glm::dmat4 Bone;
    vtkIdType Cells;
  } poses[] = { { glm::dmat4(1.), 64 }, { MoveBy({ 14., 4., 4. }), 64 },
    { MoveBy({ 0.25, 0., 0. }) * wide, 128 }, { MoveBy({ 100., 0., 0. }), 0 } };
  for (const auto& pose : poses)
  {
    // Half a cell beside the cells' middles, which lie on whole numbers.
    skin->SetInputData(1, MakeSkeleton({ MoveBy({ 0.5, 0.5, 0.5 }) * pose.Bone }));
    shell->Update();
    RELIEVO_CHECK_NEAR(static_cast<double>(shell->GetNumberOfCellsInside()),
      static_cast<double>(pose.Cells), 0., "cells inside the moved cube");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelRigs)
{
  relievoTest::Session session;
  TestSharedBone();
  TestIdleBones();
  TestMirroringKeys();
  TestNoTexture();
  TestBind("X/Testwuson.X");
  TestBind("FBX/huesitos.fbx");
  TestVoxels();
  return session.Result();
}
}
