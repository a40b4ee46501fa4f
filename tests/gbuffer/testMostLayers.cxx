// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A G-buffer with as many layers as it holds, and with more.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>

#include <string>
#include <vector>

namespace testMostLayers
{
namespace
{
using relievoTest::Layers;
using relievoTest::Stage;
using G = vtkRelievoLayersStage;

// 20 words per pixel are the maximum: more are refused, with one message; the picture is unchanged.
void TestMost()
{
  const Stage fixture(200, 150);
  const auto ball = relievoTest::AddActor(fixture.Renderer, relievoTest::MakeBall(1.2));
  ball->SetPosition(0., 0.6, 0.);
  for (int i = 0; i < 23; ++i)
  {
    vtkNew<vtkLight> light;
    light->SetSwitch(i == 0);
    fixture.Renderer->AddLight(light);
  }
  const auto picture = relievoTest::Picture(fixture.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  frame->GetLayersStage()->SetNormalFormat(G::NORMAL_FLOAT32);
  std::vector<std::string> names = { "depth", "cell", "normal", "geometric_normal", "albedo" };
  for (int i = 0; i < 22; ++i)
  {
    names.push_back("shadow_" + std::to_string(i));
  }
  for (const std::string& name : names)
  {
    frame->RequestLayer(name);
  }
  for (const bool shares : { true, false })
  {
    frame->GetLayersStage()->SetShareGeometryPass(shares);
    relievoTest::SamePicture(picture, relievoTest::Picture(fixture.Window), "20 words");
    vtkNew<vtkImageData> image;
    for (const std::string& name : names)
    {
      RELIEVO_CHECK(frame->ReadLayer(name, image));
    }
    const Layers layers(image);
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(
                            layers, Layers(fixture.Renderer, { "depth", "albedo" }), "albedo"),
      0, "20 words: pixels of another albedo");
    double range[2];
    layers.Image->GetPointData()->GetArray("shadow_21")->GetRange(range);
    RELIEVO_CHECK_THAT(range[0] == 1., "20 words: the last is not written");
  }
  frame->RequestLayer("shadow_22");
  relievoTest::ExpectMessage expect("21 words");
  for (int i = 0; i < 3; ++i)
  {
    relievoTest::SamePicture(picture, relievoTest::Picture(fixture.Window), "21 words");
  }
  RELIEVO_CHECK_THAT(expect.Count() == 1, "21 words: not said once");
  {
    relievoTest::ExpectMessage unread("cannot be read");
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(!frame->ReadLayer("depth", image));
  }
  frame->GetLayersStage()->SetNormalFormat(G::NORMAL_AUTO);
  fixture.Window->Render();
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(frame->ReadLayer("shadow_22", image));
  // The layer of a missing light is refused when read, others are unaffected.
  frame->RequestLayer("shadow_23");
  frame->ReleaseLayer("shadow_0");
  fixture.Window->Render();
  RELIEVO_CHECK(frame->ReadLayer("shadow_22", image) && frame->ReadLayer("depth", image));
  {
    relievoTest::ExpectMessage unread("shadow_23");
    RELIEVO_CHECK(!frame->ReadLayer("shadow_23", image));
  }
  vtkRelievoPass::Detach(fixture.Renderer);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMostLayers)
{
  relievoTest::Session session;
  TestMost();
  return session.Result();
}
}
