// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent over lit surfaces: blend + (1 - a) (color + lamps) in double, for each of VTK's
// blending methods; volumes; groups of layers; pictures unchanged without lights on the colour.
#include "BlendScene.h"
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkDepthPeelingPass.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkOpaquePass.h>
#include <vtkOrderIndependentTranslucentPass.h>
#include <vtkOverlayPass.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

namespace testBlendStage
{
namespace
{
using namespace relievoTest;

int CountLevels(vtkImageData* a, vtkImageData* b)
{
  const auto* x = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* y = static_cast<unsigned char*>(b->GetScalarPointer());
  int most = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints() * a->GetNumberOfScalarComponents(); ++i)
  {
    most = std::max(most, std::abs(x[i] - y[i]));
  }
  return most;
}

// The linear colour and the layer against their closed forms.
void CheckBlend(BlendScene& scene, Blending blending, double limit, const std::string& what)
{
  const GLCheck gl(scene.Window);
  scene.ShowPanes(false);
  scene.Lamps->EnabledOff();
  const Layers dark = scene.Read({ "color" });
  scene.Lamps->EnabledOn();
  const Layers lit = scene.Read({ "color" });
  RELIEVO_CHECK_THAT(scene.Blend->GetBytesHeld() == 0 && scene.Blend->GetDrawCalls() == 0, what);
  scene.ShowPanes(true);
  const Layers seen = scene.Read({ "color", "blend" });
  RELIEVO_CHECK_THAT(scene.Blend->GetReasonCode() == "ran", what);
  double worst = 0.0;
  double worstLayer = 0.0;
  double lamp = 0.0; // that comes through a pane
  int panes = 0;
  for (int y = 0; y < seen.Height; ++y)
  {
    for (int x = 0; x < seen.Width; ++x)
    {
      const glm::dvec4 blend = scene.GetBlend(x, y, blending);
      const glm::dvec4 behind = GetColor(lit, "color", x, y);
      worstLayer = std::max(worstLayer, GetError(GetColor(seen, "blend", x, y), blend));
      worst = std::max(worst, GetError(GetColor(seen, "color", x, y), Over(blend, behind)));
      if (blend.a > 0.0)
      {
        ++panes;
        lamp = std::max(lamp, behind.r - dark.Value("color", x, y, 0));
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(worstLayer, limit, what + ": the layer blend");
  RELIEVO_CHECK_AT_MOST(worst, limit, what + ": linear colour");
  RELIEVO_CHECK(panes == 34 * 32 + 14 * 24 && lamp > 0.2);
}

template <typename Translucent>
vtkSmartPointer<vtkRenderPass> MakeSteps()
{
  vtkNew<Translucent> translucent;
  translucent->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(translucent);
  return vtkSmartPointer<vtkRenderPass>(steps.Get());
}

void TestWays()
{
  const auto check = [](const std::string& what, Blending blending, double limit, int samples,
                       const std::function<void(BlendScene&)>& change) {
    BlendScene scene(samples);
    change(scene);
    CheckBlend(scene, blending, limit, what);
  };
  const auto nothing = [](BlendScene&) {};
  check("renderer's own steps", Blending::Averaged, Halves, 0, nothing);
  check("8 samples", Blending::Averaged, Halves, 8, nothing);
  check("peeling", Blending::Sorted, Bytes, 0, [](BlendScene& s) {
    s.Window->SetAlphaBitPlanes(1);
    s.Renderer->UseDepthPeelingOn();
  });
  check("steps pass", Blending::Sorted, Halves, 0,
    [](BlendScene& s) { s.Frame->SetDelegatePass(vtkNew<vtkRenderStepsPass>()); });
  check("steps pass, 8 samples", Blending::Sorted, Halves, 8,
    [](BlendScene& s) { s.Frame->SetDelegatePass(vtkNew<vtkRenderStepsPass>()); });
  check("steps pass, average", Blending::Averaged, Halves, 0, [](BlendScene& s) {
    s.Frame->SetDelegatePass(MakeSteps<vtkOrderIndependentTranslucentPass>());
  });
  check("steps pass, dual peeling", Blending::Sorted, Bytes, 0,
    [](BlendScene& s) { s.Frame->SetDelegatePass(MakeSteps<vtkDualDepthPeelingPass>()); });
  check("steps pass, peeling", Blending::Sorted, Bytes, 0, [](BlendScene& s) {
    s.Window->SetAlphaBitPlanes(1);
    s.Frame->SetDelegatePass(MakeSteps<vtkDepthPeelingPass>());
  });
  check("hidden lines", Blending::Averaged, Halves, 0, [](BlendScene& s) {
    s.Renderer->UseHiddenLineRemovalOn();
    s.Wall->GetProperty()->SetRepresentationToWireframe();
    s.Wall->GetProperty()->SetLineWidth(30.0);
  });
  check("SSAO", Blending::Averaged, Halves, 0, [](BlendScene& s) { s.Renderer->UseSSAOOn(); });
  // ParaView has a camera pass around the frame.
  check("nested", Blending::Averaged, Halves, 0, [](BlendScene& s) {
    vtkNew<vtkOrderIndependentTranslucentPass> translucent;
    translucent->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(vtkNew<vtkLightsPass>());
    passes->AddItem(vtkNew<vtkOpaquePass>());
    passes->AddItem(translucent);
    passes->AddItem(vtkNew<vtkVolumetricPass>());
    passes->AddItem(vtkNew<vtkOverlayPass>());
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    s.Frame->SetDelegatePass(sequence);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(s.Frame);
    s.Renderer->SetPass(camera);
  });
}

// A volume before the panes: its layer goes over theirs. Composited in either grouping, they are
// equal.
void TestVolumes()
{
  for (const bool peeling : { false, true })
  {
    const std::string what = peeling ? "volume, peeling" : "volume";
    BlendScene scene;
    const GLCheck gl(scene.Window);
    scene.Window->SetAlphaBitPlanes(1);
    scene.Renderer->SetUseDepthPeeling(peeling);
    const Layers panes = scene.Read({ "color", "blend" });
    scene.ShowVolume(true);
    const Layers both = scene.Read({ "color", "blend" });
    scene.ShowPanes(false);
    const Layers volume = scene.Read({ "blend" });
    double worst = 0.0;
    double worstLayer = 0.0;
    int over = 0;
    for (int y = 0; y < both.Height; ++y)
    {
      for (int x = 0; x < both.Width; ++x)
      {
        const glm::dvec4 front = GetColor(volume, "blend", x, y);
        worst = std::max(worst,
          GetError(GetColor(both, "color", x, y), Over(front, GetColor(panes, "color", x, y))));
        worstLayer = std::max(worstLayer,
          GetError(GetColor(both, "blend", x, y), Over(front, GetColor(panes, "blend", x, y))));
        over += front.a > 0.2 && front.a < 0.9 && panes.Value("blend", x, y, 3) > 0.2;
      }
    }
    // Each value is rounded to a half float once or twice, which Mesa's software cuts.
    RELIEVO_CHECK_AT_MOST(worstLayer, 3.0 / 1024.0, what + ": layers first");
    RELIEVO_CHECK_AT_MOST(worst, 3.0 / 1024.0, what + ": one layer after the other");
    RELIEVO_CHECK(over > 50);
  }
}

// If nothing lights the colour, or it is not drawn, VTK blends as without Relievo.
void TestUnchanged()
{
  BlendScene scene;
  const GLCheck gl(scene.Window);
  scene.Lamps->EnabledOff();
  const auto frame = Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  RELIEVO_CHECK(scene.Blend->GetReasonCode() == "not_asked");
  vtkSmartPointer<vtkRenderPass> pass = scene.Frame;
  scene.Renderer->SetPass(nullptr);
  const auto plain = Picture(scene.Window);
  scene.Renderer->SetPass(pass);
  RELIEVO_CHECK(CountLevels(frame, plain) == 0);
  const Layers color = scene.Read({ "color" });
  RELIEVO_CHECK(scene.Blend->GetReasonCode() == "not_asked");
  // VTK's picture has another alpha before 9.3, the layer has not.
  scene.Wall->VisibilityOff();
  const Layers bare = scene.Read({ "color" });
  scene.Wall->VisibilityOn();
  double worstAlpha = 0.0;
  for (int y = 0; y < color.Height; ++y)
  {
    for (int x = 0; x < color.Width; ++x)
    {
      const double panes = scene.GetBlend(x, y, Blending::Averaged).a;
      const double wall = x >= 4 && x < 56 && y >= 10 && y < 30 ? 1.0 : 0.0;
      worstAlpha = std::max({ worstAlpha, std::abs(bare.Value("color", x, y, 3) - panes),
        std::abs(color.Value("color", x, y, 3) - (panes + (1.0 - panes) * wall)) });
    }
  }
  RELIEVO_CHECK_AT_MOST(worstAlpha, Halves, "alpha of the layer color");
  // A layer that is read does not change the picture, in which VTK blends.
  scene.Frame->RequestLayer("blend");
  RELIEVO_CHECK_AT_MOST(CountLevels(Picture(scene.Window), plain), 1, "beside the layer");
  const Layers beside = scene.Read({ "color", "blend" });
  double worst = 0.0;
  for (int y = 0; y < color.Height; ++y)
  {
    for (int x = 0; x < color.Width; ++x)
    {
      worst = std::max(
        worst, GetError(GetColor(beside, "blend", x, y), scene.GetBlend(x, y, Blending::Averaged)));
      worst =
        std::max(worst, GetError(GetColor(beside, "color", x, y), GetColor(color, "color", x, y)));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, Halves, "the layer alone");
  scene.Frame->SetLayersOnly(true);
  RELIEVO_CHECK(CountDifferent(scene.Read({ "blend" }), beside, "blend") == 0);
  scene.Frame->SetLayersOnly(false);
  RELIEVO_CHECK(CountLevels(Picture(scene.Window), plain) == 0);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  // Without anything translucent the layer is empty.
  scene.ShowPanes(false);
  const Layers empty = scene.Read({ "blend" });
  RELIEVO_CHECK(GetColor(empty, "blend", 30, 20) == glm::dvec4(0.0));
}

// Points that shine by themselves add to alpha: VTK's average loses them, where it draws bytes, and
// half floats have nothing else of them; sorted, they cover, but no more than all.
void TestEmissive()
{
  for (const bool sorted : { false, true })
  {
    BlendScene scene;
    const GLCheck gl(scene.Window);
    scene.Lamps->EnabledOff();
    scene.ShowPanes(false);
    if (sorted)
    {
      scene.Frame->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    }
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 60; ++i)
    {
      points->InsertNextPoint(0.01 * (i % 7), 0.01 * (i % 5), 0.5);
    }
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(places);
    mapper->SetScaleFactor(0.3);
    mapper->EmissiveOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.2, 0.5, 1.0);
    actor->GetProperty()->SetOpacity(0.6);
    scene.Renderer->AddActor(actor);
    const std::string what = sorted ? "shining, sorted" : "shining, averaged";
    const auto with = Picture(scene.Window);
    const Layers seen = scene.Read({ "blend" });
    if (!sorted)
    {
      scene.Frame->RequestLayer("blend");
      RELIEVO_CHECK_AT_MOST(
        CountLevels(Picture(scene.Window), with), 1, what + ": beside the layer");
    }
    double least = 1.0;
    double most = 0.0;
    double brightest = 0.0;
    for (int y = 0; y < seen.Height; ++y)
    {
      for (int x = 0; x < seen.Width; ++x)
      {
        const glm::dvec4 blend = GetColor(seen, "blend", x, y);
        least = std::min({ least, blend.r, blend.g, blend.b, blend.a });
        most = std::max(most, blend.a);
        brightest = std::max(brightest, blend.b);
      }
    }
    RELIEVO_CHECK(least >= 0.0 && most <= 1.0);
    RELIEVO_CHECK_THAT(sorted == (brightest > 0.5), what);
  }
}

// Emissive points change how a highlight on a pane is decoded, as the document says: as much where
// they are out of view, so that turning the camera changes no pane.
void TestEmissiveOutOfView()
{
  BlendScene scene;
  scene.Lamps->EnabledOff();
  scene.Frame->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  vtkNew<vtkLight> bright;
  bright->SetLightTypeToHeadlight();
  bright->SetIntensity(4.0);
  scene.Renderer->AddLight(bright);
  scene.Panes[1]->GetProperty()->LightingOn();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetScaleFactor(0.1);
  mapper->EmissiveOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.6);
  scene.Renderer->AddActor(actor);
  const auto look = [&]() { return GetColor(scene.Read({ "blend" }), "blend", 50, 20); };
  actor->SetPosition(-2.5, -1.5, 0.5);
  const glm::dvec4 inView = look();
  actor->SetPosition(-250.0, -1.5, 0.5);
  const glm::dvec4 outOfView = look();
  actor->VisibilityOff();
  const glm::dvec4 none = look();
  RELIEVO_CHECK(outOfView == inView);
  RELIEVO_CHECK(none.b > none.a && inView.b > inView.a && none.b - inView.b > 0.1);
  // VTK's drawing through the sRGB curve in double, over the documented cover.
  const double drawn = none.a * SrgbFromLinear(none.b / none.a);
  RELIEVO_CHECK_NEAR(inView.b, drawn, 0.01, "what is brighter than it covers");
}

// FXAA smooths VTK's blended picture; a delegate with its own framebuffer blends in there.
void TestLeftAlone()
{
  BlendScene scene;
  const GLCheck gl(scene.Window);
  scene.Renderer->UseFXAAOn();
  scene.Window->Render();
  RELIEVO_CHECK(scene.Blend->GetReasonCode() == "idle");
  scene.Renderer->UseFXAAOff();
  vtkNew<vtkSSAOPass> pass;
  pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  scene.Frame->SetDelegatePass(pass);
  scene.Blend->EnabledOff();
  const auto off = Picture(scene.Window);
  scene.Blend->EnabledOn();
  RELIEVO_CHECK(CountLevels(Picture(scene.Window), off) == 0);
  RELIEVO_CHECK(scene.Blend->GetReason().find("nothing translucent") != std::string::npos);
  RELIEVO_CHECK(scene.Blend->GetBytesHeld() == 0);
}

void TestToggles()
{
  BlendScene scene(4);
  const GLCheck gl(scene.Window);
  const auto first = Picture(scene.Window);
  const vtkIdType bytes = scene.Frame->GetBytesHeld();
  RELIEVO_CHECK(scene.Blend->GetBytesHeld() == 60 * 40 * 8 && scene.Blend->GetDrawCalls() == 1);
  GLObjects objects;
  for (int i = 0; i < 20; ++i)
  {
    scene.Blend->SetEnabled(i % 2 != 0);
    scene.Lamps->SetEnabled(i % 4 != 2);
    scene.ShowPanes(i % 3 != 1);
    scene.Window->Render();
    scene.Blend->EnabledOn();
    scene.Lamps->EnabledOn();
    scene.ShowPanes(true);
    RELIEVO_CHECK(CountLevels(Picture(scene.Window), first) == 0);
    RELIEVO_CHECK(scene.Frame->GetBytesHeld() == bytes);
    if (i == 3)
    {
      objects = CountGLObjects(scene.Window);
    }
  }
  RELIEVO_CHECK(CountGLObjects(scene.Window).Bytes == objects.Bytes);
  // Lamps shine through surfaces that are not kept apart.
  scene.Blend->EnabledOff();
  RELIEVO_CHECK(CountLevels(Picture(scene.Window), first) > 10);
}
}

RELIEVO_TEST_CASE(testBlendStage)
{
  Session session;
  TestWays();
  TestVolumes();
  TestUnchanged();
  TestEmissive();
  TestEmissiveOutOfView();
  TestLeftAlone();
  TestToggles();
  return session.Result();
}
}
