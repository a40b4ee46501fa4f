// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshTree.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoRayFile.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
constexpr int ToALeaf = 4;
constexpr vtkIdType InABlock = 1 << 14;                   // triangles
constexpr std::int64_t MostCells = std::int64_t(1) << 60; // before the polygons
constexpr double NoBound = std::numeric_limits<double>::infinity();

bool HasPlace(const glm::dvec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Times and numbers that identify the state of a mesh.
std::vector<vtkMTimeType> GetTimes(vtkPolyData* data)
{
  return { data->GetPoints() ? data->GetPoints()->GetMTime() : 0, data->GetPolys()->GetMTime(),
    data->GetStrips()->GetMTime(),
    static_cast<vtkMTimeType>(data->GetNumberOfVerts() + data->GetNumberOfLines()),
    static_cast<vtkMTimeType>(data->GetNumberOfPoints()) };
}

vtkIdType GetLargest(const vtkRelievoStoredArray<std::uint32_t>& values)
{
  std::uint32_t largest = 0;
  for (const std::uint32_t value : values)
  {
    largest = std::max(largest, value);
  }
  return values.empty() ? -1 : static_cast<vtkIdType>(largest);
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
  return this->Places.GetBytes() + this->Points.GetBytes() + this->Corners.GetBytes() +
    this->Cells.GetBytes() + this->Tree.GetBytes();
}

//------------------------------------------------------------------------------
// Takes the places of the points in use, or of all points of a mesh whose triangles were just read.
void vtkRelievoMeshTree::TakePlaces(vtkPolyData* data, bool all)
{
  std::vector<glm::dvec3> places = this->Places.Release();
  places.resize(all ? static_cast<std::size_t>(data->GetNumberOfPoints()) : this->Points.size());
  places.shrink_to_fit();
  vtkRelievoForAll(static_cast<vtkIdType>(places.size()), [&](vtkIdType i) {
    data->GetPoint(all ? i : static_cast<vtkIdType>(this->Points[i]), &places[i].x);
  });
  const vtkIdType triangles = this->GetNumberOfTriangles();
  const vtkIdType blocks = (triangles + InABlock - 1) / InABlock;
  std::vector<glm::dvec3> lows(static_cast<std::size_t>(blocks), glm::dvec3(NoBound));
  std::vector<glm::dvec3> highs(static_cast<std::size_t>(blocks), glm::dvec3(-NoBound));
  vtkRelievoForAll(blocks, [&](vtkIdType block) {
    const vtkIdType end = std::min(triangles, (block + 1) * InABlock);
    for (vtkIdType i = block * InABlock; i < end; ++i)
    {
      const std::uint32_t* corners = this->GetCorners(static_cast<int>(i));
      const glm::dvec3& a = places[corners[0]];
      const glm::dvec3& b = places[corners[1]];
      const glm::dvec3& c = places[corners[2]];
      if (HasPlace(a) && HasPlace(b) && HasPlace(c))
      {
        lows[block] = glm::min(lows[block], glm::min(glm::min(a, b), c));
        highs[block] = glm::max(highs[block], glm::max(glm::max(a, b), c));
      }
    }
  });
  this->Low = glm::dvec3(NoBound);
  this->High = glm::dvec3(-NoBound);
  for (std::size_t block = 0; block < lows.size(); ++block)
  {
    this->Low = glm::min(this->Low, lows[block]);
    this->High = glm::max(this->High, highs[block]);
  }
  if (!this->IsEmpty())
  {
    this->Origin = 0.5 * this->Low + 0.5 * this->High;
    this->Low -= this->Origin;
    this->High -= this->Origin;
    vtkRelievoForAll(
      static_cast<vtkIdType>(places.size()), [&](vtkIdType i) { places[i] -= this->Origin; });
    const double reach = std::max({ this->High.x, this->High.y, this->High.z });
    this->Scale = reach > 1e-290 ? 1.0 / reach : 1.0;
  }
  this->Places.Set(std::move(places));
}

//------------------------------------------------------------------------------
// Without cells as long as each is one triangle.
void vtkRelievoMeshTree::TakeTriangles(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule)
{
  std::vector<std::uint32_t> corners = this->Corners.Release();
  std::vector<std::uint32_t> cells = this->Cells.Release();
  corners.clear();
  cells.clear();
  this->Points.Set({});
  this->CellOffset = data->GetNumberOfVerts() + data->GetNumberOfLines();
  const vtkIdType points = data->GetNumberOfPoints();
  const std::size_t polygons = static_cast<std::size_t>(data->GetNumberOfPolys());
  corners.reserve(3 * polygons);
  vtkRelievoPolygonCut::ForEachTriangle(
    data,
    [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
      if (std::min({ a, b, c }) < 0 || std::max({ a, b, c }) >= points)
      {
        return; // an index beyond the points
      }
      const std::size_t triangle = corners.size() / 3;
      if (!cells.empty() || static_cast<std::size_t>(cell) != triangle)
      {
        if (cells.empty())
        {
          cells.reserve(polygons);
          cells.resize(triangle);
          std::iota(cells.begin(), cells.end(), std::uint32_t(0));
        }
        cells.push_back(static_cast<std::uint32_t>(cell));
      }
      for (const vtkIdType id : { a, b, c })
      {
        corners.push_back(static_cast<std::uint32_t>(id));
      }
    },
    rule);
  this->Corners.Set(std::move(corners));
  this->Cells.Set(std::move(cells));
}

//------------------------------------------------------------------------------
vtkRelievoBoxTree::Box vtkRelievoMeshTree::GetBox(int triangle) const
{
  const std::uint32_t* corners = this->GetCorners(triangle);
  const glm::dvec3 a = this->Scale * this->Places[corners[0]];
  const glm::dvec3 b = this->Scale * this->Places[corners[1]];
  const glm::dvec3 c = this->Scale * this->Places[corners[2]];
  return HasPlace(a) && HasPlace(b) && HasPlace(c)
    ? vtkRelievoWideTree::Around(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c))
    : vtkRelievoWideTree::Nowhere();
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoBoxTree::Box> vtkRelievoMeshTree::GetBoxes() const
{
  const vtkIdType count = this->GetNumberOfTriangles();
  std::vector<vtkRelievoBoxTree::Box> boxes(static_cast<std::size_t>(count));
  vtkRelievoForAll(count, [&](vtkIdType i) { boxes[i] = this->GetBox(static_cast<int>(i)); });
  return boxes;
}

//------------------------------------------------------------------------------
// Reorders triangles by the leaves.
void vtkRelievoMeshTree::SortTriangles()
{
  const std::vector<int> order = this->Tree.TakeOrder();
  const auto count = static_cast<vtkIdType>(order.size());
  std::vector<std::uint32_t> corners(3 * order.size());
  vtkRelievoForAll(count,
    [&](vtkIdType i) { std::copy_n(this->GetCorners(order[i]), 3, corners.data() + 3 * i); });
  this->Corners.Set(std::move(corners));
  std::vector<std::uint32_t> cells(order.begin(), order.end());
  if (!this->Cells.empty())
  {
    vtkRelievoForAll(count, [&](vtkIdType i) { cells[i] = this->Cells[cells[i]]; });
  }
  this->Cells.Set(std::move(cells));
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTree::SortPoints(vtkPolyData* data)
{
  constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> sorted(static_cast<std::size_t>(data->GetNumberOfPoints()), None);
  std::vector<std::uint32_t> points;
  std::vector<std::uint32_t> corners = this->Corners.Release();
  for (std::uint32_t& corner : corners)
  {
    if (sorted[corner] == None)
    {
      sorted[corner] = static_cast<std::uint32_t>(points.size());
      points.push_back(corner);
    }
    corner = sorted[corner];
  }
  points.shrink_to_fit();
  std::vector<glm::dvec3> places(points.size());
  vtkRelievoForAll(static_cast<vtkIdType>(points.size()), [&](vtkIdType i) {
    data->GetPoint(static_cast<vtkIdType>(points[i]), &places[i].x);
    places[i] -= this->IsEmpty() ? glm::dvec3(0.0) : this->Origin;
  });
  this->Corners.Set(std::move(corners));
  this->Points.Set(std::move(points));
  this->Places.Set(std::move(places));
}

//------------------------------------------------------------------------------
double vtkRelievoMeshTree::GetBytesToBuild(vtkPolyData* data) const
{
  const std::vector<vtkMTimeType> times = GetTimes(data);
  if (this->Times.size() == times.size() &&
    std::equal(times.begin() + 1, times.end(), this->Times.begin() + 1))
  {
    return 0.0;
  }
  // Held together when the last node is made: corners, records, nodes, and places of points.
  constexpr double OfTriangle = 3 * sizeof(std::uint32_t) + vtkRelievoWideTree::BytesToBuild;
  constexpr double OfPoint = sizeof(glm::dvec3);
  const double needed =
    OfTriangle * static_cast<double>(vtkRelievoPolygonCut::CountTriangles(data)) +
    OfPoint * static_cast<double>(data->GetNumberOfPoints());
  return std::max(needed - static_cast<double>(this->GetBytes()), 0.0);
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshTree::Update(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule)
{
  const std::vector<vtkMTimeType> times = GetTimes(data);
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
    this->TakePlaces(data, false);
    this->Refitted = this->Tree.Refit(this->GetBoxes());
  }
  if (!this->Refitted)
  {
    this->TakeTriangles(data, rule);
    this->TakePlaces(data, true);
    this->Tree.Build(
      this->GetNumberOfTriangles(), [this](int i) { return this->GetBox(i); }, ToALeaf);
    this->Places.Set({}); // they are taken again: with them, the peak would be here
    this->SortTriangles();
    this->SortPoints(data);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTree::Write(vtkRelievoRayFileWriter& file) const
{
  const std::vector<double> numbers = { this->Origin.x, this->Origin.y, this->Origin.z, this->Low.x,
    this->Low.y, this->Low.z, this->High.x, this->High.y, this->High.z, this->Scale };
  const std::int64_t offset = this->CellOffset;
  file.Put(numbers);
  file.Put(&offset, 1);
  file.Put(this->Points);
  file.Put(this->Places);
  file.Put(this->Corners);
  file.Put(this->Cells);
  this->Tree.Write(file);
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshTree::Read(vtkRelievoRayFileReader& file)
{
  std::vector<double> numbers;
  std::vector<std::int64_t> offset;
  if (!file.Take(numbers) || numbers.size() != 10 || !file.Take(offset) || offset.size() != 1 ||
    offset[0] < 0 || offset[0] > MostCells || !file.Take(this->Points) ||
    !file.Take(this->Places) || !file.Take(this->Corners) || !file.Take(this->Cells))
  {
    return false;
  }
  this->Origin = { numbers[0], numbers[1], numbers[2] };
  this->Low = { numbers[3], numbers[4], numbers[5] };
  this->High = { numbers[6], numbers[7], numbers[8] };
  this->Scale = numbers[9];
  this->CellOffset = static_cast<vtkIdType>(offset[0]);
  return this->Scale > 0.0 && std::isfinite(this->Scale) && HasPlace(this->Origin) &&
    (this->IsEmpty() || (HasPlace(this->Low) && HasPlace(this->High))) &&
    this->Points.size() == this->Places.size() &&
    this->Cells.size() <= static_cast<std::size_t>(MostTriangles) &&
    this->Corners.size() == 3 * this->Cells.size() &&
    GetLargest(this->Corners) < static_cast<vtkIdType>(this->Places.size()) &&
    this->Tree.Read(file, this->Cells.size());
}

//------------------------------------------------------------------------------
void vtkRelievoMeshTree::SetMesh(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule)
{
  this->Times = GetTimes(data);
  this->Cuts = NumberCuts(data, rule);
  this->Refitted = false;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMeshTree::GetLastCell() const
{
  return this->Cells.empty() ? -1 : this->CellOffset + GetLargest(this->Cells);
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMeshTree::GetLastPoint() const
{
  return GetLargest(this->Points);
}
