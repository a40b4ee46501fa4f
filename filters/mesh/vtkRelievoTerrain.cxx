// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTerrain.h"

#include "vtkRelievoMemory.h"
#include "vtkRelievoRaster.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoTerrain);

namespace
{
constexpr double NoHeight = 1e30; // larger than any
constexpr double BytesOfCell = 80.0;

// The heights of a raster, whose row 0 is at the top.
class TerrainHeights
{
public:
  explicit TerrainHeights(vtkImageData* image)
    : Values(image->GetPointData()->GetScalars())
    , Columns(image->GetDimensions()[0])
    , Rows(image->GetDimensions()[1])
  {
    if (vtkDataArray* array = image->GetFieldData()->GetArray(relievo::raster::NoData))
    {
      this->Missing = array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : this->Missing;
    }
  }

  double Get(vtkIdType row, vtkIdType column) const
  {
    return this->Values->GetComponent((this->Rows - 1 - row) * this->Columns + column, 0);
  }

  bool IsThere(double height) const
  {
    return std::abs(height) < NoHeight && height != this->Missing &&
      static_cast<float>(height) != static_cast<float>(this->Missing);
  }

private:
  vtkDataArray* Values;
  double Missing = std::numeric_limits<double>::quiet_NaN();

public:
  vtkIdType Columns;
  vtkIdType Rows;
};

// "", or the problem.
std::string ReadTransform(vtkImageData* image, std::array<double, 6>& transform)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(relievo::raster::Transform);
  if (!array || array->GetNumberOfValues() != 6)
  {
    return "the raster needs the field data raster_transform, six numbers that place it";
  }
  double largest = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    const int components = array->GetNumberOfComponents();
    transform[static_cast<std::size_t>(i)] = array->GetComponent(i / components, i % components);
    largest = std::max(largest, i % 3 < 2 ? std::abs(transform[static_cast<std::size_t>(i)]) : 0.0);
  }
  const double area = transform[0] * transform[4] - transform[1] * transform[3];
  const double sum = std::accumulate(transform.begin(), transform.end(), 0.0);
  return std::isfinite(sum) && std::abs(area) > 1e-12 * largest * largest
    ? ""
    : "the raster's transform does not give its cells an area";
}
}

//------------------------------------------------------------------------------
int vtkRelievoTerrain::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoTerrain::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::UserError);
  int size[3];
  input->GetDimensions(size);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1; // the reader has said why
  }
  std::array<double, 6> to{};
  std::string problem = ReadTransform(input, to);
  if (size[2] > 1 || !input->GetPointData()->GetScalars())
  {
    problem = "expected one slice of heights";
  }
  else if (size[0] < 2 || size[1] < 2)
  {
    problem = "the raster has " + std::to_string(size[1]) + " rows and " + std::to_string(size[0]) +
      " columns, and a surface needs at least two of each";
  }
  const double cells = static_cast<double>(size[0]) * size[1];
  if (problem.empty())
  {
    problem = relievo::LackOfMemory(BytesOfCell * cells, 0.0);
  }
  if (!problem.empty() || 6.0 * cells > std::numeric_limits<vtkTypeInt32>::max())
  {
    vtkErrorMacro(
      "No terrain: " << (problem.empty() ? "the raster has more than 357 million cells" : problem)
                     << ".");
    return 1;
  }

  const TerrainHeights heights(input);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> cellOf;
  cellOf->SetName(relievo::raster::Cell);
  vtkNew<vtkTypeInt32Array> corners;
  // Points of the row before and of this one; -1: no data.
  const auto columns = static_cast<std::size_t>(heights.Columns);
  std::vector<vtkTypeInt32> above(columns, -1);
  std::vector<vtkTypeInt32> here(columns, -1);
  const bool isTurned = to[0] * to[4] - to[1] * to[3] > 0.0; // rows run to the left of columns
  const auto add = [&](vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c) {
    corners->InsertNextValue(a);
    corners->InsertNextValue(isTurned ? c : b);
    corners->InsertNextValue(isTurned ? b : c);
  };
  for (vtkIdType row = 0; row < heights.Rows; ++row)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      const double height = heights.Get(row, static_cast<vtkIdType>(i));
      here[i] = -1;
      if (heights.IsThere(height))
      {
        const double u = static_cast<double>(i) + 0.5;
        const double v = static_cast<double>(row) + 0.5;
        here[i] = static_cast<vtkTypeInt32>(points->InsertNextPoint(
          to[0] * u + to[1] * v + to[2], to[3] * u + to[4] * v + to[5], height));
        cellOf->InsertNextValue(row * heights.Columns + static_cast<vtkIdType>(i));
      }
      if (row == 0 || i == 0)
      {
        continue;
      }
      const vtkTypeInt32 ring[4] = { above[i - 1], here[i - 1], here[i], above[i] };
      int missing = -1;
      int count = 0;
      for (int k = 0; k < 4; ++k)
      {
        missing = ring[k] < 0 ? k : missing;
        count += ring[k] < 0 ? 1 : 0;
      }
      if (count == 0)
      {
        add(ring[0], ring[1], ring[2]);
        add(ring[0], ring[2], ring[3]);
      }
      else if (count == 1)
      {
        add(ring[(missing + 1) % 4], ring[(missing + 2) % 4], ring[(missing + 3) % 4]);
      }
    }
    above.swap(here);
  }
  if (corners->GetNumberOfValues() == 0)
  {
    vtkErrorMacro("No terrain: no three neighbouring cells have data.");
    return 1;
  }
  points->Squeeze();
  cellOf->Squeeze();
  corners->Squeeze();
  const vtkIdType triangles = corners->GetNumberOfValues() / 3;
  vtkNew<vtkTypeInt32Array> starts;
  starts->SetNumberOfValues(triangles + 1);
  for (vtkIdType i = 0; i <= triangles; ++i)
  {
    starts->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(starts, corners);
  output->SetPoints(points);
  output->SetPolys(polygons);
  output->GetPointData()->AddArray(cellOf);
  output->GetFieldData()->PassData(input->GetFieldData());
  vtkNew<vtkIntArray> shape;
  shape->SetName(relievo::raster::Size);
  shape->InsertNextValue(size[0]);
  shape->InsertNextValue(size[1]);
  output->GetFieldData()->AddArray(shape);
  this->SetErrorCode(vtkErrorCode::NoError);
  return 1;
}
