// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps that cast beside lights that do: each has all of its shadows.
#include "Check.h"
#include "LampScenes.h"
#include "Layers.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRelievoShadowStage.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace testLampsBesideLights
{
namespace
{
using namespace relievoTest;

const std::vector<std::string> Light{ "light" };

void AddSun(LampScene& scene)
{
  vtkNew<vtkLight> light;
  light->SetPosition(-2.0, 4.0, 3.0);
  scene.Renderer->AddLight(light);
  scene.Frame->ShadowsOn();
}

// The frame that makes the lamps' maps keeps the sun's: sunlight equals that of the next frame.
void TestFirstFrame()
{
  LampScene scene(120, 90);
  AddSun(scene);
  scene.AddLamps({ { glm::dvec3(0.2, 2.4, 0.3), 6.0, 1.0, glm::dvec3(1.0) } });
  scene.Stage->SetCasting(1);
  const vtkSmartPointer<vtkImageData> first = Picture(scene.Window);
  SamePicture(Picture(scene.Window), first, "the first frame of lamps' maps beside a sun's");
  for (const int size : { 256, 512 })
  {
    scene.Frame->GetShadowStage()->SetLampMapSize(size);
    const vtkSmartPointer<vtkImageData> anew = Picture(scene.Window);
    SamePicture(Picture(scene.Window), anew, "maps of another size");
  }
}

// Lamps have maps of all that casts, whatever way the lights' own shadows take.
void TestBesideLights()
{
  const std::vector<Lamp> lamps{ { glm::dvec3(-2.0, 1.6, 2.0), 6.0, 1.0, glm::dvec3(1.0) },
    { glm::dvec3(0.2, 2.4, 0.3), 6.0, 1.0, glm::dvec3(1.0) } };
  LampScene scene(120, 90);
  AddSun(scene);
  scene.AddLamps(lamps);
  const Layers open(scene.Read(Light));
  scene.Stage->SetCasting(8);
  const Layers cast(scene.Read(Light));
  RELIEVO_CHECK(CountDifferent(open, cast, "light") > 200);
  LampScene other(120, 90);
  AddSun(other);
  other.AddLamps(lamps);
  other.Stage->SetCasting(8);
  vtkRelievoShadowStage* shadows = other.Frame->GetShadowStage();
  shadows->SetMethodToExact();
  RELIEVO_CHECK(CountDifferent(cast, Layers(other.Read(Light)), "light") == 0);
  shadows->SetMethodToMap();
  RELIEVO_CHECK(CountDifferent(cast, Layers(other.Read(Light)), "light") == 0);
  shadows->SetTolerance(1e-6);
  RELIEVO_CHECK(CountDifferent(cast, Layers(other.Read(Light)), "light") == 0);
  RELIEVO_CHECK(shadows->GetMethodUsed() == vtkRelievoShadowStage::METHOD_EXACT);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLampsBesideLights)
{
  Session session;
  TestFirstFrame();
  TestBesideLights();
  return session.Result();
}
}
