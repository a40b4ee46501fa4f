// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keys and bones as no good file has them: scenes made in memory, written by Assimp in its own
// binary format, and read back by vtkRelievoModelReader.
#include "Check.h"
#include "ModelScenes.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <assimp/scene.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace testModelKeys
{
namespace
{
using namespace relievoTest;
constexpr double Pi = 3.14159265358979323846;
const float NaN = std::numeric_limits<float>::quiet_NaN();

bool HasNote(vtkRelievoModelReader* reader, const std::string& text)
{
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    if (std::string(reader->GetNote(i)).find(text) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

void TestInterpolation()
{
  const auto reader = Read(*MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) },
                             { 14., AboutZ(90.) }, { 20., AboutZ(-60., -1.f) } }),
    "turns");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.25), 22.5, 1e-4, "a quarter of the way, slerp");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 1.2), 90., 1e-4, "between equal keys");
  // Quaternions of opposite sign: from 90 to -60 by the shorter arc, through 15 degrees.
  RELIEVO_CHECK_NEAR(AngleAt(reader, 1.7), 15., 1e-4, "opposite quaternions, shorter arc");
  RELIEVO_CHECK_NEAR(AngleAt(reader, -3.), 0., 1e-4, "before the first key");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 99.), -60., 1e-4, "after the last key");
  reader->SlerpOff();
  // By the chord: atan of the mean of the half angles' sines and cosines.
  const double s = std::sin(45. * Pi / 180.) * 0.25;
  const double c = 0.75 + std::cos(45. * Pi / 180.) * 0.25;
  RELIEVO_CHECK_NEAR(
    AngleAt(reader, 0.25), 2. * std::atan2(s, c) * 180. / Pi, 1e-4, "a quarter, nlerp");
  reader->SlerpOn();

  // Loop, speed, and the pipeline's times.
  reader->LoopOn();
  RELIEVO_CHECK_NEAR(AngleAt(reader, 2.25), 22.5, 1e-4, "the second round");
  RELIEVO_CHECK_NEAR(AngleAt(reader, -1.75), 22.5, 1e-4, "the round before");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 2.), -60., 1e-4, "the end");
  reader->LoopOff();
  reader->SetSpeed(2.);
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.125), 22.5, 1e-4, "at double speed");
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const std::vector<double> expected = { 0., 0.5, 0.7, 1. };
  if (RELIEVO_CHECK(info->Length(Pipeline::TIME_STEPS()) == 4))
  {
    for (int i = 0; i < 4; ++i)
    {
      RELIEVO_CHECK_NEAR(info->Get(Pipeline::TIME_STEPS())[i],
        expected[static_cast<std::size_t>(i)], 1e-12, "time step");
    }
    RELIEVO_CHECK_NEAR(info->Get(Pipeline::TIME_RANGE())[1], 1., 1e-12, "end of the range");
  }
}

void TestBadKeys()
{
  const aiQuaternion none(NaN, 0.f, 0.f, 0.f);
  const aiQuaternion zero(0.f, 0.f, 0.f, 0.f);
  // Out of order, doubled, not finite and of no length.
  auto reader = Read(*MakeScene({ { 10., AboutZ(90.) }, { 0., AboutZ(30.) }, { 0., AboutZ(0.) },
                       { 5., none }, { 6., zero }, { NaN, AboutZ(10.) } }),
    "bad");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 45., 1e-4, "between the good keys");
  RELIEVO_CHECK(HasNote(reader, "3 keys are not finite"));
  RELIEVO_CHECK(HasNote(reader, "out of order"));
  RELIEVO_CHECK(HasNote(reader, "1 keys stand at the time of the one before"));
  // Sorted, two keys at one time are a jump; keys between three are never seen.
  reader = Read(*MakeScene({ { 0., AboutZ(20.) }, { 10., AboutZ(20.) }, { 10., AboutZ(80.) },
                  { 20., AboutZ(60.) }, { 20., AboutZ(10.) }, { 20., AboutZ(-40.) } }),
    "jump");
  for (const int method : { 0, 2 })
  {
    reader->SetMethod(method);
    RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 20., 1e-4, "before a jump");
    RELIEVO_CHECK_NEAR(AngleAt(reader, 0.999999), 20., 1e-2, "just before it");
    RELIEVO_CHECK_NEAR(AngleAt(reader, 1.), 80., 1e-4, "at the jump");
    RELIEVO_CHECK_NEAR(AngleAt(reader, 2.), -40., 1e-4, "at the last of three keys");
  }
  reader->SetMethod(0);
  RELIEVO_CHECK_NEAR(AngleAt(reader, 1.5), 70., 1e-4, "after the jump, to the first of three");
  RELIEVO_CHECK(HasNote(reader, "1 keys stand at the time of the one before"));
  reader = Read(*MakeScene({ { 7., AboutZ(40.) } }), "one");
  for (const double time : { -1., 0., 0.7, 5. })
  {
    RELIEVO_CHECK_NEAR(AngleAt(reader, time), 40., 1e-4, "one key only");
  }
  reader = Read(*MakeScene({ { 0., none } }), "none");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.), 0., 1e-4, "no key left: as at rest");
  // Ticks that are not told, and a channel of a node that is not there.
  const auto stranger = MakeScene({ { 0., AboutZ(0.) }, { 25., AboutZ(50.) } });
  stranger->mAnimations[0]->mTicksPerSecond = 0.;
  delete stranger->mAnimations[0]->mChannels[0];
  delete[] stranger->mAnimations[0]->mChannels;
  stranger->mAnimations[0]->mNumChannels = 2;
  stranger->mAnimations[0]->mChannels = new aiNodeAnim* [2] {
    MakeChannel("noBone", { { 0., AboutZ(10.) } }),
      MakeChannel("arm", { { 0., AboutZ(0.) }, { 25., AboutZ(50.) } })
  };
  reader = Read(*stranger, "stranger");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 25., 1e-4, "25 ticks a second");
  RELIEVO_CHECK(HasNote(reader, "'noBone'") && HasNote(reader, "how long a tick is"));
}

// More bones than are kept, weights that do not sum to 1 or are none, a bone without a node.
void TestBadWeights()
{
  const auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  aiMesh* mesh = scene->mMeshes[0];
  delete mesh->mBones[0];
  delete[] mesh->mBones;
  const std::vector<std::pair<const char*, std::vector<aiVertexWeight>>> bones = {
    { "arm", { { 0, 0.1f }, { 1, 2.f }, { 99, 1.f } } },
    { "root", { { 0, 0.3f }, { 1, 2.f } } },
    { "body", { { 0, 0.6f }, { 1, NaN } } },
    { "ghost", { { 2, 1.f } } },
  };
  mesh->mNumBones = static_cast<unsigned int>(bones.size());
  mesh->mBones = new aiBone*[bones.size()];
  for (std::size_t i = 0; i < bones.size(); ++i)
  {
    mesh->mBones[i] = new aiBone;
    mesh->mBones[i]->mName = bones[i].first;
    mesh->mBones[i]->mNumWeights = static_cast<unsigned int>(bones[i].second.size());
    mesh->mBones[i]->mWeights = new aiVertexWeight[bones[i].second.size()];
    std::copy(bones[i].second.begin(), bones[i].second.end(), mesh->mBones[i]->mWeights);
  }
  const auto reader = Read(*scene, "weights");
  reader->SetWeightsPerPoint(2);
  reader->Update();
  vtkDataArray* weights = MeshOf(reader)->GetPointData()->GetArray("weights");
  vtkDataArray* joints = MeshOf(reader)->GetPointData()->GetArray("joints");
  if (RELIEVO_CHECK(weights && joints && weights->GetNumberOfComponents() == 2))
  {
    // The strongest, body and root, in this order; 0.6 and 0.3 of the remaining sum.
    RELIEVO_CHECK(joints->GetComponent(0, 0) == 2. && joints->GetComponent(0, 1) == 1.);
    RELIEVO_CHECK_NEAR(weights->GetComponent(0, 0), 2. / 3., 1e-6, "the strongest");
    RELIEVO_CHECK_NEAR(weights->GetComponent(0, 1), 1. / 3., 1e-6, "the second");
    RELIEVO_CHECK_NEAR(weights->GetComponent(1, 0), 0.5, 1e-6, "rescaled");
    RELIEVO_CHECK_NEAR(weights->GetComponent(2, 0), 1., 1e-6, "without a bone, of its node");
  }
  RELIEVO_CHECK(HasNote(reader, "1 points have more than 2 bones"));
  RELIEVO_CHECK(HasNote(reader, "at most 10"));
  RELIEVO_CHECK(HasNote(reader, "'ghost' has no node"));
  RELIEVO_CHECK(HasNote(reader, "weights are not finite"));
  RELIEVO_CHECK(HasNote(reader, "1 points have no bone"));
  RELIEVO_CHECK(HasNote(reader, "do not sum to 1"));
}

// One of them chosen, and one that is not there asked for.
void TestChoice()
{
  const auto reader = Read(*MakeTwo(), "two");
  RELIEVO_CHECK(reader->GetNumberOfAnimations() == 2 && !reader->GetAnimationName(2));
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 45., 1e-4, "the first");
  RELIEVO_CHECK(std::string(reader->GetAnimationName(1)) == "turn 2");
  reader->SetAnimation("turn 2");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), -30., 1e-4, "the second, of the same name");
  reader->SetAnimation("run");
  const ExpectMessage expect("no animation 'run'; it has 'turn', 'turn 2'");
  RELIEVO_CHECK_NEAR(AngleAt(reader, 0.5), 0., 1e-4, "one that is not there");
  AngleAt(reader, 0.7);
  RELIEVO_CHECK(expect.Count() == 1);
}

// A deep tree of bones adds up and does not end the process.
void TestDeepTree()
{
  const auto scene = MakeScene({ { 0., AboutZ(0.) }, { 10., AboutZ(90.) } });
  aiNode* node = scene->mRootNode->mChildren[1];
  node->mName = "bone 0";
  for (int i = 1; i < 1000; ++i)
  {
    aiNode* child = new aiNode(i == 999 ? "arm" : "bone " + std::to_string(i));
    child->mTransformation.a4 = 1.f;
    node->addChildren(1, &child);
    node = child;
  }
  // The channel's own position replaces the arm's: 998 steps of 1.
  const auto reader = Read(*scene, "deep");
  double p[3];
  MeshOf(reader)->GetPoint(0, p);
  RELIEVO_CHECK_NEAR(p[0], 999., 1e-3, "a thousand bones in a row");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelKeys)
{
  relievoTest::Session session;
  TestInterpolation();
  TestBadKeys();
  TestBadWeights();
  TestChoice();
  TestDeepTree();
  return session.Result();
}
}
