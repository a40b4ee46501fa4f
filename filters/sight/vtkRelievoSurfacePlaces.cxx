// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSurfacePlaces.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonCut.h"

#include <cmath>

namespace
{
constexpr double BeforeSurface = 1e-7; // of the mesh's size

using Vector = vtkRelievoSurfacePlaces::Vector;
}

//------------------------------------------------------------------------------
struct vtkRelievoSurfacePlaces::Triangle
{
  Vector Corners[3];
  Vector Cross; // as long as twice its area
  Vector Middle;

  Triangle(vtkPolyData* mesh, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    mesh->GetPoint(a, this->Corners[0].data());
    mesh->GetPoint(b, this->Corners[1].data());
    mesh->GetPoint(c, this->Corners[2].data());
    const Vector ab = From(this->Corners[0], this->Corners[1]);
    const Vector ac = From(this->Corners[0], this->Corners[2]);
    vtkMath::Cross(ab.data(), ac.data(), this->Cross.data());
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Middle[i] = this->Corners[0][i] + (ab[i] + ac[i]) / 3.0;
    }
  }

  // Whether a line along a normal through a position hits the triangle. The middle of a quad lies
  // on the edge between its triangles, but for rounding.
  bool IsBelow(const Vector& place, const Vector& normal) const
  {
    constexpr double rounding = 1e-12;
    const double area = vtkMath::Dot(this->Cross.data(), normal.data());
    bool below = area > 0.0;
    for (std::size_t i = 0; i < 3 && below; ++i)
    {
      const Vector side = From(this->Corners[i], this->Corners[(i + 1) % 3]);
      const Vector to = From(this->Corners[i], place);
      Vector cross;
      vtkMath::Cross(side.data(), to.data(), cross.data());
      below = vtkMath::Dot(cross.data(), normal.data()) >= -rounding * area;
    }
    return below;
  }

  // The position of that hit.
  Vector Project(const Vector& place, const Vector& normal) const
  {
    const Vector to = From(place, this->Corners[0]);
    const double along =
      vtkMath::Dot(to.data(), this->Cross.data()) / vtkMath::Dot(normal.data(), this->Cross.data());
    Vector projected = place;
    for (std::size_t i = 0; i < 3; ++i)
    {
      projected[i] += along * normal[i];
    }
    return projected;
  }

  static Vector From(const Vector& a, const Vector& b)
  {
    return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  }
};

//------------------------------------------------------------------------------
// The angle at a point between two others.
double vtkRelievoSurfacePlaces::GetAngle(vtkPolyData* mesh, vtkIdType at, vtkIdType a, vtkIdType b)
{
  Vector middle;
  Vector sides[2];
  mesh->GetPoint(at, middle.data());
  mesh->GetPoint(a, sides[0].data());
  mesh->GetPoint(b, sides[1].data());
  vtkMath::Subtract(sides[0].data(), middle.data(), sides[0].data());
  vtkMath::Subtract(sides[1].data(), middle.data(), sides[1].data());
  return vtkMath::AngleBetweenVectors(sides[0].data(), sides[1].data());
}

//------------------------------------------------------------------------------
void vtkRelievoSurfacePlaces::TakeCells(vtkPolyData* mesh)
{
  this->Before = BeforeSurface * mesh->GetLength();
  const auto count = static_cast<std::size_t>(mesh->GetNumberOfCells());
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  this->Normals.assign(count, Vector{});
  std::vector<Vector> middles(count, Vector{});
  this->Areas.assign(count, 0.0);
  std::vector<double>& areas = this->Areas;
  const auto forEach = [&](const auto& take) {
    vtkRelievoPolygonCut::ForEachTriangle(
      mesh,
      [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
        take(static_cast<std::size_t>(first + cell), Triangle(mesh, a, b, c));
      },
      vtkRelievoPolygonCut::Rule::ByOutline);
  };
  forEach([&](std::size_t at, const Triangle& triangle) {
    vtkMath::Add(this->Normals[at].data(), triangle.Cross.data(), this->Normals[at].data());
  });
  for (Vector& normal : this->Normals)
  {
    vtkMath::Normalize(normal.data());
  }
  forEach([&](std::size_t at, const Triangle& triangle) {
    const double area = vtkMath::Dot(triangle.Cross.data(), this->Normals[at].data());
    areas[at] += area;
    for (std::size_t i = 0; i < 3; ++i)
    {
      middles[at][i] += area * triangle.Middle[i];
    }
  });
  for (std::size_t at = 0; at < count; ++at)
  {
    if (areas[at] > 0.0)
    {
      vtkMath::MultiplyScalar(middles[at].data(), 1.0 / areas[at]);
    }
  }
  std::vector<Vector> places = middles;
  std::vector<double> largest(count); // infinity: the middle lies over a triangle
  forEach([&](std::size_t at, const Triangle& triangle) {
    const double area = vtkMath::Dot(triangle.Cross.data(), this->Normals[at].data());
    const bool over = triangle.IsBelow(middles[at], this->Normals[at]);
    if (over ? std::isfinite(largest[at]) : area > largest[at])
    {
      largest[at] = over ? vtkMath::Inf() : area;
      places[at] = over ? triangle.Project(middles[at], this->Normals[at]) : triangle.Middle;
    }
  });
  for (const Vector& place : places)
  {
    this->Add(place);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSurfacePlaces::TakePoints(vtkPolyData* mesh)
{
  this->Before = BeforeSurface * mesh->GetLength();
  this->Normals.assign(static_cast<std::size_t>(mesh->GetNumberOfPoints()), Vector{});
  vtkDataArray* own = mesh->GetPointData()->GetNormals();
  if (!own)
  {
    vtkRelievoPolygonCut::ForEachTriangle(
      mesh,
      [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
        Vector unit = Triangle(mesh, a, b, c).Cross;
        vtkMath::Normalize(unit.data());
        for (const auto& [point, next, last] :
          { std::array<vtkIdType, 3>{ a, b, c }, { b, c, a }, { c, a, b } })
        {
          const double angle = GetAngle(mesh, point, next, last);
          Vector& sum = this->Normals[static_cast<std::size_t>(point)];
          for (std::size_t i = 0; i < 3; ++i)
          {
            sum[i] += angle * unit[i];
          }
        }
      },
      vtkRelievoPolygonCut::Rule::ByOutline);
  }
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    Vector& normal = this->Normals[static_cast<std::size_t>(point)];
    if (own)
    {
      own->GetTuple(point, normal.data());
    }
    vtkMath::Normalize(normal.data());
    Vector place;
    mesh->GetPoint(point, place.data());
    this->Add(place);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSurfacePlaces::Keep(const std::array<std::size_t, 2>& range)
{
  for (std::size_t i = 0; i < this->Normals.size(); ++i)
  {
    if (i < range[0] || i >= range[1])
    {
      this->Normals[i] = Vector{};
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSurfacePlaces::Add(Vector place)
{
  const Vector& normal = this->Normals[this->At.size()];
  for (std::size_t i = 0; i < 3; ++i)
  {
    place[i] += this->Before * normal[i];
  }
  this->At.push_back(place);
}
