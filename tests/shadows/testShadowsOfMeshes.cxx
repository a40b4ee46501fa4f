// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadow verdicts on the real meshes against Embree: every kind of light, any window shape, Phong
// and PBR.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

#include <iostream>
#include <map>

namespace testShadowsOfMeshes
{
namespace
{
using relievoTest::Layers;
using relievoTest::SceneLight;

// Largest share of wrong verdicts under the sun; lamps may have twice that.
const std::map<std::string, double> Limits = { { "bunny", 0.0012 }, { "motorBike", 0.0015 },
  { "buildings", 0.0008 } };

const int Sizes[][2] = { { 400, 400 }, { 600, 338 }, { 240, 960 } };

const float* Visibility(const Layers& layers)
{
  return vtkFloatArray::SafeDownCast(layers.Image->GetPointData()->GetArray("shadow_0"))
    ->GetPointer(0);
}

// Pictures that are not square are drawn where `everySize` is true.
void Test(
  const std::string& mesh, SceneLight kind, const std::string& name, double limit, bool everySize)
{
  const auto scene = relievoTest::MakeReferenceScene(mesh, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(400, 400, scene.Renderer);
  relievoTest::GLCheck gl(window);
  const auto truth = scene.MakeTruth();
  for (const auto& size : Sizes)
  {
    if (!everySize && size[0] != size[1])
    {
      continue;
    }
    window->SetSize(size[0], size[1]);
    window->Render();
    const auto view = truth->Trace(relievoTest::View(scene.Renderer));
    const auto shadow = relievoTest::TraceShadow(*truth, view, scene.Light);
    const std::string what =
      mesh + ", " + name + ", " + std::to_string(size[0]) + " x " + std::to_string(size[1]);
    const Layers phong(scene.Renderer, { "shadow_0" });
    const auto errors = relievoTest::CompareShadow(shadow, Visibility(phong));
    std::cout << what << ": " << errors.ToString() << "\n";
    RELIEVO_CHECK_THAT(errors.Compared > 10000 && errors.Dark > 1000, what + ": what is compared");
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), limit, what + ": share of wrong verdicts");
    for (vtkActor* actor : { scene.MeshActor.Get(), scene.GroundActor.Get() })
    {
      actor->GetProperty()->SetInterpolationToPBR();
    }
    const Layers pbr(scene.Renderer, { "shadow_0" });
    RELIEVO_CHECK_AT_MOST(
      relievoTest::CountDifferent(phong, pbr, "shadow_0"), 0, what + ": pixels unlike with PBR");
    for (vtkActor* actor : { scene.MeshActor.Get(), scene.GroundActor.Get() })
    {
      actor->GetProperty()->SetInterpolationToFlat();
    }
  }
  gl.Poll(mesh);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowsOfMeshes)
{
  relievoTest::Session session;
  for (const std::string& mesh : relievoTest::ReferenceMeshes())
  {
    const double limit = Limits.at(mesh);
    // Each mesh with one light in all sizes, and each light with one mesh.
    Test(mesh, SceneLight::Sun, "sun", limit, mesh == "bunny");
    Test(mesh, SceneLight::Spot, "spot", 2. * limit, mesh == "motorBike");
    Test(mesh, SceneLight::Point, "point", 2. * limit, mesh == "buildings");
  }
  return session.Result();
}
}
