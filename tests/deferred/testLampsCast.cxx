// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casting lamps: their light compared with rays and with VTK's own point lights; which of them
// cast; and failures.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "LampScenes.h"
#include "Layers.h"
#include "MadeMeshes.h"
#include "Props.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "TestCase.h"
#include "View.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <vtkRelievoShadowStage.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace testLampsCast
{
namespace
{
using namespace relievoTest;

const glm::dvec3 White(1.0);
const std::vector<std::string> Light{ "light" };

int GetFact(vtkRelievoStage* stage, const char* name)
{
  return stage->GetFacts().at(name).ToInt();
}

// Three lamps, each in a channel of its own: the light with shadows over the light without, against
// rays to the lamps.
std::vector<ShadowErrors> CompareWithRays(
  LampScene& scene, const glm::dvec3* places, const std::string& what)
{
  std::vector<Lamp> lamps;
  for (int c = 0; c < 3; ++c)
  {
    glm::dvec3 color(0.0);
    color[c] = 1.0;
    lamps.push_back({ places[c], 30.0, 1.0, color });
  }
  EmbreeScene truth;
  truth.AddActors(scene.Renderer);
  vtkSmartPointer<vtkRelievoLamps> set = scene.AddLamps(lamps);
  set->SetCasts(vtkRelievoLamps::CASTS_NEVER);
  const Layers open(scene.Read(Light));
  set->SetCasts(vtkRelievoLamps::CASTS_ALWAYS);
  const Layers shadowed(scene.Read(Light));
  RELIEVO_CHECK(scene.Stage->GetNumberCasting() == 3);
  const TruthImage view = truth.Trace(View(scene.Renderer));
  std::vector<ShadowErrors> found;
  for (int c = 0; c < 3; ++c)
  {
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(180.0);
    light->SetPosition(places[c].x, places[c].y, places[c].z);
    std::vector<float> visibility;
    for (int y = 0; y < open.Height; ++y)
    {
      for (int x = 0; x < open.Width; ++x)
      {
        const double all = open.Value("light", x, y, c);
        const double seen = shadowed.Value("light", x, y, c);
        visibility.push_back(all > 0.0 ? static_cast<float>(seen / all) : 1.0f);
      }
    }
    found.push_back(CompareShadow(TraceShadow(truth, view, light), visibility.data()));
    std::cout << what << ", lamp " << c << ": " << found.back().ToString() << "\n";
  }
  scene.Stage->RemoveAllPoints();
  return found;
}

void CheckAgainstRays(LampScene& scene, const glm::dvec3* places, const std::string& what)
{
  for (const ShadowErrors& errors : CompareWithRays(scene, places, what))
  {
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), 0.002, what);
    RELIEVO_CHECK(errors.Dark > 100);
  }
}

const glm::dvec3 Around[3] = { { -2.0, 1.6, 2.0 }, { 0.2, 2.4, 0.3 }, { 2.6, 0.4, -0.8 } };

void TestRays()
{
  for (const int way : { vtkRelievoLampsStage::QUADS, vtkRelievoLampsStage::CLUSTERS })
  {
    LampScene scene(200, 150);
    const GLCheck gl(scene.Window);
    scene.Stage->SetWay(way);
    CheckAgainstRays(scene, Around, "way " + std::to_string(way));
  }
  LampScene parallel(200, 150);
  parallel.Renderer->GetActiveCamera()->ParallelProjectionOn();
  parallel.Renderer->GetActiveCamera()->SetParallelScale(2.2);
  CheckAgainstRays(parallel, Around, "parallel");
  LampScene coarse(200, 150);
  coarse.Window->SetMultiSamples(8);
  coarse.Frame->DeferredOn();
  CheckAgainstRays(coarse, Around, "deferred, 8 samples");
  const glm::dvec3 offset(1e5, -2e5, 1e5);
  LampScene far(200, 150, offset);
  const glm::dvec3 there[3] = { Around[0] + offset, Around[1] + offset, Around[2] + offset };
  CheckAgainstRays(far, there, "far from the origin");
  // Inside the ball, on the floor, inside the cone.
  LampScene scene(200, 150);
  const glm::dvec3 within[3] = { { -0.7, 0.8, 0.0 }, { 0.2, 1e-3, 1.5 }, { 1.0, 0.3, 0.4 } };
  CheckAgainstRays(scene, within, "inside and on surfaces");
}

// The error is the map's: it falls with the map's size, and grows with the density of edges.
void TestScenesByLot(const std::string& name, int scenes, vtkPolyData* mesh, double limit)
{
  Lots lots(31);
  const int sizes[] = { 512, 1024, 2048 };
  std::vector<double> error[3];
  for (int i = 0; i < scenes; ++i)
  {
    LampScene scene(200, 150);
    vtkActorCollection* actors = scene.Renderer->GetActors();
    for (int j = 0; j < 2; ++j) // the ball and the cone
    {
      scene.Renderer->RemoveActor(vtkActor::SafeDownCast(actors->GetItemAsObject(0)));
    }
    AddActor(scene.Renderer, mesh ? vtkSmartPointer<vtkPolyData>(mesh) : MakeThings(lots));
    const auto bunny = mesh || i % 3 != 0 ? nullptr : LoadMesh("bunny");
    if (bunny)
    {
      AddActor(scene.Renderer, PlaceMesh(bunny, false));
    }
    glm::dvec3 places[3];
    for (glm::dvec3& place : places)
    {
      place = { lots.Between(-2.5, 2.5), lots.Between(0.4, 3.0), lots.Between(-1.8, 2.2) };
    }
    for (int size = 0; size < 3; ++size)
    {
      scene.Frame->GetShadowStage()->SetLampMapSize(sizes[size]);
      for (const ShadowErrors& errors :
        CompareWithRays(scene, places, name + " " + std::to_string(i)))
      {
        error[size].push_back(errors.Wrong());
      }
    }
  }
  double means[3];
  for (int size = 0; size < 3; ++size)
  {
    const std::vector<double>& each = error[size];
    means[size] = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size());
    std::cout << name << ", maps of " << sizes[size] << ": mean " << means[size] << ", worst "
              << *std::max_element(each.begin(), each.end()) << " of " << each.size() << "\n";
  }
  RELIEVO_CHECK_AT_MOST(
    *std::max_element(error[1].begin(), error[1].end()), limit, name + ": worst, maps of 1024");
  RELIEVO_CHECK_AT_MOST(means[1], 0.75 * means[0], name + ": maps of 1024 over those of 512");
  RELIEVO_CHECK_AT_MOST(means[2], 0.75 * means[1], name + ": maps of 2048 over those of 1024");
}

// A lamp lights white surfaces as VTK's own positional light does with the shadow stage's maps:
// there VTK's picture is the light.
void TestPointLight()
{
  for (const bool glossy : { false, true })
  {
    LampScene scene(160, 120);
    scene.Renderer->AutomaticLightCreationOff();
    vtkActorCollection* actors = scene.Renderer->GetActors();
    for (int i = 0; glossy && i < actors->GetNumberOfItems(); ++i)
    {
      auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
      actor->GetProperty()->SetDiffuse(0.0);
      actor->GetProperty()->SetSpecular(1.0);
      actor->GetProperty()->SetSpecularPower(8.0);
    }
    const double attenuation[3] = { 0.9, 0.2, 0.05 };
    const glm::dvec3 place(0.2, 2.4, 1.3);
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(180.0);
    light->SetPosition(place.x, place.y, place.z);
    light->SetAttenuationValues(attenuation[0], attenuation[1], attenuation[2]);
    scene.Renderer->AddLight(light);
    scene.Frame->ShadowsOn();
    scene.Frame->GetShadowStage()->SetLampMapSize(scene.Frame->GetShadowStage()->GetMapSize());
    vtkSmartPointer<vtkImageData> expected = Picture(scene.Window);
    light->SwitchOff();
    vtkSmartPointer<vtkRelievoLamps> lamps = scene.AddLamps({ { place, 100.0, 1.0, White } });
    lamps->SetFalloffToVTK();
    lamps->SetAttenuationValues(attenuation[0], attenuation[1], attenuation[2]);
    scene.Stage->SetCasting(1);
    const Layers seen(scene.Read({ glossy ? "color" : "light" }));
    double worst = 0.0;
    int dark = 0;
    for (int y = 0; y < seen.Height; ++y)
    {
      for (int x = 0; x < seen.Width; ++x)
      {
        const double value = std::min(1.0, seen.Value(glossy ? "color" : "light", x, y));
        const double level = expected->GetScalarComponentAsDouble(x, y, 0, 0);
        worst = std::max(worst, std::abs(255.0 * value - level));
        dark += level == 0.0 ? 1 : 0;
      }
    }
    RELIEVO_CHECK_AT_MOST(
      worst, 1.0, std::string(glossy ? "highlights" : "light") + ", levels of 255");
    RELIEVO_CHECK(dark > 500);
  }
}

// Walls, hidden and shown; props that never cast; unchanged props are not redrawn.
void TestCasters()
{
  LampScene scene(120, 90);
  GLCheck gl(scene.Window);
  vtkRelievoShadowStage* shadows = scene.Frame->GetShadowStage();
  auto* ball = vtkActor::SafeDownCast(scene.Renderer->GetActors()->GetItemAsObject(0));
  std::vector<Lamp> lamps{ { Around[1], 6.0, 1.0, White } };
  vtkSmartPointer<vtkRelievoLamps> set = scene.AddLamps(lamps);
  const Layers open(scene.Read(Light));
  scene.Stage->SetCasting(8);
  const Layers cast(scene.Read(Light));
  RELIEVO_CHECK(CountDifferent(open, cast, "light") > 200);
  RELIEVO_CHECK(GetFact(shadows, "lamp_maps_drawn") == GetFact(shadows, "lamp_maps"));
  RELIEVO_CHECK(GetFact(shadows, "lamp_maps") > 0);
  RELIEVO_CHECK(
    scene.Stage->GetReason().find("1 casts shadows, at (0.2, 2.4, 0.3)") != std::string::npos);
  const Layers still(scene.Read(Light));
  RELIEVO_CHECK(GetFact(shadows, "lamp_maps_drawn") == 0);
  RELIEVO_CHECK(CountDifferent(cast, still, "light") == 0);

  shadows->SetPropCasts(ball, vtkRelievoShadowStage::CASTS_NEVER);
  const Layers without(scene.Read(Light));
  RELIEVO_CHECK(CountDifferent(cast, without, "light") > 50);
  shadows->SetPropCasts(ball, vtkRelievoShadowStage::CASTS_IF_OPAQUE);
  RELIEVO_CHECK(CountDifferent(cast, Layers(scene.Read(Light)), "light") == 0);
  // Hidden, the ball neither casts nor is visible: its shadow disappears.
  ball->VisibilityOff();
  const Layers hidden(scene.Read(Light));
  shadows->SetPropCasts(ball, vtkRelievoShadowStage::CASTS_NEVER);
  RELIEVO_CHECK(CountDifferent(hidden, Layers(scene.Read(Light)), "light") == 0);
  ball->VisibilityOn();
  shadows->SetPropCasts(ball, vtkRelievoShadowStage::CASTS_IF_OPAQUE);

  // Moving in every frame, and back.
  for (int i = 0; i < 5; ++i)
  {
    lamps[0].Place.x = -0.5 + 0.3 * i;
    set->SetInputData(ToPolyData(lamps));
    const Layers moved(scene.Read(Light));
    RELIEVO_CHECK(CountDifferent(cast, moved, "light") > 200);
    RELIEVO_CHECK(GetFact(shadows, "lamp_maps_drawn") > 0);
  }
  lamps[0].Place = Around[1];
  set->SetInputData(ToPolyData(lamps));
  RELIEVO_CHECK(CountDifferent(cast, Layers(scene.Read(Light)), "light") == 0);

  // A share of the light is left; a small lamp in a large scene keeps its shadow.
  shadows->SetStrength(0.5);
  const Layers half(scene.Read(Light));
  double worst = 0.0;
  for (int y = 0; y < half.Height; ++y)
  {
    for (int x = 0; x < half.Width; ++x)
    {
      worst = std::max(worst,
        std::abs(half.Value("light", x, y) -
          0.5 * (open.Value("light", x, y) + cast.Value("light", x, y))));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-6, "strength 0.5");
  gl.Poll("end of casters");
}

// Shadows of lamps fall on everything, whatever was chosen for those of the renderer's lights.
void TestReceivers()
{
  LampScene scene(120, 90);
  vtkActorCollection* actors = scene.Renderer->GetActors();
  scene.AddLamps({ { Around[0], 6.0, 1.0, White }, { Around[1], 6.0, 1.0, White } });
  scene.Stage->SetCasting(8);
  const Layers all(scene.Read(Light));
  for (int i = actors->GetNumberOfItems() - 1; i >= 0; --i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    scene.Frame->GetShadowStage()->SetPropReceives(actor, false);
    const Layers fewer(scene.Read(Light));
    RELIEVO_CHECK(CountDifferent(all, fewer, "light") == 0);
  }
}

// With a lamp at the eye, no visible surface is in shadow, except a texel at silhouettes.
void TestAtEye()
{
  LampScene scene(120, 90);
  const double* eye = scene.Renderer->GetActiveCamera()->GetPosition();
  vtkSmartPointer<vtkRelievoLamps> set =
    scene.AddLamps({ { glm::dvec3(eye[0], eye[1], eye[2]), 30.0, 1.0, White } });
  const Layers open(scene.Read(Light));
  set->SetCasts(vtkRelievoLamps::CASTS_ALWAYS);
  const Layers cast(scene.Read(Light));
  RELIEVO_CHECK(scene.Stage->GetNumberCasting() == 1);
  RELIEVO_CHECK_AT_MOST(static_cast<double>(CountDifferent(open, cast, "light")) / (120 * 90), 0.02,
    "pixels in shadow of a lamp at the eye");
}

// Beyond a lamp's radius lies most of the scene.
void TestSmallLamp()
{
  double dark[2];
  for (const bool large : { false, true })
  {
    LampScene scene(120, 90);
    auto* floor = vtkActor::SafeDownCast(scene.Renderer->GetActors()->GetItemAsObject(2));
    if (large)
    {
      floor->SetScale(1e3, 1.0, 1e3);
    }
    scene.AddLamps({ { glm::dvec3(0.3, 1.5, 1.2), 2.2, 1.0, White } });
    scene.Stage->SetCasting(1);
    const Layers cast(scene.Read(Light));
    dark[large] = 0.0;
    for (int y = 0; y < cast.Height; ++y)
    {
      for (int x = 0; x < cast.Width; ++x)
      {
        dark[large] += cast.Value("light", x, y);
      }
    }
  }
  RELIEVO_CHECK_NEAR(
    dark[1] / dark[0], 1.0, 0.01, "light in a large scene over that in a small one");
}

// From none to eight and back, other sizes, off and on: the same pictures, and nothing held.
void TestToggles()
{
  LampScene scene(100, 80);
  vtkSmartPointer<vtkRelievoLamps> set = scene.AddLamps(RandomLamps(40, 2.0, false));
  vtkSmartPointer<vtkImageData> none = Picture(scene.Window);
  const vtkIdType bytes = scene.Frame->GetBytesHeld();
  const GLObjects objects = CountGLObjects(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetStage("shadows")->GetBytesHeld() == 0);
  RELIEVO_CHECK(GetFact(scene.Stage, "lamps_casting") == 0);
  scene.Stage->SetCasting(8);
  vtkSmartPointer<vtkImageData> eight = Picture(scene.Window);
  RELIEVO_CHECK(FailuresOf([&]() { SamePicture(none, eight, "eight"); }) > 0);
  RELIEVO_CHECK(GetFact(scene.Stage, "lamps_casting") > 4);
  RELIEVO_CHECK(scene.Frame->GetStage("shadows")->GetBytesHeld() > 0);
  for (int i = 0; i < 12; ++i)
  {
    scene.Stage->SetCasting(i % 3 * 4);
    scene.Stage->SetWay(i % 4);
    scene.Frame->SetShadows(i % 2 == 0);
    scene.Window->SetSize(100 + i % 5, 80);
    scene.Window->Render();
    scene.Frame->ShadowsOff();
    scene.Stage->SetWay(vtkRelievoLampsStage::AUTOMATIC);
    scene.Window->SetSize(100, 80);
    scene.Stage->SetCasting(8);
    SamePicture(eight, Picture(scene.Window), "eight again, " + std::to_string(i));
  }
  scene.Stage->SetCasting(0);
  SamePicture(none, Picture(scene.Window), "none again");
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == bytes);
  RELIEVO_CHECK(CountGLObjects(scene.Window).Bytes <= objects.Bytes);
  RELIEVO_CHECK(scene.Frame->GetStage("shadows")->GetReasonCode() == "not_asked" ||
    scene.Frame->GetStage("shadows")->GetReasonCode() == "off");
  // All named, more than there is room for; and none, whatever the stage would choose.
  set->SetCasts(vtkRelievoLamps::CASTS_ALWAYS);
  scene.Window->Render();
  RELIEVO_CHECK(scene.Stage->GetNumberCasting() > 4 && scene.Stage->GetNumberCasting() <= 8);
  set->SetCasts(vtkRelievoLamps::CASTS_NEVER);
  scene.Stage->SetCasting(8);
  SamePicture(none, Picture(scene.Window), "none may");
  RELIEVO_CHECK(scene.Stage->GetNumberCasting() == 0);
  scene.Stage->RemoveAllPoints();
  scene.Window->Render();
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
}

// Lamps that are none.
void TestRefusals()
{
  LampScene scene(60, 45);
  vtkSmartPointer<vtkImageData> plain = Picture(scene.Window);
  scene.Stage->SetCasting(8);
  scene.AddLamps({ { Around[1], 0.0, 1.0, White }, { Around[0], 2.0, 0.0, White } });
  SamePicture(plain, Picture(scene.Window), "lamps without radius or intensity");
}
}

RELIEVO_TEST_CASE(testLampsCast)
{
  relievoTest::Session session;
  TestRays();
  const int scenes = IsLong(argc, argv) ? 4 : 1;
  TestScenesByLot("things by lot", 3 * scenes, nullptr, 0.002);
  TestScenesByLot("arrows", scenes, MakeArrows(), 0.02);
  TestScenesByLot("a tree", scenes, MakeTree(), 0.005);
  TestPointLight();
  TestCasters();
  TestReceivers();
  TestAtEye();
  TestSmallLamp();
  TestToggles();
  TestRefusals();
  return session.Result();
}
}
