// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps that cast beside lights that do: each has all of its shadows.
#include "Check.h"
#include "LampScenes.h"
#include "Layers.h"
#include "Session.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRelievoShadowPass.h>

#include <string>
#include <vector>

namespace
{
using namespace relievoTest;

const std::vector<std::string> Light{ "light" };

vtkSmartPointer<vtkRelievoLamps> Add(LampScene& scene, const std::vector<Lamp>& lamps)
{
  auto set = vtkSmartPointer<vtkRelievoLamps>::New();
  set->SetInputData(ToPolyData(lamps));
  scene.Stage->AddLamps(set);
  return set;
}

// Lamps have maps of all that casts, whatever way the lights' own shadows take.
void TestBesideLights()
{
  const std::vector<Lamp> lamps{ { glm::dvec3(-2.0, 1.6, 2.0), 6.0, 1.0, glm::dvec3(1.0) },
    { glm::dvec3(0.2, 2.4, 0.3), 6.0, 1.0, glm::dvec3(1.0) } };
  const auto addSun = [](LampScene& scene) {
    vtkNew<vtkLight> light;
    light->SetPosition(-2.0, 4.0, 3.0);
    scene.Renderer->AddLight(light);
    scene.Frame->ShadowsOn();
  };
  LampScene scene(120, 90);
  addSun(scene);
  Add(scene, lamps);
  const Layers open(scene.Read(Light));
  scene.Stage->SetCasting(8);
  const Layers cast(scene.Read(Light));
  RELIEVO_CHECK(CountDifferent(open, cast, "light") > 200);
  LampScene other(120, 90);
  addSun(other);
  Add(other, lamps);
  other.Stage->SetCasting(8);
  vtkRelievoShadowPass* shadows = other.Frame->GetShadowPass();
  shadows->SetMethodToExact();
  RELIEVO_CHECK(CountDifferent(cast, Layers(other.Read(Light)), "light") == 0);
  shadows->SetMethodToMap();
  RELIEVO_CHECK(CountDifferent(cast, Layers(other.Read(Light)), "light") == 0);
  shadows->SetTolerance(1e-6);
  RELIEVO_CHECK(CountDifferent(cast, Layers(other.Read(Light)), "light") == 0);
  RELIEVO_CHECK(shadows->GetMethodUsed() == vtkRelievoShadowPass::METHOD_EXACT);
}
}

//------------------------------------------------------------------------------
int main()
{
  Session session;
  TestBesideLights();
  return session.Result();
}
