// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCasterRays.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoCasterRay.h"
#include "vtkRelievoPolygonCut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
using Box = vtkRelievoBoxTree::Box;
constexpr int LeafSize = 4;
constexpr double Endless = std::numeric_limits<double>::infinity();

// Of floats around a box of doubles: rounding is within.
Box Around(const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec3 reach = glm::max(glm::abs(low), glm::abs(high));
  const double pad = 2.5e-7 * std::max({ reach.x, reach.y, reach.z });
  return { glm::vec3(low - pad), glm::vec3(high + pad) };
}
}

//------------------------------------------------------------------------------
// Triangles about the middle of their points, in the order of their tree's leaves.
struct vtkRelievoCasterRays::Mesh
{
  std::vector<vtkMTimeType> Times;
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 Low{ 0.0 };
  glm::dvec3 High{ 0.0 };
  std::vector<glm::dvec3> Points;
  std::vector<unsigned int> Corners; // three points each
  vtkRelievoBoxTree Tree;

  void Update(vtkPolyData* data);
  void GetCorners(int triangle, glm::dvec3 corners[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = this->Points[this->Corners[3 * static_cast<std::size_t>(triangle) + i]];
    }
  }
};

//------------------------------------------------------------------------------
void vtkRelievoCasterRays::Mesh::Update(vtkPolyData* data)
{
  const std::vector<vtkMTimeType> times = { data->GetPoints() ? data->GetPoints()->GetMTime() : 0,
    data->GetPolys()->GetMTime(), data->GetStrips()->GetMTime() };
  if (this->Times == times)
  {
    return;
  }
  this->Times = times;
  this->Corners.clear();
  this->Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  this->Low = glm::dvec3(Endless);
  this->High = glm::dvec3(-Endless);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    glm::dvec3& p = this->Points[i];
    data->GetPoint(static_cast<vtkIdType>(i), &p.x);
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
    {
      this->Low = glm::min(this->Low, p);
      this->High = glm::max(this->High, p);
    }
    else
    {
      p = glm::dvec3(vtkMath::Nan());
    }
  }
  vtkRelievoPolygonCut::ForEachTriangle(data, [this](vtkIdType a, vtkIdType b, vtkIdType c) {
    const vtkIdType corners[3] = { a, b, c };
    if (std::all_of(corners, corners + 3, [this](vtkIdType id) {
          return std::isfinite(this->Points[static_cast<std::size_t>(id)].x);
        }))
    {
      this->Corners.insert(this->Corners.end(), corners, corners + 3);
    }
  });
  this->Origin = 0.5 * (this->Low + this->High);
  this->Low -= this->Origin;
  this->High -= this->Origin;
  for (glm::dvec3& p : this->Points)
  {
    p -= this->Origin;
  }
  std::vector<Box> boxes(this->Corners.size() / 3);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    glm::dvec3 p[3];
    this->GetCorners(static_cast<int>(i), p);
    boxes[i] = Around(glm::min(glm::min(p[0], p[1]), p[2]), glm::max(glm::max(p[0], p[1]), p[2]));
  }
  this->Tree.Build(boxes, LeafSize);
  std::vector<unsigned int> sorted(this->Corners.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    std::copy_n(this->Corners.begin() + 3 * static_cast<std::ptrdiff_t>(this->Tree.GetOrder()[i]),
      3, sorted.begin() + 3 * static_cast<std::ptrdiff_t>(i));
  }
  this->Corners.swap(sorted);
}

//------------------------------------------------------------------------------
void vtkRelievoCasterRays::SetSurfaces(const std::vector<vtkRelievoSurface>& surfaces)
{
  std::map<vtkPolyData*, Held> before;
  before.swap(this->Meshes);
  this->Surfaces.clear();
  this->Places.clear();
  glm::dvec3 low(Endless);
  glm::dvec3 high(-Endless);
  std::vector<glm::dvec3> corners;
  for (const vtkRelievoSurface& surface : surfaces)
  {
    vtkPolyData* const data = surface.Caster.Mesh;
    Held& held = this->Meshes[data];
    if (!held.Triangles)
    {
      const auto old = before.find(data);
      held = old != before.end() && old->second.Data == data
        ? old->second
        : Held{ data, std::make_shared<Mesh>() };
      held.Triangles->Update(data);
    }
    const Mesh& mesh = *held.Triangles;
    if (mesh.Corners.empty())
    {
      continue;
    }
    Placed placed;
    placed.Surface = static_cast<int>(this->Surfaces.size());
    placed.Triangles = &mesh;
    for (std::size_t place = 0; place < surface.Caster.GetNumberOfPlaces(); ++place)
    {
      placed.ToScene = surface.Caster.GetPlace(place);
      for (int i = 0; i < 8; ++i)
      {
        const glm::dvec3 corner(i & 1 ? mesh.High.x : mesh.Low.x, i & 2 ? mesh.High.y : mesh.Low.y,
          i & 4 ? mesh.High.z : mesh.Low.z);
        corners.emplace_back(placed.ToScene * glm::dvec4(corner + mesh.Origin, 1.0));
        low = glm::min(low, corners.back());
        high = glm::max(high, corners.back());
      }
      this->Places.push_back(placed);
    }
    this->Surfaces.push_back(surface);
  }
  this->Center = this->Places.empty() ? glm::dvec3(0.0) : 0.5 * (low + high);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    Placed& placed = this->Places[i];
    placed.ToScene[3] = glm::dvec4(
      glm::dvec3(placed.ToScene * glm::dvec4(placed.Triangles->Origin, 1.0)) - this->Center, 1.0);
    placed.ToMesh = glm::inverse(placed.ToScene);
    glm::dvec3 least(Endless);
    glm::dvec3 most(-Endless);
    for (std::size_t k = 8 * i; k < 8 * i + 8; ++k)
    {
      least = glm::min(least, corners[k] - this->Center);
      most = glm::max(most, corners[k] - this->Center);
    }
    boxes.push_back(Around(least, most));
  }
  this->Tree.Build(boxes, 1);
}

//------------------------------------------------------------------------------
long long vtkRelievoCasterRays::GetNumberOfTriangles() const
{
  long long count = 0;
  for (const Placed& placed : this->Places)
  {
    count += static_cast<long long>(placed.Triangles->Corners.size() / 3);
  }
  return count;
}

//------------------------------------------------------------------------------
// Calls visit(place, triangle, t, owns) for every meeting, in no order; it returns the t up
// to which more are of interest. owns: see vtkRelievoCasterRay::Meets.
template <typename Visit>
void vtkRelievoCasterRays::Walk(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high, Visit visit) const
{
  const vtkRelievoCasterRay outer(from, ray);
  const auto& nodes = this->Tree.GetNodes();
  const int count = static_cast<int>(nodes.size());
  for (int n = 0; n < count && low <= high;)
  {
    const auto& node = nodes[n];
    const bool leaf = node.Low.w < 0.f;
    const bool meets = outer.Meets(node, low, high);
    n = meets || leaf ? n + 1 : static_cast<int>(node.Low.w);
    if (!meets || !leaf)
    {
      continue;
    }
    const int place = this->Tree.GetOrder()[-1 - static_cast<int>(node.Low.w)];
    const Placed& placed = this->Places[place];
    const Mesh& mesh = *placed.Triangles;
    const vtkRelievoCasterRay inner(
      glm::dvec3(placed.ToMesh * glm::dvec4(from, 1.0)), glm::dmat3(placed.ToMesh) * ray);
    const auto& within = mesh.Tree.GetNodes();
    const int inside = static_cast<int>(within.size());
    for (int k = 0; k < inside && low <= high;)
    {
      const auto& small = within[k];
      const bool end = small.Low.w < 0.f;
      const bool met = inner.Meets(small, low, high);
      k = met || end ? k + 1 : static_cast<int>(small.Low.w);
      const int first = met && end ? -1 - static_cast<int>(small.Low.w) : 0;
      const int last = met && end ? first + static_cast<int>(small.High.w) : 0;
      for (int triangle = first; triangle < last && low <= high; ++triangle)
      {
        glm::dvec3 corners[3];
        mesh.GetCorners(triangle, corners);
        double t = 0.0;
        bool owns = false;
        if (inner.Meets(corners, t, owns) && t >= low && t <= high)
        {
          high = visit(place, triangle, t, owns);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoCasterRays::GetNormal(const Meeting& meeting, glm::dvec3& corner) const
{
  const Placed& placed = this->Places[meeting.Place];
  glm::dvec3 p[3];
  placed.Triangles->GetCorners(meeting.Triangle, p);
  for (glm::dvec3& each : p)
  {
    each = glm::dvec3(placed.ToScene * glm::dvec4(each, 1.0));
  }
  corner = p[0];
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

//------------------------------------------------------------------------------
vtkRelievoCasterRays::Meeting vtkRelievoCasterRays::Find(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high, double wanted) const
{
  Meeting found;
  this->Walk(from, ray, low, high, [&](int place, int triangle, double t, bool) {
    const int surface = this->Places[place].Surface;
    const vtkRelievoCaster& caster = this->Surfaces[surface].Caster;
    if (this->Surfaces[surface].Seen &&
      (found.Surface < 0 || std::abs(t - wanted) < std::abs(found.T - wanted)))
    {
      glm::dvec3 corner;
      const bool culls = caster.CullsFront || caster.CullsBack;
      const bool front =
        culls && glm::dot(this->GetNormal({ surface, place, triangle, t, {} }, corner), ray) < 0.0;
      if (!culls || !(front ? caster.CullsFront : caster.CullsBack))
      {
        found = { surface, place, triangle, t, glm::dvec3(0.0) };
      }
    }
    return found.Surface < 0 ? high : std::min(high, wanted + std::abs(found.T - wanted));
  });
  if (found.Surface >= 0)
  {
    glm::dvec3 corner;
    const glm::dvec3 normal = this->GetNormal(found, corner);
    found.Normal = glm::dot(normal, ray) > 0.0 ? -normal : normal;
  }
  return found;
}

//------------------------------------------------------------------------------
vtkRelievoCasterRays::Meeting vtkRelievoCasterRays::FindFirst(
  const glm::dvec3& from, const glm::dvec3& ray, double low) const
{
  return this->Find(from, ray, low, Endless, low);
}

//------------------------------------------------------------------------------
double vtkRelievoCasterRays::Pass(
  const glm::dvec3& from, const glm::dvec3& ray, double last, const Meeting& own, double blur) const
{
  double passes = 1.0;
  this->Walk(from, ray, 0.0, last, [&](int place, int triangle, double t, bool owns) {
    const int surface = this->Places[place].Surface;
    const vtkRelievoSurface& caster = this->Surfaces[surface];
    const bool counts = caster.Casts && (owns || caster.Caster.Passes == 0.0);
    if (counts && (place != own.Place || triangle != own.Triangle))
    {
      glm::dvec3 corner;
      const glm::dvec3 normal =
        glm::normalize(this->GetNormal({ surface, place, triangle, t, {} }, corner));
      const bool ends = std::isfinite(last);
      if (std::abs(glm::dot(normal, corner - from)) > blur &&
        (!ends || std::abs(glm::dot(normal, corner - from - last * ray)) > blur))
      {
        passes *= caster.Caster.Passes;
      }
    }
    return passes > 0.0 ? last : -1.0;
  });
  return passes;
}
