// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows on, off and otherwise, many times: the first picture comes back bit for bit and OpenGL
// itself says that nothing stays; lights come and go; renderers beside each other do not meet; a
// map that OpenGL cannot make is drawn as large as it can.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkDataArray.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#ifdef RELIEVO_VTK_GLAD
#include <vtk_glad.h>
#endif

#include <dlfcn.h>

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowToggle
{
namespace
{
using relievoTest::Picture;
using relievoTest::ShadowStage;

// While above 0: the largest texture that this program's OpenGL says it can make.
int LargestTexture = 0;
// And the numbers that it says a fragment shader's uniforms can hold.
int MostUniforms = 0;
}

//------------------------------------------------------------------------------
#ifdef RELIEVO_VTK_GLAD
// Stands in VTK's pointer to OpenGL's own.
PFNGLGETINTEGERVPROC NextGetInteger = nullptr;
static void GetInteger(GLenum name, GLint* values)
{
  NextGetInteger(name, values);
#else
// Stands before OpenGL's own, by the dynamic linker's rule that the program's symbols come first.
extern "C" __attribute__((visibility("default"))) void glGetIntegerv(unsigned int name, int* values)
{
  using Function = void (*)(unsigned int, int*);
  static const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glGetIntegerv"));
  next(name, values);
#endif
  const unsigned int maxTextureSize = 0x0D33;
  if (name == maxTextureSize && LargestTexture > 0)
  {
    *values = LargestTexture;
  }
  const unsigned int maxFragmentUniformComponents = 0x8B49;
  if (name == maxFragmentUniformComponents && MostUniforms > 0)
  {
    *values = MostUniforms;
  }
}

namespace
{
// From VTK with glad, which loads its pointers with every window.
void StandBeforeOpenGL()
{
#ifdef RELIEVO_VTK_GLAD
  NextGetInteger = glad_glGetIntegerv;
  glad_glGetIntegerv = GetInteger;
#endif
}

void TestCycles()
{
  ShadowStage stage(200, 150);
  stage.AddThings();
  stage.AddSun(-3., 4., -2.)->SetIntensity(0.5);
  const auto lamp = stage.AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, 90.);
  lamp->SetIntensity(0.5);
  const relievoTest::GLCheck gl(stage.Window);
  const auto first = Picture(stage.Window);
  vtkSmartPointer<vtkImageData> shadows;
  relievoTest::GLObjects held;
  for (int cycle = 0; cycle < 200; ++cycle)
  {
    vtkRelievoPass* frame = stage.GetFrame();
    frame->GetShadowStage()->SetMapSize(cycle % 2 ? 256 : 320);
    frame->GetShadowStage()->SetLightCasts(lamp, cycle % 3 != 0);
    frame->ShadowsOn();
    const auto picture = Picture(stage.Window);
    RELIEVO_CHECK(frame->GetBytesHeld() >= 4 * 256 * 256);
    if (cycle % 6 == 1)
    {
      if (!shadows)
      {
        shadows = picture;
        RELIEVO_CHECK(relievoTest::CountUnlike(first, shadows) > 1000);
      }
      relievoTest::SamePicture(shadows, picture, "shadows in cycle " + std::to_string(cycle));
    }
    frame->ShadowsOff();
    stage.Window->Render();
    RELIEVO_CHECK(frame->GetBytesHeld() == 0);
    vtkRelievoPass::Detach(stage.Renderer);
    stage.Window->Render();
    auto now = relievoTest::CountGLObjects(stage.Window);
    // VTK's mappers time themselves now and then, with two queries each.
    RELIEVO_CHECK(now.Queries <= 6);
    now.Queries = 0;
    // The first cycles compile the shaders of both sets of lights.
    if (cycle == 6)
    {
      held = now;
      std::cout << held.ToString() << "\n";
    }
    if (cycle > 6 && (now.Bytes != held.Bytes || now.Total() != held.Total()))
    {
      relievoTest::Fail(__FILE__, __LINE__,
        "cycle " + std::to_string(cycle) + " holds " + now.ToString() + ", the seventh " +
          held.ToString());
      break;
    }
  }
  relievoTest::SamePicture(first, Picture(stage.Window), "the first picture");
}

// Lights come and go between frames: the verdicts are those of the lights that are there.
void TestLights()
{
  ShadowStage stage;
  stage.AddThings();
  const relievoTest::GLCheck gl(stage.Window);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMapSize(1024);
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 0.9 * i;
    const double x = 3. * std::cos(angle);
    const double z = 3. * std::sin(angle);
    lights.push_back(i % 3 == 0
        ? stage.AddSun(x, 4., z)
        : stage.AddLamp({ x, 3., z }, { 0., 0., 0. }, i % 3 == 1 ? 50. : 90.));
    if (i % 4 == 3)
    {
      // From the middle, so that the others' numbers change.
      stage.Renderer->RemoveLight(lights[1]);
      lights.erase(lights.begin() + 1);
    }
    stage.Window->Render();
    const int count = static_cast<int>(lights.size());
    RELIEVO_CHECK(stage.GetShadows()->GetNumberOfCastingLights() == count);
    if (i % 4 == 3)
    {
      for (int number : { 0, 1, count - 1 })
      {
        relievoTest::CheckShadow(stage, number, 2e-3,
          "light " + std::to_string(number) + " of " + std::to_string(count) +
            " that came and went");
      }
    }
  }
  stage.Renderer->RemoveAllLights();
  stage.Window->Render();
  RELIEVO_CHECK(
    stage.GetShadows()->GetNumberOfCastingLights() == 0 && stage.GetFrame()->GetBytesHeld() == 0);
}

// Three renderers in one window, each with other settings: each shows its own picture.
void TestBeside()
{
  const auto set = [](ShadowStage& stage, int which) {
    stage.AddThings();
    stage.AddSun(-3., 4., which - 2.)->SetIntensity(0.6);
    stage.AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, which == 1 ? 90. : 40.)->SetIntensity(0.4);
    stage.GetFrame();
    stage.GetShadows()->SetMapSize(which == 2 ? 300 : 512);
    stage.GetShadows()->SetFilterRadius(1 + which);
    stage.GetFrame()->SetShadows(which != 0);
  };
  ShadowStage stages[3];
  const auto window = relievoTest::MakeWindow(600, 200);
  const relievoTest::GLCheck gl(window);
  for (int i = 0; i < 3; ++i)
  {
    stages[i].Window->RemoveRenderer(stages[i].Renderer);
    stages[i].Renderer->SetViewport(i / 3., 0., (i + 1) / 3., 1.);
    window->AddRenderer(stages[i].Renderer);
    set(stages[i], i);
  }
  Picture(window);
  const auto all = Picture(window);
  for (int i = 0; i < 3; ++i)
  {
    ShadowStage alone(600, 200);
    alone.Renderer->SetViewport(i / 3., 0., (i + 1) / 3., 1.);
    set(alone, i);
    const auto picture = Picture(alone.Window);
    long long unlike = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 200 * i; x < 200 * (i + 1); ++x)
      {
        for (int c = 0; c < 3; ++c)
        {
          unlike += all->GetScalarComponentAsDouble(x, y, 0, c) !=
            picture->GetScalarComponentAsDouble(x, y, 0, c);
        }
      }
    }
    RELIEVO_CHECK_AT_MOST(
      unlike, 0, "viewport " + std::to_string(i) + " of three: channels unlike those of one alone");
  }
  // Before the window, which takes their resources with it.
  for (ShadowStage& stage : stages)
  {
    window->RemoveRenderer(stage.Renderer);
  }
}

void TestLimit()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  StandBeforeOpenGL();
  LargestTexture = 512;
  {
    relievoTest::ExpectMessage expect("at most 512 x 512");
    for (int i = 0; i < 3; ++i)
    {
      stage.Window->Render();
    }
    RELIEVO_CHECK_THAT(expect.Count() == 1,
      std::to_string(expect.Count()) + " warnings of a map of 2048 where 512 is the limit");
  }
  RELIEVO_CHECK(stage.GetFrame()->GetBytesHeld() == 4 * 512 * 512);
  relievoTest::CheckShadow(stage, 0, 4e-3, "a map at OpenGL's limit");
  stage.GetShadows()->SetMapSize(400);
  stage.Window->Render();
  RELIEVO_CHECK(stage.GetFrame()->GetBytesHeld() == 4 * 400 * 400);
  LargestTexture = 0;
}

// Lights that find no room in the shaders any more say so, once each; the others cast.
void TestRoom()
{
  ShadowStage stage;
  stage.AddThings();
  stage.GetShadows()->SetMapSize(256);
  stage.GetFrame()->ShadowsOn();
  const int lights = 8;
  for (int i = 0; i < lights; ++i)
  {
    stage.AddLamp({ 0.3 * i - 2., 3., -1. }, { 0., 0., 0. }, 90.)->SetIntensity(0.1);
  }
  stage.Window->Render();
  RELIEVO_CHECK(stage.GetShadows()->GetNumberOfCastingLights() == lights);
  StandBeforeOpenGL();
  // Guaranteed by OpenGL 3.2.
  MostUniforms = 1024;
  relievoTest::ExpectMessage expect("the lights before it take all maps");
  stage.Window->Render();
  stage.Window->Render();
  const int casting = stage.GetShadows()->GetNumberOfCastingLights();
  std::cout << "where there is little room " << casting << " lamps cast\n";
  RELIEVO_CHECK(casting > 0 && casting < lights);
  RELIEVO_CHECK_THAT(expect.Count() == lights - casting,
    std::to_string(expect.Count()) + " warnings of " + std::to_string(lights - casting) + " lamps");
  relievoTest::CheckShadow(stage, 0, 5e-3, "a lamp that found room");
  MostUniforms = 0;
}

// Picking does not depend on shadows.
void TestSelection()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  const auto count = [&stage]() {
    stage.Window->Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(stage.Renderer);
    selector->SetArea(0, 0, 239, 179);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    vtkIdType cells = 0;
    for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
    {
      cells += selection->GetNode(i)->GetSelectionList()->GetNumberOfTuples();
    }
    return cells;
  };
  const vtkIdType before = count();
  stage.GetFrame()->ShadowsOn();
  const auto first = Picture(stage.Window);
  const vtkIdType after = count();
  RELIEVO_CHECK_THAT(before > 4 && after == before,
    "cells picked: " + std::to_string(before) + ", with shadows " + std::to_string(after));
  relievoTest::SamePicture(first, Picture(stage.Window), "after picking");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowToggle)
{
  relievoTest::Session session;
  TestCycles();
  TestLights();
  TestBeside();
  TestLimit();
  TestRoom();
  TestSelection();
  return session.Result();
}
}
