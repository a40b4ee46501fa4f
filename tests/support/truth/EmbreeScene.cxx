// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeScene.h"

#include "Check.h"
#include "PolygonEars.h"
#include "ScreenTriangle.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace relievoTest
{
namespace
{
struct Triangle
{
  std::array<glm::dvec3, 3> Corners;
  std::array<long long, 3> Ids;
  int Actor;
  long long Cell;
  bool Mirrored;
};

// Data for the filter of a query, beside Embree's own context.
struct Context
{
  RTCIntersectContext Embree;
  unsigned int Ignored;
};

// Makes rays pass the triangle that they start from.
void Filter(const RTCFilterFunctionNArguments* arguments)
{
  const auto* context = reinterpret_cast<const Context*>(arguments->context);
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (RTCHitN_primID(arguments->hit, arguments->N, i) == context->Ignored)
    {
      arguments->valid[i] = 0;
    }
  }
}

void TakeError(void*, RTCError code, const char* text)
{
  Fail("Embree", static_cast<int>(code), text ? text : "error");
}

bool IsFinite(const glm::dvec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}
}

//------------------------------------------------------------------------------
struct EmbreeScene::Internals
{
  RTCDevice Device = rtcNewDevice(nullptr);
  RTCScene Scene = nullptr;
  std::once_flag Built;
  std::vector<Triangle> Triangles;
  int NumberOfActors = 0;
  glm::dvec3 Lowest{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Highest{ -std::numeric_limits<double>::infinity() };

  glm::dvec3 Center() const { return 0.5 * (this->Lowest + this->Highest); }

  void Add(const Triangle& triangle)
  {
    const auto& p = triangle.Corners;
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0] || !IsFinite(p[0]) || !IsFinite(p[1]) ||
      !IsFinite(p[2]))
    {
      return;
    }
    for (const glm::dvec3& corner : p)
    {
      this->Lowest = glm::min(this->Lowest, corner);
      this->Highest = glm::max(this->Highest, corner);
    }
    this->Triangles.push_back(triangle);
  }

  // Passes the triangles to Embree, in float relative to the centre; once.
  void Build()
  {
    rtcSetDeviceErrorFunction(this->Device, TakeError, nullptr);
    this->Scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(this->Scene,
      static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcSetSceneBuildQuality(this->Scene, RTC_BUILD_QUALITY_HIGH);
    if (!this->Triangles.empty())
    {
      const size_t count = this->Triangles.size();
      RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
      auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
      auto* ids = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), count));
      const glm::dvec3 center = this->Center();
      for (size_t i = 0; i < 3 * count; ++i)
      {
        const glm::vec3 p(this->Triangles[i / 3].Corners[i % 3] - center);
        std::copy(&p.x, &p.x + 3, points + 3 * i);
        ids[i] = static_cast<unsigned int>(i);
      }
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(this->Scene, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(this->Scene);
  }

  // Narrows [tMin, tMax] to the box around the scene; false if the ray misses it.
  bool Enter(const Ray& ray, double& tMin, double& tMax) const
  {
    // Margin larger than float rounding.
    const glm::dvec3 margin(1e-5 * glm::length(this->Highest - this->Lowest));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = this->Lowest[axis] - margin[axis] - ray.Origin[axis];
      const double high = this->Highest[axis] + margin[axis] - ray.Origin[axis];
      const double along = ray.Direction[axis];
      if (along == 0.)
      {
        if (low > 0. || high < 0.)
        {
          return false;
        }
        continue;
      }
      tMin = std::max(tMin, std::min(low / along, high / along));
      tMax = std::min(tMax, std::max(low / along, high / along));
    }
    return tMin <= tMax;
  }
};

//------------------------------------------------------------------------------
EmbreeScene::EmbreeScene()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
EmbreeScene::~EmbreeScene()
{
  if (this->Internal->Scene)
  {
    rtcReleaseScene(this->Internal->Scene);
  }
  rtcReleaseDevice(this->Internal->Device);
}

//------------------------------------------------------------------------------
int EmbreeScene::AddActor(vtkPolyData* mesh, vtkMatrix4x4* matrix)
{
  if (this->Internal->Scene)
  {
    Fail(__FILE__, __LINE__, "an actor was added to a scene that has been cast into");
    return -1;
  }
  Triangle triangle;
  triangle.Actor = this->Internal->NumberOfActors++;
  triangle.Cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  triangle.Mirrored = matrix && matrix->Determinant() < 0.;
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    triangle.Ids = { a, b, c };
    for (int i = 0; i < 3; ++i)
    {
      double p[4] = { 0., 0., 0., 1. };
      mesh->GetPoint(triangle.Ids[i], p);
      if (matrix)
      {
        matrix->MultiplyPoint(p, p);
      }
      triangle.Corners[i] = glm::dvec3(p[0], p[1], p[2]) / p[3];
    }
    this->Internal->Add(triangle);
  };
  const auto forEachCell = [&](vtkCellArray* cells, auto&& work) {
    const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      work(count, ids);
      ++triangle.Cell;
    }
  };
  forEachCell(mesh->GetPolys(), [&](vtkIdType count, const vtkIdType* ids) {
#ifdef RELIEVO_VTK_EAR_CLIPPING
    if (count >= 5)
    {
      ClipEars(mesh, ids, static_cast<int>(count), add);
      return;
    }
#endif
    for (vtkIdType i = 1; i + 1 < count; ++i)
    {
      add(ids[0], ids[i], ids[i + 1]);
    }
  });
  forEachCell(mesh->GetStrips(), [&](vtkIdType count, const vtkIdType* ids) {
    for (vtkIdType i = 0; i + 2 < count; ++i)
    {
      // Every second triangle of a strip has the opposite orientation.
      add(ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2]);
    }
  });
  return triangle.Actor;
}

//------------------------------------------------------------------------------
int EmbreeScene::AddActors(vtkRenderer* renderer)
{
  int added = 0;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator cookie;
  actors->InitTraversal(cookie);
  while (vtkActor* actor = actors->GetNextActor(cookie))
  {
    vtkPolyDataMapper* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    if (!actor->GetVisibility() || !mapper)
    {
      continue;
    }
    mapper->Update();
    if (vtkPolyData* mesh = mapper->GetInput())
    {
      this->AddActor(mesh, actor->GetMatrix());
      ++added;
    }
  }
  return added;
}

//------------------------------------------------------------------------------
long long EmbreeScene::NumberOfTriangles() const
{
  return static_cast<long long>(this->Internal->Triangles.size());
}

//------------------------------------------------------------------------------
std::array<glm::dvec3, 3> EmbreeScene::Corners(long long triangle) const
{
  return this->Internal->Triangles[static_cast<size_t>(triangle)].Corners;
}

//------------------------------------------------------------------------------
std::array<long long, 3> EmbreeScene::PointIds(long long triangle) const
{
  return this->Internal->Triangles[static_cast<size_t>(triangle)].Ids;
}

//------------------------------------------------------------------------------
glm::dvec3 EmbreeScene::Weights(long long triangle, const glm::dvec3& position) const
{
  const auto& p = this->Internal->Triangles[static_cast<size_t>(triangle)].Corners;
  const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double area = glm::dot(normal, normal);
  const double b = glm::dot(glm::cross(p[0] - p[2], position - p[2]), normal) / area;
  const double c = glm::dot(glm::cross(p[1] - p[0], position - p[0]), normal) / area;
  return glm::dvec3(1. - b - c, b, c);
}

//------------------------------------------------------------------------------
SurfacePoint EmbreeScene::Cast(const Ray& ray, double tMin, double tMax, long long ignored) const
{
  std::call_once(this->Internal->Built, [this] { this->Internal->Build(); });
  SurfacePoint point;
  double start = tMin;
  double end = tMax;
  if (this->Internal->Triangles.empty() || !this->Internal->Enter(ray, start, end))
  {
    return point;
  }
  Context context;
  rtcInitIntersectContext(&context.Embree);
  context.Embree.filter = Filter;
  context.Ignored = ignored < 0 ? RTC_INVALID_GEOMETRY_ID : static_cast<unsigned int>(ignored);

  const glm::vec3 origin(ray.At(start) - this->Internal->Center());
  const glm::vec3 direction(ray.Direction);
  RTCRayHit query;
  query.ray.org_x = origin.x;
  query.ray.org_y = origin.y;
  query.ray.org_z = origin.z;
  query.ray.dir_x = direction.x;
  query.ray.dir_y = direction.y;
  query.ray.dir_z = direction.z;
  query.ray.time = 0.f;
  query.ray.mask = 0xffffffffu;
  query.ray.id = 0;
  query.ray.flags = 0;
  query.ray.tnear = 0.f;
  // Skips hits before tMin in double precision; a few attempts suffice.
  for (int attempt = 0; attempt < 16; ++attempt)
  {
    query.ray.tfar = static_cast<float>(end - start);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(this->Internal->Scene, &context.Embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    {
      return point;
    }
    const Triangle& triangle = this->Internal->Triangles[query.hit.primID];
    const auto& p = triangle.Corners;
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double along = glm::dot(ray.Direction, normal);
    const double depth = glm::dot(p[0] - ray.Origin, normal) / along;
    if (depth >= tMin && depth <= tMax)
    {
      point.Hit = true;
      point.Depth = depth;
      point.Position = ray.At(depth);
      point.Normal = glm::normalize(normal) * (along < 0. ? 1. : -1.);
      point.FrontFacing = (along < 0.) != triangle.Mirrored;
      point.Actor = triangle.Actor;
      point.Cell = triangle.Cell;
      point.Triangle = static_cast<long long>(query.hit.primID);
      return point;
    }
    query.ray.tnear = std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity());
  }
  return point;
}

//------------------------------------------------------------------------------
TruthImage EmbreeScene::Trace(const View& view) const
{
  return TraceView(
    view, [this](const Ray& ray, double tMin, double tMax) { return this->Cast(ray, tMin, tMax); },
    [this, &view](int x, int y, PixelTruth& pixel) {
      const ScreenTriangle drawn(view, this->Corners(pixel.Triangle));
      pixel.EdgeDistance = drawn.Distance(glm::dvec2(x + 0.5, y + 0.5));
      pixel.TriangleWidth = drawn.Width();
    });
}

//------------------------------------------------------------------------------
ShadowVerdict EmbreeScene::Shadow(
  const SurfacePoint& point, const glm::dvec3& toLight, double tMax, double jitter) const
{
  const double tMin = 1e-6 * this->Size() / glm::length(toLight);
  const auto occluded = [&](const glm::dvec3& from) {
    return this->Cast(Ray{ from, toLight }, tMin, tMax, point.Triangle).Hit;
  };
  // Two directions in the surface's plane, from the axis farthest from its normal.
  const glm::dvec3 size = glm::abs(point.Normal);
  const glm::dvec3 axis(size.x <= size.y && size.x <= size.z ? 1. : 0.,
    size.y < size.x && size.y <= size.z ? 1. : 0., size.z < size.x && size.z < size.y ? 1. : 0.);
  const glm::dvec3 u = jitter * glm::normalize(glm::cross(point.Normal, axis));
  const glm::dvec3 v = glm::cross(point.Normal, u);

  ShadowVerdict verdict;
  verdict.Occluded = occluded(point.Position);
  for (const glm::dvec3& offset : { u, v, -u, -v })
  {
    verdict.Stable = verdict.Stable && occluded(point.Position + offset) == verdict.Occluded;
  }
  return verdict;
}

//------------------------------------------------------------------------------
double EmbreeScene::Size() const
{
  return this->Internal->Triangles.empty()
    ? 0.
    : glm::length(this->Internal->Highest - this->Internal->Lowest);
}
}
