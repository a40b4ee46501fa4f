// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fog: error of a sphere's chord in float by the viewing distance, for several formulas, against
// long double; and the cost of frames with fog, by the number of spheres, as ratios to plain frames
// drawn in turn with them.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "FogChord.h"
#include "FogTruth.h"
#include "FrameBench.h"
#include "Statistics.h"
#include "Table.h"

#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderer.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using namespace relievoTest;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int Width = 641;
constexpr int Height = 481;

// b^2 - c, as in textbooks.
template <typename T>
double Textbook(const glm::dvec3& center, const glm::dvec3& ray)
{
  using V = glm::tvec3<T, glm::highp>;
  const V c(center);
  const V l = glm::normalize(V(ray));
  const T b = glm::dot(c, l);
  const T under = b * b - (glm::dot(c, c) - T(1));
  return under > T(0) ? 2. * std::sqrt(under) : 0.;
}

// 1 - |c - b l|^2: only the small distance to the ray is squared.
double Perpendicular(const glm::dvec3& center, const glm::dvec3& ray)
{
  const glm::vec3 c(center);
  const glm::vec3 l = glm::normalize(glm::vec3(ray));
  const glm::vec3 across = c - glm::dot(c, l) * l;
  const float under = 1.f - glm::dot(across, across);
  return under > 0.f ? 2. * std::sqrt(under) : 0.;
}

const char* const Methods[] = { "textbook, float", "perpendicular, float", "textbook, double",
  "pairs of floats" };

// A sphere of radius 1 that fills the height, seen from this distance, off the middle of a wide
// picture: on an axis, its coordinates would be rounded less than elsewhere.
void MeasureChords(double distance, int rays, Table& table)
{
  vtkRelievoFrameCamera view;
  view.Viewport[2] = Width;
  view.Viewport[3] = Height;
  view.Near = 0.01;
  view.Far = 10. * distance;
  const glm::dvec2 aside(0.5, 0.3);
  const double depth = distance / std::sqrt(1. + glm::dot(aside, aside));
  const double top = 1.1 * view.Near / std::sqrt(depth * depth - 1.);
  const double right = top * Width / Height;
  view.ViewToNDC = glm::frustum(aside.x * view.Near - right, aside.x * view.Near + right,
    aside.y * view.Near - top, aside.y * view.Near + top, view.Near, view.Far);
  const vtkRelievoSphereRays fog(view);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<float> errors[std::size(Methods)];
  while (static_cast<int>(errors[0].size()) < rays)
  {
    // The position varies by pixels between rays, so that rays hit the sphere anywhere.
    const glm::dvec3 center(PointAt(
      view, 0.5 * Width + 4. * uniform(random), 0.5 * Height + 4. * uniform(random), depth));
    const double x = std::floor(Width * uniform(random)) + 0.5;
    const double y = std::floor(Height * uniform(random)) + 0.5;
    vtkRelievoSphereRays::Sphere sphere;
    const auto truth = static_cast<double>(ChordTruth(view, x, y, center, 1., Infinity));
    if (truth == 0. || !fog.Find(center, 1., sphere))
    {
      continue;
    }
    const glm::dvec3 ray(PointAt(view, x, y, 1.L));
    const double chords[] = { Textbook<float>(center, ray), Perpendicular(center, ray),
      Textbook<double>(center, ray),
      FogChord(fog, sphere, 1., x, y, std::numeric_limits<float>::infinity()) };
    for (std::size_t i = 0; i < std::size(Methods); ++i)
    {
      errors[i].push_back(static_cast<float>(std::abs(chords[i] - truth)));
    }
  }
  for (std::size_t i = 0; i < std::size(Methods); ++i)
  {
    const Statistics all = Summarize(errors[i]);
    table.AddRow(
      { Methods[i], Number(distance), Number(all.Median), Number(all.P99), Number(all.Max) });
    std::cout << Methods[i] << ", " << Number(distance) << " radii: median " << Number(all.Median)
              << ", p99 " << Number(all.P99) << ", max " << Number(all.Max) << std::endl;
  }
}

struct Way
{
  const char* Name;
  bool Attached;
  int Spheres;
  double Share; // of the picture, covered by each sphere
};

const Way Ways[] = { { "plain", false, 0, 0. }, { "no fog", true, 0, 0. },
  { "out of view", true, 1, 0. }, { "1, a few pixels", true, 1, 1e-5 },
  { "1, a tenth of the picture", true, 1, 0.1 }, { "1", true, 1, 0.01 }, { "10", true, 10, 0.01 },
  { "100", true, 100, 0.01 }, { "1000", true, 1000, 0.01 } };

// Spheres around the mesh that cover this share of the picture.
vtkSmartPointer<vtkPolyData> MakeSpheres(const Way& way, vtkRenderer* renderer, double aspect)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double angle = 0.5 * camera->GetViewAngle() * std::acos(-1.) / 180.;
  const glm::dvec3 eye(
    camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]);
  const glm::dvec3 focus(
    camera->GetFocalPoint()[0], camera->GetFocalPoint()[1], camera->GetFocalPoint()[2]);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius");
  std::mt19937 random(2);
  std::uniform_real_distribution<double> around(-1., 1.);
  for (int i = 0; i < way.Spheres; ++i)
  {
    glm::dvec3 center = focus;
    if (way.Spheres > 1)
    {
      center += glm::dvec3(around(random), 0.5 * around(random), around(random));
    }
    const double height = 2. * glm::distance(eye, center) * std::tan(angle);
    const double radius = std::sqrt(way.Share * aspect / std::acos(-1.)) * height;
    center = way.Share > 0. ? center : 2. * eye - focus; // behind the camera
    points->InsertNextPoint(center.x, center.y, center.z);
    radii->InsertNextValue(way.Share > 0. ? radius : 0.1);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(radii);
  return data;
}

void MeasureFrames(const std::string& name, vtkPolyData* mesh, const FogSizes& sizes, Table& table)
{
  std::vector<std::unique_ptr<SceneWindow>> windows;
  std::vector<Timed> frames;
  for (const Way& way : Ways)
  {
    windows.emplace_back(new SceneWindow(mesh, sizes.Width, sizes.Height));
    vtkRenderer* renderer = windows.back()->Scene.Renderer;
    if (way.Attached)
    {
      vtkRelievoPass* pass = vtkRelievoPass::Attach(renderer);
      vtkNew<vtkRelievoFogSpheres> fog;
      fog->SetInputData(MakeSpheres(way, renderer, double(sizes.Width) / sizes.Height));
      fog->SetDensity(0.5);
      pass->GetFogStage()->AddPoints(fog);
    }
    frames.push_back(windows.back()->Frame());
  }
  const std::vector<Timing> times = TimeInTurn(frames, sizes.Rounds);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const TimingPair pair = PairOf(times[i], times[0]);
    std::cout << name << ", " << Ways[i].Name << ": " << pair.ToString("frame", "plain")
              << std::endl;
    auto* pass = vtkRelievoPass::SafeDownCast(windows[i]->Scene.Renderer->GetPass());
    table.AddRow({ name, std::to_string(sizes.Width) + "x" + std::to_string(sizes.Height),
      Ways[i].Name, std::to_string(Ways[i].Spheres), Number(Ways[i].Share),
      Number(1e3 * times[i].Median(), 4), Number(pair.Ratio(), 4), Number(pair.RatioSpread(), 2),
      Number(1e3 * (times[i].Median() - times[0].Median()), 3),
      Number(pass ? double(pass->GetBytesHeld()) / (double(sizes.Width) * sizes.Height) : 0., 3),
      Number(LoadAverage(), 2) });
  }
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchFog(const std::string& outDir, const FogSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table chords({ "method", "distance / radius", "error in radii median", "p99", "max" });
  for (const double distance : sizes.Distances)
  {
    MeasureChords(distance, sizes.Rays, chords);
  }
  Table frames({ "scene", "pixels", "frame", "spheres", "share of the picture each", "milliseconds",
    "times a plain frame", "+-", "milliseconds more", "bytes per pixel", "load" });
  for (const std::string& name : sizes.Meshes)
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    MeasureFrames(name, mesh, sizes, frames);
  }
  const bool written =
    chords.WriteCsv(outDir + "/fog.csv") && frames.WriteCsv(outDir + "/fog-frames.csv");
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchFog(const std::string& outDir)
{
  return relievoBench::BenchFog(outDir, {});
}
