// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The linear colour: its values against the closed form, unclamped; the picture that is made of it
// against VTK's own; beside multisampling, peeling, FXAA, SSAO, VTK's passes, layers of renderers,
// viewports and texts.
#include "Check.h"
#include "ColorStage.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRelievoFormulas.h>
#include <vtkRelievoPass.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkSphereSource.h>
#if __has_include(<vtkToneMappingPass.h>)
#include <vtkToneMappingPass.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace testFrameColor
{
namespace
{
using relievoTest::ColorStage;
using relievoTest::Picture;

vtkSmartPointer<vtkActor> Add(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkActor> Ball, Wall, Glass;

  explicit Scene(int samples = 0)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(40);
    ball->SetPhiResolution(40);
    this->Ball = Add(this->Renderer, ball);
    this->Ball->GetProperty()->SetColor(0.9, 0.5, 0.2);
    this->Ball->GetProperty()->SetSpecular(0.05);
    vtkNew<vtkPlaneSource> wall;
    wall->SetOrigin(-2.0, -2.0, -0.8);
    wall->SetPoint1(2.0, -2.0, -0.8);
    wall->SetPoint2(-2.0, 2.0, -0.8);
    this->Wall = Add(this->Renderer, wall);
    vtkNew<vtkSphereSource> glass;
    glass->SetCenter(0.3, 0.2, 0.5);
    glass->SetRadius(0.4);
    this->Glass = Add(this->Renderer, glass);
    this->Glass->GetProperty()->SetOpacity(0.4);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Window = relievoTest::MakeWindow(160, 120, this->Renderer);
    this->Window->SetMultiSamples(samples);
    this->Renderer->ResetCamera(-0.7, 0.7, -0.7, 0.7, -0.7, 0.7);
  }

  void AddText()
  {
    vtkNew<vtkPlaneSource> bar;
    bar->SetOrigin(10.0, 10.0, 0.0);
    bar->SetPoint1(90.0, 10.0, 0.0);
    bar->SetPoint2(10.0, 40.0, 0.0);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputConnection(bar->GetOutputPort());
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.25, 1.0, 0.5);
    this->Renderer->AddViewProp(actor);
  }
};

// The largest difference of a byte, all but this share of the bytes.
int GetDifference(vtkImageData* a, vtkImageData* b, double butFor = 0.0)
{
  const auto* x = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* y = static_cast<unsigned char*>(b->GetScalarPointer());
  const vtkIdType count = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return 1000;
  }
  std::vector<int> differences(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    differences[i] = std::abs(x[i] - y[i]);
  }
  const auto place = static_cast<std::ptrdiff_t>((1.0 - butFor) * static_cast<double>(count - 1));
  std::nth_element(differences.begin(), differences.begin() + place, differences.end());
  return differences[place];
}

// A stage that changes nothing: the picture is VTK's but for the rounding of half floats, and when
// it goes, VTK's to the last bit.
// FXAA smooths where contrast passes a limit: half floats are on the other side of it in some
// places.
void TestSame(const std::string& what, int samples, const std::function<void(Scene&)>& change)
{
  const double butFor = what.find("FXAA") == std::string::npos ? 0.0 : 0.005;
  Scene scene(samples);
  relievoTest::GLCheck gl(scene.Window);
  change(scene);
  Picture(scene.Window);
  const auto plain = Picture(scene.Window);
  vtkNew<vtkFloatArray> z;
  scene.Window->GetZbufferData(0, 0, 159, 119, z);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  RELIEVO_CHECK_THAT(GetDifference(plain, Picture(scene.Window)) == 0, what + ": attached");
  vtkNew<ColorStage> stage;
  frame->AddStage(stage);
  const auto through = Picture(scene.Window);
  RELIEVO_CHECK_THAT(stage->Executed == 1, what + ": " + stage->GetReason());
  RELIEVO_CHECK_AT_MOST(GetDifference(plain, through, butFor), 1, what + ": levels of 255");
  RELIEVO_CHECK_THAT(GetDifference(through, Picture(scene.Window)) == 0, what + ": again");
  {
    Scene fresh(samples);
    change(fresh);
    vtkNew<ColorStage> first;
    vtkRelievoPass::Attach(fresh.Renderer)->AddStage(first);
    RELIEVO_CHECK_THAT(
      GetDifference(through, Picture(fresh.Window)) == 0, what + ": from the first frame on");
  }
  vtkNew<vtkFloatArray> after;
  scene.Window->GetZbufferData(0, 0, 159, 119, after);
  double most = 0.0;
  for (vtkIdType i = 0; i < z->GetNumberOfTuples() && samples == 0; ++i)
  {
    most = std::max<double>(most, std::abs(z->GetValue(i) - after->GetValue(i)));
  }
  // The window's z has up to 32 bits, a shader a float's 24.
  RELIEVO_CHECK_AT_MOST(most, std::pow(2.0, -23.0), what + ": window z");
  // Twice the light is not twice the value.
  stage->Factor = 2.0;
  RELIEVO_CHECK_THAT(GetDifference(through, Picture(scene.Window)) > 20, what + ": twice");
  RELIEVO_CHECK(frame->GetBytesHeld() > 0);
  frame->RemoveStage(stage);
  RELIEVO_CHECK_THAT(GetDifference(plain, Picture(scene.Window)) == 0, what + ": without");
  RELIEVO_CHECK(frame->GetBytesHeld() == 0);
  vtkRelievoPass::Detach(scene.Renderer);
  gl.Poll(what);
}

void TestCombinations()
{
  TestSame("plain", 0, [](Scene&) {});
  TestSame("multisampled", 8, [](Scene&) {});
  TestSame("parallel", 0, [](Scene& s) { s.Renderer->GetActiveCamera()->ParallelProjectionOn(); });
  TestSame("viewport", 0, [](Scene& s) { s.Renderer->SetViewport(0.25, 0.1, 0.8, 0.95); });
  TestSame("FXAA", 0, [](Scene& s) { s.Renderer->UseFXAAOn(); });
  TestSame("SSAO", 0, [](Scene& s) { s.Renderer->UseSSAOOn(); });
  TestSame("peeling", 0, [](Scene& s) {
    s.Window->SetAlphaBitPlanes(1);
    s.Renderer->UseDepthPeelingOn();
  });
  TestSame("texts", 0, [](Scene& s) { s.AddText(); });
  TestSame("PBR", 0, [](Scene& s) { s.Ball->GetProperty()->SetInterpolationToPBR(); });
  TestSame("steps pass", 0, [](Scene& s) { s.Renderer->SetPass(vtkNew<vtkRenderStepsPass>()); });
#if __has_include(<vtkToneMappingPass.h>)
  TestSame("tone mapping pass", 0, [](Scene& s) {
    vtkNew<vtkToneMappingPass> pass;
    pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    s.Renderer->SetPass(pass);
  });
#endif
  TestSame("FXAA pass", 0, [](Scene& s) {
    vtkNew<vtkOpenGLFXAAPass> pass;
    pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    s.Renderer->SetPass(pass);
  });
  TestSame("SSAO pass", 0, [](Scene& s) {
    vtkNew<vtkSSAOPass> pass;
    pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    s.Renderer->SetPass(pass);
  });
}

// Texts lie over the picture as they are, whatever stages do to the colour beneath.
void TestTexts()
{
  Scene scene;
  scene.AddText();
  const auto plain = Picture(scene.Window);
  vtkNew<ColorStage> stage;
  stage->Factor = 0.25;
  vtkRelievoPass::Attach(scene.Renderer)->AddStage(stage);
  const auto dark = Picture(scene.Window);
  const auto at = [](vtkImageData* image, int x, int y) {
    return static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
  };
  RELIEVO_CHECK(std::equal(at(plain, 50, 25), at(plain, 50, 25) + 3, at(dark, 50, 25)));
  RELIEVO_CHECK(at(plain, 50, 25)[1] == 255);
  RELIEVO_CHECK(at(dark, 130, 60)[2] < at(plain, 130, 60)[2]);
}

// A square without light: VTK gives its colour as it is, above 1 as well.
void TestValues()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkPlaneSource> plane;
  vtkSmartPointer<vtkActor> actor = Add(renderer, plane);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.5, 2.5, 0.02);
  renderer->SetBackground(0.2, 0.0, 1.0);
  auto window = relievoTest::MakeWindow(40, 30, renderer);
  relievoTest::GLCheck gl(window);
  const auto plain = Picture(window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  frame->RequestLayer("color");
  for (const bool layersOnly : { false, true })
  {
    const std::string what = layersOnly ? "layers only: " : "with the picture: ";
    frame->SetLayersOnly(layersOnly);
    window->Render();
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(frame->ReadLayer("color", image));
    vtkDataArray* color = image->GetPointData()->GetArray("color");
    if (!RELIEVO_CHECK(color && color->GetNumberOfComponents() == 4))
    {
      continue;
    }
    const double expected[2][3] = { { 0.5, 2.5, 0.02 }, { 0.2, 0.0, 1.0 } };
    const vtkIdType pixels[2] = { 15 * 40 + 20, 0 };
    for (int place = 0; place < 2; ++place)
    {
      for (int c = 0; c < 3; ++c)
      {
        // Rounded to half floats twice, before the curve and after.
        const double linear = relievo::f64::relievoLinearFromSrgb(expected[place][c]);
        RELIEVO_CHECK_NEAR(color->GetComponent(pixels[place], c), linear, 2e-3 * linear + 1e-6,
          what + "component " + std::to_string(c));
      }
    }
  }
  // The window has kept the picture that was there.
  frame->SetLayersOnly(false);
  RELIEVO_CHECK(GetDifference(plain, Picture(window)) <= 1);
  frame->ReleaseLayer("color");
  RELIEVO_CHECK(GetDifference(plain, Picture(window)) == 0);
  RELIEVO_CHECK(frame->GetBytesHeld() == 0);
  gl.Poll("values");
}

// A renderer over another: its colour begins with the existing picture.
void TestLayersOfRenderers()
{
  Scene scene;
  scene.Window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> over;
  over->SetLayer(1);
  vtkNew<vtkSphereSource> source;
  source->SetCenter(0.6, 0.0, 0.0);
  source->SetRadius(0.2);
  Add(over, source);
  scene.Window->AddRenderer(over);
  over->SetActiveCamera(scene.Renderer->GetActiveCamera());
  for (const int samples : { 0, 4 })
  {
    scene.Window->SetMultiSamples(samples);
    const std::string what = "two layers, " + std::to_string(samples) + " samples";
    const auto plain = Picture(scene.Window);
    vtkNew<ColorStage> stage;
    vtkRelievoPass::Attach(over)->AddStage(stage);
    const auto through = Picture(scene.Window);
    RELIEVO_CHECK(stage->Executed == 1);
    // Where samples are resolved before the second renderer draws, its edges blend with the mean.
    RELIEVO_CHECK_AT_MOST(GetDifference(plain, through), samples ? 2 : 1, what);
    vtkRelievoPass::Detach(over);
    over->SetPass(nullptr);
  }
  // Another's depth is not known in the float framebuffer: said, and the picture is VTK's.
  over->PreserveDepthBufferOn();
  scene.Window->SetMultiSamples(0);
  const auto plain = Picture(scene.Window);
  vtkNew<ColorStage> stage;
  stage->Factor = 3.0;
  vtkRelievoPass::Attach(over)->AddStage(stage);
  RELIEVO_CHECK(GetDifference(plain, Picture(scene.Window)) == 0);
  RELIEVO_CHECK(stage->GetReasonCode() == "refused");
  RELIEVO_CHECK(stage->GetReason().find("PreserveDepthBuffer") != std::string::npos);
}
}

RELIEVO_TEST_CASE(testFrameColor)
{
  relievoTest::Session session;
  TestValues();
  TestCombinations();
  TestTexts();
  TestLayersOfRenderers();
  return session.Result();
}
}
