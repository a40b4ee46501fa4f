// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointArrays.h
 * @brief Points with arrays, from structs.
 */
#ifndef relievoTestPointArrays_h
#define relievoTestPointArrays_h

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <utility>
#include <vector>

namespace relievoTest
{
/** A point for each item, in double, with arrays of these numbers, and of its colour as `color`. */
template <typename Item>
vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<Item>& items, glm::dvec3 Item::*place,
  const std::vector<std::pair<const char*, double Item::*>>& numbers, glm::dvec3 Item::*color)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  data->SetPoints(points);
  const auto add = [&](const char* name, int components, const auto& valueOf) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (const Item& item : items)
    {
      array->InsertNextTuple(valueOf(item));
    }
    data->GetPointData()->AddArray(array);
  };
  for (const Item& item : items)
  {
    points->InsertNextPoint(&(item.*place).x);
  }
  for (const auto& number : numbers)
  {
    add(number.first, 1, [&](const Item& item) { return &(item.*number.second); });
  }
  add("color", 3, [&](const Item& item) { return &(item.*color).x; });
  return data;
}
}

#endif
