// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoToneStage in the frame: idle it leaves no trace, depth and texts are as without it,
// multisampling, viewports, a layer that is shown, toggles, and VTK's own tone mapping.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "ToneScene.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSequencePass.h>
#include <vtkSphereSource.h>
#if __has_include(<vtkToneMappingPass.h>)
#include <vtkToneMappingPass.h>
#endif

#include <string>

namespace testToneFrame
{
namespace
{
using relievoTest::IsSame;
using relievoTest::Picture;

// A ball under a light of intensity 4, half of it brighter than 1, and glass before it.
struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  explicit Scene(int samples = 0)
  {
    for (const bool glass : { false, true })
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetThetaResolution(40);
      ball->SetPhiResolution(40);
      ball->SetCenter(glass ? 0.3 : 0.0, 0.0, glass ? 0.6 : 0.0);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(ball->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(0.9, 0.5, glass ? 0.8 : 0.2);
      actor->GetProperty()->SetOpacity(glass ? 0.4 : 1.0);
      this->Renderer->AddActor(actor);
    }
    vtkNew<vtkLight> light;
    light->SetPosition(1.0, 2.0, 3.0);
    light->SetIntensity(4.0);
    this->Renderer->AddLight(light);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Window = relievoTest::MakeWindow(120, 90, this->Renderer);
    this->Window->SetMultiSamples(samples);
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(1.5);
  }

  vtkRelievoToneStage* Attach()
  {
    vtkRelievoPass* frame = vtkRelievoPass::Attach(this->Renderer);
    auto* tone = vtkRelievoToneStage::SafeDownCast(frame->GetStage("tone"));
    RELIEVO_CHECK(!tone->GetEnabled());
    tone->EnabledOn();
    return tone;
  }

  vtkRelievoPass* GetFrame() { return vtkRelievoPass::Attach(this->Renderer); }
};

// The picture is the formula of the layer `color`, wherever it is.
void CheckPicture(Scene& scene, vtkRelievoToneStage* tone, const std::string& what)
{
  vtkRelievoPass* frame = scene.GetFrame();
  frame->RequestLayer("color");
  const auto picture = Picture(scene.Window);
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK_THAT(frame->ReadLayer("color", image), what);
  vtkDataArray* color = image->GetPointData()->GetArray("color");
  int size[4];
  scene.Renderer->GetTiledSizeAndOrigin(size, size + 1, size + 2, size + 3);
  double most = 0.0;
  double brightest = 0.0;
  for (vtkIdType i = 0; color && i < color->GetNumberOfTuples(); ++i)
  {
    const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(
      size[2] + static_cast<int>(i % size[0]), size[3] + static_cast<int>(i / size[0]), 0));
    glm::dvec3 light;
    for (int c = 0; c < 3; ++c)
    {
      light[c] = std::exp2(tone->GetUsedExposure()) * color->GetComponent(i, c);
      brightest = std::max(brightest, color->GetComponent(i, c));
    }
    const glm::dvec3 shown = 255. *
      relievo::f64::relievoSrgbColorFromLinear(
        relievo::f64::relievoTone(tone->GetOperator(), light, tone->GetWhite()));
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(most, std::abs(pixel[c] - shown[c]));
    }
  }
  RELIEVO_CHECK_AT_MOST(most, 0.501, what + ", steps of 255");
  RELIEVO_CHECK_THAT(brightest > (size[0] > 1 ? 2.0 : 0.0), what + ": highlights above 1");
  frame->ReleaseLayers();
}

void TestCombinations()
{
  for (const bool automatic : { false, true })
  {
    for (const int samples : { 0, 8 })
    {
      Scene scene(samples);
      relievoTest::GLCheck gl(scene.Window);
      vtkRelievoToneStage* tone = scene.Attach();
      tone->SetAutoExposure(automatic);
      const std::string what = std::to_string(samples) + " samples" + (automatic ? ", auto" : "");
      CheckPicture(scene, tone, what);
      scene.Renderer->SetViewport(0.25, 0.1, 0.8, 0.95);
      CheckPicture(scene, tone, what + ", viewport");
      scene.Renderer->SetViewport(0.5, 0.5, 0.5 + 1.0 / 120.0, 0.5 + 1.0 / 90.0);
      CheckPicture(scene, tone, what + ", one pixel");
      scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.Window->SetSize(33, 200);
      CheckPicture(scene, tone, what + ", resized");
      gl.Poll(what);
    }
  }
}

void TestDepth()
{
  Scene scene;
  vtkNew<vtkFloatArray> plain;
  vtkNew<vtkFloatArray> toned;
  vtkRelievoToneStage* tone = scene.Attach();
  tone->EnabledOff();
  scene.GetFrame()->RequestLayer("color"); // the plain curve presents it
  scene.Window->Render();
  scene.Window->GetZbufferData(0, 0, 119, 89, plain);
  tone->EnabledOn();
  scene.Window->Render();
  scene.Window->GetZbufferData(0, 0, 119, 89, toned);
  float least = 1.0F;
  for (vtkIdType i = 0; i < plain->GetNumberOfTuples(); ++i)
  {
    RELIEVO_CHECK(plain->GetValue(i) == toned->GetValue(i));
    least = std::min(least, toned->GetValue(i));
  }
  RELIEVO_CHECK(least < 1.0F);
}

void TestIdleAndToggles()
{
  for (const int samples : { 0, 8 })
  {
    Scene scene(samples);
    relievoTest::GLCheck gl(scene.Window);
    Picture(scene.Window);
    const auto plain = Picture(scene.Window);
    vtkRelievoToneStage* tone = scene.Attach();
    vtkRelievoPass* frame = scene.GetFrame();
    tone->SetOperatorToClamp();
    RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
    RELIEVO_CHECK(tone->GetReasonCode() == "idle");
    RELIEVO_CHECK(frame->GetBytesHeld() == 0);
    tone->SetOperatorToReinhard();
    tone->AutoExposureOn();
    tone->SetDitherToBlueNoise();
    const auto toned = Picture(scene.Window);
    const vtkIdType bytes = frame->GetBytesHeld();
    RELIEVO_CHECK(!IsSame(plain, toned) && bytes > 0);
    for (int i = 0; i < 200; ++i)
    {
      tone->SetEnabled(i % 2 == 1);
      scene.Window->Render();
      RELIEVO_CHECK(frame->GetBytesHeld() == (i % 2 == 1 ? bytes : 0));
    }
    RELIEVO_CHECK(IsSame(toned, Picture(scene.Window)));
    tone->AutoExposureOff();
    tone->SetDitherToNone();
    scene.Window->Render();
    RELIEVO_CHECK(tone->GetDrawCalls() == 1);
    tone->EnabledOff();
    RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
    RELIEVO_CHECK(frame->GetBytesHeld() == 0 && tone->GetReasonCode() == "off");
    vtkRelievoPass::Detach(scene.Renderer);
    RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
    gl.Poll("toggles");
  }
}

// A layer that surely covers leaves nothing to do; one that may not be there does not.
void TestShownLayer()
{
  Scene scene;
  vtkRelievoToneStage* tone = scene.Attach();
  vtkRelievoPass* frame = scene.GetFrame();
  const auto toned = Picture(scene.Window);
  frame->SetDisplayLayer("depth");
  const auto depth = Picture(scene.Window);
  RELIEVO_CHECK(tone->GetReasonCode() == "hidden");
  tone->EnabledOff();
  RELIEVO_CHECK(IsSame(depth, Picture(scene.Window)));
  tone->EnabledOn();
  {
    relievoTest::ExpectMessage expect("NoSuchArray");
    frame->SetDisplayLayer("NoSuchArray");
    RELIEVO_CHECK(IsSame(toned, Picture(scene.Window)));
    RELIEVO_CHECK(tone->GetReasonCode() == "ran");
  }
  frame->SetDisplayLayer(nullptr);
  frame->RequestLayer("depth");
  frame->LayersOnlyOn();
  scene.Window->Render();
  RELIEVO_CHECK(tone->GetReasonCode() == "not_asked");
}

void TestTexts()
{
  Scene scene;
  vtkNew<vtkPlaneSource> bar;
  bar->SetOrigin(10.0, 10.0, 0.0);
  bar->SetPoint1(90.0, 10.0, 0.0);
  bar->SetPoint2(10.0, 40.0, 0.0);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(bar->GetOutputPort());
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.25, 1.0, 0.5);
  scene.Renderer->AddViewProp(actor);
  const auto plain = Picture(scene.Window);
  scene.Attach()->SetExposure(-4.0);
  const auto dark = Picture(scene.Window);
  const auto at = [](vtkImageData* image, int x, int y) {
    return static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
  };
  RELIEVO_CHECK(std::equal(at(plain, 50, 25), at(plain, 50, 25) + 3, at(dark, 50, 25)));
  RELIEVO_CHECK(at(plain, 50, 25)[1] == 255);
  RELIEVO_CHECK(at(dark, 5, 80)[2] < at(plain, 5, 80)[2]);
}

#if __has_include(<vtkToneMappingPass.h>)
// Both would map tones: said once, and the picture is VTK's. Where the pass is the delegate, within
// it, and around the frame.
void TestTwice()
{
  for (int where = 0; where < 3; ++where)
  {
    Scene scene;
    vtkNew<vtkToneMappingPass> own;
    own->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    if (where < 2)
    {
      scene.Renderer->SetPass(own);
    }
    if (where == 1)
    {
      vtkNew<vtkRenderPassCollection> parts;
      parts->AddItem(own);
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(parts);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(sequence);
      vtkNew<vtkOpenGLFXAAPass> outer;
      outer->SetDelegatePass(camera);
      scene.Renderer->SetPass(outer);
    }
    vtkSmartPointer<vtkRelievoPass> frame = scene.GetFrame();
    if (where == 2)
    {
      own->SetDelegatePass(frame);
      scene.Renderer->SetPass(own);
    }
    const auto plain = Picture(scene.Window);
    auto* tone = vtkRelievoToneStage::SafeDownCast(frame->GetStage("tone"));
    {
      relievoTest::ExpectMessage expect("vtkToneMappingPass");
      tone->EnabledOn();
      RELIEVO_CHECK_THAT(IsSame(plain, Picture(scene.Window)), "place " + std::to_string(where));
      RELIEVO_CHECK(IsSame(plain, Picture(scene.Window)));
      RELIEVO_CHECK(expect.Count() == 1);
    }
    RELIEVO_CHECK(tone->GetReasonCode() == "refused");
    RELIEVO_CHECK(tone->GetReason().find("vtkToneMappingPass") != std::string::npos);
    RELIEVO_CHECK(frame->GetBytesHeld() == 0);
    // With nothing to do there is nothing to refuse.
    tone->SetOperatorToClamp();
    scene.Window->Render();
    RELIEVO_CHECK(tone->GetReasonCode() == "idle");
    tone->SetOperatorToReinhard();
    scene.Renderer->SetPass(nullptr);
    frame->SetDelegatePass(nullptr);
    scene.Renderer->SetPass(frame);
    scene.Window->Render();
    RELIEVO_CHECK(tone->GetReasonCode() == "ran");
    scene.Renderer->SetPass(nullptr);
    own->ReleaseGraphicsResources(scene.Window);
    frame->ReleaseGraphicsResources(scene.Window);
  }
}
#endif

#if __has_include(<vtkToneMappingPass.h>)
// Within VTK's pass, the frame draws into floats. A fog that takes no light shows that light above
// 1 arrives there unchanged, however the stage presents it.
void TestLightAboveOne()
{
  Scene scene;
  scene.Renderer->RemoveActor(scene.Renderer->GetActors()->GetLastActor()); // glass blends in sRGB
  vtkNew<vtkToneMappingPass> own;
  vtkSmartPointer<vtkRelievoPass> frame = scene.GetFrame();
  own->SetDelegatePass(frame);
  scene.Renderer->SetPass(own);
  const auto plain = Picture(scene.Window);
  vtkNew<vtkPoints> centre;
  centre->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(centre);
  vtkNew<vtkRelievoFogSpheres> fog;
  fog->SetInputData(cloud);
  fog->SetRadius(10.0);
  fog->SetDensity(1e-9);
  frame->GetFogStage()->AddPoints(fog);
  RELIEVO_CHECK(relievoTest::GetLargestDifference(plain, Picture(scene.Window)) <= 1);
  RELIEVO_CHECK(frame->GetFogStage()->GetReasonCode() == "ran");
  scene.Renderer->SetPass(nullptr);
  own->ReleaseGraphicsResources(scene.Window);
  frame->ReleaseGraphicsResources(scene.Window);
}
#endif

// The stage's parameters are set as words, by name.
void TestParameters()
{
  vtkNew<vtkRelievoPass> frame;
  vtkRelievoStage* tone = frame->GetStage("tone");
  RELIEVO_CHECK(tone->GetParameterDefault("operator") == "neutral");
  RELIEVO_CHECK(tone->TrySetParameter("operator", "reinhard_rgb").empty());
  RELIEVO_CHECK(tone->TrySetParameter("dither", "blue_noise").empty());
  RELIEVO_CHECK(tone->TrySetParameter("exposure", "-1.5").empty());
  RELIEVO_CHECK(tone->TrySetParameter("auto_exposure", "on").empty());
  RELIEVO_CHECK(!tone->TrySetParameter("white", "0").empty());
  RELIEVO_CHECK(!tone->TrySetParameter("operator", "filmic").empty());
  auto* own = vtkRelievoToneStage::SafeDownCast(tone);
  RELIEVO_CHECK(own->GetOperator() == vtkRelievoToneStage::REINHARD_RGB);
  RELIEVO_CHECK(own->GetExposure() == -1.5 && own->GetAutoExposure() && own->GetWhite() == 4.0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testToneFrame)
{
  relievoTest::Session session;
  TestCombinations();
  TestDepth();
  TestIdleAndToggles();
  TestShownLayer();
  TestTexts();
#if __has_include(<vtkToneMappingPass.h>)
  TestTwice();
  TestLightAboveOne();
#endif
  TestParameters();
  return session.Result();
}
}
