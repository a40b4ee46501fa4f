// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cases that deferred shading leaves to VTK and reports; with every chain of passes, with effects
// on the linear colour, with multisampling, off and on again.
#include "Check.h"
#include "DeferredScenes.h"
#include "GLCheck.h"
#include "ImageCompare.h"
#include "Layers.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoSoftwareOpenGL.h>
#include <vtkRelievoToneStage.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAOPass.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#if __has_include(<vtkToneMappingPass.h>)
#include <vtkToneMappingPass.h>
#endif

#include <functional>
#include <string>

namespace testDeferredLimits
{
namespace
{
using namespace relievoTest;
using Set = std::function<void(DeferredScene&)>;

vtkProperty* Shiny(DeferredScene& scene)
{
  vtkProperty* property = scene.Actors[0]->GetProperty();
  property->SetInterpolationToPBR();
  property->SetMetallic(0.5);
  property->SetRoughness(0.3);
  return property;
}

// VTK lights the first actor, the frame says why, and the picture is VTK's.
void TestLeft(const char* what, const char* words, const Set& set)
{
  DeferredScene scene(120, 90);
  scene.AddLight()->SetIntensity(0.9);
  set(scene);
  RELIEVO_CHECK_AT_MOST(scene.CompareWithVTK(what), 1, std::string(what) + ": levels");
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");
  RELIEVO_CHECK(scene.Stage->GetReason().find(words) != std::string::npos);
  RELIEVO_CHECK(scene.Stage->GetNumberLeft() == 1);
  RELIEVO_CHECK(scene.Stage->GetNumberDeferred() == 3);
}

void TestAllLeft()
{
  TestLeft("shader code", "has shader code of its own", [](DeferredScene& s) {
    s.Actors[0]->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
      "//VTK::Light::Impl\n  gl_FragData[0].r = 1.0 - gl_FragData[0].r;\n", false);
  });
  TestLeft("clear coat", "has a clear coat or anisotropy",
    [](DeferredScene& s) { Shiny(s)->SetCoatStrength(0.8); });
  TestLeft("refraction", "has an index of refraction other than 1.5",
    [](DeferredScene& s) { Shiny(s)->SetBaseIOR(2.0); });
  TestLeft(
    "edge tint", "or an edge tint", [](DeferredScene& s) { Shiny(s)->SetEdgeTint(0.2, 1.0, 0.4); });
  TestLeft(
    "mirrored", "is mirrored", [](DeferredScene& s) { s.Actors[0]->SetScale(-1.0, 1.0, 1.0); });
}

// Props drawn over surfaces without replacing them: the surfaces must be lit before.
void TestNothingLeft(const char* what, const char* words, const Set& set)
{
  DeferredScene scene(120, 90);
  scene.AddLight();
  set(scene);
  RELIEVO_CHECK(scene.CompareWithVTK(what) == 0);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle");
  RELIEVO_CHECK(scene.Stage->GetReason().find(words) != std::string::npos);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
}

void TestBlended()
{
  // The last actor is drawn over the others.
  TestNothingLeft("forced opaque", "forced to be drawn among the opaque", [](DeferredScene& s) {
    s.Actors[3]->SetPosition(0.0, 0.0, 2.5);
    s.Actors[3]->GetProperty()->SetOpacity(0.4);
    s.Actors[3]->ForceOpaqueOn();
  });
  TestNothingLeft("splats", "Gaussian splats", [](DeferredScene& s) {
    vtkNew<vtkPointGaussianMapper> splats;
    splats->SetInputConnection(s.Actors[0]->GetMapper()->GetInputConnection(0, 0));
    splats->SetScaleFactor(0.1);
    s.Actors[0]->SetMapper(splats);
    s.Renderer->RemoveActor(s.Actors[0]);
    s.Renderer->AddActor(s.Actors[0]);
  });
}

// Two renderers whose lights differ share a program; the picture is the same however often drawn.
void TestTwoRenderers()
{
  DeferredScene scene(160, 90);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkLight* first = scene.AddLight();
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->AutomaticLightCreationOff();
  // VTK's own shaders differ: where they do not, its own lights are the other renderer's.
  scene.SetTexture(2);
  scene.Renderer->RemoveActor(scene.Actors[2]);
  other->AddActor(scene.Actors[2]);
  other->SetActiveCamera(scene.Renderer->GetActiveCamera());
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-3.0, 1.0, 4.0);
  light->SetDiffuseColor(1.0, 0.4, 0.2);
  other->AddLight(light);
  scene.Window->AddRenderer(other);
  const auto both = [&](bool on) {
    scene.Frame->SetDeferred(on);
    vtkRelievoPass::Attach(other)->SetDeferred(on);
    Picture(scene.Window);
    first->Modified();
    Picture(scene.Window);
    return Picture(scene.Window);
  };
  const auto own = both(false);
  RELIEVO_CHECK_AT_MOST(GetLargestDifference(both(true), own), 1, "two renderers: levels");
}

// Nothing is deferred where the layers cannot be written along.
void TestMultisampling()
{
  DeferredScene scene(120, 90);
  scene.AddLight();
  scene.Window->SetMultiSamples(8);
  RELIEVO_CHECK(scene.CompareWithVTK("8 samples") == 0);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle");
  RELIEVO_CHECK(scene.Stage->GetReason().find("VTK lights all surfaces, since") == 0);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Window->SetMultiSamples(0);
  RELIEVO_CHECK(scene.CompareWithVTK("no samples") <= 1);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");
}

template <typename Pass>
void TestChain(const char* name)
{
  DeferredScene scene(120, 90);
  scene.AddLight();
  vtkNew<Pass> pass;
  pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  scene.Frame->SetDelegatePass(pass);
  // FXAA blends by contrast: a difference of one level in its input becomes up to four.
  RELIEVO_CHECK_AT_MOST(scene.CompareWithVTK(name), 4, std::string(name) + ": levels");
}

void TestPicture(const char* name, const Set& set, int levels = 1)
{
  DeferredScene scene(120, 90);
  scene.AddLight();
  set(scene);
  RELIEVO_CHECK_AT_MOST(scene.CompareWithVTK(name), levels, std::string(name) + ": levels");
  RELIEVO_CHECK(scene.Stage->GetNumberDeferred() > 0);
}

void TestCombinations()
{
  TestChain<vtkSSAOPass>("vtkSSAOPass");
  TestChain<vtkOpenGLFXAAPass>("vtkOpenGLFXAAPass");
#if __has_include(<vtkToneMappingPass.h>)
  TestChain<vtkToneMappingPass>("vtkToneMappingPass");
#endif
  const auto glass = [](DeferredScene& s) { s.Actors[1]->GetProperty()->SetOpacity(0.5); };
  TestPicture("translucent", glass);
  TestPicture("peeled", [&](DeferredScene& s) {
    glass(s);
    s.Renderer->UseDepthPeelingOn();
  });
  TestPicture(
    "FXAA", [](DeferredScene& s) { s.Renderer->UseFXAAOn(); }, 4);
  TestPicture("tone", [](DeferredScene& s) { s.Frame->GetToneStage()->EnabledOn(); });
  TestPicture("gradient", [](DeferredScene& s) {
    s.Renderer->GradientBackgroundOn();
    s.Renderer->SetBackground2(0.9, 0.5, 0.1);
  });
}

// The linear colour is the same but for the surfaces' 9 bits and the rounding to halves.
void TestLinear()
{
  DeferredScene scene(120, 90);
  scene.AddLight()->SetIntensity(3.0);
  const auto read = [&](bool deferred) {
    scene.Stage->SetEnabled(deferred);
    scene.Frame->RequestLayer("color");
    scene.Window->Render();
    const auto image = vtkSmartPointer<vtkImageData>::New();
    scene.Frame->ReadLayer("color", image);
    return Layers(image);
  };
  const Layers own = read(false);
  const Layers deferred = read(true);
  double worst = 0.0;
  double most = 0.0;
  for (int y = 0; y < own.Height; ++y)
  {
    for (int x = 0; x < own.Width; ++x)
    {
      for (int c = 0; c < 4; ++c)
      {
        const double expected = own.Value("color", x, y, c);
        worst = std::max(
          worst, std::abs(deferred.Value("color", x, y, c) - expected) / (0.02 + expected));
        most = std::max(most, expected);
      }
    }
  }
  RELIEVO_CHECK(most > 2.0);
  RELIEVO_CHECK_AT_MOST(worst, 0.02, "linear colour: relative difference");
}

void TestToggles()
{
  DeferredScene scene(120, 90);
  scene.AddLight();
  const GLCheck gl(scene.Window);
  const auto own = Picture(scene.Window);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "off");
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Stage->EnabledOn();
  const auto deferred = Picture(scene.Window);
  const vtkIdType bytes = scene.Frame->GetBytesHeld();
  // Depth, normal and colour: in textures of two words and one, or in one of four words.
  RELIEVO_CHECK(bytes == 120 * 90 * (vtkRelievoIsSoftwareOpenGL() ? 12 : 16));
  for (int i = 0; i < 100; ++i)
  {
    scene.Stage->SetEnabled(i % 2 == 0);
    scene.Window->Render();
    RELIEVO_CHECK(scene.Frame->GetBytesHeld() == (i % 2 == 0 ? bytes : 0));
  }
  RELIEVO_CHECK(SamePicture(own, Picture(scene.Window), "off again"));
  scene.Stage->EnabledOn();
  RELIEVO_CHECK(SamePicture(deferred, Picture(scene.Window), "on again"));
  // Layers alone: nothing to light.
  scene.Frame->LayersOnlyOn();
  scene.Frame->RequestLayer("depth");
  scene.Window->Render();
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "not_asked");
  scene.Frame->LayersOnlyOff();
  RELIEVO_CHECK(SamePicture(deferred, Picture(scene.Window), "after layers alone"));
}
}

RELIEVO_TEST_CASE(testDeferredLimits)
{
  relievoTest::Session session;
  TestAllLeft();
  TestBlended();
  TestTwoRenderers();
  TestMultisampling();
  TestCombinations();
  TestLinear();
  TestToggles();
  return session.Result();
}
}
