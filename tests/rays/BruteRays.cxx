// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteRays.h"

#include <vtkIdList.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Real = long double;
using Vector = glm::tvec3<Real>;

constexpr Real Near = 1e-9L;
}

namespace relievoTest
{
//------------------------------------------------------------------------------
void BruteRays::Add(vtkPolyData* mesh, int prop, vtkMatrix4x4* matrix, long long cell)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    if (ids->GetNumberOfIds() != 3)
    {
      continue;
    }
    Triangle triangle{ {}, prop, cell < 0 ? i : cell };
    bool finite = true;
    for (int k = 0; k < 3; ++k)
    {
      double p[4];
      mesh->GetPoint(ids->GetId(k), p);
      p[3] = 1.;
      if (matrix)
      {
        matrix->MultiplyPoint(p, p);
      }
      triangle.Corners[k] = glm::dvec3(p[0], p[1], p[2]) / p[3];
      finite = finite && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    }
    if (finite)
    {
      this->Triangles.push_back(triangle);
      for (const glm::dvec3& corner : triangle.Corners)
      {
        this->Low = glm::min(this->Low, corner);
        this->High = glm::max(this->High, corner);
      }
    }
  }
}

//------------------------------------------------------------------------------
BruteAnswer BruteRays::Find(
  const glm::dvec3& origin, const glm::dvec3& direction, double low, double high) const
{
  BruteAnswer answer;
  const Real size = glm::length(Vector(this->High) - Vector(this->Low));
  const Vector way = glm::normalize(Vector(direction));
  for (const Triangle& triangle : this->Triangles)
  {
    const Vector corners[3] = { Vector(triangle.Corners[0]) - Vector(origin),
      Vector(triangle.Corners[1]) - Vector(origin), Vector(triangle.Corners[2]) - Vector(origin) };
    const Vector across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const Real area = glm::length(across);
    if (area == 0.L)
    {
      continue; // no triangle
    }
    const Vector normal = across / area;
    const Real slope = glm::dot(normal, way);
    // How far the ray is from the edges, as a line from lines.
    bool near = false;
    for (int k = 0; k < 3; ++k)
    {
      const Vector& from = corners[k];
      const Vector edge = corners[(k + 1) % 3] - from;
      const Vector both = glm::cross(way, edge);
      const Real sine = glm::length(both);
      const Real apart = sine > 1e-12L * glm::length(edge) ? std::abs(glm::dot(from, both)) / sine
                                                           : glm::length(glm::cross(from, way));
      if (apart < Near * size)
      {
        const Real along =
          sine > 0.L ? glm::dot(glm::cross(way, from), both) / (sine * sine) : 0.5L;
        const Real slack = 1e-6L;
        near = near || (along > -slack && along < 1.L + slack);
      }
    }
    if (std::abs(slope) < 1e-9L)
    {
      answer.Unsure = answer.Unsure || near;
      continue;
    }
    const Real t = glm::dot(normal, corners[0]) / slope;
    const Vector at = t * way;
    bool inside = true;
    for (int k = 0; k < 3; ++k)
    {
      const Vector side = glm::cross(corners[(k + 1) % 3] - corners[k], at - corners[k]);
      inside = inside && glm::dot(side, normal) > 0.L;
    }
    const bool ends = std::abs(t - low) < Near * size || std::abs(t - high) < Near * size;
    if (near || (inside && ends))
    {
      answer.Unsure = true;
    }
    if (inside && t >= low && t <= high)
    {
      answer.Hits.push_back({ static_cast<double>(t), triangle.Prop, triangle.Cell });
    }
  }
  std::sort(answer.Hits.begin(), answer.Hits.end(),
    [](const BruteHit& a, const BruteHit& b) { return a.Distance < b.Distance; });
  for (std::size_t i = 1; i < answer.Hits.size(); ++i)
  {
    const Real apart = answer.Hits[i].Distance - answer.Hits[i - 1].Distance;
    answer.Unsure = answer.Unsure || apart < Near * size; // which comes first is rounding
  }
  return answer;
}
}
