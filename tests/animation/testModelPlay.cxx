// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two animations blended, and the inspection of a model.
#include "Check.h"
#include "ModelScenes.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>
#include <vtkRelievoSkin.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace testModelPlay
{
namespace
{
using namespace relievoTest;
constexpr double Pi = 3.14159265358979323846;

// One on the way to the other, by weight; the times of both.
void TestBlend()
{
  const auto reader = Read(*MakeTwo(), "blend");
  reader->SetBlendAnimation("turn 2");
  for (const double weight : { 0., 0.25, 0.4, 1. })
  {
    reader->SetBlendWeight(weight);
    for (const int method : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
    {
      reader->SetMethod(method);
      RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 45. + weight * (-30. - 45.), 1e-4, "blended");
      RELIEVO_CHECK_NEAR(AngleAt(reader, 9.), 90. + weight * (-30. - 90.), 1e-4, "after the end");
    }
  }
  reader->SetBlendWeight(0.4);
  // Between whole keys, at 0 and 1 second; from 0 to 90 the blend goes from -12 to 42.
  reader->SetMethod(vtkRelievoSkin::KEY_MATRIX);
  reader->UpdateTimeStep(0.5);
  double p[3];
  MeshOf(reader)->GetPoint(0, p);
  const auto mean = [](double (*part)(double)) {
    return 0.5 * (part(-12. * Pi / 180.) + part(42. * Pi / 180.));
  };
  RELIEVO_CHECK_NEAR(p[0], mean(std::cos), 1e-6, "blended keys, x");
  RELIEVO_CHECK_NEAR(p[1], mean(std::sin), 1e-6, "blended keys, y");
  reader->SetMethod(vtkRelievoSkin::LINEAR);
  reader->SetBlendAnimation("run");
  const ExpectMessage expect("no animation 'run'");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 45., 1e-4, "one that is not there: the first alone");
  AngleAt(reader, 0.7);
  RELIEVO_CHECK(expect.Count() == 1);
}

// Two channels of one node, one rotating and one moving it, are composed, blended or not. Assimp
// gives a channel a key of each kind, so parts that should not move have a refused one.
void TestTwoChannels()
{
  const auto scene = MakeTwo();
  aiAnimation* animation = scene->mAnimations[0];
  aiNodeAnim* turn = animation->mChannels[0];
  aiNodeAnim* move = MakeChannel("arm", { { 0., aiQuaternion(0.f, 0.f, 0.f, 0.f) } });
  const float none = std::numeric_limits<float>::quiet_NaN();
  turn->mPositionKeys[0].mValue.x = none;
  move->mScalingKeys[0].mValue.x = none;
  delete[] move->mPositionKeys;
  move->mNumPositionKeys = 2;
  move->mPositionKeys = new aiVectorKey[2]{ aiVectorKey(0., aiVector3D(0.f, 0.f, 0.f)),
    aiVectorKey(10., aiVector3D(0.f, 0.f, 4.f)) };
  delete[] animation->mChannels;
  animation->mNumChannels = 2;
  animation->mChannels = new aiNodeAnim* [2] { turn, move };
  const auto reader = Read(*scene, "channels");
  for (const double weight : { -1., 0., 0.5 })
  {
    reader->SetBlendAnimation(weight < 0. ? "" : "turn 2");
    reader->SetBlendWeight(weight);
    reader->UpdateTimeStep(0.5);
    double p[3];
    MeshOf(reader)->GetPoint(0, p);
    const double share = std::max(0., weight);
    const double angle = (45. + share * (-30. - 45.)) * Pi / 180.;
    RELIEVO_CHECK_NEAR(p[0], std::cos(angle), 1e-5, "turned by one channel");
    RELIEVO_CHECK_NEAR(p[2], 2. * (1. - share), 1e-5, "moved by the other");
  }
}

// Whole keys at a rate: the end is one, and keys of the first beyond an end of the second wrap or
// hold as the second does.
void TestWholeKeys()
{
  const auto at = [](vtkRelievoModelReader* reader, double time) {
    reader->UpdateTimeStep(time);
    double p[3];
    MeshOf(reader)->GetPoint(0, p);
    return std::vector<double>{ p[0], p[1] };
  };
  const auto check = [&](vtkRelievoModelReader* reader, double time, double before, double after,
                       double share, const std::string& what) {
    const std::vector<double> p = at(reader, time);
    const double a = before * Pi / 180.;
    const double b = after * Pi / 180.;
    RELIEVO_CHECK_NEAR(p[0], (1. - share) * std::cos(a) + share * std::cos(b), 1e-5, what + ", x");
    RELIEVO_CHECK_NEAR(p[1], (1. - share) * std::sin(a) + share * std::sin(b), 1e-5, what + ", y");
  };
  const auto scene = MakeTwo(); // the first turns by 90 degrees in a second
  aiNodeAnim* second = scene->mAnimations[1]->mChannels[0];
  delete[] second->mRotationKeys; // the second by 60 in 0.7 seconds
  second->mNumRotationKeys = 2;
  second->mRotationKeys = new aiQuatKey[2]{ aiQuatKey(0., AboutZ(0.)), aiQuatKey(7., AboutZ(60.)) };
  scene->mAnimations[1]->mDuration = 7.;
  const auto reader = Read(*scene, "whole keys");
  reader->SetMethod(vtkRelievoSkin::KEY_MATRIX);
  reader->SetKeyRate(2.5); // at 0, 0.4, 0.8, and the end
  for (const bool loop : { false, true })
  {
    reader->SetLoop(loop);
    check(reader, 0.5, 36., 72., 0.25, "between keys");
    check(reader, 0.95, 72., 90., 0.75, "between the last key and the end");
    check(reader, 1., 90., 90., 0., "the end");
  }
  check(reader, 1.5, 36., 72., 0.25, "the second round");
  reader->SetBlendAnimation("turn 2");
  reader->SetBlendWeight(1.);
  // At 0.5, between 0.4 and 0.8: the second is over at 0.7, and 0.1 into its next round.
  const double turn = 60. / 0.7;
  check(reader, 0.5, 0.4 * turn, 0.1 * turn, 0.25, "the second wraps");
  reader->LoopOff();
  check(reader, 0.5, 0.4 * turn, 60., 0.25, "the second holds");
}

// The axes of joints, the strongest bone, one bone's weights, and the bind pose.
void TestLook()
{
  const auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  scene->mMeshes[0]->mBones[0]->mOffsetMatrix.a4 = -3.f; // bound where x is 3
  const auto reader = Read(*scene, "look");
  reader->SetFirstBone(true);
  reader->SetWeightsOf("arm");
  reader->UpdateTimeStep(0.5);
  auto* skeleton = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1));
  RELIEVO_CHECK(skeleton->GetNumberOfPoints() == 3); // its lines have no colours of axes
  RELIEVO_CHECK(!skeleton->GetCellData()->HasArray("axis"));
  RELIEVO_CHECK(!skeleton->GetCellData()->GetScalars());
  reader->SetSkeletonAxes(true);
  reader->SetAxisLength(0.5);
  reader->UpdateTimeStep(0.5);
  skeleton = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1));
  // Nodes root, body, arm; then the ends of arm's axes, turned by 45 degrees.
  if (RELIEVO_CHECK(skeleton->GetNumberOfPoints() == 6 && skeleton->GetNumberOfLines() == 3))
  {
    const double r = 0.5 * std::sqrt(0.5);
    const double ends[3][3] = { { r, r, 0. }, { -r, r, 0. }, { 0., 0., 0.5 } };
    for (int i = 0; i < 3; ++i)
    {
      double p[3];
      skeleton->GetPoint(3 + i, p);
      RELIEVO_CHECK_AT_MOST(std::hypot(p[0] - ends[i][0], p[1] - ends[i][1], p[2] - ends[i][2]),
        1e-6, "end of an axis");
      RELIEVO_CHECK(skeleton->GetCellData()->GetArray("axis")->GetComponent(i, 0) == i + 1);
      RELIEVO_CHECK(skeleton->GetCellData()->GetArray("axis_color")->GetComponent(i, i) == 230.);
    }
  }
  vtkPointData* data = MeshOf(reader)->GetPointData();
  if (RELIEVO_CHECK(data->GetArray("first_bone") && data->GetArray("bone_weight")))
  {
    RELIEVO_CHECK(data->GetArray("first_bone")->GetComponent(1, 0) == 2.);
    RELIEVO_CHECK(data->GetArray("bone_weight")->GetComponent(1, 0) == 1.);
    RELIEVO_CHECK(data->GetScalars() == data->GetArray("bone_weight"));
  }
  RELIEVO_CHECK(reader->GetBoneNames()->GetNumberOfValues() == 1);
  reader->SetPose(vtkRelievoModelReader::POSE_BIND);
  reader->SetSkeletonAxes(false);
  reader->UpdateTimeStep(0.5);
  double p[3];
  skeleton = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(1));
  RELIEVO_CHECK(skeleton->GetNumberOfPoints() == 3 && skeleton->GetNumberOfLines() == 0);
  skeleton->GetPoint(2, p);
  RELIEVO_CHECK_NEAR(p[0], 3., 1e-6, "where the bone was bound");
  MeshOf(reader)->GetPoint(0, p);
  RELIEVO_CHECK_NEAR(p[0], 1., 1e-6, "the mesh of the bind pose");
  const ExpectMessage expect("no bone 'leg'; it has 'arm'");
  reader->SetWeightsOf("leg");
  reader->Update();
  reader->UpdateTimeStep(0.7);
  RELIEVO_CHECK(expect.Count() == 1);
  RELIEVO_CHECK(!MeshOf(reader)->GetPointData()->GetArray("bone_weight"));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelPlay)
{
  relievoTest::Session session;
  TestBlend();
  TestTwoChannels();
  TestWholeKeys();
  TestLook();
  return session.Result();
}
}
