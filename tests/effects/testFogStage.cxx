// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoFogStage: transmittance of each pixel compared with sums in long double over all
// spheres, in every projection; and the picture with color T + fog (1 - T) in linear light.
#include "Check.h"
#include "FogScene.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace testFogStage
{
namespace
{
using namespace relievoTest;

// The scene's spheres: before, in and behind the wall and the ball, around the eye, behind it, and
// where nothing else is.
std::vector<FogSphere> SomeSpheres()
{
  return { { { 0., 0.5, 0.4 }, 0.6, 0.8, { 1., 1., 1. } },
    { { 0.9, 0.2, -1. }, 0.7, 0.5, { 0.2, 0.5, 1. } },
    { { -1.2, 1.2, -1.6 }, 0.8, 2., { 1., 0.1, 0.1 } },
    { { 0., 0.5, 4.2 }, 1., 0.1, { 0.3, 0.9, 0.2 } }, { { 0., 0.5, 9. }, 2., 5., { 1., 0., 1. } },
    { { 1.6, 1.5, 0. }, 0.3, 1.5, { 1., 1., 0. } } };
}

const std::vector<Look> Looks = {
  { "wide",
    [](vtkCamera* camera) {
      camera->SetViewAngle(110.);
      camera->SetPosition(0.3, 0.8, 2.);
    } },
  { "off-centre", [](vtkCamera* camera) { camera->SetWindowCenter(0.4, -0.3); } },
  { "sheared", [](vtkCamera* camera) { camera->SetViewShear(0.2, -0.1, 1.1); } },
};

void TestLayer()
{
  std::vector<Look> looks = PlainLooks;
  looks.insert(looks.end(), Looks.begin(), Looks.end());
  for (const Look& look : looks)
  {
    for (const bool chord : { false, true })
    {
      for (const bool dominant : { false, true })
      {
        FogScene scene(121, 91);
        look.Set(scene.Renderer->GetActiveCamera());
        GLCheck gl(scene.Window);
        scene.Set(SomeSpheres());
        scene.Stage->SetMode(chord ? vtkRelievoFogStage::CHORD : vtkRelievoFogStage::BEER);
        scene.Stage->SetOverlap(dominant ? vtkRelievoFogStage::DOMINANT : vtkRelievoFogStage::SUM);
        const FogErrors errors = scene.Compare();
        const std::string name = std::string(look.Name) + (chord ? ", chord" : ", beer") +
          (dominant ? ", dominant" : ", sum");
        RELIEVO_CHECK_AT_MOST(errors.Transmittance, 1e-6, name + ": what passes");
        RELIEVO_CHECK_AT_MOST(errors.Picture, 1.01, name + ": levels of 255 of the picture");
        RELIEVO_CHECK_THAT(errors.Fogged > 800 && errors.Sky > 200,
          name + ": " + std::to_string(errors.Fogged) + " fogged, of the sky " +
            std::to_string(errors.Sky));
        RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");
      }
    }
  }
  // The comparison detects deviations from the scene.
  FogScene scene(60, 45);
  scene.Set(SomeSpheres());
  scene.Fog->SetArray("density", "");
  scene.Fog->SetDensity(0.5);
  const FogErrors errors = scene.Compare();
  RELIEVO_CHECK(errors.Transmittance > 0.05 && errors.Picture > 5.);
}

// From as far as 10 000 radii the outlines are as they are from near by, on the GPU as well.
void TestFar()
{
  for (const double distance : { 100., 1e4 })
  {
    FogScene scene(300, 225);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.3 * distance, 0.2 * distance, 0.9 * distance);
    camera->SetFocalPoint(0., 0.5, 0.);
    camera->SetClippingRange(0.5 * distance, 2. * distance);
    camera->SetViewAngle(170. / distance);
    GLCheck gl(scene.Window);
    scene.Set({ { { 0., 0.5, 0. }, 1., 1., { 1., 1., 1. } },
      { { 0.7, 1.1, -0.3 }, 0.5, 2., { 1., 0.5, 0. } } });
    const FogErrors errors = scene.Compare();
    RELIEVO_CHECK_AT_MOST(
      errors.Transmittance, 1e-6, "from " + std::to_string(distance) + " radii: what passes");
    RELIEVO_CHECK(errors.Fogged > 10000);
  }
}

// Over nothing: premultiplied, with the alpha of the fog, for who composes it further.
void TestAlpha()
{
  FogScene scene(61, 61);
  scene.Renderer->SetBackgroundAlpha(0.);
  scene.Renderer->SetBackground(0., 0., 0.);
  scene.Set({ { { 0., 0.5, 0. }, 8., 0.02, { 1., 0.5, 0.25 } } });
  const Layers layers = scene.Read({ "fog", "color", "depth" });
  for (const int x : { 2, 58 })
  {
    const double passes = layers.Value("fog", x, 58);
    RELIEVO_CHECK(std::isinf(layers.Value("depth", x, 58)) && passes > 0.6 && passes < 0.9);
    const double expected[4] = { 1., 0.5, 0.25, 1. };
    for (int i = 0; i < 4; ++i)
    {
      RELIEVO_CHECK_NEAR(layers.Value("color", x, 58, i), expected[i] * (1. - passes), 1e-3,
        "premultiplied fog over nothing, component " + std::to_string(i));
    }
  }
}

// Nested and equal spheres, many of them, in any order.
void TestOrder()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2., 2.);
  std::uniform_real_distribution<double> share(0.05, 1.);
  std::vector<FogSphere> spheres;
  for (int i = 0; i < 1000; ++i)
  {
    spheres.push_back({ { place(random), place(random), place(random) }, 0.6 * share(random),
      0.4 * share(random), { share(random), share(random), share(random) } });
  }
  FogScene scene(100, 75);
  scene.Set(spheres);
  const FogErrors errors = scene.Compare();
  RELIEVO_CHECK_AT_MOST(errors.Transmittance, 1e-6, "1000 spheres: what passes");
  RELIEVO_CHECK_AT_MOST(errors.Picture, 1.01, "1000 spheres: levels of 255");
  RELIEVO_CHECK(scene.Stage->GetNumberDrawn() > 800 && scene.Stage->GetDrawCalls() == 2);
  const Layers first = scene.Read({ "fog", "color" });
  std::shuffle(spheres.begin(), spheres.end(), random);
  scene.Set(spheres);
  const Layers second = scene.Read({ "fog", "color" });
  RELIEVO_CHECK_AT_MOST(LargestDifference(first, second, "fog"), 3e-6, "another order: fog");
  RELIEVO_CHECK_AT_MOST(LargestDifference(first, second, "color"), 1e-3, "another order: colour");

  // A thousand equal ones are one that is a thousand times as dense.
  scene.Set(std::vector<FogSphere>(1000, { { 0., 0.5, 0.4 }, 0.6, 0.001, { 1., 1., 1. } }));
  const Layers many = scene.Read({ "fog", "color" });
  scene.Set({ { { 0., 0.5, 0.4 }, 0.6, 1., { 1., 1., 1. } } });
  const Layers one = scene.Read({ "fog", "color" });
  RELIEVO_CHECK_AT_MOST(LargestDifference(many, one, "fog"), 2e-5, "a thousand equal: fog");
}

// The layer covers opaque surfaces; testBlendFog has pictures with translucent ones.
void TestTranslucent()
{
  FogScene scene(60, 45);
  scene.Set(SomeSpheres());
  const Layers without = scene.Read({ "fog", "depth" });
  scene.AddGlass();
  const Layers with = scene.Read({ "fog", "depth" });
  RELIEVO_CHECK(CountDifferent(without, with, "fog") == 0);
}

// Depths belong to the centres of pixels, whatever the multisampling.
void TestSamples()
{
  FogScene scene(60, 45);
  scene.Set(SomeSpheres());
  const Layers one = scene.Read({ "fog" });
  scene.Window->SetMultiSamples(8);
  const FogErrors errors = scene.Compare();
  RELIEVO_CHECK_AT_MOST(errors.Transmittance, 1e-6, "8 samples: what passes");
  RELIEVO_CHECK_AT_MOST(errors.Picture, 2.01, "8 samples: levels of 255");
  const Layers eight = scene.Read({ "fog" });
  RELIEVO_CHECK_AT_MOST(LargestDifference(one, eight, "fog"), 2e-6, "8 samples and one");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFogStage)
{
  Session session;
  TestLayer();
  TestFar();
  TestAlpha();
  TestOrder();
  TestTranslucent();
  TestSamples();
  return session.Result();
}
}
