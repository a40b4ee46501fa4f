// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockInput.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkRelievoArrayNames.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace relievo
{
//------------------------------------------------------------------------------
bool CheckBlockLabels(
  vtkImageData* image, vtkDataArray* labels, bool onPoints, std::string& problem)
{
  if (!labels)
  {
    problem = "the image needs an array of labels, on cells or points; the one that was asked for "
              "is not there. Choose another as the input array. On cells there are: " +
      ArrayNames(image->GetCellData()) + "; on points: " + ArrayNames(image->GetPointData());
    return false;
  }
  const std::string name = labels->GetName() ? labels->GetName() : "(unnamed)";
  const int type = labels->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE || type == VTK_BIT)
  {
    problem = "labels are whole numbers, but '" + name + "' is of type " +
      labels->GetDataTypeAsString() + "; convert it to an integer type first";
    return false;
  }
  if (labels->GetNumberOfComponents() != 1)
  {
    problem = "labels have one component, but '" + name + "' has " +
      std::to_string(labels->GetNumberOfComponents());
    return false;
  }
  const vtkIdType blocks = onPoints ? image->GetNumberOfPoints() : image->GetNumberOfCells();
  if (labels->GetNumberOfTuples() != blocks)
  {
    problem = "'" + name + "' has " + std::to_string(labels->GetNumberOfTuples()) +
      " values, but the image has " + std::to_string(blocks) + (onPoints ? " points" : " cells") +
      "; take an array of labels on cells or points";
    return false;
  }
  int size[3];
  image->GetDimensions(size);
  if (!onPoints && std::min({ size[0], size[1], size[2] }) < 2)
  {
    problem = "the image is flat, so its cells are no blocks; it has " + std::to_string(size[0]) +
      " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
      " points. Put the labels on its points, or make it one cell thick";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
HiddenBlocks FindHiddenBlocks(vtkImageData* image, bool onPoints)
{
  HiddenBlocks hidden;
  vtkUnsignedCharArray* points = image->GetPointGhostArray();
  vtkUnsignedCharArray* cells = image->GetCellGhostArray();
  if (onPoints)
  {
    hidden.Marks = points;
    hidden.Bits = vtkDataSetAttributes::HIDDENPOINT;
    return hidden;
  }
  hidden.Marks = cells;
  hidden.Bits = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  const auto hides = [](unsigned char mark) {
    return (mark & vtkDataSetAttributes::HIDDENPOINT) != 0;
  };
  if (!points ||
    std::none_of(points->GetPointer(0), points->GetPointer(points->GetNumberOfValues()), hides))
  {
    return hidden;
  }
  // A cell with a hidden point is hidden.
  const vtkIdType count = image->GetNumberOfCells();
  hidden.Marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  hidden.Marks->SetNumberOfValues(count);
  int size[3];
  image->GetDimensions(size);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    unsigned char mark =
      cells ? static_cast<unsigned char>(cells->GetValue(cell) & hidden.Bits) : 0;
    const vtkIdType i = cell % (size[0] - 1);
    const vtkIdType j = cell / (size[0] - 1) % (size[1] - 1);
    const vtkIdType k = cell / (size[0] - 1) / (size[1] - 1);
    for (int corner = 0; corner < 8; ++corner)
    {
      const vtkIdType point =
        i + (corner & 1) + size[0] * (j + (corner >> 1 & 1) + size[1] * (k + (corner >> 2)));
      mark |= hides(points->GetValue(point)) ? hidden.Bits : 0;
    }
    hidden.Marks->SetValue(cell, mark);
  }
  return hidden;
}

//------------------------------------------------------------------------------
std::array<int, 6> FindOwnedBlocks(
  vtkImageData* image, bool onPoints, const BlockBox& box, const int whole[6])
{
  int extent[6];
  image->GetExtent(extent);
  const vtkIdType cells[3] = { std::max(extent[1] - extent[0], 1),
    std::max(extent[3] - extent[2], 1), std::max(extent[5] - extent[4], 1) };
  std::array<int, 6> owned = { 1, static_cast<int>(cells[0]), 1, static_cast<int>(cells[1]), 1,
    static_cast<int>(cells[2]) };
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (ghosts && ghosts->GetNumberOfValues() == cells[0] * cells[1] * cells[2])
  {
    std::array<int, 6> found = { VTK_INT_MAX, 0, VTK_INT_MAX, 0, VTK_INT_MAX, 0 };
    for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
    {
      if (!(ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL))
      {
        const vtkIdType place[3] = { i % cells[0], i / cells[0] % cells[1],
          i / (cells[0] * cells[1]) };
        for (int axis = 0; axis < 3; ++axis)
        {
          const auto number = static_cast<int>(place[axis]) + 1;
          found[2 * axis] = std::min(found[2 * axis], number);
          found[2 * axis + 1] = std::max(found[2 * axis + 1], number);
        }
      }
    }
    owned = found;
  }
  for (int axis = 0; onPoints && axis < 3; ++axis)
  {
    // The last points of the last cells belong to the next piece, if there is one.
    int& last = owned[2 * axis + 1];
    const bool end =
      last == static_cast<int>(cells[axis]) && extent[2 * axis + 1] == whole[2 * axis + 1];
    last = end ? box.Size[axis] : std::min(last, box.Size[axis]);
  }
  return owned;
}

//------------------------------------------------------------------------------
void SetBlockGeometry(vtkImageData* image, bool onPoints, BlockSettings& settings)
{
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    settings.First[axis] = extent[2 * axis] - (onPoints ? 0.5 : 0.);
    settings.Origin[axis] = image->GetOrigin()[axis];
    for (int row = 0; row < 3; ++row)
    {
      settings.Axes[row][axis] =
        image->GetDirectionMatrix()->GetElement(row, axis) * image->GetSpacing()[axis];
    }
  }
}

//------------------------------------------------------------------------------
std::array<int, 6> GrowBlocks(const std::array<int, 6>& box, int by, const std::array<int, 3>& size)
{
  std::array<int, 6> grown = box;
  for (int axis = 0; axis < 3; ++axis)
  {
    grown[2 * axis] = std::max(box[2 * axis] - by, 1);
    grown[2 * axis + 1] = std::min(box[2 * axis + 1] + by, size[axis]);
  }
  return grown;
}
}
