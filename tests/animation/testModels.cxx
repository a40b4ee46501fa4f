// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every model of Debian's assimp-testmodels that has bones or moves: bones that do nothing leave it
// as it is, and at 100 times of every animation its points are where an evaluation in double,
// straight from Assimp's structures, has them.
#include "AssimpPose.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>
#include <vtkRelievoSkin.h>

#include <assimp/Importer.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>

namespace testModels
{
namespace
{
using namespace relievoTest;

// Files that tools/unpack-data writes, but for glTF, of which tests/gltf takes care.
constexpr std::size_t NumberOfModels = 58;

// Files that Assimp 5.2.5 refuses: a number that begins with a space, Irrlicht's XML in two bytes
// per character, a changed binary format, animations and textures in other files.
const std::set<std::string> Refused = { "library_animation_clips.dae", "animMesh.irr",
  "multipleAnimators.irr", "scenegraphAnim.irr", "WusonBlitz2.m3d", "man01.mdl", "manT.mdl" };

// The numbers of a scene's animations, or -1 without any.
std::vector<int> AnimationsOf(const aiScene* scene)
{
  std::vector<int> animations;
  for (unsigned int i = 0; i < scene->mNumAnimations; ++i)
  {
    animations.push_back(static_cast<int>(i));
  }
  return animations.empty() ? std::vector<int>{ -1 } : animations;
}

std::vector<vtkPolyData*> MeshesOf(vtkRelievoModelReader* reader)
{
  std::vector<vtkPolyData*> meshes;
  for (unsigned int i = 0; i < reader->GetOutput()->GetNumberOfBlocks(); ++i)
  {
    meshes.push_back(vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(i)));
  }
  return meshes;
}

double SizeOf(const std::vector<std::vector<glm::dvec3>>& meshes)
{
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const std::vector<glm::dvec3>& points : meshes)
  {
    for (const glm::dvec3& p : points)
    {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  return glm::length(high - low);
}

// Largest distance of the reader's points from the truth, in sizes of the model.
double Compare(
  vtkRelievoModelReader* reader, const std::vector<std::vector<glm::dvec3>>& truth, double size)
{
  const std::vector<vtkPolyData*> meshes = MeshesOf(reader);
  if (!RELIEVO_CHECK(meshes.size() == truth.size()))
  {
    return 1e300;
  }
  double off = 0.;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    if (!RELIEVO_CHECK(static_cast<std::size_t>(meshes[i]->GetNumberOfPoints()) == truth[i].size()))
    {
      return 1e300;
    }
    for (std::size_t j = 0; j < truth[i].size(); ++j)
    {
      double p[3];
      meshes[i]->GetPoint(static_cast<vtkIdType>(j), p);
      off = Larger(off, glm::length(glm::dvec3(p[0], p[1], p[2]) - truth[i][j]));
    }
  }
  return off / std::max(size, 1e-30); // one of the models is a single point
}

// The least and the largest time of any key: before the one and after the other nothing moves.
void FindEnds(const aiAnimation* animation, double& first, double& last)
{
  first = 1e300;
  last = animation->mDuration;
  const auto take = [&](double time) {
    first = std::min(first, time);
    last = std::max(last, time);
  };
  for (unsigned int i = 0; i < animation->mNumChannels; ++i)
  {
    const aiNodeAnim* c = animation->mChannels[i];
    std::for_each(c->mPositionKeys, c->mPositionKeys + c->mNumPositionKeys,
      [&](const aiVectorKey& key) { take(key.mTime); });
    std::for_each(c->mRotationKeys, c->mRotationKeys + c->mNumRotationKeys,
      [&](const aiQuatKey& key) { take(key.mTime); });
    std::for_each(c->mScalingKeys, c->mScalingKeys + c->mNumScalingKeys,
      [&](const aiVectorKey& key) { take(key.mTime); });
  }
}

void TestPose(vtkRelievoModelReader* reader, const aiScene* scene, const std::string& name)
{
  const double size = SizeOf(PosedPoints(scene, nullptr, 0.));
  reader->SetPose(vtkRelievoModelReader::POSE_NODES);
  reader->Update();
  double off = Compare(reader, PosedPoints(scene, nullptr, 0.), size);
  RELIEVO_CHECK_AT_MOST(off, 1e-5, name + ": nodes at rest");
  reader->SetPose(vtkRelievoModelReader::POSE_ANIMATION);
  int played = 0;
  for (const int which : AnimationsOf(scene))
  {
    const aiAnimation* animation = which < 0 ? nullptr : scene->mAnimations[which];
    double first = 0.;
    double last = 0.;
    if (animation)
    {
      FindEnds(animation, first, last);
    }
    if (!animation || first == 1e300)
    {
      continue; // nothing of it moves nodes
    }
    reader->SetAnimation(reader->GetAnimationName(played++));
    const double ticks = animation->mTicksPerSecond > 0. ? animation->mTicksPerSecond : 25.;
    off = 0.;
    for (int i = 0; i < 100; ++i)
    {
      // From a little before the first key to a little after the last, and at whole keys.
      const double at = i % 4 == 0 ? std::round(first + (last - first) * i / 99.)
                                   : first + (last - first) * (1.02 * i / 99. - 0.01);
      reader->UpdateTimeStep(at / ticks);
      const double held = std::clamp(at, first, last);
      off = Larger(off, Compare(reader, PosedPoints(scene, animation, held), size));
    }
    RELIEVO_CHECK_AT_MOST(
      off, 1e-5, name + ": '" + reader->GetAnimation() + "' at 100 times, of its size");
  }
  RELIEVO_CHECK(played == reader->GetNumberOfAnimations());
}

// Bones put where their offsets come from leave the mesh as it is, by every method.
void TestIdentity(vtkRelievoModelReader* reader, const std::string& name)
{
  reader->SetPose(vtkRelievoModelReader::POSE_REST);
  reader->Update();
  double off = 0.;
  for (vtkPolyData* mesh : MeshesOf(reader))
  {
    vtkDataArray* offsets = mesh->GetFieldData()->GetArray("bone_offset");
    vtkNew<vtkPolyData> rest;
    rest->ShallowCopy(mesh);
    vtkNew<vtkIntArray> nodes;
    nodes->SetName("bone_node");
    vtkSmartPointer<vtkDataArray> pose;
    pose.TakeReference(offsets->NewInstance());
    pose->SetName("pose");
    pose->SetNumberOfComponents(16);
    for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
    {
      glm::dmat4 m;
      for (int j = 0; j < 16; ++j)
      {
        m[j % 4][j / 4] = offsets->GetComponent(i, j);
      }
      m = glm::inverse(m);
      double rows[16];
      for (int j = 0; j < 16; ++j)
      {
        rows[j] = m[j % 4][j / 4];
      }
      pose->InsertNextTuple(rows);
      nodes->InsertNextValue(static_cast<int>(i));
    }
    rest->GetFieldData()->AddArray(nodes); // a node for each bone
    vtkNew<vtkPolyData> skeleton;
    skeleton->GetPointData()->AddArray(pose);
    double box[6];
    mesh->GetBounds(box);
    double size = 0.;
    for (int i = 0; i < 3; ++i)
    {
      size = std::max(
        { size, box[2 * i + 1] - box[2 * i], std::abs(box[2 * i]), std::abs(box[2 * i + 1]) });
    }
    for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
    {
      vtkNew<vtkRelievoSkin> skin;
      skin->SetInputData(0, rest);
      skin->SetInputData(1, skeleton);
      skin->SetMethod(method);
      skin->Update();
      RELIEVO_CHECK(skin->GetOutput()->GetNumberOfPoints() == mesh->GetNumberOfPoints());
      for (vtkIdType i = 0; i < skin->GetOutput()->GetNumberOfPoints(); ++i)
      {
        double p[3];
        double q[3];
        mesh->GetPoint(i, p);
        skin->GetOutput()->GetPoint(i, q);
        off =
          Larger(off, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / std::max(size, 1e-30));
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(off, 1e-6, name + ": bind pose against the rest mesh, of its size");
}

void TestModel(const std::filesystem::path& path)
{
  const std::string name = path.filename().string();
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), AssimpSteps);
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(path.string().c_str());
  reader->SetWeightsPerPoint(8);
  if (!scene || !scene->mRootNode || (scene->mNumMeshes == 0 && scene->mNumAnimations == 0))
  {
    // Says why not.
    const ExpectMessage expect(name);
    reader->Update();
    std::cout << name << ": refused\n";
    RELIEVO_CHECK_THAT(Refused.count(name) == 1, name + " is refused");
    RELIEVO_CHECK(expect.Count() == 1 && reader->GetErrorCode() != 0);
    RELIEVO_CHECK(reader->GetOutput()->GetNumberOfBlocks() == 0);
    return;
  }
  RELIEVO_CHECK(vtkRelievoModelReader::CanReadFile(path.string().c_str()));
  reader->Update();
  RELIEVO_CHECK(reader->GetErrorCode() == 0);
  RELIEVO_CHECK_THAT(MostBones(scene) <= 8, name + " has points with more bones than are kept");
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    std::cout << name << ": " << reader->GetNote(i) << "\n";
  }
  TestPose(reader, scene, name);
  TestIdentity(reader, name);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModels)
{
  relievoTest::Session session;
  const std::filesystem::path folder =
    std::filesystem::path(DataFile("models/BVH/01_01.bvh")).parent_path().parent_path();
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file() && entry.path().string().find("glTF2") == std::string::npos)
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  RELIEVO_CHECK_THAT(paths.size() == NumberOfModels,
    std::to_string(paths.size()) +
      " models are there, expected all that tools/unpack-data writes: " +
      std::to_string(NumberOfModels));
  for (const std::filesystem::path& path : paths)
  {
    TestModel(path);
  }
  return session.Result();
}
}
