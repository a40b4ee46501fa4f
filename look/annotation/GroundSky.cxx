// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundSky.h"

#include "DataSets.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace look
{
namespace
{
constexpr int Cells = 96; // along the scene's longer side
constexpr int Directions = 32;
constexpr int Bands = 32;      // of elevation, each with the same light
constexpr double Growth = 0.2; // of steps, by the distance
constexpr double LeastOpacity = 0.5;
}

//------------------------------------------------------------------------------
GroundSky::GroundSky(vtkRenderer* renderer, const double bounds[6], int upAxis, double height)
  : Axes{ static_cast<std::size_t>((upAxis + 1) % 3), static_cast<std::size_t>((upAxis + 2) % 3),
    static_cast<std::size_t>(upAxis) }
  , Height(height)
{
  const std::array<double, 2> sides = { bounds[2 * this->Axes[0] + 1] - bounds[2 * this->Axes[0]],
    bounds[2 * this->Axes[1] + 1] - bounds[2 * this->Axes[1]] };
  this->Cell = std::max(sides[0], sides[1]) / Cells;
  if (!(this->Cell > 0.0))
  {
    return;
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Origin[i] = bounds[2 * this->Axes[i]];
    this->Size[i] = std::max(1, static_cast<int>(std::ceil(sides[i] / this->Cell)));
  }
  for (int i = 0; i < 4 * Directions; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * (i + 0.5) / (4 * Directions); // none along an axis
    this->Along.push_back({ std::cos(angle), std::sin(angle) });
  }
  this->Columns.assign(
    static_cast<std::size_t>(this->Size[0]) * this->Size[1], Column{ 1.0F, -1.0F });
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    if (!actor->GetVisibility() || !actor->GetMapper() ||
      actor->GetProperty()->GetOpacity() < LeastOpacity)
    {
      continue;
    }
    vtkMatrix4x4* toWorld = actor->GetMatrix();
    ForEachDataSet(actor->GetMapper()->GetInputDataObject(0, 0), [&](vtkDataSet* data) {
      std::vector<std::array<double, 3>> points(
        static_cast<std::size_t>(data->GetNumberOfPoints()));
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        double point[4] = { 0.0, 0.0, 0.0, 1.0 };
        data->GetPoint(static_cast<vtkIdType>(i), point);
        toWorld->MultiplyPoint(point, point);
        points[i] = { point[0], point[1], point[2] };
        this->Add(points[i]);
      }
      auto* mesh = vtkPolyData::SafeDownCast(data);
      if (!mesh)
      {
        return;
      }
      const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
      {
        cells->GetCurrentCell(size, ids);
        for (vtkIdType i = 2; i < size; ++i)
        {
          this->AddTriangle({ points[static_cast<std::size_t>(ids[0])],
            points[static_cast<std::size_t>(ids[i - 1])],
            points[static_cast<std::size_t>(ids[i])] });
        }
      }
    });
  }
}

//------------------------------------------------------------------------------
void GroundSky::Add(const std::array<double, 3>& point)
{
  std::array<int, 2> at;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double place = (point[this->Axes[i]] - this->Origin[i]) / this->Cell;
    at[i] = std::clamp(static_cast<int>(place), 0, this->Size[i] - 1);
  }
  const auto height = static_cast<float>(point[this->Axes[2]] - this->Height);
  Column& column = this->Columns[static_cast<std::size_t>(at[1]) * this->Size[0] + at[0]];
  column = column.Low > column.High
    ? Column{ height, height }
    : Column{ std::min(column.Low, height), std::max(column.High, height) };
}

//------------------------------------------------------------------------------
// The corners of small triangles have been added.
void GroundSky::AddTriangle(const std::array<std::array<double, 3>, 3>& corners)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::array<double, 3>& a = corners[i];
    const std::array<double, 3>& b = corners[(i + 1) % 3];
    longest = std::max({ longest, std::abs(a[this->Axes[0]] - b[this->Axes[0]]),
      std::abs(a[this->Axes[1]] - b[this->Axes[1]]) });
  }
  const int steps = std::min(2 * Cells, static_cast<int>(std::ceil(longest / this->Cell)));
  for (int i = 0; steps > 1 && i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      std::array<double, 3> point;
      for (std::size_t k = 0; k < 3; ++k)
      {
        point[k] = (1.0 - u - v) * corners[0][k] + u * corners[1][k] + v * corners[2][k];
      }
      this->Add(point);
    }
  }
}

//------------------------------------------------------------------------------
double GroundSky::GetHidden(const std::array<double, 3>& point, std::size_t quarter) const
{
  if (this->Columns.empty())
  {
    return 0.0;
  }
  const std::array<double, 2> from = { (point[this->Axes[0]] - this->Origin[0]) / this->Cell,
    (point[this->Axes[1]] - this->Origin[1]) / this->Cell };
  int hidden = 0;
  for (std::size_t direction = quarter; direction < this->Along.size(); direction += 4)
  {
    const std::array<double, 2>& along = this->Along[direction];
    // Distances in cells at which the way enters and leaves the grid.
    double first = 0.5;
    double last = VTK_DOUBLE_MAX;
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double ends[] = { -from[i] / along[i], (this->Size[i] - from[i]) / along[i] };
      first = std::max(first, std::min(ends[0], ends[1]));
      last = std::min(last, std::max(ends[0], ends[1]));
    }
    std::uint64_t bands = 0;
    for (double distance = first; distance < last; distance += std::max(1.0, Growth * distance))
    {
      const int x =
        std::clamp(static_cast<int>(from[0] + distance * along[0]), 0, this->Size[0] - 1);
      const int y =
        std::clamp(static_cast<int>(from[1] + distance * along[1]), 0, this->Size[1] - 1);
      const Column& column = this->Columns[static_cast<std::size_t>(y) * this->Size[0] + x];
      if (column.Low <= column.High)
      {
        // The light of a uniform sky below an elevation grows with its sine squared.
        const double away = distance * this->Cell;
        const auto getBandsBelow = [away](double height) {
          const double above = std::max(0.0, height);
          return (std::uint64_t(1) << static_cast<unsigned int>(
                    Bands * above * above / (above * above + away * away) + 0.5)) -
            1;
        };
        bands |= getBandsBelow(column.High) & ~getBandsBelow(column.Low);
      }
    }
    for (; bands != 0; bands &= bands - 1)
    {
      ++hidden;
    }
  }
  return static_cast<double>(hidden) / (Directions * Bands);
}
}
