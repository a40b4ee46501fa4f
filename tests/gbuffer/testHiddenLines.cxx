// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's hidden line removal draws wire frames last, and before that as surfaces into the depth
// buffer alone. The layers show the lines that the picture shows, and no others.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>

#include <cmath>

namespace testHiddenLines
{
namespace
{
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;

const std::vector<std::string> Names = { "depth", "normal" };

void Unlit(vtkActor* actor)
{
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1., 1., 1.);
}

// White on black: pixels shown in the picture are those with a depth.
void Check(const Layers& layers, vtkImageData* picture, bool removed, const std::string& what)
{
  vtkDataArray* colors = picture->GetPointData()->GetScalars();
  long long shown = 0;
  long long unlike = 0;
  long long far = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const double depth = layers.Value("depth", x, y);
      const bool white =
        colors->GetComponent(static_cast<vtkIdType>(y) * layers.Width + x, 0) > 127.;
      shown += white;
      unlike += white != std::isfinite(depth);
      // Behind the centre of the ball: the eye is 7 before it, the ball's radius 0.8.
      far += std::isfinite(depth) && depth > 7.;
    }
  }
  RELIEVO_CHECK(shown > 800);
  RELIEVO_CHECK_AT_MOST(unlike, 0, what + ": pixels shown without a depth, or not shown with one");
  RELIEVO_CHECK_THAT(
    removed == (far == 0), what + ": " + std::to_string(far) + " pixels of lines on the far side");
}

void Test(bool removal, bool wireFrameFirst, bool share)
{
  const Stage stage(240, 180);
  stage.Renderer->GetActiveCamera()->SetPosition(0., 0., 7.);
  stage.Renderer->GetActiveCamera()->SetFocalPoint(0., 0., 0.);
  stage.Renderer->SetUseHiddenLineRemoval(removal);
  const auto wires = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(0.8));
  wires->GetProperty()->SetRepresentationToWireframe();
  Unlit(wires);
  const auto box = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBox(0.4, 0.4, 0.4));
  box->SetPosition(1.2, 0., 0.5);
  Unlit(box);
  if (!wireFrameFirst)
  {
    stage.Renderer->RemoveActor(wires);
    stage.Renderer->AddActor(wires);
  }
  const std::string what = std::string(removal ? "removal" : "no removal") +
    (wireFrameFirst ? ", wire frame first" : ", wire frame last") +
    (share ? ", in the picture's pass" : ", in a pass of its own");
  const auto before = Picture(stage.Window);
  const relievoTest::GLCheck gl(stage.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->GetLayersStage()->SetShareGeometryPass(share);
  frame->GetLayersStage()->RefineDepthOff();
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  for (int i = 0; i < 2; ++i)
  {
    relievoTest::SamePicture(before, Picture(stage.Window), what);
    RELIEVO_CHECK_THAT(
      frame->GetLayersStage()->GetShared() == share, what + ": " + frame->GetFrameReport());
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(frame->ReadLayers(Names, image));
    Check(Layers(image), before, removal, what);
  }
  vtkRelievoPass::Detach(stage.Renderer);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", detached");
  const Layers alone(stage.Renderer, Names, relievoTest::Way::Own,
    [](vtkRelievoLayersStage* gbuffer) { gbuffer->RefineDepthOff(); });
  Check(alone, before, removal, what + ", captured");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testHiddenLines)
{
  relievoTest::Session session;
  for (const bool removal : { false, true })
  {
    for (const bool first : { false, true })
    {
      for (const bool share : { false, true })
      {
        Test(removal, first, share);
      }
    }
  }
  return session.Result();
}
}
