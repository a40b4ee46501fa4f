// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every light that VTK has, on every material: dark pixels are checked by rays; the set of
// materials must not matter; lit and dark surfaces look like VTK's with that light on and off.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowCatcher.h>
#include <vtkRelievoShadowStage.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowLights
{
namespace
{
using relievoTest::CheckShadow;
using relievoTest::Picture;
using relievoTest::ShadowStage;

// Share of wrong verdicts: edges of shadows in a map of 2048 texels.
constexpr double Limit = 1e-3;

void TestKinds()
{
  ShadowStage sun;
  sun.AddThings();
  const relievoTest::GLCheck gl(sun.Window);
  sun.AddSun(-3., 4., -2.);
  CheckShadow(sun, 0, Limit, "sun");
  for (const double cone : { 15., 60., 89., 90., 120. })
  {
    ShadowStage stage;
    stage.AddThings();
    stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, cone);
    const auto errors = CheckShadow(stage, 0, Limit, "lamp of " + std::to_string(cone), 0.03);
    // A cone lights only its inside; from 90 degrees on there is none.
    RELIEVO_CHECK((errors.Compared < 12000) == (cone == 15.));
    RELIEVO_CHECK(stage.GetShadows()->GetNumberOfMaps() >= 1);
  }
}

// In the middle of six walls' worth of things: shadows in all directions.
void TestInTheMiddle()
{
  for (const double cone : { 60., 89., 90. })
  {
    ShadowStage stage;
    stage.AddGround();
    stage.AddBox({ 0., 2.2, 0. }, { 5., 0.1, 3. });
    stage.AddBox({ -2.5, 1., 0. }, { 0.1, 2., 3. });
    stage.AddBox({ 0., 1., -2. }, { 5., 2., 0.1 });
    for (const double x : { -1.2, 0.2, 1.3 })
    {
      stage.AddBox({ x, 0.6, -0.9 }, { 0.3, 0.4, 0.3 });
      stage.AddBox({ x, 1.5, 0.9 }, { 0.3, 0.3, 0.3 });
    }
    stage.AddLamp({ -0.4, 0.9, 0.1 }, { -0.6, 0.6, -0.9 }, cone);
    const std::string what = "lamp in the middle, " + std::to_string(cone);
    CheckShadow(stage, 0, 2e-3, what, 0.03);
    if (cone == 90.)
    {
      RELIEVO_CHECK_THAT(stage.GetShadows()->GetNumberOfMaps() >= 4, what + ": too few maps");
    }
  }
}

void TestCameraLights()
{
  ShadowStage stage;
  stage.AddThings();
  for (const bool lamp : { false, true })
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPositional(lamp);
    light->SetConeAngle(50.);
    light->SetPosition(-0.4, 0.8, 0.7);
    light->SetFocalPoint(0., 0., 0.);
    stage.Renderer->AddLight(light);
  }
  for (const int degrees : { 0, 35 })
  {
    stage.Renderer->GetActiveCamera()->Azimuth(degrees);
    CheckShadow(stage, 0, Limit, "sun of the camera");
    CheckShadow(stage, 1, Limit, "lamp of the camera");
  }
}

// A sun along the gaze of a parallel camera hides its shadows, except those of geometry cut away by
// the near plane: here a box above the eye.
void TestAlongTheView()
{
  ShadowStage stage(200, 150);
  stage.AddGround();
  const auto box = stage.AddBox({ 0.3, 7., 0.2 }, { 0.5, 0.2, 0.3 });
  stage.AddSun(0., 1., 0.);
  stage.GetFrame()->ShadowsOn();
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.);
  camera->SetPosition(0., 5., 0.);
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 0., -1.);
  camera->SetClippingRange(1., 10.);
  const auto image = relievoTest::CaptureShadow(stage, 0);
  auto* lit = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"));
  int mismatches = 0;
  int dark = 0;
  for (int i = 0; i < 200 * 150; ++i)
  {
    const double x = (i % 200 + 0.5) / 75. - 200. / 150.;
    const double z = 1. - (i / 200 + 0.5) / 75.;
    const bool under = std::abs(x - 0.3) < 0.25 && std::abs(z - 0.2) < 0.15;
    const bool edge =
      std::abs(std::abs(x - 0.3) - 0.25) < 0.01 || std::abs(std::abs(z - 0.2) - 0.15) < 0.01;
    dark += under ? 1 : 0;
    mismatches += !edge && (lit->GetValue(i) < 0.5) != under ? 1 : 0;
  }
  RELIEVO_CHECK(dark > 500);
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "above the eye: wrong verdicts");
  box->SetPosition(0., -6., 0.); // before the near plane no more
  stage.Window->Render();
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  RELIEVO_CHECK(shadows->GetNumberOfCastingLights() == 0);
  RELIEVO_CHECK(shadows->GetShadowLayers(stage.Renderer).empty());
  // Where light of casting lights is told from other light it counts, without maps.
  vtkRelievoShadowCatcher::Make(box);
  stage.Window->Render();
  RELIEVO_CHECK(shadows->GetNumberOfCastingLights() == 1 && shadows->GetNumberOfMaps() == 0);
  // With a size it casts.
  shadows->SetSoftSamples(4);
  stage.Window->Render();
  RELIEVO_CHECK(shadows->GetNumberOfCastingLights() == 1 && shadows->GetNumberOfMaps() == 1);
  RELIEVO_CHECK(shadows->GetShadowLayers(stage.Renderer).size() == 1);
}

// A lamp at the eye hides its own shadows, whatever its radius, and takes no maps from others.
void TestLampAtTheEye()
{
  ShadowStage stage;
  stage.AddThings();
  const double* eye = stage.Renderer->GetActiveCamera()->GetPosition();
  stage.AddLamp({ eye[0], eye[1], eye[2] }, { 0., 0., 0. }, 90.);
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->SetSoftSamples(4);
  shadows->SetLampRadius(0.2);
  stage.Window->Render();
  RELIEVO_CHECK(shadows->GetNumberOfCastingLights() == 1);
  RELIEVO_CHECK(shadows->GetShadowLayers(stage.Renderer).size() == 1);
  vtkRelievoShadowCatcher::Make(stage.Renderer->GetActors()->GetLastActor());
  stage.Window->Render();
  RELIEVO_CHECK(shadows->GetNumberOfCastingLights() == 2 && shadows->GetNumberOfMaps() == 1);
}

void TestLightKit()
{
  ShadowStage stage;
  stage.AddThings();
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(stage.Renderer);
  vtkRelievoPass* frame = stage.GetFrame();
  frame->ShadowsOn();
  stage.Window->Render();
  const int lights = stage.Renderer->GetLights()->GetNumberOfItems();
  RELIEVO_CHECK(lights == 5);
  int heads = 0;
  for (int i = 0; i < lights; ++i)
  {
    auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(i));
    if (light->LightTypeIsHeadlight())
    {
      ++heads;
      const std::string words =
        "light " + std::to_string(i) + " casts none: a light at the eye hides its own shadows";
      RELIEVO_CHECK_THAT(frame->GetFrameReport().find(words) != std::string::npos,
        "the report does not say: " + words + "; it says " + frame->GetFrameReport());
      continue;
    }
    // Back lights shine on few of the pixels.
    const auto errors = relievoTest::JudgeShadow(stage, i);
    std::cout << "light kit, " << i << ": " << errors.ToString() << "\n";
    RELIEVO_CHECK(errors.Compared > 500);
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), 2e-3, "light kit: share of wrong verdicts");
  }
  RELIEVO_CHECK(heads == 1 && stage.GetShadows()->GetNumberOfCastingLights() == lights - heads);
  kit->RemoveLightsFromRenderer(stage.Renderer);
}

// Eight at once, each with its own shadow; one off and one that is told to cast none in between.
void TestEight()
{
  ShadowStage stage(160, 120);
  stage.AddThings();
  const relievoTest::GLCheck gl(stage.Window);
  stage.GetShadows()->SetMapSize(1024);
  for (int i = 0; i < 10; ++i)
  {
    const double angle = 0.7 * i;
    const double x = 3. * std::cos(angle);
    const double z = 3. * std::sin(angle);
    const auto light = i % 3 == 0
      ? stage.AddSun(x, 4., z)
      : stage.AddLamp({ x, 3., z }, { 0., 0., 0. }, i % 3 == 1 ? 50. : 90.);
    light->SetIntensity(0.12);
    if (i == 4)
    {
      light->SwitchOff();
    }
    if (i == 7)
    {
      stage.GetShadows()->SetLightCasts(light, false);
      RELIEVO_CHECK(!stage.GetShadows()->GetLightCasts(light));
    }
  }
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  RELIEVO_CHECK(stage.GetShadows()->GetNumberOfCastingLights() == 8);
  for (int i = 0; i < 10; ++i)
  {
    if (i == 4 || i == 7)
    {
      const auto image = relievoTest::CaptureShadow(stage, i);
      double range[2];
      image->GetPointData()->GetArray(("shadow_" + std::to_string(i)).c_str())->GetRange(range);
      RELIEVO_CHECK_THAT(range[0] == 1. && range[1] == 1.,
        "light " + std::to_string(i) + " casts none, and has a shadow");
      continue;
    }
    CheckShadow(stage, i, 3e-3, "light " + std::to_string(i) + " of ten");
  }
}

void TestWarnings()
{
  ShadowStage stage;
  stage.AddThings();
  const auto light = stage.AddSun(0., 0., 0.);
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  {
    relievoTest::ExpectMessage expect("light 0 casts no shadow");
    for (int i = 0; i < 3; ++i)
    {
      stage.Window->Render();
    }
    RELIEVO_CHECK_THAT(expect.Count() == 1, std::to_string(expect.Count()) + " warnings");
  }
  RELIEVO_CHECK(stage.GetShadows()->GetNumberOfCastingLights() == 1);
  const auto spot = stage.AddLamp({ 0., 3., -1. }, { 0., 0., 0. }, 0.);
  {
    relievoTest::ExpectMessage expect("light 2 casts no shadow: its cone angle is 0");
    stage.Window->Render();
    stage.Window->Render();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  const double* eye = stage.Renderer->GetActiveCamera()->GetPosition();
  spot->SetPosition(eye[0], eye[1], eye[2]);
  stage.Window->Render();
  RELIEVO_CHECK(
    stage.GetFrame()->GetFrameReport().find("its cone angle is 0") != std::string::npos);
  stage.Renderer->RemoveLight(spot);
  light->SetPosition(3., 5., 2.);
  CheckShadow(stage, 0, Limit, "a light that got its direction");
}

struct Material
{
  const char* Name;
  std::function<void(vtkActor*)> Set;
};

// Colours at the points, or cells, of a mesh.
void SetColors(vtkActor* actor, bool atPoints)
{
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  vtkNew<vtkFloatArray> values;
  values->SetName("values");
  const vtkIdType count = atPoints ? mesh->GetNumberOfPoints() : mesh->GetNumberOfCells();
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 5) / 4.f);
  }
  vtkDataSetAttributes* data = mesh->GetPointData();
  if (!atPoints)
  {
    data = mesh->GetCellData();
  }
  data->SetScalars(values);
}

const Material Materials[] = {
  { "flat", [](vtkActor* a) { a->GetProperty()->SetInterpolationToFlat(); } },
  { "Gouraud", [](vtkActor* a) { a->GetProperty()->SetInterpolationToGouraud(); } },
  { "Phong, shiny",
    [](vtkActor* a) {
      a->GetProperty()->SetInterpolationToPhong();
      a->GetProperty()->SetSpecular(0.6);
      a->GetProperty()->SetSpecularPower(20.);
    } },
  { "PBR", [](vtkActor* a) { a->GetProperty()->SetInterpolationToPBR(); } },
  { "PBR, metal",
    [](vtkActor* a) {
      a->GetProperty()->SetInterpolationToPBR();
      a->GetProperty()->SetMetallic(0.8);
      a->GetProperty()->SetRoughness(0.4);
    } },
  { "PBR, anisotropic",
    [](vtkActor* a) {
      a->GetProperty()->SetInterpolationToPBR();
      a->GetProperty()->SetAnisotropy(0.7);
      a->GetProperty()->SetAnisotropyRotation(0.2);
    } },
  { "PBR, coat",
    [](vtkActor* a) {
      a->GetProperty()->SetInterpolationToPBR();
      a->GetProperty()->SetCoatStrength(0.8);
      a->GetProperty()->SetCoatRoughness(0.1);
    } },
  { "point colours", [](vtkActor* a) { SetColors(a, true); } },
  { "cell colours", [](vtkActor* a) { SetColors(a, false); } },
  { "texture", [](vtkActor* a) { a->SetTexture(relievoTest::MakeChecker(false)); } },
  { "ambient",
    [](vtkActor* a) {
      a->GetProperty()->SetAmbient(0.3);
      a->GetProperty()->SetDiffuse(0.7);
    } },
};

// A sun, a spot, a lamp in all directions; and a light that casts none.
void Test(const Material& material, const std::vector<int>& numbers)
{
  ShadowStage stage;
  stage.AddThings();
  const vtkSmartPointer<vtkLight> lights[] = { stage.AddSun(-3., 4., -2.),
    stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 40.),
    stage.AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, 90.) };
  const auto fill = stage.AddSun(-2., 3., 4.);
  stage.GetShadows()->SetLightCasts(fill, false);
  for (vtkLight* light : { lights[0].Get(), lights[1].Get(), lights[2].Get(), fill.Get() })
  {
    light->SetIntensity(0.25);
  }
  const std::vector<std::string> masks = { "shadow_0", "shadow_1", "shadow_2" };
  const relievoTest::Layers plain(stage.Renderer, masks);
  std::vector<relievoTest::ShadowTruth> truths;
  for (const int number : numbers)
  {
    truths.push_back(relievoTest::TraceStage(stage, number));
  }
  vtkActorCollection* actors = stage.Renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    material.Set(actor);
  }
  const std::string name = material.Name;
  const relievoTest::Layers styled(stage.Renderer, masks);
  for (const std::string& mask : masks)
  {
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(plain, styled, mask), 0,
      name + ": pixels of " + mask + " unlike the default material's");
  }
  const auto off = Picture(stage.Window);
  stage.GetFrame()->ShadowsOn();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const std::string what = name + ", light " + std::to_string(numbers[i]);
    for (int j = 0; j < 3; ++j)
    {
      stage.GetShadows()->SetLightCasts(lights[j], j == numbers[i]);
    }
    const auto shadows = Picture(stage.Window);
    stage.GetFrame()->ShadowsOff();
    lights[numbers[i]]->SetIntensity(0.);
    const auto dark = Picture(stage.Window);
    lights[numbers[i]]->SetIntensity(0.25);
    stage.GetFrame()->ShadowsOn();
    const auto errors = relievoTest::JudgePicture(shadows, off, dark, truths[i], 1, 1);
    std::cout << what << ": " << errors.ToString() << "\n";
    RELIEVO_CHECK(errors.Lit > 3000 && errors.Dark > 800);
    RELIEVO_CHECK_AT_MOST(static_cast<double>(errors.LitWrong) / static_cast<double>(errors.Lit),
      3e-4, what + ": lit pixels unlike the picture without shadows");
    RELIEVO_CHECK_AT_MOST(static_cast<double>(errors.DarkWrong) / static_cast<double>(errors.Dark),
      2e-3, what + ": dark pixels unlike the picture without that light");
    RELIEVO_CHECK_AT_MOST(errors.Outside, 20, what + ": pixels that are neither");
  }
}

// The middle pixel of a ground that the sun and the camera are straight above: the diffuse share,
// and the highlight's whole strength.
double GetMiddle(ShadowStage& stage)
{
  const auto picture = Picture(stage.Window);
  return picture->GetScalarComponentAsDouble(40, 30, 0, 0) / 255.;
}

// Highlights are left out while no surface has any: each way to get them brings them back.
void TestHighlights()
{
  ShadowStage stage(81, 61);
  stage.AddSun(0., 1., 0.);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetPosition(0., 6., 0.);
  camera->SetViewUp(0., 0., -1.);
  const auto ground = stage.AddGround();
  const auto make = [](double specular) {
    auto property = vtkSmartPointer<vtkProperty>::New();
    property->SetAmbient(0.);
    property->SetDiffuse(0.25);
    property->SetColor(1., 1., 1.);
    property->SetSpecular(specular);
    property->SetSpecularPower(20.);
    return property;
  };
  const auto shiny = make(0.5);
  const auto dull = make(0.);
  ground->SetProperty(dull);
  stage.GetShadows()->EnabledOn();
  stage.Renderer->ResetCameraClippingRange();
  constexpr double Step = 1. / 255.;
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.25), Step, "no highlight");
  ground->SetProperty(shiny);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.75), Step, "another property");
  ground->SetProperty(dull);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.25), Step, "the first property again");
  dull->SetSpecular(0.25);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.5), Step, "a changed property");
  dull->SetSpecular(0.);
  ground->SetBackfaceProperty(shiny);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.25), Step, "its back is shiny");
  camera->SetPosition(0., -6., 0.);
  stage.Renderer->GetLights()->RemoveAllItems();
  stage.AddSun(0., -1., 0.);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.75), Step, "the shiny back");
  ground->SetBackfaceProperty(nullptr);
  ground->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "specularColor = vec3(0.5);\n//VTK::Light::Impl\n", false);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.75), Step, "a highlight of a replacement");
  ground->GetShaderProperty()->ClearAllFragmentShaderReplacements();
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.25), Step, "no replacement");
  ground->GetShaderProperty()->AddFragmentShaderReplacement(
    "specular = specular * specularColor;", false, "specular = specular * 0.5;", false);
  RELIEVO_CHECK_AT_MOST(std::abs(GetMiddle(stage) - 0.75), Step, "a replacement made last");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowLights)
{
  relievoTest::Session session;
  TestKinds();
  TestInTheMiddle();
  TestCameraLights();
  TestAlongTheView();
  TestLampAtTheEye();
  TestLightKit();
  TestEight();
  TestWarnings();
  TestHighlights();
  int turn = 0;
  for (const Material& material : Materials)
  {
    // The materials that VTK's own shadows fail on with all lights, others in turns.
    const bool all = std::string(material.Name) == "PBR";
    Test(material, all ? std::vector<int>{ 0, 1, 2 } : std::vector<int>{ turn++ % 3 });
  }
  return session.Result();
}
}
