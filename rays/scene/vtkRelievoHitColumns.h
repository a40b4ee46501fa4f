// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The columns of a table of hits, with `count` rows.
#ifndef vtkRelievoHitColumns_h
#define vtkRelievoHitColumns_h

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkRelievoFormulas.h" // for GLM
#include "vtkTable.h"

#include <algorithm>
#include <limits>

class vtkRelievoHitColumns
{
public:
  vtkRelievoHitColumns(vtkTable* table, vtkIdType count)
    : Distance(Add<vtkDoubleArray>(table, "distance", 1, count))
    , Prop(Add<vtkIntArray>(table, "prop", 1, count))
    , Block(Add<vtkIntArray>(table, "block", 1, count))
    , Cell(Add<vtkIdTypeArray>(table, "cell", 1, count))
    , Points(Add<vtkIdTypeArray>(table, "points", 3, count))
    , Weights(Add<vtkDoubleArray>(table, "weights", 3, count))
    , Position(Add<vtkDoubleArray>(table, "position", 3, count))
    , Normal(Add<vtkDoubleArray>(table, "normal", 3, count))
    , GeometricNormal(Add<vtkDoubleArray>(table, "geometric_normal", 3, count))
  {
  }

  template <typename Array>
  static decltype(Array::New()->GetPointer(0)) Add(
    vtkTable* table, const char* name, int components, vtkIdType count)
  {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(count);
    table->GetRowData()->AddArray(array);
    return array->GetPointer(0);
  }

  void SetNone(vtkIdType row) const
  {
    this->Distance[row] = std::numeric_limits<double>::infinity();
    this->Prop[row] = this->Block[row] = -1;
    this->Cell[row] = -1;
    std::fill_n(this->Points + 3 * row, 3, -1);
    for (double* three : { this->Weights, this->Position, this->Normal, this->GeometricNormal })
    {
      std::fill_n(three + 3 * row, 3, 0.0);
    }
  }

  static void Set(double* column, vtkIdType row, const glm::dvec3& value)
  {
    std::copy_n(&value.x, 3, column + 3 * row);
  }

  double* Distance;
  int* Prop;
  int* Block;
  vtkIdType* Cell;
  vtkIdType* Points;
  double* Weights;
  double* Position;
  double* Normal;
  double* GeometricNormal;
};

#endif
