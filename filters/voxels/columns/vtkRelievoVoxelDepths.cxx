// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelDepths.h"

#include "vtkRelievoVoxelMeshes.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
struct Side
{
  vtkDataArray* Depth = nullptr;
  int Size[2] = { 0, 0 };
  double WorldToNDC[16];
  int Axis = -1;
  int Sign = 0;    // of the viewing direction
  double Eye = 0.; // along the axis
};

std::string Understand(vtkImageData* image, Side& side)
{
  side.Depth = image->GetPointData()->GetArray("depth");
  double worldToCamera[16];
  const int* size = image->GetDimensions();
  if (!side.Depth || side.Depth->GetNumberOfComponents() != 1 || size[2] != 1)
  {
    return "it has no layer 'depth' on a single slice; capture the layer depth";
  }
  if (!vtkRelievoVoxelDepths::GetMatrix(image, "worldToCamera", worldToCamera) ||
    !vtkRelievoVoxelDepths::GetMatrix(image, "worldToNDC", side.WorldToNDC))
  {
    return "its field data has no 'worldToCamera' and 'worldToNDC' of 16 numbers, as "
           "captures by a renderer's camera have";
  }
  side.Size[0] = size[0];
  side.Size[1] = size[1];
  // The camera looks along its -z.
  const double* look = worldToCamera + 8;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(std::abs(look[axis]) - 1.) < 1e-9)
    {
      side.Axis = axis;
      side.Sign = look[axis] < 0. ? 1 : -1;
    }
  }
  const double* last = side.WorldToNDC + 12;
  const double scale = std::abs(last[3]);
  const bool parallel =
    std::max({ std::abs(last[0]), std::abs(last[1]), std::abs(last[2]) }) <= 1e-12 * scale;
  if (side.Axis < 0 || !parallel)
  {
    return "its camera does not look along x, y or z in parallel projection";
  }
  double inverse[16];
  vtkMatrix4x4::Invert(worldToCamera, inverse);
  side.Eye = inverse[4 * side.Axis + 3];
  return {};
}

double DepthAt(const Side& side, const double place[4])
{
  double ndc[4];
  vtkMatrix4x4::MultiplyPoint(side.WorldToNDC, place, ndc);
  vtkIdType texel[2];
  for (int c = 0; c < 2; ++c)
  {
    const double at = std::floor((ndc[c] / ndc[3] + 1.) / 2. * side.Size[c]);
    if (!(at >= 0. && at < side.Size[c]))
    {
      return std::numeric_limits<double>::infinity();
    }
    texel[c] = static_cast<vtkIdType>(at);
  }
  return side.Depth->GetComponent(texel[1] * side.Size[0] + texel[0], 0);
}
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelDepths::Add(vtkDataObject* data, std::vector<vtkImageData*>& images)
{
  for (vtkDataSet* leaf : vtkRelievoVoxelMeshes::GetLeaves(data))
  {
    if (auto* image = vtkImageData::SafeDownCast(leaf))
    {
      images.push_back(image);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoVoxelDepths::GetMatrix(vtkImageData* image, const char* name, double matrix[16])
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != 16)
  {
    return false;
  }
  const int components = array->GetNumberOfComponents();
  for (int i = 0; i < 16; ++i)
  {
    matrix[i] = array->GetComponent(i / components, i % components);
  }
  return std::all_of(matrix, matrix + 16, [](double value) { return std::isfinite(value); });
}

//------------------------------------------------------------------------------
std::string vtkRelievoVoxelDepths::Read(const std::vector<vtkImageData*>& images,
  const vtkRelievoVoxelGrid& grid, std::vector<vtkRelievoVoxelViews>& views)
{
  std::array<std::array<Side, 2>, 3> sides; // by axis; looking up and down the axis
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    Side side;
    const std::string problem = Understand(images[i], side);
    if (!problem.empty())
    {
      return "depth image " + std::to_string(i) + ": " + problem;
    }
    Side& place = sides[static_cast<std::size_t>(side.Axis)][side.Sign > 0 ? 0 : 1];
    if (place.Depth)
    {
      return "depth image " + std::to_string(i) + ": there is one already from " +
        (side.Sign > 0 ? "below" : "above") + " along " + "xyz"[side.Axis] +
        "; give one from each side";
    }
    place = side;
  }
  views.clear();
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::array<Side, 2>& both = sides[static_cast<std::size_t>(axis)];
    if (!both[0].Depth && !both[1].Depth)
    {
      continue;
    }
    if (!both[0].Depth || !both[1].Depth)
    {
      return std::string("along ") + "xyz"[axis] + " there is a depth image from " +
        (both[0].Depth ? "below" : "above") + " only; each axis needs one from each side";
    }
    vtkRelievoVoxelViews view;
    view.Axis = axis;
    const auto columns = static_cast<std::size_t>(grid.GetNumberOfColumns(axis));
    view.Front.resize(columns);
    view.Back.resize(columns);
    const int across = vtkRelievoVoxelGrid::GetColumn(axis);
    const int up = vtkRelievoVoxelGrid::GetRow(axis);
    const int width = grid.Cells[across];
    vtkSMPTools::For(0, grid.Cells[up], 16, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          double place[4] = { 0., 0., 0., 1. };
          place[axis] = both[0].Eye;
          place[across] = grid.ToWorld(column, across);
          place[up] = grid.ToWorld(static_cast<double>(row), up);
          const double front = DepthAt(both[0], place);
          const double back = DepthAt(both[1], place);
          const bool seen = std::isfinite(front) && std::isfinite(back);
          const auto at = static_cast<std::size_t>(row * width + column);
          constexpr double Infinity = std::numeric_limits<double>::infinity();
          view.Front[at] = seen ? grid.ToGrid(both[0].Eye + front, axis) : Infinity;
          view.Back[at] = seen ? grid.ToGrid(both[1].Eye - back, axis) : -Infinity;
        }
      }
    });
    views.push_back(view);
  }
  return views.empty() ? "there are no depth images" : std::string();
}
