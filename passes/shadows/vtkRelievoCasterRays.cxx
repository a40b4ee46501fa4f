// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCasterRays.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

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

// A ray as boxes and triangles are asked for it (S. Woop, C. Benthin, I. Wald, Watertight
// ray/triangle intersection, 2013).
struct Ray
{
  glm::dvec3 From;
  glm::dvec3 Inverse;
  int X = 0;
  int Y = 1;
  int Z = 2;
  glm::dvec3 Shear{ 0.0 };

  Ray(const glm::dvec3& from, const glm::dvec3& ray)
    : From(from)
  {
    const glm::dvec3 size = glm::abs(ray);
    this->Z = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    this->X = (this->Z + 1) % 3;
    this->Y = (this->Z + 2) % 3;
    this->Shear =
      glm::dvec3(ray[this->X] / ray[this->Z], ray[this->Y] / ray[this->Z], 1.0 / ray[this->Z]);
    for (int i = 0; i < 3; ++i)
    {
      this->Inverse[i] = std::abs(ray[i]) > 1e-290 ? 1.0 / ray[i] : std::copysign(1e290, ray[i]);
    }
  }

  bool Meets(const vtkRelievoBoxTree::Node& node, double low, double high) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const double a = (static_cast<double>(node.Low[i]) - this->From[i]) * this->Inverse[i];
      const double b = (static_cast<double>(node.High[i]) - this->From[i]) * this->Inverse[i];
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return low <= high;
  }

  bool Meets(const glm::dvec3* corners, double& t) const
  {
    double x[3];
    double y[3];
    double z[3];
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 p = corners[i] - this->From;
      x[i] = p[this->X] - this->Shear.x * p[this->Z];
      y[i] = p[this->Y] - this->Shear.y * p[this->Z];
      z[i] = p[this->Z] * this->Shear.z;
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    const double sum = u + v + w;
    if ((std::min({ u, v, w }) < 0.0 && std::max({ u, v, w }) > 0.0) || sum == 0.0)
    {
      return false;
    }
    t = (u * z[0] + v * z[1] + w * z[2]) / sum;
    return true;
  }
};
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
  void AddCells(vtkCellArray* cells, bool strips);
  void GetCorners(int triangle, glm::dvec3 corners[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = this->Points[this->Corners[3 * static_cast<std::size_t>(triangle) + i]];
    }
  }
};

//------------------------------------------------------------------------------
// As VTK's mapper cuts them: polygons as fans. Without what has a corner nowhere, or no area.
void vtkRelievoCasterRays::Mesh::AddCells(vtkCellArray* cells, bool strips)
{
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      vtkIdType corners[3] = { ids[strips ? i - 2 : 0], ids[i - 1], ids[i] };
      if (strips && i % 2 == 1)
      {
        std::swap(corners[0], corners[1]);
      }
      if (std::all_of(corners, corners + 3, [this](vtkIdType id) {
            return std::isfinite(this->Points[static_cast<std::size_t>(id)].x);
          }))
      {
        this->Corners.insert(this->Corners.end(), corners, corners + 3);
      }
    }
  }
}

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
  this->AddCells(data->GetPolys(), false);
  this->AddCells(data->GetStrips(), true);
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
    placed.Triangles = &mesh;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 corner(i & 1 ? mesh.High.x : mesh.Low.x, i & 2 ? mesh.High.y : mesh.Low.y,
        i & 4 ? mesh.High.z : mesh.Low.z);
      corners.emplace_back(surface.Caster.MeshToWorld * glm::dvec4(corner + mesh.Origin, 1.0));
      low = glm::min(low, corners.back());
      high = glm::max(high, corners.back());
    }
    this->Surfaces.push_back(surface);
    this->Places.push_back(placed);
  }
  this->Center = this->Places.empty() ? glm::dvec3(0.0) : 0.5 * (low + high);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    Placed& placed = this->Places[i];
    const glm::dmat4& matrix = this->Surfaces[i].Caster.MeshToWorld;
    placed.ToScene = matrix;
    placed.ToScene[3] = glm::dvec4(
      glm::dvec3(matrix * glm::dvec4(placed.Triangles->Origin, 1.0)) - this->Center, 1.0);
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
// Calls visit(surface, triangle, t) for every meeting, in no order; it returns the t up to which
// more are of interest.
template <typename Visit>
void vtkRelievoCasterRays::Walk(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high, Visit visit) const
{
  const Ray outer(from, ray);
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
    const int surface = this->Tree.GetOrder()[-1 - static_cast<int>(node.Low.w)];
    const Placed& placed = this->Places[surface];
    const Mesh& mesh = *placed.Triangles;
    const Ray inner(
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
        if (inner.Meets(corners, t) && t >= low && t <= high)
        {
          high = visit(surface, triangle, t);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoCasterRays::GetNormal(const Meeting& meeting, glm::dvec3& corner) const
{
  const Placed& placed = this->Places[meeting.Surface];
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
  this->Walk(from, ray, low, high, [&](int surface, int triangle, double t) {
    const vtkRelievoCaster& caster = this->Surfaces[surface].Caster;
    if (this->Surfaces[surface].Seen &&
      (found.Surface < 0 || std::abs(t - wanted) < std::abs(found.T - wanted)))
    {
      glm::dvec3 corner;
      const bool culls = caster.CullsFront || caster.CullsBack;
      const bool front =
        culls && glm::dot(this->GetNormal({ surface, triangle, t, {} }, corner), ray) < 0.0;
      if (!culls || !(front ? caster.CullsFront : caster.CullsBack))
      {
        found = { surface, triangle, t, glm::dvec3(0.0) };
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
  this->Walk(from, ray, 0.0, last, [&](int surface, int triangle, double t) {
    const vtkRelievoSurface& caster = this->Surfaces[surface];
    if (caster.Casts && (surface != own.Surface || triangle != own.Triangle))
    {
      glm::dvec3 corner;
      const glm::dvec3 normal =
        glm::normalize(this->GetNormal({ surface, triangle, t, {} }, corner));
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
