// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shaders that no longer compile with Relievo's text: here a user's replacement uses one of its
// names. Their props are drawn as in VTK without Relievo; one message reports it.
#include "Check.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkShaderProperty.h>

#include <cmath>

namespace testShaderFailures
{
namespace
{
using relievoTest::ExpectMessage;
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;

struct Case
{
  const char* Name;
  const char* Taken; // a declaration that the stage's text makes as well
  bool Shadows;
  const char* Message;
};

const Case Cases[] = {
  { "layers",
    "uint relievoPackDepth(float depth, bool parallel, float zNear, float zFar)"
    " { return uint(0); }\n",
    false, "No layers of geometry drawn by " },
  { "shadows", "bool relievoShadowSees(vec3 place) { return false; }\n", true,
    "No shadows on surfaces drawn by " },
};

void Test(const Case& c, bool early, bool last)
{
  const std::string what =
    std::string(c.Name) + (early ? ", replaced before VTK's own" : ", replaced after VTK's own");
  const Stage stage(200, 140);
  const auto good = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(0.5));
  good->SetPosition(-0.6, 0.6, 0.);
  const auto bad = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(0.5));
  bad->SetPosition(0.6, 0.6, 0.);
  bad->GetProperty()->SetColor(0.9, 0.5, 0.2);
  vtkNew<vtkLight> sun;
  sun->SetPosition(0., 1., 9.);
  sun->PositionalOff();
  stage.Renderer->AddLight(sun);
  // Before or after VTK's own replacements; a tag that VTK leaves where it is.
  bad->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Output::Dec", early, std::string("//VTK::Output::Dec\n") + c.Taken, false);
  const auto picture = Picture(stage.Window);
  {
    ExpectMessage expect(c.Message);
    vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
    frame->SetShadows(c.Shadows);
    frame->GetShadowStage()->SetPropReceives(good, false);
    if (!c.Shadows)
    {
      frame->RequestLayer("depth");
      frame->RequestLayer("normal");
    }
    for (int i = 0; i < 3; ++i)
    {
      relievoTest::SamePicture(picture, Picture(stage.Window), what);
      if (!c.Shadows)
      {
        vtkNew<vtkImageData> image;
        RELIEVO_CHECK(frame->ReadLayers({ "depth", "normal" }, image));
        const Layers layers(image);
        const long long covered = layers.Covered();
        RELIEVO_CHECK_THAT(covered > 1000, what + ": the other actor has its layers");
        bad->VisibilityOff();
        Picture(stage.Window);
        RELIEVO_CHECK(frame->ReadLayers({ "depth", "normal" }, image));
        RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(layers, Layers(image), "depth"), 0,
          what + ": pixels of the layers of what has none");
        bad->VisibilityOn();
      }
      bad->GetProperty()->Modified(); // its shaders are built again
    }
    RELIEVO_CHECK_AT_MOST(expect.Count(), 1, what + ": messages");
    vtkRelievoPass::Detach(stage.Renderer);
  }
  relievoTest::SamePicture(picture, Picture(stage.Window), what + ", detached");
  if (last)
  {
    bad->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    const Layers mended(stage.Renderer, { "depth" });
    RELIEVO_CHECK(mended.Covered() > 2000);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShaderFailures)
{
  relievoTest::Session session;
  for (const Case& c : Cases)
  {
    Test(c, true, false);
    Test(c, false, true);
  }
  return session.Result();
}
}
