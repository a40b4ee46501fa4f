// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light of lamps at each pixel against the sum over all of them in double: every way, every
// fall-off, 1 to 100 000 lamps, every projection.
#include "Check.h"
#include "GLCheck.h"
#include "LampScenes.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <string>

namespace testLamps
{
namespace
{
using namespace relievoTest;

// Half a step of a half float.
constexpr double HalfRounding = 1.1 / 2048.0;
const std::vector<std::string> Needed{ "light", "depth", "range", "position", "normal" };
const int Ways[] = { vtkRelievoLampsStage::QUADS, vtkRelievoLampsStage::CLUSTERS,
  vtkRelievoLampsStage::ALL };

std::string GetName(int way)
{
  return way == vtkRelievoLampsStage::QUADS ? "quads"
    : way == vtkRelievoLampsStage::CLUSTERS ? "clusters"
                                            : "all";
}

// The light of these lamps in all ways.
void CheckWays(LampScene& scene, vtkRelievoLamps* lamps, const std::vector<Lamp>& truth,
  const std::string& what, double place = 1e-6)
{
  const double* a = lamps->GetAttenuationValues();
  for (const int way : Ways)
  {
    scene.Stage->SetWay(way);
    vtkSmartPointer<vtkImageData> image = scene.Read(Needed);
    const std::string name = what + ", " + GetName(way);
    const long long lit =
      CheckLight(image, truth, lamps->GetFalloff(), glm::dvec3(a[0], a[1], a[2]), name, place);
    RELIEVO_CHECK(lit > 0);
    RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");
    RELIEVO_CHECK(scene.Stage->GetWayTaken() == way);
  }
}

void TestNumbers()
{
  const struct
  {
    int Count;
    double Radius;
    int Width;
    int Height;
  } cases[] = { { 1, 6.0, 120, 90 }, { 10, 2.0, 120, 90 }, { 1000, 0.4, 120, 90 },
    { 100000, 0.1, 60, 45 } };
  for (const auto& each : cases)
  {
    for (const bool white : { true, false })
    {
      LampScene scene(each.Width, each.Height);
      const std::vector<Lamp> truth = RandomLamps(each.Count, each.Radius, white);
      const auto lamps = scene.AddLamps(truth);
      CheckWays(scene, lamps, truth,
        std::to_string(each.Count) + (white ? " white lamps" : " coloured lamps"));
      RELIEVO_CHECK(scene.Stage->GetNumberOfLamps() == each.Count);
      RELIEVO_CHECK(scene.Stage->GetNumberDrawn() > 0);
    }
  }
}

void TestFalloffs()
{
  LampScene scene(120, 90);
  const std::vector<Lamp> truth = RandomLamps(60, 1.5, false);
  const auto lamps = scene.AddLamps(truth);
  lamps->SetFalloffToInverseSquare();
  CheckWays(scene, lamps, truth, "inverse square");
  lamps->SetFalloffToVTK();
  lamps->SetAttenuationValues(0.5, 0.3, 2.0);
  CheckWays(scene, lamps, truth, "VTK's attenuation");

  // Two sets of different fall-off: their sum.
  vtkNew<vtkRelievoLamps> others;
  const std::vector<Lamp> second = RandomLamps(7, 2.0, true);
  others->SetInputData(ToPolyData(second));
  scene.Stage->AddPoints(others);
  vtkSmartPointer<vtkImageData> both = scene.Read(Needed);
  scene.Stage->RemovePoints(others);
  vtkSmartPointer<vtkImageData> first = scene.Read(Needed);
  scene.Stage->RemoveAllPoints();
  scene.Stage->AddPoints(others);
  vtkSmartPointer<vtkImageData> last = scene.Read(Needed);
  scene.Stage->RemoveAllPoints();
  vtkSmartPointer<vtkImageData> none = scene.Read(Needed);
  double worst = 0.0;
  for (vtkIdType i = 0; i < 3 * both->GetNumberOfPoints(); ++i)
  {
    const auto at = [i](vtkImageData* image) {
      return static_cast<float*>(image->GetPointData()->GetArray("light")->GetVoidPointer(0))[i];
    };
    const double sum = static_cast<double>(at(first)) + at(last);
    worst = std::max(worst, std::abs(at(both) - sum) / (sum + 1e-3));
    RELIEVO_CHECK(at(none) == 0.0f);
  }
  RELIEVO_CHECK_AT_MOST(worst, 2.0 * HalfRounding, "two sets, against the sum of each");
}

void TestViews()
{
  const std::vector<Lamp> truth = RandomLamps(300, 0.8, false);
  const auto check = [&](const std::string& what, const auto& change, double place = 1e-6) {
    LampScene scene(130, 70);
    const auto lamps = scene.AddLamps(truth);
    change(scene);
    CheckWays(scene, lamps, truth, what, place);
  };
  const auto camera = [](LampScene& scene) { return scene.Renderer->GetActiveCamera(); };
  check("parallel", [&](LampScene& scene) {
    camera(scene)->ParallelProjectionOn();
    camera(scene)->SetParallelScale(2.0);
  });
  check("parallel, the near plane behind the eye", [&](LampScene& scene) {
    camera(scene)->ParallelProjectionOn();
    camera(scene)->SetParallelScale(2.0);
    camera(scene)->SetPosition(0.2, 0.3, 0.5);
    camera(scene)->SetClippingRange(-6.0, 9.0);
  });
  check("off-centre", [&](LampScene& scene) { camera(scene)->SetWindowCenter(0.7, -0.4); });
  // Floats lose digits of a shear's two terms, which cancel in the middle of the scene.
  check(
    "sheared", [&](LampScene& scene) { camera(scene)->SetViewShear(0.3, -0.2, 1.0); }, 2e-6);
  check("the eye among the lamps", [&](LampScene& scene) {
    camera(scene)->SetPosition(0.1, 0.9, 1.5);
    camera(scene)->SetClippingRange(0.01, 16.0);
  });
  check("far / near of 1e7", [&](LampScene& scene) { camera(scene)->SetClippingRange(1e-3, 1e4); });
  check("a viewport of its own",
    [&](LampScene& scene) { scene.Renderer->SetViewport(0.3, 0.1, 0.95, 0.8); });
  check("8 samples", [&](LampScene& scene) { scene.Window->SetMultiSamples(8); });
  check("only layers", [&](LampScene& scene) { scene.Frame->LayersOnlyOn(); });
}

// The pixels' places are float in eye space: exact far from the origin, when the lamps are, too.
void TestFarAway()
{
  const glm::dvec3 offset(1e6, -2e6, 3e6);
  LampScene scene(120, 90, offset);
  const std::vector<Lamp> truth = RandomLamps(100, 0.8, false, offset);
  const auto lamps = scene.AddLamps(truth);
  CheckWays(scene, lamps, truth, "far from the origin");
}
}

RELIEVO_TEST_CASE(testLamps)
{
  relievoTest::Session session;
  TestNumbers();
  TestFalloffs();
  TestViews();
  TestFarAway();
  return session.Result();
}
}
