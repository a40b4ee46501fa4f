// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// State and messages of vtkRelievoSkinnedActor: methods change many times, one actor is in two
// windows, shader code is removed; missing parts are reported once and the mesh is drawn at rest.
#include "Check.h"
#include "Layers.h"
#include "LeakCounter.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SkinnedScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLShaderProperty.h>
#include <vtkPointData.h>
#include <vtkRelievoTextureBuffer.h>
#include <vtkRenderer.h>
#include <vtkTrivialProducer.h>

#include <memory>
#include <string>
#include <vector>

namespace testSkinnedActorState
{
namespace
{
using namespace relievoTest;
constexpr int Methods[] = { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION,
  vtkRelievoSkin::KEY_MATRIX };

void TestSwitches()
{
  Chain few = MakeChain(5, 41, 12, 2);
  Chain many = MakeChain(60, 41, 12, 6);
  SkinnedSide side(true);
  side.Set(few.Mesh, few.Skeleton, 0);
  side.Stage.Renderer->ResetCamera();
  const auto first = Picture(side.Stage.Window);
  GLObjects held;
  std::string leaks;
  std::unique_ptr<LeakCounter> counter;
  for (int cycle = 0; cycle < 200; ++cycle)
  {
    side.Skinned->SetMethod(Methods[cycle % 3]);
    const Chain& chain = cycle % 4 == 3 ? many : few;
    side.Skinned->SetInputData(chain.Mesh);
    side.Skinned->SetSkeletonData(chain.Skeleton);
    side.Skinned->SetBindPose(cycle % 5 == 4);
    side.Stage.Window->Render();
    if (cycle % 60 == 59)
    {
      // VTK's mappers time themselves now and then, with two queries each.
      GLObjects now = CountGLObjects(side.Stage.Window);
      now.Queries = 0;
      if (held.Total() == 0)
      {
        held = now;
        counter.reset(new LeakCounter);
      }
      RELIEVO_CHECK_THAT(now.Total() == held.Total() && now.Bytes == held.Bytes,
        "cycle " + std::to_string(cycle) + " holds " + now.ToString() + ", before " +
          held.ToString());
      leaks = counter->Leaks();
      RELIEVO_CHECK_THAT(leaks.empty(), leaks);
    }
  }
  side.Set(few.Mesh, few.Skeleton, 0);
  side.Skinned->BindPoseOff();
  RELIEVO_CHECK(relievoTest::SamePicture(first, Picture(side.Stage.Window), "after 200 switches"));
  // In another window the same bones are there as well.
  SkinnedSide other(true);
  other.Stage.Renderer->RemoveActor(other.Actor);
  side.Stage.Renderer->RemoveActor(side.Actor);
  side.Stage.Window->Render();
  other.Stage.Renderer->AddActor(side.Actor);
  other.Stage.Renderer->GetActiveCamera()->DeepCopy(side.Stage.Renderer->GetActiveCamera());
  RELIEVO_CHECK(relievoTest::SamePicture(first, Picture(other.Stage.Window), "another window"));
}

// One actor in two windows, drawn in turn: neither loses nor collects anything.
void TestTwoWindows()
{
  SkinnedSide first(true);
  SkinnedSide second(true);
  if (first.Stage.Window->IsA("vtkEGLRenderWindow"))
  {
    return; // VTK 9.7 loses objects shared by two of these windows, even its own actors'
  }
  first.Set(MakeThreeBoneTube(41, 20), MakeBentPose(0.7, 1., 1.), 0);
  first.Stage.Renderer->ResetCamera();
  second.Stage.Renderer->RemoveActor(second.Actor);
  second.Stage.Renderer->AddActor(first.Actor);
  second.Stage.Renderer->GetActiveCamera()->DeepCopy(first.Stage.Renderer->GetActiveCamera());
  std::vector<vtkSmartPointer<vtkImageData>> pictures;
  GLObjects held[2];
  for (int turn = 0; turn < 5; ++turn)
  {
    for (SkinnedSide* side : { &first, &second })
    {
      pictures.push_back(Picture(side->Stage.Window));
      RELIEVO_CHECK(SamePicture(pictures.front(), pictures.back(), "in turn"));
    }
    GLObjects now[2] = { CountGLObjects(first.Stage.Window), CountGLObjects(second.Stage.Window) };
    for (int i = 0; i < 2; ++i)
    {
      held[i] = turn == 1 ? now[i] : held[i];
      RELIEVO_CHECK_THAT(
        turn < 2 || (now[i].Buffers == held[i].Buffers && now[i].Textures == held[i].Textures),
        "turn " + std::to_string(turn) + ", window " + std::to_string(i) + " holds " +
          now[i].ToString() + ", before " + held[i].ToString());
    }
  }
}

// More bones than a buffer texture holds: said once for all poses, drawn at rest.
void TestTooManyBones()
{
  SkinnedSide side(true);
  const auto tube = MakeThreeBoneTube(41, 20);
  side.Set(tube, MakeBentPose(0.7, 1., 1.), 0);
  side.Skinned->BindPoseOn();
  side.Stage.Renderer->ResetCamera();
  const auto still = Picture(side.Stage.Window);
  side.Skinned->BindPoseOff();
  vtkRelievoTextureBuffer::SetMostTexels(8);
  ExpectMessage expect("at most 8");
  for (int i = 0; i < 4; ++i)
  {
    side.Skinned->SetSkeletonData(MakeBentPose(0.1 * i, 1., 1.));
    RELIEVO_CHECK(SamePicture(still, Picture(side.Stage.Window), "refused bones"));
  }
  RELIEVO_CHECK_THAT(expect.Count() == 1, std::to_string(expect.Count()) + " messages");
  vtkRelievoTextureBuffer::SetMostTexels(0);
}

// Replacements that others take away come back, as does the move after another shader property.
void TestReplacements()
{
  SkinnedSide side(true);
  side.Set(MakeThreeBoneTube(41, 20), MakeBentPose(0.7, 1., 1.), 0);
  side.Stage.Renderer->ResetCamera();
  const auto moved = Picture(side.Stage.Window);
  side.Actor->GetShaderProperty()->ClearAllShaderReplacements();
  RELIEVO_CHECK(SamePicture(moved, Picture(side.Stage.Window), "replacements taken away"));
  vtkNew<vtkOpenGLShaderProperty> other;
  side.Actor->SetShaderProperty(other);
  RELIEVO_CHECK(SamePicture(moved, Picture(side.Stage.Window), "another shader property"));
}

// Said once, and drawn at rest; mended, it moves.
void TestMissing()
{
  SkinnedSide rest(true);
  const auto tube = MakeThreeBoneTube(41, 20);
  const auto pose = MakeBentPose(0.7, 1., 1.);
  rest.Set(tube, pose, 0);
  rest.Skinned->BindPoseOn();
  rest.Stage.Renderer->ResetCamera();
  const auto still = Picture(rest.Stage.Window);
  rest.Skinned->BindPoseOff();
  const auto moved = Picture(rest.Stage.Window);
  RELIEVO_CHECK(CountUnlike(still, moved, 20) > 500);
  const auto refuse = [&](vtkPolyData* mesh, vtkPolyData* skeleton, int method, const char* text) {
    ExpectMessage expect(text);
    rest.Set(mesh, skeleton, method);
    for (int frame = 0; frame < 3; ++frame)
    {
      RELIEVO_CHECK_THAT(SamePicture(still, Picture(rest.Stage.Window), text), text);
    }
    RELIEVO_CHECK_THAT(
      expect.Count() == 1, std::string(text) + ": " + std::to_string(expect.Count()) + " messages");
    rest.Set(tube, pose, 0);
    RELIEVO_CHECK(SamePicture(moved, Picture(rest.Stage.Window), "mended"));
  };
  vtkNew<vtkPolyData> nothing;
  refuse(tube, nothing, 0, "no point array pose");
  refuse(tube, MakeSkeleton({ glm::dmat4(1.) }), 0, "of a skeleton of 1");
  vtkNew<vtkPolyData> keyless;
  keyless->DeepCopy(pose);
  keyless->GetPointData()->RemoveArray("pose_before");
  refuse(tube, keyless, vtkRelievoSkin::KEY_MATRIX, "no whole keys");
  refuse(MakeTube(41, 20, false), pose, 0, "joints and weights");
  // Without a mesh nothing is drawn; a composite is refused, and the actor names the remedy.
  rest.Skinned->SetInputConnection(nullptr);
  const auto empty = Picture(rest.Stage.Window);
  RELIEVO_CHECK(CountUnlike(still, empty, 20) > 500);
  RELIEVO_CHECK(rest.Skinned->GetMovedMesh() == nullptr);
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, tube);
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(blocks);
    ExpectMessage expect("vtkMultiBlockDataSet, expected vtkPolyData");
    rest.Skinned->SetInputConnection(producer->GetOutputPort());
    RELIEVO_CHECK(SamePicture(empty, Picture(rest.Stage.Window), "a composite"));
    rest.Stage.Window->Render();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  vtkNew<vtkPolyData> pointless;
  rest.Set(pointless, pose, 0);
  RELIEVO_CHECK(SamePicture(empty, Picture(rest.Stage.Window), "no points"));
  rest.Set(tube, pose, 0);
  RELIEVO_CHECK(SamePicture(moved, Picture(rest.Stage.Window), "a mesh again"));
  // More bones than the vertex shader takes: the weaker ones are left out.
  const Chain chain = MakeChain(20, 41, 20, 10);
  ExpectMessage expect("more than 8 bones");
  rest.Set(chain.Mesh, chain.Skeleton, 0);
  rest.Stage.Window->Render();
  rest.Stage.Window->Render();
  RELIEVO_CHECK(expect.Count() == 1);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinnedActorState)
{
  relievoTest::Session session;
  TestSwitches();
  TestTwoWindows();
  TestTooManyBones();
  TestReplacements();
  TestMissing();
  return session.Result();
}
}
