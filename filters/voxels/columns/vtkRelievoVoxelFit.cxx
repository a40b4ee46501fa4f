// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
double LengthOf(const double box[6], int axis)
{
  return box[2 * axis + 1] - box[2 * axis];
}

double LongestOf(const double box[6])
{
  return std::max({ LengthOf(box, 0), LengthOf(box, 1), LengthOf(box, 2) });
}
}

//------------------------------------------------------------------------------
bool vtkRelievoVoxelFit::IsByDimensions() const
{
  return *std::min_element(this->Dimensions.begin(), this->Dimensions.end()) > 0;
}

//------------------------------------------------------------------------------
double vtkRelievoVoxelFit::GetCubeSize(const double box[6]) const
{
  const double longest = LongestOf(box);
  return this->CellSize > 0. ? this->CellSize : longest > 0. ? longest / this->Resolution : 1.;
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkRelievoVoxelFit::Count(const double box[6]) const
{
  std::array<double, 3> count{};
  for (int axis = 0; axis < 3; ++axis)
  {
    // Rounding must not add a cell.
    const double cubes = std::ceil(LengthOf(box, axis) / this->GetCubeSize(box) - 1e-6);
    count[axis] =
      (this->IsByDimensions() ? this->Dimensions[axis] : std::max(cubes, 1.)) + 2. * this->Padding;
  }
  return count;
}

//------------------------------------------------------------------------------
std::string vtkRelievoVoxelFit::FindProblem(const double box[6]) const
{
  std::ostringstream out;
  // Sums of two ends must also be finite.
  constexpr double Farthest = std::numeric_limits<double>::max() / 4.;
  for (int i = 0; i < 6; ++i)
  {
    if (!(std::abs(box[i]) <= Farthest))
    {
      out << "the box along "
          << "xyz"[i / 2] << " is from " << box[i / 2 * 2] << " to " << box[i / 2 * 2 + 1]
          << ", expected finite numbers up to " << Farthest
          << "; set Bounds to the box that the grid shall fill";
      return out.str();
    }
  }
  const std::array<double, 3> count = this->Count(box);
  // An extent counts points, one more than cells. The test also rejects NaN.
  constexpr double Most = std::numeric_limits<int>::max() - 1.;
  if (!(count[0] <= Most && count[1] <= Most && count[2] <= Most))
  {
    out.precision(10);
    out << count[0] << " x " << count[1] << " x " << count[2] << " cells are asked for, at most "
        << Most << " along an axis can be counted; make cells larger";
  }
  return out.str();
}

//------------------------------------------------------------------------------
vtkRelievoVoxelGrid vtkRelievoVoxelFit::Fit(const double box[6]) const
{
  vtkRelievoVoxelGrid grid;
  const std::array<double, 3> count = this->Count(box);
  double widest = 0.;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Cells[axis] = static_cast<int>(count[axis]);
    grid.Spacing[axis] = this->IsByDimensions() ? LengthOf(box, axis) / this->Dimensions[axis]
                                                : this->GetCubeSize(box);
    widest = std::max(widest, grid.Spacing[axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // A flat box also has cells with a volume.
    grid.Spacing[axis] = grid.Spacing[axis] > 0. ? grid.Spacing[axis] : widest > 0. ? widest : 1.;
    grid.Origin[axis] = (box[2 * axis] + box[2 * axis + 1] - count[axis] * grid.Spacing[axis]) / 2.;
  }
  return grid;
}
