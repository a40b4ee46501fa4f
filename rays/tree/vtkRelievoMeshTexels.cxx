// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshTexels.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int LeafSize = 4;  // of relievoTreeLeafFirst
constexpr double Worn = 1.5; // relative to the tree's cost when it was built

std::vector<vtkIdType> GetTriangles(vtkPolyData* data)
{
  std::vector<vtkIdType> triangles;
  triangles.reserve(static_cast<std::size_t>(3 * data->GetNumberOfPolys()));
  vtkRelievoPolygonCut::ForEachTriangle(
    data, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
      triangles.insert(triangles.end(), { a, b, c });
    });
  return triangles;
}

bool IsFinite(const glm::dvec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Corners about an origin. Triangles with a corner that is not finite are not drawn, so they become
// points.
std::vector<glm::vec3> GetCorners(
  vtkPolyData* data, const std::vector<vtkIdType>& triangles, const glm::dvec3& origin)
{
  std::vector<glm::vec3> corners(triangles.size());
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(triangles.size() / 3), [&](vtkIdType from, vtkIdType to) {
        for (vtkIdType i = from; i < to; ++i)
        {
          bool finite = true;
          for (vtkIdType k = 3 * i; k < 3 * i + 3; ++k)
          {
            glm::dvec3 p;
            data->GetPoint(triangles[k], &p.x);
            finite = finite && IsFinite(p);
            corners[k] = glm::vec3(p - origin);
          }
          if (!finite)
          {
            corners[3 * i] = corners[3 * i + 1] = corners[3 * i + 2] = glm::vec3(0.f);
          }
        }
      });
  });
  return corners;
}

// The centre of the finite points.
glm::dvec3 GetMiddle(vtkPolyData* data, const std::vector<vtkIdType>& triangles)
{
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const vtkIdType id : triangles)
  {
    glm::dvec3 p;
    data->GetPoint(id, &p.x);
    if (IsFinite(p))
    {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  return low.x > high.x ? glm::dvec3(0.0) : 0.5 * (low + high);
}

// Enlarged for rounding: an axis-parallel ray in the common side of two boxes hits both.
std::vector<vtkRelievoBoxTree::Box> GetBoxes(const std::vector<glm::vec3>& corners)
{
  std::vector<vtkRelievoBoxTree::Box> boxes(corners.size() / 3);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const glm::vec3* p = corners.data() + 3 * i;
    const glm::vec3 low = glm::min(glm::min(p[0], p[1]), p[2]);
    const glm::vec3 high = glm::max(glm::max(p[0], p[1]), p[2]);
    const glm::vec3 reach = glm::max(glm::abs(low), glm::abs(high));
    const float room = 2.5e-7f * std::max({ reach.x, reach.y, reach.z });
    boxes[i] = { low - room, high + room };
  }
  return boxes;
}
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMeshTexels::MostTriangles = vtkIdType(LeafSize) * vtkRelievoBoxTree::MostLeaves;

//------------------------------------------------------------------------------
bool vtkRelievoMeshTexels::Update(vtkPolyData* data)
{
  this->Refitted = false;
  const std::vector<vtkMTimeType> times = { data->GetPoints() ? data->GetPoints()->GetMTime() : 0,
    data->GetPolys()->GetMTime(), data->GetStrips()->GetMTime() };
  if (this->Times == times)
  {
    return false;
  }
  const bool sameCells = this->Times.size() == times.size() &&
    std::equal(times.begin() + 1, times.end(), this->Times.begin() + 1);
  const std::vector<vtkIdType> triangles = GetTriangles(data);
  this->Origin = GetMiddle(data, triangles);
  const std::vector<glm::vec3> corners = GetCorners(data, triangles, this->Origin);
  const std::vector<vtkRelievoBoxTree::Box> boxes = GetBoxes(corners);
  if (sameCells && boxes.size() == this->Tree.GetOrder().size())
  {
    this->Tree.Refit(boxes);
    this->Refitted = this->Tree.GetCost() <= Worn * this->CostWhenBuilt;
  }
  if (!this->Refitted)
  {
    this->Tree.Build(boxes, LeafSize);
    this->CostWhenBuilt = this->Tree.GetCost();
  }
  this->Times = times;
  this->Pack(corners);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTexels::Pack(const std::vector<glm::vec3>& corners)
{
  const auto& nodes = this->Tree.GetNodes();
  const auto& order = this->Tree.GetOrder();
  this->Texels.assign(2 * nodes.size() + (5 * order.size() + 1) / 2, glm::vec4(0.f));
  if (this->Texels.empty())
  {
    return;
  }
  float* to = &this->Texels[0].x;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (const glm::vec4& texel : nodes[i].GetTexels(static_cast<int>(i), LeafSize))
    {
      to = std::copy(&texel.x, &texel.x + 4, to);
    }
  }
  for (const int triangle : order)
  {
    const float* from = &corners[3 * static_cast<std::size_t>(triangle)].x;
    std::copy(from, from + 9, to);
    to += 10;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTexels::GetBounds(glm::dvec3& low, glm::dvec3& high) const
{
  low = glm::dvec3(this->Tree.GetNodes()[0].Low);
  high = glm::dvec3(this->Tree.GetNodes()[0].High);
}
