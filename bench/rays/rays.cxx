// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays per second and core at meshes of many sizes, and bytes per triangle, beside Embree's; and
// beside Embree with boxes only, which calls our test in double for their triangles. Rays are
// incoherent: from positions on a sphere around the mesh to positions in its box. Our rays are
// given all at once, as vtkRelievoRayScene gives them, and Embree's one by one.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "FrameBench.h"
#include "Scenes.h"
#include "Table.h"

#include <vtkCellArray.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoRay.h>
#include <vtkRelievoRayTree.h>

#include <embree3/rtcore.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <iterator>
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

using RayLine = vtkRelievoRayTree::Line;

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

// An Embree scene with its content.
class EmbreeWorld
{
public:
  EmbreeWorld()
    : Device(rtcNewDevice("threads=1"))
  {
    rtcSetDeviceMemoryMonitorFunction(
      this->Device.get(),
      [](void* own, ssize_t bytes, bool) {
        static_cast<EmbreeWorld*>(own)->Bytes += static_cast<double>(bytes);
        return true;
      },
      this);
    this->Scene.reset(rtcNewScene(this->Device.get()));
    rtcSetSceneFlags(this->Scene.get(), RTC_SCENE_FLAG_ROBUST);
  }
  EmbreeWorld(const EmbreeWorld&) = delete;
  void operator=(const EmbreeWorld&) = delete;

  double GetBytes() const { return this->Bytes; }

protected:
  void Hold(RTCGeometry geometry)
  {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene.get());
  }

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

glm::dvec3 GetMiddle(const double bounds[6])
{
  return 0.5 * glm::dvec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
}

// Embree on the same triangles in float relative to the middle of their box, with its robust flag.
class EmbreePeer : public EmbreeWorld
{
public:
  EmbreePeer(vtkPolyData* mesh, const double bounds[6])
  {
    RTCGeometry triangles = rtcNewGeometry(this->Device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    const vtkIdType points = mesh->GetNumberOfPoints();
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), static_cast<std::size_t>(points)));
    const glm::dvec3 middle = GetMiddle(bounds);
    for (vtkIdType i = 0; i < points; ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      for (int k = 0; k < 3; ++k)
      {
        places[3 * i + k] = static_cast<float>(p[k] - middle[k]);
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
    this->Hold(triangles);
  }

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
};

// Embree's tree over the boxes of triangles, enlarged for rays in float, with our own test of the
// triangles in it: a backend with equal results.
class EmbreeBoxes : public EmbreeWorld
{
public:
  EmbreeBoxes(vtkPolyData* mesh, const double bounds[6])
  {
    const glm::dvec3 middle = GetMiddle(bounds);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 p;
      mesh->GetPoint(i, &p.x);
      this->Places.push_back(p - middle);
    }
    for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetCellPoints(i, size, ids);
      std::transform(ids, ids + 3, std::back_inserter(this->Corners),
        [](vtkIdType id) { return static_cast<unsigned>(id); });
    }
    this->Room = 1e-6 *
      glm::distance(
        glm::dvec3(bounds[0], bounds[2], bounds[4]), glm::dvec3(bounds[1], bounds[3], bounds[5]));
    RTCGeometry boxes = rtcNewGeometry(this->Device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(boxes, static_cast<unsigned>(this->Corners.size() / 3));
    rtcSetGeometryUserData(boxes, this);
    rtcSetGeometryBoundsFunction(boxes, GetBox, nullptr);
    rtcSetGeometryIntersectFunction(boxes, Intersect);
    this->Hold(boxes);
    this->Bytes += static_cast<double>(
      this->Places.size() * sizeof(glm::dvec3) + this->Corners.size() * sizeof(unsigned));
  }

  // Distance along the ray; infinity without a hit.
  double Nearest(const RayLine& line) const
  {
    const vtkRelievoRay ray(line.From, line.Direction);
    Asked asked;
    rtcInitIntersectContext(&asked.Context);
    asked.Ray = &ray;
    RTCRayHit hit{};
    hit.ray = MakeRay(line);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(this->Scene.get(), &asked.Context, &hit);
    return asked.Nearest;
  }

private:
  struct Asked
  {
    RTCIntersectContext Context; // first, because callbacks get its address
    const vtkRelievoRay* Ray;
    double Nearest = Endless;
  };

  const glm::dvec3& Get(unsigned triangle, unsigned corner) const
  {
    return this->Places[this->Corners[3 * triangle + corner]];
  }

  static void GetBox(const RTCBoundsFunctionArguments* asked)
  {
    const auto* own = static_cast<const EmbreeBoxes*>(asked->geometryUserPtr);
    const glm::dvec3& a = own->Get(asked->primID, 0);
    const glm::dvec3& b = own->Get(asked->primID, 1);
    const glm::dvec3& c = own->Get(asked->primID, 2);
    const glm::vec3 low(glm::min(glm::min(a, b), c) - own->Room);
    const glm::vec3 high(glm::max(glm::max(a, b), c) + own->Room);
    RTCBounds& box = *asked->bounds_o;
    box.lower_x = low.x;
    box.lower_y = low.y;
    box.lower_z = low.z;
    box.upper_x = high.x;
    box.upper_y = high.y;
    box.upper_z = high.z;
  }

  static void Intersect(const RTCIntersectFunctionNArguments* given)
  {
    const auto* own = static_cast<const EmbreeBoxes*>(given->geometryUserPtr);
    auto* asked = reinterpret_cast<Asked*>(given->context);
    double t = 0.;
    glm::dvec3 sides;
    if (asked->Ray->Hits(own->Get(given->primID, 0), own->Get(given->primID, 1),
          own->Get(given->primID, 2), t, sides) &&
      t >= 0. && t < asked->Nearest)
    {
      asked->Nearest = t;
      RTCRayHitN* hit = given->rayhit;
      RTCRayN_tfar(RTCRayHitN_RayN(hit, given->N), given->N, 0) =
        static_cast<float>(t * (1. + 1e-6) + own->Room);
      RTCHitN_geomID(RTCRayHitN_HitN(hit, given->N), given->N, 0) = given->geomID;
    }
  }

  std::vector<glm::dvec3> Places; // relative to the middle
  std::vector<unsigned> Corners;
  double Room;
};

struct Way
{
  const char* Method;
  const char* Answer;
  std::function<int(const std::vector<RayLine>&)> CountHits;
  double Bytes;
  double Best = 1e9; // core seconds for all rays
  int Hits = 0;
};

// Calls ask(line) for each line.
template <typename Ask>
std::function<int(const std::vector<RayLine>&)> OneByOne(Ask ask)
{
  return [ask](const std::vector<RayLine>& lines) {
    return static_cast<int>(std::count_if(lines.begin(), lines.end(), ask));
  };
}

bool Measure(const std::string& name, vtkPolyData* mesh, const RaySizes& sizes, Table& table)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  vtkRelievoPlacedMesh placed;
  placed.Mesh = mesh;
  vtkRelievoRayTree tree;
  std::string lack;
  tree.SetMeshes({ placed }, lack);
  if (!lack.empty())
  {
    std::cerr << name << ": " << lack << "\n";
    return false;
  }
  const EmbreePeer peer(mesh, bounds);
  const EmbreeBoxes boxes(mesh, bounds);
  const std::vector<RayLine> lines = DrawLines(bounds, sizes.Rays);
  const auto own = static_cast<double>(tree.GetBytes());
  std::vector<vtkRelievoRayTree::Hit> hits(lines.size());
  const auto countHits = [&hits]() {
    return static_cast<int>(
      std::count_if(hits.begin(), hits.end(), [](const auto& hit) { return hit.Place >= 0; }));
  };
  Way ways[] = {
    { "rays in double", "nearest",
      [&](const std::vector<RayLine>& all) {
        tree.FindNearest(all.data(), sizes.Rays, 0., Endless, hits.data());
        return countHits();
      },
      own },
    { "Embree", "nearest", OneByOne([&](const RayLine& line) { return peer.Nearest(line); }),
      peer.GetBytes() },
    { "Embree's boxes, triangles in double", "nearest",
      OneByOne([&](const RayLine& line) { return boxes.Nearest(line) < Endless; }),
      boxes.GetBytes() },
    { "rays in double", "any",
      [&](const std::vector<RayLine>& all) {
        tree.FindAny(all.data(), sizes.Rays, 0., Endless, hits.data());
        return countHits();
      },
      own },
    { "Embree", "any", OneByOne([&](const RayLine& line) { return peer.Any(line); }),
      peer.GetBytes() },
  };
  // In turn, each several times, so that the caches' content from others does not count.
  for (int round = 0; round < sizes.Rounds; ++round)
  {
    for (Way& way : ways)
    {
      for (int again = 0; again < 4; ++again)
      {
        const std::clock_t begin = std::clock();
        way.Hits = way.CountHits(lines);
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
  // Both in double: equal but for the rounding of their origins.
  const double size = glm::distance(
    glm::dvec3(bounds[0], bounds[2], bounds[4]), glm::dvec3(bounds[1], bounds[3], bounds[5]));
  const auto differ = std::count_if(lines.begin(), lines.end(), [&](const RayLine& line) {
    const double here = tree.FindNearest(line.From, line.Direction, 0., Endless).T;
    const double there = boxes.Nearest(line);
    return here != there && !(std::abs(here - there) <= 1e-9 * size);
  });
  std::cout << name << ": " << differ << " of " << sizes.Rays
            << " nearest hits differ between both ways in double" << std::endl;
  alike = alike && differ == 0;
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
