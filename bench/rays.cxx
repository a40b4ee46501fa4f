// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays a second of one core past meshes of many sizes, and bytes for a triangle, beside Embree's.
// Rays are incoherent: from places on a sphere around the mesh to places in its box.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "FrameBench.h"
#include "Scenes.h"
#include "Table.h"

#include <vtkCellArray.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoRayTree.h>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace
{
using namespace relievoBench;

constexpr double Endless = std::numeric_limits<double>::infinity();

struct RayLine
{
  glm::dvec3 From;
  glm::dvec3 Direction;
};

std::vector<RayLine> DrawLines(const double bounds[6], int count)
{
  const glm::dvec3 half =
    0.5 * glm::dvec3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  std::mt19937_64 lots(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(-1., 1.);
  std::vector<RayLine> lines(static_cast<std::size_t>(count));
  for (RayLine& line : lines)
  {
    const glm::dvec3 way(normal(lots), normal(lots), normal(lots));
    line.From = 1.2 * glm::length(half) * glm::normalize(way);
    const glm::dvec3 to = half * glm::dvec3(even(lots), even(lots), even(lots));
    line.Direction = glm::normalize(to - line.From);
  }
  return lines;
}

// Embree's, of the same triangles in float about the middle of their box, with its robust flag.
class EmbreePeer
{
public:
  EmbreePeer(vtkPolyData* mesh, const double bounds[6])
    : Device(rtcNewDevice("threads=1"))
  {
    rtcSetDeviceMemoryMonitorFunction(
      this->Device.get(),
      [](void* own, ssize_t bytes, bool) {
        static_cast<EmbreePeer*>(own)->Bytes += static_cast<double>(bytes);
        return true;
      },
      this);
    this->Scene.reset(rtcNewScene(this->Device.get()));
    rtcSetSceneFlags(this->Scene.get(), RTC_SCENE_FLAG_ROBUST);
    RTCGeometry triangles = rtcNewGeometry(this->Device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const vtkIdType points = mesh->GetNumberOfPoints();
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), static_cast<std::size_t>(points)));
    for (vtkIdType i = 0; i < points; ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      for (int k = 0; k < 3; ++k)
      {
        places[3 * i + k] = static_cast<float>(p[k] - 0.5 * (bounds[2 * k] + bounds[2 * k + 1]));
      }
    }
    const vtkIdType count = mesh->GetNumberOfPolys();
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX,
      0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), static_cast<std::size_t>(count)));
    for (vtkIdType i = 0; i < count; ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetCellPoints(i, size, ids);
      std::transform(
        ids, ids + 3, corners + 3 * i, [](vtkIdType id) { return static_cast<unsigned>(id); });
    }
    rtcCommitGeometry(triangles);
    rtcAttachGeometry(this->Scene.get(), triangles);
    rtcReleaseGeometry(triangles);
    rtcCommitScene(this->Scene.get());
  }

  double GetBytes() const { return this->Bytes; }

  bool Nearest(const RayLine& line) const
  {
    RTCRayHit hit{};
    hit.ray = MakeRay(line);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(this->Scene.get(), &context, &hit);
    return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

  bool Any(const RayLine& line) const
  {
    RTCRay ray = MakeRay(line);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(this->Scene.get(), &context, &ray);
    return ray.tfar < 0.f;
  }

private:
  static RTCRay MakeRay(const RayLine& line)
  {
    RTCRay ray{};
    ray.org_x = static_cast<float>(line.From.x);
    ray.org_y = static_cast<float>(line.From.y);
    ray.org_z = static_cast<float>(line.From.z);
    ray.dir_x = static_cast<float>(line.Direction.x);
    ray.dir_y = static_cast<float>(line.Direction.y);
    ray.dir_z = static_cast<float>(line.Direction.z);
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    return ray;
  }

  struct Release
  {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  double Bytes = 0.;
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> Device;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> Scene;
};

struct Way
{
  const char* Method;
  const char* Answer;
  std::function<bool(const RayLine&)> Ask;
  double Bytes;
  double Best = 1e9; // seconds of the core for all rays
  int Hits = 0;
};

bool Measure(const std::string& name, vtkPolyData* mesh, const RaySizes& sizes, Table& table)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  vtkRelievoPlacedMesh placed;
  placed.Mesh = mesh;
  vtkRelievoRayTree tree;
  tree.SetMeshes({ placed });
  const EmbreePeer peer(mesh, bounds);
  const std::vector<RayLine> lines = DrawLines(bounds, sizes.Rays);
  const auto own = static_cast<double>(tree.GetBytes());
  Way ways[] = {
    { "rays in double", "nearest",
      [&](const RayLine& line) {
        return tree.FindNearest(line.From, line.Direction, 0., Endless).Place >= 0;
      },
      own },
    { "Embree", "nearest", [&](const RayLine& line) { return peer.Nearest(line); },
      peer.GetBytes() },
    { "rays in double", "any",
      [&](const RayLine& line) { return tree.MeetsAny(line.From, line.Direction, 0., Endless); },
      own },
    { "Embree", "any", [&](const RayLine& line) { return peer.Any(line); }, peer.GetBytes() },
  };
  // In turn, and each some times before the next: what the others leave in the caches does not
  // count.
  for (int round = 0; round < sizes.Rounds; ++round)
  {
    for (Way& way : ways)
    {
      for (int again = 0; again < 4; ++again)
      {
        way.Hits = 0;
        const std::clock_t begin = std::clock();
        for (const RayLine& line : lines)
        {
          way.Hits += way.Ask(line) ? 1 : 0;
        }
        way.Best = std::min(way.Best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      }
    }
  }
  const auto triangles = static_cast<double>(mesh->GetNumberOfPolys());
  bool alike = true;
  for (const Way& way : ways)
  {
    const double rate = 1e-6 * sizes.Rays / std::max(way.Best, 1e-9);
    table.AddRow({ name, Number(triangles, 8), way.Method, way.Answer, Number(rate, 3),
      Number(way.Bytes / triangles, 3), Number(100. * way.Hits / sizes.Rays, 4),
      Number(LoadAverage(), 2) });
    std::cout << name << ", " << way.Method << ", " << way.Answer << ": " << Number(rate, 3)
              << " M rays/s of a core, " << Number(way.Bytes / triangles, 3)
              << " bytes for a triangle" << std::endl;
    alike = alike && std::abs(way.Hits - ways[0].Hits) <= 1 + sizes.Rays / 10000;
  }
  if (!alike)
  {
    std::cerr << name << ": the numbers of hits differ by more than edges do\n";
  }
  return alike;
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchRays(const std::string& outDir, const RaySizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "mesh", "triangles", "method", "answer", "million rays per second",
    "bytes per triangle", "hit percent", "load" });
  for (const std::string& name : sizes.Meshes)
  {
    vtkSmartPointer<vtkPolyData> mesh = relievoTest::LoadMesh(name);
    if (!mesh)
    {
      return 1;
    }
    const int divisions = name == "bunny" ? sizes.Divisions : 0;
    for (int division = 0; division <= divisions; ++division)
    {
      if (division > 0)
      {
        vtkNew<vtkLinearSubdivisionFilter> divide; // each triangle into four
        divide->SetInputData(mesh);
        divide->Update();
        mesh = divide->GetOutput();
      }
      if (!Measure(name, mesh, sizes, table))
      {
        return 1;
      }
    }
  }
  return table.WriteCsv(outDir + "/rays.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchRays(const std::string& outDir)
{
  return relievoBench::BenchRays(outDir, relievoBench::RaySizes());
}
