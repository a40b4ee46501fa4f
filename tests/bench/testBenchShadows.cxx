// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Foundations of the benches of shadows: verdicts from pictures equal those of the layer shadow_0,
// the computed map agrees with the drawn one, and generated scenes cast shadows.
#include "Check.h"
#include "Session.h"
#include "ShadowSimulation.h"
#include "ShadowVerdicts.h"
#include "TestCase.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <cstdlib>
#include <string>

namespace testBenchShadows
{
namespace
{
using namespace relievoBench;
using relievoTest::SceneLight;
using relievoTest::ShadowErrors;

constexpr int MapSize = 512;
const ShadowLight Sun = { "sun", SceneLight::Sun, 0. };

// A picture of the light times a visibility gives that visibility back.
void TestPictures()
{
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(4, 1, 1);
  plain->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkImageData> shadowed;
  shadowed->DeepCopy(plain);
  const unsigned char light[4] = { 200, 200, 13, 0 };
  const unsigned char left[4] = { 200, 50, 0, 0 };
  for (int i = 0; i < 12; ++i)
  {
    static_cast<unsigned char*>(plain->GetScalarPointer())[i] = light[i / 3];
    static_cast<unsigned char*>(shadowed->GetScalarPointer())[i] = left[i / 3];
  }
  const std::vector<float> visibility = PictureVisibility(shadowed, plain, 1.);
  const float expected[4] = { 1.f, 0.25f, 0.f, 1.f };
  for (int i = 0; i < 4; ++i)
  {
    RELIEVO_CHECK_NEAR(visibility[i], expected[i], 1e-6, "visibility " + std::to_string(i));
  }
  RELIEVO_CHECK_NEAR(
    PictureVisibility(shadowed, plain, 2.)[1], 0.0625, 1e-6, "visibility of a square's root");
}

ShadowErrors LayerErrors(ShadowVerdicts& verdicts)
{
  UseShadowMap(verdicts.Scene.Renderer, MapSize);
  ShadowErrors errors;
  {
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(verdicts.Scene.Renderer);
    source->AddLayer("shadow_0");
    source->Update();
    auto* layer =
      vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("shadow_0"));
    if (RELIEVO_CHECK(layer != nullptr))
    {
      errors = relievoTest::CompareShadow(verdicts.Truth, layer->GetPointer(0));
    }
  }
  UseNoShadows(verdicts.Window, verdicts.Scene.Renderer);
  return errors;
}

void TestScene(const std::string& name)
{
  const vtkSmartPointer<vtkPolyData> mesh = ShadowSceneMesh(name);
  ShadowVerdicts verdicts(name, mesh, Sun, 220, 220);
  const ShadowErrors plain = verdicts.MeasureAsItIs();
  RELIEVO_CHECK_THAT(plain.Compared > 20000 && plain.Dark > 50, name + ": " + plain.ToString());
  RELIEVO_CHECK_THAT(plain.FalseLight == plain.Dark && plain.FalseShadow == 0,
    name + ", plain, all light: " + plain.ToString());

  ShadowErrors map;
  for (const ShadowWay& way : ShadowWays())
  {
    const ShadowErrors errors = verdicts.Measure(way, MapSize);
    map = way.SetUp == UseShadowMap ? errors : map;
    RELIEVO_CHECK_THAT(errors.Compared == plain.Compared, name + ", " + way.Name + ": compared");
    // The peer's map of everything to the horizon is too coarse for any pole.
    RELIEVO_CHECK_THAT(name == HorizonScene || errors.FalseLight < plain.Dark,
      name + ", " + way.Name + " draws shadows: " + errors.ToString());
  }
  RELIEVO_CHECK_AT_MOST(map.Wrong(), 0.01, name + ", map: wrong verdicts");
  const ShadowErrors layer = LayerErrors(verdicts);
  const long long inPicture = map.FalseLight + map.FalseShadow;
  const long long inLayer = layer.FalseLight + layer.FalseShadow;
  RELIEVO_CHECK_AT_MOST(std::abs(static_cast<double>(inPicture - inLayer)), 10.,
    name + ": wrong in the picture and not in the layer, or the other way round");

  glm::dvec3 toSun;
  verdicts.Scene.Light->GetPosition(&toSun[0]);
  const ShadowSimulation simulation(*verdicts.Scene.MakeTruth(), verdicts.View, toSun, MapSize);
  const ShadowErrors computed = relievoTest::CompareShadow(
    verdicts.Truth, simulation.Visibility(verdicts.View, 1.5, true).data());
  RELIEVO_CHECK_AT_MOST(computed.Wrong(), 2. * map.Wrong() + 0.001, name + ": computed map");
  const ShadowErrors acne = relievoTest::CompareShadow(
    verdicts.Truth, simulation.Visibility(verdicts.View, 0., false).data());
  RELIEVO_CHECK_THAT(acne.FalseShadow > acne.Compared / 5, name + ", no bias: " + acne.ToString());
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchShadows)
{
  relievoTest::Session session;
  TestPictures();
  TestScene(SpheresScene);
  TestScene(SlabsScene);
  TestScene(HorizonScene);
  return session.Result();
}
}
