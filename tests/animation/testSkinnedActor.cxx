// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes that the vertex shader moves, against the same moved by vtkRelievoSkin: depth, normals and
// ids, by every method; where skinning fails; colours, textures, PBR; a real model. Both sides
// compute by shaders/formulas/geometry/skin.glsl: that the formulas are right is shown by testSkin.
#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SkinnedScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyDataTangents.h>
#include <vtkProperty.h>
#include <vtkRelievoModelReader.h>
#include <vtkTriangleFilter.h>

#include <cmath>
#include <string>

namespace testSkinnedActor
{
namespace
{
using namespace relievoTest;
constexpr int Methods[] = { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION,
  vtkRelievoSkin::KEY_MATRIX };

void TestTwist()
{
  const auto tube = MakeTwoBoneTube(65, 24);
  for (const int method : Methods)
  {
    SkinnedPair pair;
    // Beyond 180 degrees the quaternions lie in opposite halves.
    for (const double degrees : { 0., 75., 150., 250. })
    {
      pair.Set(tube,
        MakeSkeleton({ glm::dmat4(1.), TurnAbout({ 1., 0., 0. }, degrees * 0.017453292519943) }),
        method);
      pair.CompareLayers(MethodName(method) + ", twisted by " + std::to_string(degrees));
    }
  }
}

// Bent, stretched, mirrored; with weights that are out of order and do not sum to 1.
void TestBent()
{
  const auto tube = MakeThreeBoneTube(41, 20);
  for (const int method : Methods)
  {
    SkinnedPair pair;
    pair.Set(tube, MakeBentPose(0.7, 1., 1.), method);
    pair.CompareLayers(MethodName(method) + ", bent");
    pair.Set(tube, MakeBentPose(0.5, 0.4, 1.), method);
    pair.CompareLayers(MethodName(method) + ", stretched");
    pair.Set(tube, MakeBentPose(0.3, 1.2, -0.8), method);
    pair.CompareLayers(MethodName(method) + ", mirrored");
  }
}

// Points of no bone, joints that are not there, weights that are negative, infinite or not numbers.
void TestOddWeights()
{
  const auto tube = MakeTube(33, 16, false);
  std::vector<int> joints;
  std::vector<float> weights;
  for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
  {
    const vtkIdType ring = i / 16;
    joints.insert(joints.end(), { 0, ring % 5 == 3 ? 77 : 1, 1 });
    weights.insert(weights.end(),
      { ring < 8 ? 0.f : 0.4f, ring < 8 ? 0.f : 0.1f * (ring % 7),
        ring % 3 == 0     ? -1.f
          : ring % 3 == 1 ? INFINITY
                          : NAN });
  }
  SetBones(tube, { glm::dmat4(1.), MoveBy({ 0.1, 0., 0. }) }, 3, joints, weights);
  for (const int method : Methods)
  {
    SkinnedPair pair;
    pair.Set(
      tube, MakeSkeleton({ MoveBy({ 0., 0., 0.1 }), TurnAbout({ 1., 0., 0. }, 0.3) }), method);
    pair.CompareLayers(MethodName(method) + ", odd weights");
  }
}

void TestChains()
{
  for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    for (const int influences : { 1, 5, 8 })
    {
      SkinnedPair pair;
      const Chain chain = MakeChain(40, 81, 16, influences);
      pair.Set(chain.Mesh, chain.Skeleton, method);
      pair.CompareLayers(MethodName(method) + ", " + std::to_string(influences) + " weights");
    }
    SkinnedPair pair;
    const Chain chain = MakeChain(1000, 401, 12, 4);
    pair.Set(chain.Mesh, chain.Skeleton, method);
    pair.CompareLayers(MethodName(method) + ", 1000 bones");
  }
}

// Colours by data, textures, PBR with a normal map, flat shading, edges.
void TestLooks()
{
  const auto rest = MakeThreeBoneTube(41, 20);
  vtkNew<vtkFloatArray> places;
  places->SetName("TextureCoordinates");
  places->SetNumberOfComponents(2);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("heights");
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    const double angle = static_cast<double>(i % 20) / 10.;
    places->InsertNextTuple2(PointOf(rest, i).x, angle > 1. ? 2. - angle : angle);
    heights->InsertNextValue(static_cast<float>(std::sin(2. * PointOf(rest, i).x)));
  }
  rest->GetPointData()->SetTCoords(places);
  rest->GetPointData()->AddArray(heights);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(rest);
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputConnection(triangles->GetOutputPort());
  tangents->Update();
  vtkPolyData* mesh = tangents->GetOutput();
  mesh->SetFieldData(rest->GetFieldData());
  const auto pose = MakeBentPose(0.7, 0.8, 1.);
  for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    SkinnedPair pair;
    pair.Set(mesh, pose, method);
    const auto both = [&pair](const auto& set) {
      set(pair.CPU);
      set(pair.GPU);
    };
    const std::string name = MethodName(method);
    pair.ComparePictures(name + ", plain", 2e-3);
    both([](SkinnedSide& side) {
      side.GetMapper()->SelectColorArray("heights");
      side.GetMapper()->SetScalarModeToUsePointFieldData();
      side.GetMapper()->SetScalarRange(-1., 1.);
    });
    pair.ComparePictures(name + ", colored by data", 2e-3);
    const auto before = Picture(pair.GPU.Stage.Window);
    both([](SkinnedSide& side) {
      side.GetMapper()->ScalarVisibilityOff();
      side.Actor->SetTexture(MakeChecker(false));
    });
    pair.ComparePictures(name + ", textured", 2e-3);
    RELIEVO_CHECK(CountUnlike(before, Picture(pair.GPU.Stage.Window), 20) > 2000);
    both([](SkinnedSide& side) { side.Actor->GetProperty()->SetInterpolationToFlat(); });
    pair.ComparePictures(name + ", flat", 2e-3);
    both([](SkinnedSide& side) {
      side.Actor->GetProperty()->EdgeVisibilityOn();
      side.Actor->GetProperty()->SetEdgeColor(1., 0., 0.);
    });
    pair.ComparePictures(name + ", edges", 4e-3);
    both([](SkinnedSide& side) {
      side.Actor->SetTexture(nullptr);
      vtkProperty* property = side.Actor->GetProperty();
      property->EdgeVisibilityOff();
      property->SetInterpolationToPBR();
      property->SetRoughness(0.4);
      property->SetMetallic(0.2);
      // Its colours as directions: far from flat.
      property->SetNormalTexture(MakeChecker(false));
    });
    pair.ComparePictures(name + ", PBR with a normal map", 2e-3);
    both([](SkinnedSide& side) { side.Actor->GetProperty()->SetNormalTexture(nullptr); });
    RELIEVO_CHECK(CountUnlike(before, Picture(pair.GPU.Stage.Window), 20) > 2000);
    pair.ComparePictures(name + ", PBR", 2e-3);
    both([](SkinnedSide& side) { side.Actor->GetProperty()->SetRepresentationToWireframe(); });
    pair.ComparePictures(name + ", wireframe", 4e-3);
  }
}

// A model of assimp-testmodels, whose mesh is uploaded once while the reader plays.
void TestModel()
{
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(DataFile("models/X/BCN_Epileptic.X").c_str());
  reader->SetPose(vtkRelievoModelReader::POSE_REST);
  reader->Update();
  vtkSmartPointer<vtkPolyData> mesh;
  for (unsigned int i = 0; i < reader->GetOutput()->GetNumberOfBlocks(); ++i)
  {
    auto* block = vtkPolyData::SafeDownCast(reader->GetOutput()->GetBlock(i));
    if (!mesh || block->GetNumberOfPoints() > mesh->GetNumberOfPoints())
    {
      mesh = block;
    }
  }
  RELIEVO_CHECK(mesh != nullptr);
  SkinnedPair pair;
  vtkSmartPointer<vtkImageData> before;
  for (const double time : { 0., 2.3, 4.1 })
  {
    reader->UpdateTimeStep(time);
    vtkNew<vtkPolyData> skeleton;
    skeleton->DeepCopy(reader->GetOutputDataObject(1));
    pair.Set(mesh, skeleton, vtkRelievoSkin::DUAL_QUATERNION);
    // Users connect the reader once, and its skeleton changes with time.
    pair.GPU.Skinned->SetSkeletonConnection(reader->GetOutputPort(1));
    pair.CompareLayers("a model at " + std::to_string(time));
    const auto now = Picture(pair.GPU.Stage.Window);
    RELIEVO_CHECK(!before || CountUnlike(before, now, 20) > 200);
    before = now;
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinnedActor)
{
  relievoTest::Session session;
  TestTwist();
  TestBent();
  TestOddWeights();
  TestChains();
  TestLooks();
  TestModel();
  return session.Result();
}
}
