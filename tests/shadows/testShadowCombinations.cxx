// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows within every chain of VTK's passes and every setting of its renderers: where a light does
// not reach, the picture is the chain's own with that light switched off; elsewhere it is the
// chain's own. Rays say where. The rows of docs/shadow-matrix.md about chains are these cases.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDepthOfFieldPass.h>
#include <vtkDepthPeelingPass.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkEDLShading.h>
#include <vtkFramebufferPass.h>
#include <vtkGaussianBlurPass.h>
#include <vtkImageData.h>
#include <vtkLightsPass.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkOverlayPass.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumetricPass.h>
#include <vtkWindowToImageFilter.h>
#if __has_include(<vtkToneMappingPass.h>)
#include <vtkToneMappingPass.h>
#endif

#include <algorithm>
#include <functional>
#include <iostream>
#include <vector>

namespace testShadowCombinations
{
namespace
{
using relievoTest::Picture;
using relievoTest::ShadowStage;
using PassPointer = vtkSmartPointer<vtkRenderPass>;

template <typename Pass>
PassPointer Around()
{
  vtkNew<Pass> pass;
  pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  return PassPointer(pass.Get());
}

template <typename Pass>
PassPointer Make()
{
  return vtkSmartPointer<Pass>::New();
}

PassPointer Steps(const PassPointer& translucent)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (const PassPointer& pass : { Make<vtkLightsPass>(), Make<vtkOpaquePass>(), translucent,
         Make<vtkVolumetricPass>(), Make<vtkOverlayPass>() })
  {
    collection->AddItem(pass);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(collection);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  return PassPointer(camera.Get());
}

template <typename Peeling>
PassPointer Peeled()
{
  vtkNew<Peeling> peeling;
  peeling->SetTranslucentPass(Make<vtkTranslucentPass>());
  return Steps(PassPointer(peeling.Get()));
}

struct Feature
{
  const char* Name;
  // How far a pixel's colour reaches into others.
  int Radius;
  // Share of lit pixels that may be off: those at the edges of things, where a shadow's edge is.
  double Limit;
  std::function<PassPointer()> MakePass;
  std::function<void(ShadowStage&)> Set;
};

const Feature Features[] = {
  { "no pass", 1, 3e-4, nullptr, nullptr },
  { "vtkRenderStepsPass", 1, 3e-4, Make<vtkRenderStepsPass>, nullptr },
  { "steps by hand", 1, 3e-4, []() { return Steps(Make<vtkTranslucentPass>()); }, nullptr },
  { "vtkDepthPeelingPass", 1, 3e-4, Peeled<vtkDepthPeelingPass>, nullptr },
  { "vtkDualDepthPeelingPass", 1, 3e-4, Peeled<vtkDualDepthPeelingPass>, nullptr },
  { "vtkSSAOPass", 2, 3e-4, Around<vtkSSAOPass>, nullptr },
  { "vtkOpenGLFXAAPass", 2, 2e-3, Around<vtkOpenGLFXAAPass>, nullptr },
#if __has_include(<vtkToneMappingPass.h>)
  { "vtkToneMappingPass", 1, 3e-4, Around<vtkToneMappingPass>, nullptr },
#endif
  { "vtkEDLShading", 2, 3e-4, Around<vtkEDLShading>, nullptr },
  { "vtkSSAAPass", 2, 3e-4, Around<vtkSSAAPass>, nullptr },
  { "vtkGaussianBlurPass", 4, 1e-3, Around<vtkGaussianBlurPass>, nullptr },
  { "vtkDepthOfFieldPass", 6, 3e-4, Around<vtkDepthOfFieldPass>, nullptr },
  { "vtkFramebufferPass", 1, 3e-4, Around<vtkFramebufferPass>, nullptr },
  { "UseDepthPeeling", 1, 3e-4, nullptr,
    [](ShadowStage& s) { s.Renderer->SetUseDepthPeeling(true); } },
  { "UseSSAO", 2, 3e-4, nullptr, [](ShadowStage& s) { s.Renderer->SetUseSSAO(true); } },
  { "UseFXAA", 2, 2e-3, nullptr, [](ShadowStage& s) { s.Renderer->SetUseFXAA(true); } },
  { "two-sided lighting off", 1, 3e-4, nullptr,
    [](ShadowStage& s) { s.Renderer->SetTwoSidedLighting(false); } },
  { "8 samples", 2, 2e-3, nullptr, [](ShadowStage& s) { s.Window->SetMultiSamples(8); } },
  { "parallel projection", 1, 3e-4, nullptr,
    [](ShadowStage& s) {
      s.Renderer->GetActiveCamera()->ParallelProjectionOn();
      s.Renderer->GetActiveCamera()->SetParallelScale(2.);
    } },
};

// A pane in the light, in front of the ground: it casts nothing, and the pane and the surfaces seen
// through it stay unchanged.
void AddGlass(ShadowStage& stage)
{
  const auto pane = stage.AddBox({ -1.5, 0.7, 2.2 }, { 0.7, 0.9, 0.05 });
  pane->GetProperty()->SetOpacity(0.4);
  pane->GetProperty()->SetColor(0.3, 0.9, 0.6);
}

void Judge(const std::string& what, ShadowStage& stage, vtkLight* light,
  const std::function<vtkSmartPointer<vtkImageData>()>& picture,
  const relievoTest::ShadowTruth& truth, int radius, double limit)
{
  const relievoTest::ShadowPictures pictures(stage, light, picture);
  relievoTest::CheckPictures(what, pictures, truth, limit, radius);
  relievoTest::SamePicture(pictures.On, picture(), what + ", a second frame");
  stage.GetFrame()->ShadowsOff();
  relievoTest::SamePicture(pictures.Off, picture(), what + ", off again");
}

void TestFeature(const Feature& feature)
{
  ShadowStage stage;
  if (feature.Set)
  {
    feature.Set(stage);
  }
  const relievoTest::GLCheck gl(stage.Window);
  const PassPointer own = feature.MakePass ? feature.MakePass() : PassPointer();
  stage.Renderer->SetPass(own);
  stage.AddThings();
  const auto light = relievoTest::AddTwoSuns(stage);
  const auto truth = relievoTest::TraceStage(stage, 0);
  AddGlass(stage);
  Judge(
    feature.Name, stage, light, [&stage]() { return Picture(stage.Window); }, truth, feature.Radius,
    feature.Limit);
  if (own)
  {
    own->ReleaseGraphicsResources(stage.Window);
  }
}

// A picture twice as large, in tiles, is that of a window twice as large.
void TestTiles()
{
  ShadowStage stage;
  const relievoTest::GLCheck gl(stage.Window);
  stage.AddThings();
  const auto light = relievoTest::AddTwoSuns(stage);
  ShadowStage large(480, 360);
  large.AddThings();
  relievoTest::AddTwoSuns(large);
  const auto truth = relievoTest::TraceStage(large, 0);
  AddGlass(stage);
  Judge(
    "tiles", stage, light,
    [&stage]() {
      vtkNew<vtkWindowToImageFilter> tiles;
      tiles->SetInput(stage.Window);
      tiles->SetScale(2);
      tiles->ReadFrontBufferOff();
      tiles->Update();
      return vtkSmartPointer<vtkImageData>(tiles->GetOutput());
    },
    truth, 2, 3e-4);
}

// Each eye has its shadows: those of a camera at the eye's place differ by no more than the
// surfaces between the eyes, so here every pixel is one of the two pictures of that eye, or
// between.
void TestStereo()
{
  for (const int type :
    { VTK_STEREO_LEFT, VTK_STEREO_RIGHT, VTK_STEREO_RED_BLUE, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    ShadowStage stage;
    stage.AddThings();
    const auto light = relievoTest::AddTwoSuns(stage);
    stage.Window->SetStereoRender(true);
    stage.Window->SetStereoType(type);
    const std::string what = "stereo " + std::to_string(type);
    relievoTest::ShadowTruth none;
    none.Width = 240;
    none.Height = 180;
    none.Verdicts.resize(240 * 180);
    const relievoTest::ShadowPictures pictures(stage, light);
    const auto errors =
      relievoTest::JudgePicture(pictures.On, pictures.Off, pictures.Dark, none, 0, 1);
    RELIEVO_CHECK_AT_MOST(errors.Outside, 20., what + ": pixels that are neither");
    stage.Window->SetStereoRender(false);
    const auto monoOn = Picture(stage.Window);
    stage.GetFrame()->ShadowsOff();
    const long long mono = relievoTest::CountUnlike(Picture(stage.Window), monoOn, 1);
    const long long here = relievoTest::CountUnlike(pictures.Off, pictures.On, 1);
    std::cout << what << ": " << here << " pixels in shadow, with one eye " << mono << "\n";
    // Red and blue halves show both; a split window shows each once, squeezed.
    const long long most = type == VTK_STEREO_RED_BLUE ? 2 * mono : mono + mono / 5;
    RELIEVO_CHECK_THAT(here > mono - mono / 5 && here <= most, what + ": shadows are missing");
  }
}

// All tiles of a picture look up the maps of the whole: no tile draws one, no edge steps between
// two, and put together they are the picture of a window that large.
void TestTilesShareMaps()
{
  for (const int scale : { 2, 3 })
  {
    const std::string what = std::to_string(scale * scale) + " tiles";
    ShadowStage stage;
    ShadowStage large(240 * scale, 180 * scale);
    for (ShadowStage* each : { &stage, &large })
    {
      each->AddThings();
      each->AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 90.);
      relievoTest::AddTwoSuns(*each);
      each->GetFrame()->ShadowsOn();
      each->Window->Render();
    }
    RELIEVO_CHECK_THAT(stage.GetShadows()->GetNumberOfMapsDrawn() > 1, what + ": no maps drawn");
    std::vector<int> drawn;
    std::function<void()> count = [&]() {
      drawn.push_back(stage.GetShadows()->GetNumberOfMapsDrawn());
    };
    vtkNew<vtkCallbackCommand> callback;
    callback->SetClientData(&count);
    callback->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      (*static_cast<std::function<void()>*>(data))();
    });
    const unsigned long tag = stage.Renderer->AddObserver(vtkCommand::EndEvent, callback);
    vtkNew<vtkWindowToImageFilter> tiles;
    tiles->SetInput(stage.Window);
    tiles->SetScale(scale);
    tiles->ReadFrontBufferOff();
    tiles->Update();
    stage.Renderer->RemoveObserver(tag);
    RELIEVO_CHECK_THAT(static_cast<int>(drawn.size()) >= scale * scale &&
        std::all_of(drawn.begin(), drawn.end(), [](int maps) { return maps == 0; }),
      what + ": a tile drew maps of its own");
    // VTK's own tiles are off by a level at some edges.
    RELIEVO_CHECK_AT_MOST(relievoTest::CountUnlike(tiles->GetOutput(), Picture(large.Window), 2), 0,
      what + ": pixels unlike those of a large window");
  }
}

// A stereo picture equals that of the first frame, whatever was drawn before it.
void TestStereoStays()
{
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT, VTK_STEREO_RED_BLUE,
         VTK_STEREO_ANAGLYPH, VTK_STEREO_INTERLACED, VTK_STEREO_DRESDEN, VTK_STEREO_CHECKERBOARD,
         VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    const std::string what = "stereo " + std::to_string(type);
    vtkSmartPointer<vtkImageData> pictures[2];
    for (const bool before : { false, true })
    {
      ShadowStage stage;
      stage.AddThings();
      relievoTest::AddTwoSuns(stage);
      stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 90.);
      stage.GetFrame()->ShadowsOn();
      if (before)
      {
        stage.Window->Render();
      }
      stage.Window->SetStereoRender(true);
      stage.Window->SetStereoType(type);
      pictures[before] = Picture(stage.Window);
      for (int frame = 2; frame <= 4; ++frame)
      {
        relievoTest::SamePicture(
          pictures[before], Picture(stage.Window), what + ", frame " + std::to_string(frame));
      }
    }
    relievoTest::SamePicture(pictures[0], pictures[1], what + ", after a frame for one eye");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowCombinations)
{
  relievoTest::Session session;
  for (const Feature& feature : Features)
  {
    TestFeature(feature);
  }
  TestTiles();
  TestTilesShareMaps();
  TestStereo();
  TestStereoStays();
  return session.Result();
}
}
