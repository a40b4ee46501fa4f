// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner of shadows from frame to frame: soft shadows are planned once for all of their
// samples, frames with a new plan have a measured time as well, and a capture or a certificate
// preserves the picture's time; and the expected error of exact shadows far away.
#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkDiskSource.h>
#include <vtkMapper.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <cmath>
#include <iostream>
#include <string>

namespace testShadowPlannerFrames
{
namespace
{
using Pass = vtkRelievoShadowStage;
using relievoTest::ShadowStage;

struct Things : ShadowStage
{
  vtkSmartPointer<vtkActor> Box;

  Things()
    : ShadowStage(480, 360) // in smaller pictures rays are the fastest
  {
    this->AddThings();
    this->Box = this->AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
    this->AddSun(-3., 4., -2.);
    this->GetFrame()->ShadowsOn();
  }

  void MovePoints()
  {
    vtkPolyData* data = vtkPolyDataMapper::SafeDownCast(this->Box->GetMapper())->GetInput();
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      data->GetPoint(i, p);
      data->GetPoints()->SetPoint(i, p[0] - 0.01, p[1], p[2]);
    }
    data->GetPoints()->Modified();
  }
};

// A wide sun, whose samples are further apart than the steps for new rays: the expectation stays
// that of its centre, and with it the choice.
void TestSoft(bool atOnce, double budget)
{
  constexpr int Samples = 12;
  Things hard;
  hard.GetShadows()->SetTolerance(2e-3);
  hard.Window->Render();
  const double share = hard.GetShadows()->EstimateWrongShareInView(Pass::METHOD_MAP, 1024);

  Things soft;
  Pass* shadows = soft.GetShadows();
  // Where every estimate that is a little off makes another choice.
  shadows->SetTolerance(1.2001 * share);
  shadows->SetTimeBudget(budget);
  shadows->SetSunAngle(40.);
  shadows->SetSoftSamples(Samples);
  shadows->SetSoftAtOnce(atOnce);
  for (int sample = 0; sample < (atOnce ? 2 : Samples); ++sample)
  {
    soft.Window->Render();
    const std::string what = "soft, sample " + std::to_string(sample);
    RELIEVO_CHECK_THAT(
      shadows->GetMethodUsed() == Pass::METHOD_MAP && shadows->GetMapSizeUsed() == 1024,
      what + ": " + shadows->GetPlan());
    RELIEVO_CHECK_THAT(shadows->EstimateWrongShareInView(Pass::METHOD_MAP, 1024) == share,
      what + ": another share is expected");
  }
  RELIEVO_CHECK(soft.GetFrame()->GetSamplesLeft() == 0);
}

// Points that move in every frame: rays are sent in each, and its time is learned all the same.
void TestMovingPoints()
{
  Things things;
  Pass* shadows = things.GetShadows();
  shadows->SetTimeBudget(1e6);
  things.Window->Render();
  const double model = shadows->GetExpectedMilliseconds(); // of no measured frame
  for (int frame = 0; frame < 8; ++frame)
  {
    things.MovePoints();
    things.Window->Render();
  }
  RELIEVO_CHECK(shadows->GetMethodUsed() == Pass::METHOD_EXACT);
  RELIEVO_CHECK_THAT(shadows->GetExpectedMilliseconds() != model, "moving points: no time learned");
}

// Casters and eyes so far away that floats have no digits left: that is expected.
void TestFarness()
{
  struct
  {
    const char* Name;
    bool FarCaster;
    bool FarEye;
    bool Rounded;
  } const cases[] = { { "near", false, false, false }, { "a caster far away", true, false, false },
    { "an eye far away", false, true, false }, { "rounded corners", false, false, true } };
  for (const auto& one : cases)
  {
    ShadowStage stage(240, 180, 1., one.Rounded ? glm::dvec3(3e4, -3e4, 0.) : glm::dvec3(0.));
    stage.AddThings();
    for (int i = 0; one.Rounded && i < stage.Renderer->GetActors()->GetNumberOfItems(); ++i)
    {
      auto* actor = vtkActor::SafeDownCast(stage.Renderer->GetActors()->GetItemAsObject(i));
      vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper())
        ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    }
    if (one.FarCaster)
    {
      stage.AddBox({ 3e4, 4e4, 2e4 }, { 1., 0.1, 1. });
    }
    stage.AddSun(3., 4., 2.);
    if (one.FarEye)
    {
      vtkCamera* camera = stage.Renderer->GetActiveCamera();
      camera->SetPosition(2.5e3, 2.5e3 + 0.5, 6e3);
      camera->SetViewAngle(0.03);
      camera->SetClippingRange(5e3, 9e3);
    }
    Pass* shadows = stage.GetShadows();
    shadows->SetMethodToExact();
    const relievoTest::ShadowErrors errors = relievoTest::JudgeShadow(stage, 0);
    const double share = shadows->EstimateWrongShareInView(Pass::METHOD_EXACT, 1);
    std::cout << one.Name << ": expected " << share << ", " << errors.ToString() << "\n";
    RELIEVO_CHECK_AT_MOST(errors.Wrong() / share, 1.5, std::string(one.Name) + ": wrong pixels");
    RELIEVO_CHECK((share == 2e-5) == !(one.FarCaster || one.FarEye || one.Rounded));
    const std::string report = stage.GetFrame()->GetFrameReport();
    const std::string key = "\"expected_wrong_share\": ";
    const double reported = std::stod(report.substr(report.find(key) + key.size()));
    RELIEVO_CHECK_NEAR(reported, share, 1e-5 * share, std::string(one.Name) + ": reported");
    auto* certificate = shadows->Certify(100000);
    RELIEVO_CHECK(certificate && certificate->GetJudged() > 20000);
    RELIEVO_CHECK_AT_MOST(certificate ? certificate->GetWrongShare() : 1., share,
      std::string(one.Name) + ": certified share of wrong verdicts");
    RELIEVO_CHECK_AT_MOST(share, 2e-3, std::string(one.Name) + ": what is expected");
  }
}

// A lamp over a hole. As wide as the lamp's cone its rim is no edge: no pixel beyond it is judged.
void TestCone()
{
  for (const double width : { 1.0002, 0.7 }) // of the cone
  {
    ShadowStage stage(60, 45); // few pixels, so that many are at the rim
    stage.AddGround();
    const double angle = 10.;
    stage.AddLamp({ 0., 8., 0. }, { 0., 0., 0. }, angle);
    vtkNew<vtkDiskSource> disk;
    disk->SetInnerRadius(width * std::tan(angle * 3.14159265358979 / 180.));
    disk->SetOuterRadius(5.);
    disk->SetCircumferentialResolution(360);
    disk->Update();
    const auto actor = relievoTest::AddActor(stage.Renderer, disk->GetOutput());
    actor->RotateX(90.);
    actor->SetPosition(0., 7., 0.);
    Pass* shadows = stage.GetShadows();
    shadows->SetMethodToExact();
    stage.GetFrame()->ShadowsOn();
    stage.Window->Render();
    const double share = shadows->EstimateWrongShareInView(Pass::METHOD_EXACT, 1);
    std::cout << "hole of " << width << " cones: expected " << share << "\n";
    RELIEVO_CHECK((share == 2e-5) == (width > 1.));
  }
}

void TestTimeTaken()
{
  Things things;
  Pass* shadows = things.GetShadows();
  shadows->SetTolerance(1e-3);
  things.Window->Render();
  const double taken = shadows->GetMillisecondsTaken();
  RELIEVO_CHECK(taken > 0.);
  relievoTest::CaptureShadow(things, 0);
  RELIEVO_CHECK_THAT(shadows->GetMillisecondsTaken() == taken, "lost by a capture");
  RELIEVO_CHECK(shadows->Certify(100));
  RELIEVO_CHECK_THAT(shadows->GetMillisecondsTaken() == taken, "lost by a certificate");
  const std::string report = things.GetFrame()->GetFrameReport();
  RELIEVO_CHECK_THAT(report.find("\"frame_ms\": null") == std::string::npos, "lost by the report");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowPlannerFrames)
{
  relievoTest::Session session;
  for (const double budget : { 0., 1e6 })
  {
    TestSoft(false, budget);
    TestSoft(true, budget);
  }
  TestMovingPoints();
  TestTimeTaken();
  TestFarness();
  TestCone();
  return session.Result();
}
}
