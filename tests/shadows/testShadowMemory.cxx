// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An OpenGL without memory for maps or masks: a failure is reported once and counts no bytes, the
// picture is the one without it, and smaller requests work later.
#include "Check.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#ifdef RELIEVO_VTK_GLAD
#include <vtk_glad.h>
#endif

#include <string>

#include <dlfcn.h>

namespace testShadowMemory
{
namespace
{
bool Full = false;
bool FullForTrees = false; // of triangles, which are the frame's
int TreesFailed = 0;       // calls
int FailuresLeft = -1;     // fails so many times; -1: always
}

// VTK asks for errors as well, after work that has gone right.
#ifdef RELIEVO_VTK_GLAD
// Stands in VTK's pointer to OpenGL's own.
static PFNGLGETERRORPROC next = nullptr;
static GLenum GetError()
{
#else
// Stands before OpenGL's own, by the dynamic linker's rule that the program's symbols come first.
extern "C" __attribute__((visibility("default"))) unsigned int glGetError()
{
  using Function = unsigned int (*)();
  static const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glGetError"));
#endif
  const unsigned int outOfMemory = 0x0505;
  Dl_info from;
  const bool known = (Full || FullForTrees) && dladdr(__builtin_return_address(0), &from) != 0 &&
    from.dli_fname != nullptr;
  const std::string library = known ? from.dli_fname : "";
  const bool ofTree = FullForTrees && library.find("RelievoFrame") != std::string::npos;
  const bool fails = ofTree || (Full && library.find("RelievoShadows") != std::string::npos);
  TreesFailed += ofTree ? 1 : 0;
  if (fails && FailuresLeft > 0 && --FailuresLeft == 0)
  {
    Full = false;
    FailuresLeft = -1;
  }
  return fails ? outOfMemory : next();
}

namespace
{
using relievoTest::ExpectMessage;
using relievoTest::Picture;
using relievoTest::SamePicture;

// From VTK with glad, which loads its pointers with every window.
void StandBeforeOpenGL()
{
#ifdef RELIEVO_VTK_GLAD
  next = glad_glGetError;
  glad_glGetError = GetError;
#endif
}

void TestMaps()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  relievoTest::AddTwoSuns(stage);
  const auto plain = Picture(stage.Window);
  StandBeforeOpenGL();
  vtkRelievoPass* frame = stage.GetFrame();
  frame->ShadowsOn();
  Full = true;
  {
    ExpectMessage expect("no memory for 1 map of 2048 x 2048");
    for (int i = 0; i < 3; ++i)
    {
      SamePicture(plain, Picture(stage.Window), "without memory for maps");
    }
    RELIEVO_CHECK_THAT(expect.Count() == 1, "maps: not said once");
  }
  RELIEVO_CHECK(stage.GetShadows()->GetBytesHeld() == 0);
  RELIEVO_CHECK(frame->GetFrameReport().find("\"failed\"") != std::string::npos);
  Full = false;
  stage.GetShadows()->SetMapSize(512);
  RELIEVO_CHECK_THAT(
    relievoTest::CountUnlike(plain, Picture(stage.Window)) > 1000, "smaller maps: no shadows");
  RELIEVO_CHECK(stage.GetShadows()->GetBytesHeld() == 4 * 512 * 512);
}

// Without masks, verdicts are those of the maps, not filtered otherwise.
void TestMasks()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  relievoTest::AddTwoSuns(stage);
  stage.GetFrame()->ShadowsOn();
  const auto maps = Picture(stage.Window);
  StandBeforeOpenGL();
  stage.GetShadows()->SetMethod(vtkRelievoShadowStage::METHOD_FORWARD);
  Full = true;
  {
    ExpectMessage expect("no memory for the masks");
    for (int i = 0; i < 3; ++i)
    {
      SamePicture(maps, Picture(stage.Window), "without memory for masks");
    }
    RELIEVO_CHECK_THAT(expect.Count() == 1, "masks: not said once");
  }
  Full = false;
  stage.Window->SetSize(241, 180);
  const auto masks = Picture(stage.Window);
  stage.GetShadows()->SetMethod(vtkRelievoShadowStage::METHOD_MAP);
  RELIEVO_CHECK_THAT(
    relievoTest::CountUnlike(masks, Picture(stage.Window)) > 0, "another size: no masks");
}

// A tolerance's choice without enough OpenGL memory is not chosen again; one that fits is.
void TestPlanned()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  relievoTest::AddTwoSuns(stage);
  const auto plain = Picture(stage.Window);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  stage.GetFrame()->ShadowsOn();
  shadows->SetTolerance(2e-3);
  (void)Picture(stage.Window);
  const int size = shadows->GetMapSizeUsed();
  RELIEVO_CHECK_THAT(shadows->GetMethodUsed() != vtkRelievoShadowStage::METHOD_EXACT, "no maps");
  shadows->ReleaseGraphicsResources(stage.Window);
  StandBeforeOpenGL();
  Full = true;
  FailuresLeft = 17; // of the first array: 16 for others' errors, one for its own
  for (int i = 0; i < 3; ++i)
  {
    RELIEVO_CHECK_THAT(
      relievoTest::CountUnlike(plain, Picture(stage.Window)) > 1000, "another choice: no shadows");
    RELIEVO_CHECK_THAT(shadows->GetMethodUsed() == vtkRelievoShadowStage::METHOD_EXACT ||
        shadows->GetMapSizeUsed() < size,
      shadows->GetPlan());
  }
  RELIEVO_CHECK(!Full);
  // No maps at all: as without a choice, and it is said.
  shadows->ReleaseGraphicsResources(stage.Window);
  shadows->SetTimeBudget(1e-3);
  shadows->SetTolerance(0.);
  Full = true;
  FullForTrees = true;
  {
    ExpectMessage expect("no memory for 1 map of 2048 x 2048");
    const ExpectMessage exact("Shadows are made with maps");
    SamePicture(plain, Picture(stage.Window), "without memory for any choice");
    SamePicture(plain, Picture(stage.Window), "without memory for any choice, again");
    RELIEVO_CHECK_THAT(expect.Count() == 1, "choices: not said once");
  }
  RELIEVO_CHECK_THAT(
    shadows->GetPlan().find("nothing was chosen") != std::string::npos, shadows->GetPlan());
  Full = false;
  FullForTrees = false;
  shadows->SetTimeBudget(2e-3);
  RELIEVO_CHECK_THAT(
    relievoTest::CountUnlike(plain, Picture(stage.Window)) > 1000, "memory again: no shadows");
}

// Without memory for a tree it is not tried again before the casters change, also where VTK's
// mappers mark themselves as modified whenever they draw.
void TestTrees()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  relievoTest::AddTwoSuns(stage);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 1., 0.5);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  (void)Picture(stage.Window); // a new window resets pointers to OpenGL
  StandBeforeOpenGL();
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMethodToExact();
  FullForTrees = true;
  const ExpectMessage exact("Shadows are made with maps");
  int failed[4];
  for (int i = 0; i < 4; ++i)
  {
    actor->SetPosition(i < 3 ? 0. : 0.1, 0., 0.);
    TreesFailed = 0;
    (void)Picture(stage.Window);
    failed[i] = TreesFailed;
  }
  FullForTrees = false;
  RELIEVO_CHECK_THAT(failed[0] > 0 && failed[3] > 0, "a tree was not tried");
  RELIEVO_CHECK_THAT(failed[1] == 0 && failed[2] == 0, "a tree was tried again");
}

// Without room for verdicts of pixels, each fragment finds the same.
void TestVerdicts()
{
  relievoTest::ShadowStage stages[2];
  for (relievoTest::ShadowStage& stage : stages)
  {
    stage.AddThings();
    relievoTest::AddTwoSuns(stage);
    stage.GetFrame()->ShadowsOn();
    stage.GetShadows()->SetMethodToExact();
    for (int i = 0; i < 2; ++i)
    {
      stage.Window->Render();
    }
    stage.Window->SetSize(241, 180);
  }
  StandBeforeOpenGL();
  Full = true;
  vtkSmartPointer<vtkImageData> without;
  for (int i = 0; i < 3; ++i)
  {
    without = Picture(stages[0].Window);
  }
  Full = false;
  const auto bytes = stages[0].GetShadows()->GetBytesHeld();
  for (int i = 0; i < 3; ++i)
  {
    SamePicture(without, Picture(stages[1].Window), "without memory for verdicts");
  }
  RELIEVO_CHECK(stages[1].GetShadows()->GetBytesHeld() == bytes + 16 * 241 * 180 + 4 * 31 * 23);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowMemory)
{
  relievoTest::Session session;
  TestMaps();
  TestMasks();
  TestVerdicts();
  TestPlanned();
  TestTrees();
  return session.Result();
}
}
