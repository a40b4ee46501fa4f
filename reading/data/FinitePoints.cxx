// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FinitePoints.h"

#include "DataSets.h"
#include "Errors.h"
#include "ReadContext.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProp3D.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace reading
{
namespace
{
// Squared distances must be floats too: shaders compute lengths.
constexpr double Furthest = 1e18;
constexpr double Smallest = 1e-18;

struct LeftOut
{
  vtkIdType Points = 0;
  vtkIdType AllPoints = 0;
  vtkIdType Cells = 0;
};

std::vector<vtkIdType> FindInfinite(vtkPoints* points)
{
  std::vector<vtkIdType> infinite;
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      infinite.push_back(i);
    }
  }
  return infinite;
}

//------------------------------------------------------------------------------
void RemoveCells(vtkPolyData* mesh, const std::vector<vtkIdType>& infinite, LeftOut& count)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->DeepCopy(mesh->GetPoints());
  std::vector<bool> invalid(static_cast<std::size_t>(points->GetNumberOfPoints()), false);
  for (const vtkIdType point : infinite)
  {
    invalid[static_cast<std::size_t>(point)] = true;
  }
  double good[3];
  points->GetPoint(
    std::distance(invalid.begin(), std::find(invalid.begin(), invalid.end(), false)), good);
  for (const vtkIdType point : infinite)
  {
    points->SetPoint(point, good); // keeps the bounds finite: no cell uses the point
  }
  mesh->SetPoints(points);

  if (!mesh->GetCellData()->HasArray("vtkOriginalCellIds"))
  {
    NumberCells(mesh);
  }
  mesh->BuildCells();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    const vtkIdType* begin = corners->GetPointer(0);
    if (std::any_of(begin, begin + corners->GetNumberOfIds(),
          [&invalid](vtkIdType point) { return invalid[static_cast<std::size_t>(point)]; }))
    {
      mesh->DeleteCell(cell);
      ++count.Cells;
    }
  }
  mesh->RemoveDeletedCells();
}

std::string Plural(vtkIdType count, const char* noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> LeaveOutInfinite(
  vtkDataObject* surface, const std::string& path, ReadContext& context)
{
  LeftOut count;
  ForEachDataSet(surface, [&count](vtkDataSet* block) {
    vtkPolyData* mesh = vtkPolyData::SafeDownCast(block);
    count.AllPoints += mesh ? mesh->GetNumberOfPoints() : 0;
    count.Points += mesh ? static_cast<vtkIdType>(FindInfinite(mesh->GetPoints()).size()) : 0;
  });
  if (count.Points == 0)
  {
    return surface;
  }
  if (count.Points == count.AllPoints)
  {
    throw WorkError(path + ": there is nothing to draw: none of its " +
      Plural(count.AllPoints, "point") + " is finite");
  }
  const vtkSmartPointer<vtkDataObject> kept = CopyDataSets(surface);
  ForEachDataSet(kept, [&count](vtkDataSet* block) {
    vtkPolyData* mesh = vtkPolyData::SafeDownCast(block);
    const std::vector<vtkIdType> infinite =
      mesh ? FindInfinite(mesh->GetPoints()) : std::vector<vtkIdType>();
    if (static_cast<vtkIdType>(infinite.size()) == (mesh ? mesh->GetNumberOfPoints() : 0))
    {
      count.Cells += block->GetNumberOfCells();
      block->Initialize();
    }
    else if (!infinite.empty())
    {
      RemoveCells(mesh, infinite, count);
    }
  });
  context.Note(path + ": left out " + Plural(count.Cells, "cell") +
    " with points that are not finite (" + std::to_string(count.Points) + " of " +
    Plural(count.AllPoints, "point") + ")");
  return kept;
}

//------------------------------------------------------------------------------
void CheckReach(vtkProp3D* prop, const std::string& path)
{
  const double* bounds = prop->GetBounds();
  if (!bounds || bounds[0] > bounds[1]) // the prop is empty
  {
    return;
  }
  std::ostringstream text;
  double longest = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    if (!(std::abs(bounds[i]) <= Furthest)) // or NaN
    {
      text << path << ": its points reach to " << bounds[i] << " along "
           << "xyz"[i / 2] << ", and OpenGL draws up to " << Furthest
           << ": scale it, or remove stray points";
      throw WorkError(text.str());
    }
    longest = std::max(longest, bounds[2 * (i / 2) + 1] - bounds[2 * (i / 2)]);
  }
  if (longest > 0.0 && longest < Smallest)
  {
    text << path << ": it is " << longest << " long, and OpenGL draws from " << Smallest
         << ": scale it";
    throw WorkError(text.str());
  }
}
}
