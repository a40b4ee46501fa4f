// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelCubes.h"

#include "vtkRelievoThreads.h"
#include "vtkRelievoVoxelDistance.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkRelievoVoxelCubes);

namespace
{
// Whether the cell and its six neighbours are inside.
bool IsInner(const unsigned char* mask, const std::array<int, 3>& cells, const int cell[3])
{
  vtkIdType stride = 1;
  vtkIdType at = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    at += cell[axis] * stride;
    stride *= cells[axis];
  }
  bool inner = mask[at] != 0;
  stride = 1;
  for (int axis = 0; axis < 3 && inner; ++axis)
  {
    inner =
      cell[axis] > 0 && cell[axis] + 1 < cells[axis] && mask[at - stride] && mask[at + stride];
    stride *= cells[axis];
  }
  return inner;
}

// The data of the nearest point, for each of the points.
void AddNearest(vtkDataSet* model, vtkPoints* points, vtkPointData* output)
{
  if (!model || model->GetNumberOfPoints() == 0 || points->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(model);
  locator->BuildLocator();
  vtkNew<vtkIdList> nearest;
  nearest->SetNumberOfIds(points->GetNumberOfPoints());
  vtkSMPTools::For(0, points->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    double place[3];
    for (vtkIdType i = begin; i < end; ++i)
    {
      points->GetPoint(i, place);
      nearest->SetId(i, locator->FindClosestPoint(place));
    }
  });
  vtkPointData* data = model->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    auto copy = vtk::TakeSmartPointer(array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->SetNumberOfTuples(nearest->GetNumberOfIds());
    array->GetTuples(nearest, copy);
    const int active = data->GetScalars() == array ? output->AddArray(copy) : -1;
    if (active >= 0)
    {
      output->SetActiveAttribute(active, vtkDataSetAttributes::SCALARS);
    }
    else
    {
      output->AddArray(copy);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoVoxelCubes::vtkRelievoVoxelCubes()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkRelievoVoxelCubes::~vtkRelievoVoxelCubes() = default;

//------------------------------------------------------------------------------
int vtkRelievoVoxelCubes::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoVoxelCubes::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  auto* mask = vtkUnsignedCharArray::SafeDownCast(image->GetCellData()->GetArray("mask"));
  if (image->GetNumberOfCells() == 0)
  {
    return 1;
  }
  if (!mask || mask->GetNumberOfComponents() != 1)
  {
    // The output stays empty. Status 0 would make the pipeline say it again in its own words.
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No cubes: the image has no cell array 'mask' of unsigned char, as Voxel Shell "
                  "(vtkRelievoVoxelShell) makes.");
    return 1;
  }
  const int* extent = image->GetExtent();
  const std::array<int, 3> cells{ { std::max(1, extent[1] - extent[0]),
    std::max(1, extent[3] - extent[2]), std::max(1, extent[5] - extent[4]) } };
  std::array<double, 3> spacing;
  image->GetSpacing(spacing.data());
  const unsigned char* inside = mask->GetPointer(0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  const double reach2 = this->RepellerRadius * this->RepellerRadius;
  const auto work = [&]() {
    std::vector<float> squares;
    if (this->Transition > 0.)
    {
      squares = vtkRelievoVoxelDistance::Squared(inside, cells, spacing);
    }
    this->UpdateProgress(0.5);
    vtkIdType at = 0;
    int cell[3];
    for (cell[2] = 0; cell[2] < cells[2]; ++cell[2])
    {
      for (cell[1] = 0; cell[1] < cells[1]; ++cell[1])
      {
        for (cell[0] = 0; cell[0] < cells[0]; ++cell[0], ++at)
        {
          double share = inside[at] ? 1. : 0.;
          if (!inside[at] && this->Transition > 0.)
          {
            const double distance = std::sqrt(squares[static_cast<std::size_t>(at)]);
            const double rest = 1. - std::min(distance / this->Transition, 1.);
            share = rest * rest * (3. - 2. * rest);
          }
          if (share == 0. && !this->WholeGrid)
          {
            continue;
          }
          double index[3];
          double place[3];
          for (int axis = 0; axis < 3; ++axis)
          {
            index[axis] = extent[2 * axis] + cell[axis] + 0.5;
          }
          image->TransformContinuousIndexToPhysicalPoint(index, place);
          const double distance2 =
            reach2 > 0. ? vtkMath::Distance2BetweenPoints(place, this->Repeller) : reach2;
          if (distance2 >= reach2 && this->Growth == 1. && IsInner(inside, cells, cell))
          {
            continue;
          }
          const double distance = std::sqrt(distance2);
          if (distance2 < reach2 && distance > 0.)
          {
            const double to =
              (this->RepellerRadius + distance2 / this->RepellerRadius) / 2. / distance;
            for (int axis = 0; axis < 3; ++axis)
            {
              place[axis] = this->Repeller[axis] + (place[axis] - this->Repeller[axis]) * to;
            }
          }
          points->InsertNextPoint(place);
          sizes->InsertNextValue(
            static_cast<float>(this->RestSize + (1. - this->RestSize) * share * this->Growth));
        }
      }
    }
    AddNearest(vtkDataSet::GetData(inputs[1]), points, output->GetPointData());
  };
  vtkRelievoWithThreads(work);
  vtkNew<vtkFloatArray> scales;
  scales->SetName("scale");
  scales->SetNumberOfComponents(3);
  scales->SetNumberOfTuples(sizes->GetNumberOfValues());
  for (vtkIdType i = 0; i < sizes->GetNumberOfValues(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      scales->SetTypedComponent(
        i, axis, static_cast<float>(sizes->GetValue(i) * std::abs(spacing[axis])));
    }
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(sizes);
  output->GetPointData()->AddArray(scales);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelCubes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RestSize: " << this->RestSize << "\n";
  os << indent << "Transition: " << this->Transition << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "WholeGrid: " << this->WholeGrid << "\n";
  os << indent << "Repeller: " << this->Repeller[0] << " " << this->Repeller[1] << " "
     << this->Repeller[2] << "\n";
  os << indent << "RepellerRadius: " << this->RepellerRadius << "\n";
}
