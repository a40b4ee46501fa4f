// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFeatureEdges.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonCut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace
{
constexpr double InOnePlane = 1.0 - 1e-9; // cosine between normals
}

//------------------------------------------------------------------------------
// Returns the index in Points of each of the mesh's points.
std::vector<std::uint32_t> vtkRelievoFeatureEdges::TakePoints(vtkPolyData* mesh)
{
  const auto count = static_cast<std::size_t>(mesh->GetNumberOfPoints());
  std::vector<glm::dvec3> places(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), &places[i].x);
    // NaN positions cannot be sorted.
    for (int axis = 0; axis < 3; ++axis)
    {
      places[i][axis] = std::isfinite(places[i][axis]) ? places[i][axis] : HUGE_VAL;
    }
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), std::uint32_t(0));
  const auto isBefore = [&places](std::uint32_t i, std::uint32_t j) {
    const glm::dvec3& a = places[i];
    const glm::dvec3& b = places[j];
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(order.begin(), order.end(), isBefore);
  std::vector<std::uint32_t> merged(count);
  this->Points.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i == 0 || isBefore(order[i - 1], order[i]))
    {
      this->Points.push_back(places[order[i]]);
    }
    merged[order[i]] = static_cast<std::uint32_t>(this->Points.size() - 1);
  }
  return merged;
}

//------------------------------------------------------------------------------
// `sides`: those of all triangles that meet at the edge.
void vtkRelievoFeatureEdges::AddEdge(const Side* sides, std::size_t count)
{
  const glm::dvec3 none(0.0);
  if (std::any_of(
        sides, sides + count, [&](const Side& side) { return this->Normals[side.Face] == none; }))
  {
    return; // a triangle without area has no normal
  }
  Edge edge = { { sides[0].Points[0], sides[0].Points[1] }, { sides[0].Face, sides[0].Face },
    false };
  if (count == 2)
  {
    edge.Faces[1] = sides[1].Face;
    edge.Flipped = sides[0].Backward == sides[1].Backward;
  }
  // With more than two triangles, the pair furthest from one plane; outer sides cannot be told from
  // inner ones.
  double least = 2.0;
  for (std::size_t i = 0; i < count && count > 2; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double cosine = glm::dot(this->Normals[sides[i].Face], this->Normals[sides[j].Face]);
      if (std::abs(cosine) < least)
      {
        least = std::abs(cosine);
        edge.Faces[0] = sides[i].Face;
        edge.Faces[1] = sides[j].Face;
        edge.Flipped = cosine < 0.0;
      }
    }
  }
  const double cosine = (edge.Flipped ? -1.0 : 1.0) *
    glm::dot(this->Normals[edge.Faces[0]], this->Normals[edge.Faces[1]]);
  if (edge.Faces[0] == edge.Faces[1] || cosine < InOnePlane)
  {
    this->Edges.push_back(edge);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFeatureEdges::Update(vtkPolyData* mesh)
{
  const std::vector<vtkMTimeType> times = { mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0,
    mesh->GetPolys()->GetMTime(), mesh->GetStrips()->GetMTime() };
  if (this->Times == times)
  {
    return;
  }
  this->Times = times;
  const std::vector<std::uint32_t> merged = this->TakePoints(mesh);
  this->Normals.clear();
  this->Edges.clear();
  std::vector<Side> sides;
  const auto last = static_cast<vtkIdType>(merged.size());
  vtkRelievoPolygonCut::ForEachTriangle(
    mesh, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
      if (std::min({ a, b, c }) < 0 || std::max({ a, b, c }) >= last)
      {
        return; // an index beyond the points
      }
      const std::uint32_t corners[3] = { merged[static_cast<std::size_t>(a)],
        merged[static_cast<std::size_t>(b)], merged[static_cast<std::size_t>(c)] };
      const glm::dvec3& from = this->Points[corners[0]];
      const glm::dvec3 normal =
        glm::cross(this->Points[corners[1]] - from, this->Points[corners[2]] - from);
      const double length = glm::length(normal);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0] ||
        !std::isfinite(length))
      {
        return;
      }
      const auto face = static_cast<std::uint32_t>(this->Normals.size());
      this->Normals.push_back(length > 0.0 ? normal / length : glm::dvec3(0.0));
      for (int i = 0; i < 3; ++i)
      {
        const std::uint32_t p = corners[i];
        const std::uint32_t q = corners[(i + 1) % 3];
        sides.push_back({ { std::min(p, q), std::max(p, q) }, face, p > q });
      }
    });
  const auto getKey = [](const Side& side) {
    return std::make_tuple(side.Points[0], side.Points[1], side.Face);
  };
  std::sort(sides.begin(), sides.end(),
    [&getKey](const Side& a, const Side& b) { return getKey(a) < getKey(b); });
  for (std::size_t first = 0; first < sides.size();)
  {
    std::size_t end = first + 1;
    while (end < sides.size() && sides[end].Points[0] == sides[first].Points[0] &&
      sides[end].Points[1] == sides[first].Points[1])
    {
      ++end;
    }
    this->AddEdge(&sides[first], end - first);
    first = end;
  }
}
