// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoSampleStage against its closed form, and unchanged pictures when it is off.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoSampleStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace testSampleStage
{
namespace
{
// A white square without light at depth 3, on blue; seen from near 1 to far 5.
struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  Scene()
  {
    vtkNew<vtkPlaneSource> plane;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
    this->Renderer->SetBackground(0.0, 0.0, 1.0);
    this->Window = relievoTest::MakeWindow(61, 61, this->Renderer);
    this->Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 3.0);
    this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 5.0);
  }

  vtkSmartPointer<vtkImageData> Picture() { return relievoTest::Picture(this->Window); }
};

void CheckPixel(vtkImageData* picture, int x, int y, const int expected[3], const std::string& what)
{
  const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
  for (int i = 0; i < 3; ++i)
  {
    RELIEVO_CHECK_NEAR(pixel[i], expected[i], 1., what + ", component " + std::to_string(i));
  }
}

bool SamePicture(vtkImageData* a, vtkImageData* b)
{
  return a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
    std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), 3 * a->GetNumberOfPoints()) == 0;
}

void TestStage()
{
  Scene scene;
  relievoTest::GLCheck gl(scene.Window);
  vtkSmartPointer<vtkImageData> plain = scene.Picture();

  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkNew<vtkRelievoSampleStage> stage;
  frame->AddStage(stage);
  stage->SetColor(1.0, 0.0, 0.0);
  stage->SetStrength(0.8);
  vtkSmartPointer<vtkImageData> faded = scene.Picture();
  // Depth 3 is half the way from 1 to 5: in linear light 0.4 of red over 0.6 of white, whose sRGB
  // value is 1.055 * 0.6 ^ (1 / 2.4) - 0.055 = 0.7977. Nothing has no depth.
  const int white[3] = { 255, 203, 203 };
  const int blue[3] = { 0, 0, 255 };
  CheckPixel(faded, 30, 30, white, "the square");
  CheckPixel(faded, 1, 1, blue, "the background");
  RELIEVO_CHECK(stage->GetReasonCode() == "ran");
  RELIEVO_CHECK(frame->GetBytesHeld() > 0);

  // By name and in words it is the same stage; a second one of the same name takes its place.
  RELIEVO_CHECK(frame->GetStage("sample") == stage.GetPointer());
  RELIEVO_CHECK(stage->GetParameter("strength") == "0.8");
  RELIEVO_CHECK(stage->TrySetParameter("color", "1,0,0").empty());
  RELIEVO_CHECK(!stage->TrySetParameter("strength", "2").empty());
  RELIEVO_CHECK(SamePicture(faded, scene.Picture()));

  stage->SetStrength(0.0);
  RELIEVO_CHECK(SamePicture(plain, scene.Picture()));
  RELIEVO_CHECK(frame->GetBytesHeld() == 0);
  RELIEVO_CHECK(stage->GetReasonCode() == "idle");
  stage->SetStrength(0.8);
  RELIEVO_CHECK(SamePicture(faded, scene.Picture()));
  stage->EnabledOff();
  RELIEVO_CHECK(SamePicture(plain, scene.Picture()));
  RELIEVO_CHECK(vtkRelievoPass::Detach(scene.Renderer));
  gl.Poll("end of the test");
}
}

RELIEVO_TEST_CASE(testSampleStage)
{
  relievoTest::Session session;
  TestStage();
  return session.Result();
}
}
