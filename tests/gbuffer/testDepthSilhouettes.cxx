// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The refined depth of every pixel lies on the triangle whose id the pixel has: all real meshes, 6
// views of each (with the word `long` 24), silhouettes, slivers and all; and on the mesh of the
// actor whose id the pixel has, where meshes pass through each other. The truth is the mesh itself,
// in double.
#include "Check.h"
#include "Layers.h"
#include "Props.h"
#include "Scenes.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "View.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace testDepthSilhouettes
{
namespace
{
using relievoTest::Layers;
using relievoTest::Ray;
using relievoTest::Stage;
using relievoTest::View;

double DistanceToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 ab = b - a;
  const double length = glm::dot(ab, ab);
  const double t = length > 0. ? glm::clamp(glm::dot(p - a, ab) / length, 0., 1.) : 0.;
  return glm::length(p - (a + t * ab));
}

// The distance to the plane over the triangle, else to the nearest edge.
double DistanceToTriangle(
  const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const bool over = glm::dot(glm::cross(b - a, p - a), n) >= 0. &&
    glm::dot(glm::cross(c - b, p - b), n) >= 0. && glm::dot(glm::cross(a - c, p - c), n) >= 0.;
  if (over && glm::dot(n, n) > 0.)
  {
    return std::abs(glm::dot(p - a, n)) / glm::length(n);
  }
  return std::min(
    { DistanceToSegment(p, a, b), DistanceToSegment(p, b, c), DistanceToSegment(p, c, a) });
}

double DistanceToCell(vtkPolyData* mesh, vtkIdType cell, const glm::dvec3& p)
{
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(cell, ids);
  auto corner = [&](vtkIdType i) {
    glm::dvec3 point;
    mesh->GetPoint(ids->GetId(i), &point[0]);
    return point;
  };
  double distance = 1e300;
  for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
  {
    distance = std::min(distance, DistanceToTriangle(p, corner(0), corner(i - 1), corner(i)));
  }
  return distance;
}

void LookFrom(vtkRenderer* renderer, int view, int views, bool parallel)
{
  // Spread evenly (a Fibonacci sphere).
  const double height = 1. - (2. * view + 1.) / views;
  const double angle = view * glm::pi<double>() * (3. - std::sqrt(5.));
  const double radius = std::sqrt(1. - height * height);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetPosition(radius * std::cos(angle), height, radius * std::sin(angle));
  camera->SetViewUp(0., 1., 0.);
  camera->SetParallelProjection(parallel);
  renderer->ResetCamera();
}

struct Worst
{
  double Off = 0.; // in widths of a pixel, there
  long long Pixels = 0;
};

void Measure(vtkRenderer* renderer, vtkPolyData* mesh, Worst& worst)
{
  const Layers layers(renderer, { "depth", "cell" });
  vtkDataArray* depths = layers.Image->GetPointData()->GetArray("depth");
  vtkDataArray* cells = layers.Image->GetPointData()->GetArray("cell");
  const View view(renderer);
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(y) * layers.Width + x;
      const double depth = depths->GetComponent(pixel, 0);
      const auto cell = static_cast<vtkIdType>(cells->GetComponent(pixel, 0));
      if (cell < 0 || !std::isfinite(depth))
      {
        continue;
      }
      const Ray ray = view.PixelRay(x + 0.5, y + 0.5);
      const double width = glm::length(view.PixelRay(x + 1.5, y + 0.5).At(depth) - ray.At(depth));
      const double off = DistanceToCell(mesh, cell, ray.At(depth)) / width;
      worst.Off = std::max(worst.Off, off);
      ++worst.Pixels;
    }
  }
}

void CheckMesh(const std::string& name, int views)
{
  auto mesh = relievoTest::LoadMesh(name);
  if (!mesh)
  {
    return;
  }
  mesh->BuildCells();
  Stage stage(500, 500);
  auto actor = relievoTest::AddActor(stage.Renderer, mesh);
  actor->GetProperty()->SetInterpolationToFlat();
  Worst worst;
  for (int view = 0; view < views; ++view)
  {
    LookFrom(stage.Renderer, view, views, view % 4 == 3);
    Measure(stage.Renderer, mesh, worst);
  }
  std::cout << name << ": " << worst.Pixels << " pixels, the worst " << worst.Off
            << " pixels off its triangle\n";
  RELIEVO_CHECK_THAT(worst.Pixels > 100000, name + " is not in the picture");
  // A tenth where the surface continues, and the movement by the rasteriser's grid of 1/256.
  RELIEVO_CHECK_AT_MOST(worst.Off, 0.15, name + ": pixels off the triangle that is named");
}

double DistanceToMesh(vtkPolyData* mesh, const glm::dvec3& p)
{
  double distance = 1e300;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    distance = std::min(distance, DistanceToCell(mesh, cell, p));
  }
  return distance;
}

// Where spheres pass through each other, a pixel's neighbours show another mesh near its depth.
void CheckCrossing()
{
  Stage stage(300, 300);
  const double spheres[3][4] = { { 0., 0., 0., 1. }, { 0.7, 0.2, 0.1, 1. },
    { -0.4, 0.5, 0.6, 0.6 } };
  std::vector<vtkSmartPointer<vtkPolyData>> meshes;
  for (const double* sphere : { spheres[0], spheres[1], spheres[2] })
  {
    vtkNew<vtkSphereSource> source;
    source->SetCenter(sphere[0], sphere[1], sphere[2]);
    source->SetRadius(sphere[3]);
    source->SetThetaResolution(24);
    source->SetPhiResolution(24);
    source->Update();
    meshes.emplace_back(source->GetOutput());
    meshes.back()->BuildCells();
    relievoTest::AddActor(stage.Renderer, meshes.back());
  }
  double worst = 0.;
  long long pixels = 0;
  for (int view = 0; view < 12; ++view)
  {
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetPosition(0., 0., 6.);
    camera->SetViewUp(0., 1., 0.);
    camera->SetViewAngle(30.);
    camera->Azimuth(13.7 * view);
    camera->Elevation(3.1 * view);
    stage.Renderer->ResetCameraClippingRange();
    const Layers layers(stage.Renderer, { "depth", "actor", "cell" });
    const View seen(stage.Renderer);
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const auto value = [&](const char* layer) {
          return layers.Image->GetPointData()->GetArray(layer)->GetComponent(
            static_cast<vtkIdType>(y) * layers.Width + x, 0);
        };
        if (value("actor") < 0.)
        {
          continue;
        }
        vtkPolyData* mesh = meshes[static_cast<std::size_t>(value("actor"))];
        const Ray ray = seen.PixelRay(x + 0.5, y + 0.5);
        const glm::dvec3 place = ray.At(value("depth"));
        const double width =
          glm::length(seen.PixelRay(x + 1.5, y + 0.5).At(value("depth")) - place);
        const double near = DistanceToCell(mesh, static_cast<vtkIdType>(value("cell")), place);
        // Others only where its own triangle ends.
        worst =
          std::max(worst, (near > 0.003 * width ? DistanceToMesh(mesh, place) : near) / width);
        ++pixels;
      }
    }
  }
  std::cout << "spheres: " << pixels << " pixels, the worst " << worst << " pixels off its mesh\n";
  RELIEVO_CHECK(pixels > 100000);
  // The movement of a silhouette by the rasteriser's grid of 1/256.
  RELIEVO_CHECK_AT_MOST(worst, 0.006, "pixels off the mesh that is named");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testDepthSilhouettes)
{
  relievoTest::Session session;
  CheckCrossing();
  for (const auto& names : { relievoTest::ReferenceMeshes(), relievoTest::OtherMeshes() })
  {
    for (const std::string& name : names)
    {
      CheckMesh(name, relievoTest::IsLong(argc, argv) ? 24 : 6);
    }
  }
  return session.Result();
}
}
