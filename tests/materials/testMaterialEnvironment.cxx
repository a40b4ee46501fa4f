// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reflections of an environment in surfaces, and its light on them, compared with the light of
// reflected rays and sums over the sphere.
#include "Check.h"
#include "MirrorScene.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "TestCase.h"
#include "View.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoEnvironmentIrradiance.h>
#include <vtkRelievoEnvironmentPrefilter.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoSkybox.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>

#include <cmath>

namespace testMaterialEnvironment
{
namespace
{
using namespace relievoTest;

const glm::dvec3 Nothing(-1.);
const glm::dvec3 Sides[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
  { 0, 0, -1 } };

void TestSides()
{
  for (const glm::dvec3& side : Sides)
  {
    MirrorScene scene(SixColors, Cube, 64, Wall(side));
    scene.LookAt(side, 80.);
    const auto truth = [&side](const glm::dvec3& d) {
      const glm::dvec3 r = glm::reflect(d, side);
      return AngleToEdge(r) > 0.05 ? SixColors(r) : Nothing;
    };
    for (const int shading : { VTK_FLAT, VTK_GOURAUD, VTK_PHONG, VTK_PBR })
    {
      scene.Actor->GetProperty()->SetInterpolation(shading);
      const bool encoded = shading == VTK_PBR;
      RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3& d) {
        const glm::dvec3 c = truth(d);
        return encoded && c.x >= 0. ? glm::pow(c, glm::dvec3(1. / 2.2)) : c;
      }),
        encoded ? 1. : 1e-6, "six colours in shading " + std::to_string(shading) + ", 255ths");
    }
  }
}

void TestProjections()
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.6, 0.5, 0.9));
  for (const int projection : { Equirectangular, Cube, SphereMap })
  {
    MirrorScene scene(Smooth, projection, 256, Wall(normal));
    const auto truth = [&](const glm::dvec3& d) { return Smooth(glm::reflect(d, normal)); };
    for (const double slant : { 0., 40., 70. })
    {
      const glm::dvec3 from =
        TurnedAbout(glm::normalize(glm::cross(normal, { 0, 1, 0 })), slant, normal);
      scene.LookAt(from, slant > 60. ? 15. : 40.);
      RELIEVO_CHECK_AT_MOST(scene.Worst(truth), 1.,
        "projection " + std::to_string(projection) + " at " + std::to_string(slant) + ", 255ths");
    }
    scene.LookAt(normal, 30.);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    RELIEVO_CHECK_AT_MOST(scene.Worst(truth), 1., "parallel, 255ths");
  }
  // Exactly behind, where a sphere map has its rim.
  MirrorScene scene(Smooth, SphereMap, 512, Wall({ 0, 0, -1 }));
  scene.LookAt({ 0, 0, -1 }, 20.);
  RELIEVO_CHECK_AT_MOST(scene.Worst([](const glm::dvec3& d) {
    return Smooth({ d.x, d.y, -d.z });
  }),
    25., "sphere map, back-facing, 255ths");
}

// The reflection equals the sky for any rotation; moved and rotated actors reflect alike.
void TestTurns()
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.3, 0.8, 0.5));
  MirrorScene scene(Smooth, Cube, 256, Wall(normal));
  scene.LookAt(normal + glm::dvec3(0.4, 0., 0.3), 50.);
  const auto truth = [&](const glm::dvec3& d) { return Smooth(glm::reflect(d, normal)); };
  for (const double degrees : { 90., -37. })
  {
    scene.Environment->SetRotation(degrees);
    RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3& d) {
      return Smooth(TurnedAbout({ 0, 1, 0 }, -degrees, glm::reflect(d, normal)));
    }),
      1., "turned by " + std::to_string(degrees) + ", 255ths");
  }
  scene.Environment->SetRotation(0.);
  scene.Environment->SetUpAxis(2);
  RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3& d) {
    const glm::dvec3 r = glm::reflect(d, normal);
    return Smooth({ r.x, r.z, -r.y });
  }),
    1., "z up, 255ths");
  scene.Environment->SetUpAxis(1);
  scene.Actor->RotateWXYZ(180., normal.x, normal.y, normal.z);
  scene.Actor->SetScale(1.5, 1.5, 1.5);
  RELIEVO_CHECK_AT_MOST(scene.Worst(truth), 1., "a turned and scaled actor, 255ths");
  // From behind VTK turns the normal.
  scene.LookAt(-normal, 50.);
  RELIEVO_CHECK_AT_MOST(scene.Worst(truth), 1., "seen from behind, 255ths");
}

void TestNormalMap()
{
  const glm::dvec3 tilted = glm::normalize(glm::dvec3(0.3, -0.2, 1.));
  MirrorScene scene(Smooth, Cube, 256, Wall({ 0, 0, 1 }));
  vtkNew<vtkImageData> map;
  map->SetDimensions(2, 2, 1);
  map->AllocateScalars(VTK_FLOAT, 3);
  for (int i = 0; i < 12; ++i)
  {
    map->GetPointData()->GetScalars()->SetComponent(i / 3, i % 3, tilted[i % 3]);
  }
  scene.Material->SetNormalMap(map);
  scene.LookAt({ 0.3, 0.2, 1. }, 50.);
  RELIEVO_CHECK_AT_MOST(
    scene.Worst([&](const glm::dvec3& d) { return Smooth(glm::reflect(d, tilted)); }), 1.,
    "about a mapped normal, 255ths");
}

void TestFresnel()
{
  const glm::dvec3 normal(0., 0., 1.);
  const glm::dvec3 own(0.2, 0.6, 0.4);
  const glm::dvec3 behind(0.9, 0.1, 0.5);
  MirrorScene scene(Smooth, Cube, 256, Wall(normal));
  scene.Renderer->SetBackground(behind.x, behind.y, behind.z);
  vtkProperty* look = scene.Actor->GetProperty();
  look->SetAmbientColor(own.x, own.y, own.z);
  look->SetAmbient(1.);
  scene.LookAt({ 1.5, 0.2, 0.5 }, 40.);
  for (const double reflectivity : { 0., 0.04, 0.5, 1. })
  {
    for (const double opacity : { 1., 0.3 })
    {
      const double weight = opacity < 1. ? 0.7 : 1.;
      scene.Material->SetReflectivity(reflectivity);
      scene.Material->SetReflectionWeight(weight);
      look->SetOpacity(opacity);
      RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3& d) {
        const double cosine = -glm::dot(d, normal);
        if (cosine < 0.1) // the wall ends
        {
          return Nothing;
        }
        const double share =
          weight * (reflectivity + (1. - reflectivity) * std::pow(1. - cosine, 5.));
        return share * Smooth(glm::reflect(d, normal)) +
          (1. - share) * (opacity * own + (1. - opacity) * behind);
      }),
        opacity < 1. ? 2. : 1., // VTK blends in halves
        "mirrored " + std::to_string(reflectivity) + ", opacity " + std::to_string(opacity) +
          ", 255ths");
    }
  }
}

// A PBR surface mirrors in its own colour as far as it is a metal, and white where it is grazed.
void TestMetal()
{
  const glm::dvec3 normal(0., 0., 1.);
  const glm::dvec3 gold(1., 0.77, 0.34);
  MirrorScene scene(Smooth, Cube, 256, Wall(normal));
  vtkProperty* look = scene.Actor->GetProperty();
  look->SetInterpolationToPBR();
  look->SetColor(gold.x, gold.y, gold.z);
  scene.Material->SetReflectivity(0.04);
  scene.LookAt({ 1.5, 0.2, 0.5 }, 40.);
  for (const double metallic : { 0., 0.5, 1. })
  {
    look->SetMetallic(metallic);
    RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3& d) {
      const double cosine = -glm::dot(d, normal);
      if (cosine < 0.1) // the wall ends
      {
        return Nothing;
      }
      const glm::dvec3 straight = glm::mix(glm::dvec3(0.04), gold, metallic);
      const glm::dvec3 share = straight + (1. - straight) * std::pow(1. - cosine, 5.);
      return glm::pow(share * Smooth(glm::reflect(d, normal)), glm::dvec3(1. / 2.2));
    }),
      1., "metal " + std::to_string(metallic) + ", 255ths");
  }
}

vtkSmartPointer<vtkPolyData> FineBall()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.);
  ball->SetThetaResolution(96);
  ball->SetPhiResolution(96);
  ball->Update();
  return ball->GetOutput();
}

void SetFilters(vtkRelievoEnvironment* environment, int size)
{
  vtkNew<vtkRelievoEnvironmentPrefilter> levels;
  levels->SetInputData(environment->GetImage());
  levels->SetSize(size);
  levels->Update();
  environment->SetLevels(levels->GetOutput());
  vtkNew<vtkRelievoEnvironmentIrradiance> irradiance;
  irradiance->SetInputData(environment->GetImage());
  irradiance->Update();
  environment->SetIrradiance(
    vtkDataArray::SafeDownCast(irradiance->GetOutput()->GetColumnByName("radiance")));
}

// Everything around has the same light: a perfect mirror has it too, however rough, and so has
// perfectly white matt stuff.
void TestFurnace()
{
  const glm::dvec3 even(0.8);
  MirrorScene scene([&](const glm::dvec3&) { return even; }, Cube, 16, FineBall());
  SetFilters(scene.Environment, 16);
  scene.LookAt({ 0.3, 0.4, 1. }, 16.);
  for (int i = 0; i <= 20; ++i)
  {
    scene.Material->SetRoughness(i / 20.);
    RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3&) { return even; }) / (255. * even.x),
      0.01, "furnace, roughness " + std::to_string(i / 20.) + ", relative");
  }
  scene.Material->SetReflectionWeight(0.);
  scene.Actor->GetProperty()->SetColor(1., 1., 1.);
  RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3&) { return even; }) / (255. * even.x),
    0.01, "furnace, matt white, relative");
}

void TestIrradiance()
{
  const glm::dvec3 color(0.9, 0.5, 0.7);
  const Light bright = [](const glm::dvec3& d) { return 1.1 * Smooth(d); };
  for (const double rotation : { 0., 90. })
  {
    for (const glm::dvec3& side : Sides)
    {
      MirrorScene scene(bright, Cube, 64, Wall(side));
      SetFilters(scene.Environment, 16);
      scene.Environment->SetRotation(rotation);
      scene.Material->SetReflectionWeight(0.);
      scene.Actor->GetProperty()->SetColor(color.x, color.y, color.z);
      scene.LookAt(side, 30.);
      const glm::dvec3 around = IrradianceOverPi(bright, TurnedAbout({ 0, 1, 0 }, -rotation, side));
      const glm::dvec3 truth = color * around;
      RELIEVO_CHECK_AT_MOST(
        scene.Worst([&](const glm::dvec3&) { return truth; }), 1., "irradiance, 255ths");
      scene.Material->SetIrradianceWeight(0.5);
      RELIEVO_CHECK_AT_MOST(
        scene.Worst([&](const glm::dvec3&) { return 0.5 * truth; }), 1., "half of it, 255ths");
      scene.Material->SetIrradianceWeight(1.);
      scene.Actor->GetProperty()->SetInterpolationToPBR();
      scene.Actor->GetProperty()->SetMetallic(0.25);
      RELIEVO_CHECK_AT_MOST(scene.Worst([&](const glm::dvec3&) {
        return glm::pow(0.75 * truth, glm::dvec3(1. / 2.2));
      }),
        1.5, "PBR, 255ths");
    }
  }
}
}

RELIEVO_TEST_CASE(testMaterialEnvironment)
{
  relievoTest::Session session;
  TestSides();
  TestProjections();
  TestTurns();
  TestNormalMap();
  TestFresnel();
  TestMetal();
  TestFurnace();
  TestIrradiance();
  return session.Result();
}
}
