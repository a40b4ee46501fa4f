// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps on a pane: their light in the layer `blend` and in the linear colour, compared with the sum
// over all lamps in double at the pane's plane.
#include "Check.h"
#include "GLCheck.h"
#include "LampScenes.h"
#include "Layers.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "View.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testLampsTranslucent
{
namespace
{
using namespace relievoTest;

// Relative to the value: half floats for display, whose curve has a slope of up to 2.4, then in
// linear light, in both pictures. Mesa's software truncates them.
constexpr double Halves = 2.0 * (2.4 + 1.0) / 1024.0;
// Relative to 1: bytes for display, in both pictures.
constexpr double Bytes = 2.0 * 2.4 / 255.0;

constexpr double Z = 1.5; // of the pane
constexpr double Opacity = 0.4;
const glm::dvec3 Color(0.8, 0.5, 0.3);

glm::dvec3 GetLinear()
{
  return { LinearFromSrgb(Color.x), LinearFromSrgb(Color.y), LinearFromSrgb(Color.z) };
}

struct PaneScene : LampScene
{
  explicit PaneScene(int width = 160, int height = 120)
    : LampScene(width, height)
  {
    this->Turn(false);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Pane->SetMapper(mapper);
    this->Pane->GetProperty()->SetOpacity(Opacity);
    this->Pane->GetProperty()->SetColor(Color.x, Color.y, Color.z);
    this->Renderer->AddActor(this->Pane);
  }

  // Which side of the pane is its front.
  void Turn(bool away)
  {
    const double first = away ? 1.8 : -1.8;
    this->Source->SetOrigin(first, 0.2, Z);
    this->Source->SetPoint1(-first, 0.2, Z);
    this->Source->SetPoint2(first, 2.2, Z);
  }

  vtkNew<vtkPlaneSource> Source;
  vtkNew<vtkActor> Pane;
};

// Compares the lamps' light on the pane with the expectation: `own` is the share of light that the
// pane reflects; the error is relative to the value, or to 1. Returns the largest added light.
double CheckPane(PaneScene& scene, const std::vector<Lamp>& lamps, const glm::dvec3& own,
  double limit, const std::string& what, bool absolute = false)
{
  const GLCheck gl(scene.Window);
  const auto set = scene.AddLamps(lamps);
  const std::vector<std::string> wanted{ "blend", "color", "depth", "light" };
  scene.Stage->TranslucentOff();
  const Layers unlit(scene.Read(wanted));
  scene.Stage->TranslucentOn();
  const Layers lit(scene.Read(wanted));
  RELIEVO_CHECK(scene.Stage->GetFacts().at("lamps_on_translucent").ToInt() == 1);
  scene.Stage->TranslucentOff();
  RELIEVO_CHECK(CountDifferent(unlit, lit, "light") == 0);
  RELIEVO_CHECK(CountDifferent(unlit, Layers(scene.Read(wanted)), "blend") == 0);
  scene.Stage->RemovePoints(set);
  const View view(scene.Renderer);
  double worst = 0.0;
  double most = 0.0;
  int inside = 0;
  for (int y = 0; y < lit.Height; ++y)
  {
    for (int x = 0; x < lit.Width; ++x)
    {
      const Ray ray = view.PixelRay(x + 0.5, y + 0.5);
      const double t = (Z - ray.Origin.z) / ray.Direction.z;
      const glm::dvec3 place = ray.At(t);
      const glm::dvec2 off(1.8 - std::abs(place.x), 1.0 - std::abs(place.y - 1.2));
      const double rim = std::min(off.x, off.y);
      const bool before = t < lit.Value("depth", x, y) - 1e-3;
      const bool behind = t > lit.Value("depth", x, y) + 1e-3;
      if (std::abs(rim) < 0.05 || (!before && !behind))
      {
        continue;
      }
      const bool pane = rim > 0.0 && before;
      const LampSum sum =
        SumLight(lamps, vtkRelievoLamps::LINEAR, glm::dvec3(1.0), place, glm::dvec3(0.0, 0.0, 1.0));
      for (int c = 0; c < 3; ++c)
      {
        const double added = pane ? Opacity * own[c] * sum.Light[c] : 0.0;
        for (const char* layer : { "blend", "color" })
        {
          const double expected = unlit.Value(layer, x, y, c) + added;
          const double error = std::abs(lit.Value(layer, x, y, c) - expected);
          worst = std::max(worst, error / (absolute ? 1.0 : expected + 0.02));
        }
        most = std::max(most, added);
      }
      inside += pane ? 1 : 0;
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, limit, what + ": largest error");
  RELIEVO_CHECK(inside > 200);
  return most;
}

void TestSums()
{
  const std::vector<Lamp> few = RandomLamps(6, 2.0, false);
  const std::vector<Lamp> many = RandomLamps(3000, 0.25, false);
  {
    PaneScene scene;
    RELIEVO_CHECK(CheckPane(scene, few, GetLinear(), Halves, "6 lamps") > 0.1);
    RELIEVO_CHECK(CheckPane(scene, many, GetLinear(), Halves, "3000 lamps") > 0.1);
    scene.Turn(true);
    CheckPane(scene, few, GetLinear(), Halves, "the pane's back");
    scene.Stage->SetCasting(2);
    CheckPane(scene, few, GetLinear(), Halves, "with lamps that cast");
    scene.Frame->DeferredOn();
    CheckPane(scene, few, GetLinear(), Halves, "deferred");
  }
  {
    PaneScene scene(200, 150);
    scene.Renderer->SetViewport(0.25, 0.3, 0.95, 0.9);
    CheckPane(scene, many, GetLinear(), Halves, "a viewport");
    scene.Renderer->UseDepthPeelingOn();
    std::vector<Lamp> dim = few;
    for (Lamp& lamp : dim)
    {
      lamp.Intensity *= 0.2;
    }
    CheckPane(scene, dim, GetLinear(), Bytes, "peeled, in a viewport", true);
  }
  {
    PaneScene scene;
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(2.0);
    CheckPane(scene, many, GetLinear(), Halves, "parallel");
    scene.Window->SetMultiSamples(8);
    CheckPane(scene, few, GetLinear(), Halves, "8 samples");
  }
}

// Lamps whose sum on the pane is far above white, where it is brightest: the light is not clamped.
void TestBright()
{
  constexpr double Brightest = 45.0;
  for (const std::vector<Lamp>& given :
    { std::vector<Lamp>{ { glm::dvec3(0.4, 1.0, 1.9), 2.0, 1.0, glm::dvec3(1.0, 0.9, 0.7) } },
      RandomLamps(300, 0.8, false) })
  {
    const std::string what = std::to_string(given.size()) + " bright lamps";
    std::vector<Lamp> lamps = given;
    double most = 0.0;
    for (double x = -1.8; x <= 1.8; x += 0.02)
    {
      for (double y = 0.2; y <= 2.2; y += 0.02)
      {
        const glm::dvec3 light = SumLight(lamps, vtkRelievoLamps::LINEAR, glm::dvec3(1.0),
          glm::dvec3(x, y, Z), glm::dvec3(0.0, 0.0, 1.0))
                                   .Light;
        most = std::max({ most, light.x, light.y, light.z });
      }
    }
    for (Lamp& lamp : lamps)
    {
      lamp.Intensity *= Brightest / most;
    }
    PaneScene scene;
    scene.Pane->GetProperty()->SetColor(1.0, 1.0, 1.0);
    RELIEVO_CHECK(
      CheckPane(scene, lamps, glm::dvec3(1.0), Halves, what) > 0.8 * Opacity * Brightest);
    scene.Pane->GetProperty()->SetInterpolationToPBR();
    CheckPane(scene, lamps, glm::dvec3(1.0), Halves, what + ", PBR");
  }
}

void TestMaterials()
{
  const std::vector<Lamp> few = RandomLamps(6, 2.0, false);
  PaneScene scene;
  vtkProperty* property = scene.Pane->GetProperty();
  property->SetDiffuse(0.5);
  CheckPane(scene, few, 0.5 * GetLinear(), Halves, "diffuse 0.5");
  property->SetDiffuse(1.0);
  property->LightingOff();
  CheckPane(scene, few, glm::dvec3(0.0), 0.0, "without lighting");
  property->LightingOn();
  property->SetInterpolationToPBR();
  property->SetMetallic(0.25);
  CheckPane(scene, few, 0.75 * Color, Halves, "PBR");
  property->SetInterpolationToFlat();
  CheckPane(scene, few, GetLinear(), Halves, "flat");
}

// On and off, without anything translucent, and without lamps: the pictures of before.
void TestToggles()
{
  PaneScene scene;
  vtkSmartPointer<vtkImageData> plain = Picture(scene.Window);
  scene.Stage->TranslucentOn();
  SamePicture(plain, Picture(scene.Window), "without lamps");
  vtkNew<vtkRelievoLamps> set;
  set->SetInputData(ToPolyData(RandomLamps(20, 1.5, true)));
  scene.Stage->AddPoints(set);
  vtkSmartPointer<vtkImageData> lit = Picture(scene.Window);
  const vtkIdType bytes = scene.Frame->GetBytesHeld();
  scene.Stage->TranslucentOff();
  vtkSmartPointer<vtkImageData> unlit = Picture(scene.Window);
  RELIEVO_CHECK(FailuresOf([&]() { SamePicture(lit, unlit, "lit"); }) > 0);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() < bytes);
  for (int i = 0; i < 5; ++i)
  {
    scene.Stage->TranslucentOn();
    SamePicture(lit, Picture(scene.Window), "on again");
    scene.Pane->VisibilityOff();
    scene.Window->Render();
    RELIEVO_CHECK(scene.Stage->GetFacts().at("lamps_on_translucent").ToInt() == 0);
    scene.Pane->VisibilityOn();
    scene.Stage->TranslucentOff();
    SamePicture(unlit, Picture(scene.Window), "off again");
  }
  // FXAA: VTK blends by itself, and the pane is lit all the same.
  scene.Renderer->UseFXAAOn();
  vtkSmartPointer<vtkImageData> smooth = Picture(scene.Window);
  scene.Stage->TranslucentOn();
  RELIEVO_CHECK(FailuresOf([&]() { SamePicture(smooth, Picture(scene.Window), "FXAA"); }) > 0);
  scene.Renderer->UseFXAAOff();
  scene.Stage->RemovePoints(set);
  SamePicture(plain, Picture(scene.Window), "without lamps again");
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
}
}

RELIEVO_TEST_CASE(testLampsTranslucent)
{
  relievoTest::Session session;
  TestSums();
  TestBright();
  TestMaterials();
  TestToggles();
  return session.Result();
}
}
