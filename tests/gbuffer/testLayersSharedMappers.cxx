// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A surface and its wire frame that share a mapper have the same layers as with a mapper each, in
// whichever order they are drawn, and whatever was drawn before: both, one of them, other widths.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>

#include <string>
#include <vector>

namespace
{
using relievoTest::Layers;
using relievoTest::Stage;

const std::vector<std::string> Names = { "depth", "normal", "geometric_normal", "actor", "cell" };

struct Step
{
  const char* Name;
  bool Surface;
  bool Wires;
  float Width;
};

const Step Steps[] = {
  { "both", true, true, 3.F },
  { "both again", true, true, 3.F },
  { "the surface alone", true, false, 3.F },
  { "the wires alone", false, true, 3.F },
  { "the surface alone after the wires", true, false, 3.F },
  { "thin lines", true, true, 1.F },
  { "wide lines again", true, true, 3.F },
  { "in the end the surface alone", true, false, 3.F },
};

struct Scene
{
  Stage Shown{ 240, 200 };
  vtkSmartPointer<vtkActor> Surface;
  vtkSmartPointer<vtkActor> Wires;
  vtkRelievoPass* Frame;

  Scene(bool shared, bool wiresFirst)
  {
    auto ball = relievoTest::MakeBall(1.);
    vtkRenderer* renderer = this->Shown.Renderer;
    auto first = relievoTest::AddActor(renderer, ball);
    auto second = relievoTest::AddActor(renderer, ball);
    if (shared)
    {
      second->SetMapper(first->GetMapper());
    }
    this->Wires = wiresFirst ? first : second;
    this->Surface = wiresFirst ? second : first;
    this->Wires->GetProperty()->SetRepresentationToWireframe();
    renderer->GetActiveCamera()->SetFocalPoint(0., 0., 0.);
    renderer->GetActiveCamera()->SetPosition(2.5, 2., 3.5);
    renderer->ResetCameraClippingRange();
    this->Frame = vtkRelievoPass::Attach(renderer);
    for (const std::string& name : Names)
    {
      this->Frame->RequestLayer(name);
    }
  }

  Layers Draw(const Step& step)
  {
    this->Surface->SetVisibility(step.Surface);
    this->Wires->SetVisibility(step.Wires);
    this->Wires->GetProperty()->SetLineWidth(step.Width);
    this->Shown.Window->Render();
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(this->Frame->ReadLayers(Names, image));
    return Layers(image);
  }
};

void Test(bool wiresFirst)
{
  Scene shared(true, wiresFirst);
  const relievoTest::GLCheck gl(shared.Shown.Window);
  for (const Step& step : Steps)
  {
    const Layers found = shared.Draw(step);
    Scene apart(false, wiresFirst);
    const Layers expected = apart.Draw(step);
    const std::string what =
      std::string(step.Name) + (wiresFirst ? ", wires first: " : ", surface first: ");
    for (const std::string& name : Names)
    {
      RELIEVO_CHECK_AT_MOST(
        relievoTest::CountDifferent(expected, found, name), 0, what + "pixels of " + name);
    }
    const vtkIdType wires = wiresFirst ? 0 : 1;
    RELIEVO_CHECK((found.CountId("actor", wires) > 500) == step.Wires);
    RELIEVO_CHECK((found.CountId("actor", 1 - wires) > 500) == step.Surface);
  }
}
}

//------------------------------------------------------------------------------
int main()
{
  relievoTest::Session session;
  Test(false);
  Test(true);
  return session.Result();
}
