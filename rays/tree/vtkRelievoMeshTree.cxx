// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshTree.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoThreads.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace
{
constexpr int ToALeaf = 4;
constexpr double NoBound = std::numeric_limits<double>::infinity();

bool HasPlace(const glm::dvec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Hash of the polygons' triangulation, if it may change with moving points.
std::uint64_t NumberCuts(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule)
{
  std::uint64_t number = 0;
  const bool fans =
    rule == vtkRelievoPolygonCut::Rule::AsDrawn && vtkRelievoPolygonCut::IsFan(VTK_INT_MAX);
  if (!fans && data->GetPolys()->IsHomogeneous() != 3)
  {
    vtkRelievoPolygonCut::ForEachTriangle(
      data,
      [&number](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
        for (const vtkIdType id : { a, b, c })
        {
          number = (number ^ static_cast<std::uint64_t>(id)) * 0x100000001b3u; // FNV-1a
          number ^= number >> 32;
        }
      },
      rule);
  }
  return number;
}
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoMeshTree::GetBytes() const
{
  return this->Places.capacity() * sizeof(glm::dvec3) +
    (this->Points.capacity() + this->Corners.capacity() + this->Cells.capacity()) *
    sizeof(std::uint32_t) +
    this->Tree.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTree::TakePlaces(vtkPolyData* data)
{
  this->Places.resize(this->Points.size());
  this->Places.shrink_to_fit();
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(this->Points[i]), &this->Places[i].x);
  }
  this->Low = glm::dvec3(NoBound);
  this->High = glm::dvec3(-NoBound);
  for (std::size_t i = 0; i < this->Corners.size(); i += 3)
  {
    const glm::dvec3& a = this->Places[this->Corners[i]];
    const glm::dvec3& b = this->Places[this->Corners[i + 1]];
    const glm::dvec3& c = this->Places[this->Corners[i + 2]];
    if (HasPlace(a) && HasPlace(b) && HasPlace(c))
    {
      this->Low = glm::min(this->Low, glm::min(glm::min(a, b), c));
      this->High = glm::max(this->High, glm::max(glm::max(a, b), c));
    }
  }
  if (this->IsEmpty())
  {
    return;
  }
  this->Origin = 0.5 * this->Low + 0.5 * this->High;
  this->Low -= this->Origin;
  this->High -= this->Origin;
  for (glm::dvec3& p : this->Places)
  {
    p -= this->Origin;
  }
  const double reach = std::max({ this->High.x, this->High.y, this->High.z });
  this->Scale = reach > 1e-290 ? 1.0 / reach : 1.0;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTree::TakeTriangles(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule)
{
  this->Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  std::iota(this->Points.begin(), this->Points.end(), std::uint32_t(0));
  this->Corners.clear();
  this->Cells.clear();
  this->CellOffset = data->GetNumberOfVerts() + data->GetNumberOfLines();
  const vtkIdType points = data->GetNumberOfPoints();
  const std::size_t polygons = static_cast<std::size_t>(data->GetNumberOfPolys());
  this->Corners.reserve(3 * polygons);
  this->Cells.reserve(polygons);
  vtkRelievoPolygonCut::ForEachTriangle(
    data,
    [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
      if (std::min({ a, b, c }) < 0 || std::max({ a, b, c }) >= points)
      {
        return; // an index beyond the points
      }
      for (const vtkIdType id : { a, b, c })
      {
        this->Corners.push_back(static_cast<std::uint32_t>(id));
      }
      this->Cells.push_back(static_cast<std::uint32_t>(cell));
    },
    rule);
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoBoxTree::Box> vtkRelievoMeshTree::GetBoxes() const
{
  const vtkIdType count = this->GetNumberOfTriangles();
  std::vector<vtkRelievoBoxTree::Box> boxes(static_cast<std::size_t>(count));
  const auto make = [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      const std::uint32_t* corners = this->GetCorners(static_cast<int>(i));
      const glm::dvec3 a = this->Scale * this->Places[corners[0]];
      const glm::dvec3 b = this->Scale * this->Places[corners[1]];
      const glm::dvec3 c = this->Scale * this->Places[corners[2]];
      boxes[static_cast<std::size_t>(i)] = HasPlace(a) && HasPlace(b) && HasPlace(c)
        ? vtkRelievoWideTree::Around(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c))
        : vtkRelievoWideTree::Nowhere();
    }
  };
  vtkRelievoWithThreads([&]() { vtkSMPTools::For(0, count, make); });
  return boxes;
}

//------------------------------------------------------------------------------
// Reorders the values by the leaves, `size` values each.
template <typename Value>
void vtkRelievoMeshTree::Sort(std::vector<Value>& values, std::size_t size) const
{
  std::vector<Value> sorted;
  sorted.reserve(values.size());
  for (const int triangle : this->Tree.GetOrder())
  {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(size * triangle);
    sorted.insert(sorted.end(), from, from + static_cast<std::ptrdiff_t>(size));
  }
  values.swap(sorted);
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTree::SortPoints()
{
  constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> sorted(this->Points.size(), None);
  std::vector<std::uint32_t> points;
  std::vector<glm::dvec3> places;
  for (std::uint32_t& corner : this->Corners)
  {
    if (sorted[corner] == None)
    {
      sorted[corner] = static_cast<std::uint32_t>(points.size());
      points.push_back(this->Points[corner]);
      places.push_back(this->Places[corner]);
    }
    corner = sorted[corner];
  }
  points.shrink_to_fit();
  places.shrink_to_fit();
  this->Points.swap(points);
  this->Places.swap(places);
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshTree::Update(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule)
{
  const std::vector<vtkMTimeType> times = { data->GetPoints() ? data->GetPoints()->GetMTime() : 0,
    data->GetPolys()->GetMTime(), data->GetStrips()->GetMTime(),
    static_cast<vtkMTimeType>(data->GetNumberOfVerts() + data->GetNumberOfLines()),
    static_cast<vtkMTimeType>(data->GetNumberOfPoints()) };
  if (this->Times == times)
  {
    return false;
  }
  this->Refitted = false;
  const std::uint64_t cuts = NumberCuts(data, rule);
  const bool sameCells = this->Times.size() == times.size() && cuts == this->Cuts &&
    std::equal(times.begin() + 1, times.end(), this->Times.begin() + 1);
  this->Times = times;
  this->Cuts = cuts;
  if (sameCells)
  {
    // Triangles keep the order of the leaves.
    this->TakePlaces(data);
    this->Refitted = this->Tree.Refit(this->GetBoxes());
  }
  if (!this->Refitted)
  {
    this->TakeTriangles(data, rule);
    this->TakePlaces(data);
    this->Tree.Build(this->GetBoxes(), ToALeaf);
    this->Sort(this->Corners, 3);
    this->Sort(this->Cells, 1);
    this->SortPoints();
    this->Tree.TakeOrderForGiven();
  }
  return true;
}
