// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelReport.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <initializer_list>
#include <sstream>

namespace
{
void AddNumbers(vtkFieldData* fields, const char* name, std::initializer_list<vtkIdType> values)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTypedTuple(values.begin());
  fields->AddArray(array);
}
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelReport::Count(
  int axis, const vtkRelievoVoxelParity& parity, const vtkRelievoVoxelGrid& grid)
{
  const auto a = static_cast<std::size_t>(axis);
  this->Open[a] = static_cast<vtkIdType>(parity.GetNumberOfOpenColumns());
  this->Columns[a] = static_cast<vtkIdType>(grid.GetNumberOfColumns(axis));
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelReport::Describe(bool parity, int axis,
  const std::vector<vtkRelievoVoxelViews>& views, const vtkRelievoVoxelGrid& grid, bool fromImages,
  vtkIdType invalid)
{
  std::ostringstream out;
  if (!parity)
  {
    out << 2 * views.size() << " views, along";
    for (const vtkRelievoVoxelViews& view : views)
    {
      out << ' ' << "xyz"[view.Axis];
    }
  }
  else if (this->Closed)
  {
    out << "parity along "
        << "xyz"[axis];
  }
  else
  {
    out << "parity, by vote of x y z";
  }
  out << ": " << this->Inside << " of " << grid.GetNumberOfCells() << " cells inside";
  if (!fromImages)
  {
    out << (this->Triangles == 0 ? "; there is no surface"
        : this->Closed           ? "; the surface is closed"
                                 : "; the surface is open");
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (this->Columns[a] > 0)
    {
      out << "; open along "
          << "xyz"[a] << ": " << this->Open[a] << " of " << this->Columns[a] << " columns";
    }
  }
  if (invalid > 0)
  {
    out << "; left out: " << invalid << " triangles with points that are not finite";
  }
  this->Words = out.str();
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelReport::AddTo(vtkFieldData* fields) const
{
  AddNumbers(fields, "inside", { this->Inside });
  AddNumbers(fields, "closed", { this->Closed });
  AddNumbers(fields, "columns", { this->Columns[0], this->Columns[1], this->Columns[2] });
  AddNumbers(fields, "open_columns", { this->Open[0], this->Open[1], this->Open[2] });
  vtkNew<vtkStringArray> report;
  report->SetName("report");
  report->InsertNextValue(this->Words);
  fields->AddArray(report);
}
