// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attach, ask, show, release, resize, detach: the picture is VTK's own whenever no layer is shown,
// bit for bit, whatever draws it; GPU memory stays where it is; the user's pass comes back.
#include "Check.h"
#include "FrameTimer.h"
#include "FrameTimes.h"
#include "GLCheck.h"
#include "ImageCompare.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkEDLShading.h>
#include <vtkGaussianBlurPass.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoStage.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#if __has_include(<vtkToneMappingPass.h>)
#include <vtkToneMappingPass.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>

namespace testToggle
{
namespace
{
using relievoTest::IsSame;
using relievoTest::Picture;

// A ball and a box, opaque, and a ball that lets them be seen through it.
void Fill(vtkRenderer* renderer)
{
  auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.7));
  ball->SetPosition(0., 0.7, 0.);
  ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
  auto box = relievoTest::AddActor(renderer, relievoTest::MakeBox(3., 0.2, 3.));
  box->GetProperty()->SetColor(0.3, 0.5, 0.8);
  auto glass = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.4));
  glass->SetPosition(0.8, 1., 1.2);
  glass->GetProperty()->SetOpacity(0.4);
  renderer->SetBackground(0.1, 0.2, 0.3);
}

template <typename Pass>
vtkSmartPointer<vtkRenderPass> Around()
{
  vtkNew<Pass> pass;
  vtkNew<vtkRenderStepsPass> steps;
  pass->SetDelegatePass(steps);
  return vtkSmartPointer<vtkRenderPass>(pass.GetPointer());
}

long CountCovered(vtkRelievoPass* frame)
{
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(frame->ReadLayer("depth", image));
  vtkDataArray* depth = image->GetPointData()->GetArray("depth");
  long count = 0;
  for (vtkIdType i = 0; depth && i < depth->GetNumberOfTuples(); ++i)
  {
    count += std::isfinite(depth->GetComponent(i, 0));
  }
  return count;
}

struct Chain
{
  const char* Name;
  vtkSmartPointer<vtkRenderPass> Pass;
};

std::vector<Chain> MakeChains()
{
  vtkNew<vtkRenderStepsPass> steps;
  return
  {
    { "no pass", nullptr },
      { "vtkRenderStepsPass", vtkSmartPointer<vtkRenderPass>(steps.GetPointer()) },
      { "vtkSSAAPass", Around<vtkSSAAPass>() },
      { "vtkGaussianBlurPass", Around<vtkGaussianBlurPass>() },
      { "vtkOpenGLFXAAPass", Around<vtkOpenGLFXAAPass>() },
#if __has_include(<vtkToneMappingPass.h>)
      { "vtkToneMappingPass", Around<vtkToneMappingPass>() },
#endif
      { "vtkSSAOPass", Around<vtkSSAOPass>() }, { "vtkEDLShading", Around<vtkEDLShading>() },
  };
}

void TestPicture(
  const std::string& what, vtkRenderer* renderer, vtkRenderWindow* window, long& covered)
{
  vtkRenderPass* own = renderer->GetPass();
  const auto before = Picture(window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  RELIEVO_CHECK_THAT(IsSame(before, Picture(window)), what + ": attached, the picture differs");
  for (const char* layer : { "depth", "normal", "albedo", "cell" })
  {
    frame->RequestLayer(layer);
  }
  RELIEVO_CHECK_THAT(IsSame(before, Picture(window)), what + ": with layers, it differs");
  RELIEVO_CHECK_THAT(IsSame(before, Picture(window)), what + ": in the second frame, it differs");
  const long count = CountCovered(frame);
  covered = covered < 0 ? count : covered;
  RELIEVO_CHECK_THAT(count == covered && count > 100, what + ": another number of pixels covered");
  frame->SetDisplayLayer("normal");
  RELIEVO_CHECK_THAT(!IsSame(before, Picture(window)), what + ": a layer shown changes nothing");
  frame->SetDisplayLayer(nullptr);
  RELIEVO_CHECK_THAT(IsSame(before, Picture(window)), what + ": a layer shown leaves its traces");
  RELIEVO_CHECK(vtkRelievoPass::Detach(renderer));
  RELIEVO_CHECK(!vtkRelievoPass::Detach(renderer));
  RELIEVO_CHECK_THAT(renderer->GetPass() == own, what + ": the user's pass does not come back");
  RELIEVO_CHECK_THAT(IsSame(before, Picture(window)), what + ": detached, the picture differs");
}

void TestChains()
{
  relievoTest::Stage stage(240, 160);
  Fill(stage.Renderer);
  relievoTest::GLCheck gl(stage.Window);
  for (const bool part : { false, true })
  {
    stage.Renderer->SetViewport(part ? 0.4 : 0., 0., 1., part ? 0.8 : 1.);
    long covered = -1;
    for (const Chain& chain : MakeChains())
    {
      // In a part of the window these leave pixels at the border as they find them.
      if (part && chain.Pass &&
        (chain.Pass->IsA("vtkSSAAPass") || chain.Pass->IsA("vtkGaussianBlurPass")))
      {
        continue;
      }
      stage.Renderer->SetPass(chain.Pass);
      TestPicture(std::string(chain.Name) + (part ? ", part of the window" : ""), stage.Renderer,
        stage.Window, covered);
      if (chain.Pass)
      {
        chain.Pass->ReleaseGraphicsResources(stage.Window);
      }
      stage.Renderer->SetPass(nullptr);
    }
    struct
    {
      const char* Name;
      void (*Set)(vtkRenderer*, bool);
    } const switches[] = {
      { "depth peeling", [](vtkRenderer* r, bool on) { r->SetUseDepthPeeling(on); } },
      { "SSAO", [](vtkRenderer* r, bool on) { r->SetUseSSAO(on); } },
      { "FXAA", [](vtkRenderer* r, bool on) { r->SetUseFXAA(on); } },
      { "hidden lines", [](vtkRenderer* r, bool on) { r->SetUseHiddenLineRemoval(on); } },
    };
    for (const auto& way : switches)
    {
      way.Set(stage.Renderer, true);
      TestPicture(way.Name, stage.Renderer, stage.Window, covered);
      way.Set(stage.Renderer, false);
    }
  }
  gl.Poll("chains");
}

void TestMultisampled()
{
  relievoTest::Stage single(240, 160);
  Fill(single.Renderer);
  relievoTest::Stage multi(240, 160);
  Fill(multi.Renderer);
  multi.Window->SetMultiSamples(4);
  long covered = -1;
  TestPicture("single sample", single.Renderer, single.Window, covered);
  TestPicture("4 samples", multi.Renderer, multi.Window, covered);
}

// 200 times on, off, another size: OpenGL itself counts the objects.
void TestCycles()
{
  relievoTest::Stage stage(200, 150);
  Fill(stage.Renderer);
  relievoTest::GLCheck gl(stage.Window);
  const auto first = Picture(stage.Window);
  relievoTest::GLObjects held;
  for (int cycle = 0; cycle < 200; ++cycle)
  {
    vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
    frame->RequestLayer("depth");
    frame->RequestLayer("normal");
    frame->SetDisplayLayer(cycle % 3 == 0 ? "cell" : cycle % 3 == 1 ? "depth" : nullptr);
    frame->GetLayersStage()->SetShareGeometryPass(cycle % 2 == 0);
    stage.Window->Render();
    stage.Window->SetSize(180, 190);
    stage.Window->Render();
    RELIEVO_CHECK(frame->GetBytesHeld() > 180 * 190 * 8);
    frame->ReleaseLayers();
    frame->SetDisplayLayer(nullptr);
    stage.Window->Render();
    RELIEVO_CHECK(frame->GetBytesHeld() == 0);
    vtkRelievoPass::Detach(stage.Renderer);
    stage.Window->SetSize(200, 150);
    stage.Window->Render();
    auto now = relievoTest::CountGLObjects(stage.Window);
    // VTK's mappers time themselves now and then, with two queries each.
    RELIEVO_CHECK(now.Queries <= 6);
    now.Queries = 0;
    // The first cycles compile the shaders of both ways and of the three pictures.
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
  RELIEVO_CHECK_THAT(IsSame(first, Picture(stage.Window)), "the first picture does not come back");
  gl.Poll("cycles");
}

void TestMessagesAndReport()
{
  relievoTest::Stage stage(120, 90);
  Fill(stage.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  stage.Window->Render();
  RELIEVO_CHECK(frame->GetStage("gbuffer")->GetReasonCode() == "not_asked");
  frame->RequestLayer("depth");
  for (int i = 0; i < 8; ++i)
  {
    stage.Window->Render();
    stage.Window->WaitForCompletion();
  }
  const std::string report = frame->GetFrameReport();
  RELIEVO_CHECK(report.find("\"name\": \"gbuffer\", \"ran\": true") != std::string::npos);
  RELIEVO_CHECK(report.find("asked for: depth") != std::string::npos);
  {
    relievoTest::ExpectMessage expect("no such array");
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(!frame->ReadLayer("no such array", image));
    RELIEVO_CHECK(expect.Count() == 1);
  }
  frame->GetLayersStage()->EnabledOff();
  stage.Window->Render();
  RELIEVO_CHECK(frame->GetFrameReport().find("EnabledOff") != std::string::npos);
  RELIEVO_CHECK(frame->GetBytesHeld() == 0);
  vtkRelievoPass::Detach(stage.Renderer);
}

// The times of late frames, in a large window and then in a small one.
void TestTimes()
{
  relievoTest::Stage stage(1200, 900);
  Fill(stage.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->RequestLayer("depth");
  for (int i = 0; i < 2; ++i)
  {
    if (i == 1)
    {
      stage.Window->SetSize(60, 45);
    }
    frame->GetFrameReport(); // software OpenGL is timed only after times have been read
    for (int j = 0; j < 8; ++j)
    {
      relievoTest::RenderAndFinish(stage.Window);
    }
    const std::string report = frame->GetFrameReport();
    const relievoTest::FrameTimes times(report);
    RELIEVO_CHECK_THAT(times.Judge().empty(), times.Judge() + "\n" + report);
    RELIEVO_CHECK(times.Stages.size() == 2 && times.Frame > 0.0);
  }
  vtkRelievoPass::Detach(stage.Renderer);
}

// Picking does not depend on Relievo.
void TestSelection()
{
  relievoTest::Stage stage(120, 90);
  Fill(stage.Renderer);
  auto count = [&]() {
    stage.Window->Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(stage.Renderer);
    selector->SetArea(0, 0, 119, 89);
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
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->RequestLayer("cell");
  const vtkIdType attached = count();
  RELIEVO_CHECK_THAT(before > 10 && attached == before,
    "cells picked: " + std::to_string(before) + ", attached " + std::to_string(attached));
  vtkRelievoPass::Detach(stage.Renderer);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testToggle)
{
  relievoTest::Session session;
  TestChains();
  TestMultisampled();
  TestCycles();
  TestMessagesAndReport();
  TestTimes();
  TestSelection();
  return session.Result();
}
}
