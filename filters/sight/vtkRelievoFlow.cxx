// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFlow.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRelievoAbort.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoFreeSight.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoReturns.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRelievoFlow);

namespace
{
constexpr vtkIdType FlowsAtOnce = 1 << 15; // their hits fit into caches, and memory is reused

template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType pixels, double fill)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(pixels);
  array->Fill(fill);
  return array;
}
}

//------------------------------------------------------------------------------
vtkRelievoFlow::vtkRelievoFlow()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoFlow::~vtkRelievoFlow() = default;

//------------------------------------------------------------------------------
void vtkRelievoFlow::SetFrom(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera)
{
  this->From = { scene, camera };
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoFlow::SetTo(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera)
{
  this->To = { scene, camera };
  this->Modified();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoFlow::GetMTime()
{
  this->Modified();
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
int vtkRelievoFlow::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int extent[6] = { 0, -1, 0, -1, 0, 0 };
  if (this->From.Camera)
  {
    extent[1] = this->From.Camera->GetSize()[0] - 1;
    extent[3] = this->From.Camera->GetSize()[1] - 1;
  }
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoFlow::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  for (const State* state : { &this->From, &this->To })
  {
    if (!state->Scene || !state->Camera)
    {
      vtkErrorMacro("It has no " << (state->Scene ? "camera" : "scene") << " to go "
                                 << (state == &this->To ? "to; give it one by SetTo."
                                                        : "from; give it one by SetFrom."));
      return 0;
    }
  }
  if (!this->To.Camera->HasPlaces())
  {
    vtkErrorMacro("A " << this->To.Camera->GetClassName()
                       << " has no places for points in its picture; expected another camera "
                          "to go to.");
    return 0;
  }
  vtkImageData* image = vtkImageData::GetData(outputs);
  const vtkIdType columns = this->From.Camera->GetSize()[0];
  const vtkIdType rows = this->From.Camera->GetSize()[1];
  const int* seen = this->To.Camera->GetSize();
  const double turnOfTo = this->To.Camera->GetColumnsOfTurn();
  const double turn = turnOfTo == this->From.Camera->GetColumnsOfTurn() ? turnOfTo : 0.0;
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const auto flow = NewArray<vtkFloatArray>("flow", 2, columns * rows, nothing);
  const auto motion = NewArray<vtkFloatArray>("motion", 3, columns * rows, nothing);
  const auto valid = NewArray<vtkUnsignedCharArray>("flow_valid", 1, columns * rows, 0.0);

  vtkNew<vtkDoubleArray> origins;
  vtkNew<vtkDoubleArray> directions;
  vtkNew<vtkDoubleArray> moved;
  vtkNew<vtkDoubleArray> targets;
  vtkNew<vtkTable> hits;
  vtkNew<vtkTable> laterHits;
  const vtkRelievoReturns source(this->From.Scene, this->From.Camera);
  const vtkRelievoReturns goal(this->To.Scene, this->To.Camera);
  const vtkIdType rowsAtOnce = std::max<vtkIdType>(1, FlowsAtOnce / columns);
  for (vtkIdType row = 0; row < rows; row += rowsAtOnce)
  {
    const vtkIdType end = std::min(rows, row + rowsAtOnce);
    const vtkIdType count = (end - row) * columns;
    this->From.Camera->GetRowRays(
      static_cast<int>(row), static_cast<int>(end), origins, directions);
    if (!this->From.Scene->FindMoved(this->To.Scene, origins, directions, hits, moved))
    {
      vtkErrorMacro("The rays of the pixels were not followed; see the errors before.");
      return 0;
    }
    this->To.Camera->Project(moved, targets);
    this->To.Camera->GetRays(targets, origins, directions);
    if (!this->To.Scene->FindNearest(origins, directions, laterHits))
    {
      vtkErrorMacro("The rays to the moved points were not followed; see the errors before.");
      return 0;
    }
    source.LimitRange(hits);
    auto* before = vtkDataArray::SafeDownCast(hits->GetColumnByName("position"));
    auto* distance = vtkDataArray::SafeDownCast(hits->GetColumnByName("distance"));
    auto* nearest = vtkDataArray::SafeDownCast(laterHits->GetColumnByName("distance"));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double* to = moved->GetPointer(3 * i);
      if (std::isnan(to[0]) || std::isinf(distance->GetComponent(i, 0)))
      {
        continue;
      }
      // Rows run downwards in cameras and upwards in images.
      const vtkIdType pixel = (rows - 1 - row - i / columns) * columns + i % columns;
      for (int k = 0; k < 3; ++k)
      {
        motion->SetComponent(pixel, k, to[k] - before->GetComponent(i, k));
      }
      const double* target = targets->GetPointer(2 * i);
      const double across = target[0] - static_cast<double>(i % columns);
      flow->SetComponent(pixel, 0, turn > 0.0 ? std::remainder(across, turn) : across);
      flow->SetComponent(pixel, 1, target[1] - static_cast<double>(row + i / columns));
      const bool inside = target[0] >= -0.5 && target[0] <= seen[0] - 0.5 && target[1] >= -0.5 &&
        target[1] <= seen[1] - 0.5;
      const double* origin = origins->GetPointer(3 * i);
      const bool free = vtkRelievoIsFree(nearest->GetComponent(i, 0), origin, to) &&
        goal.IsInRange(std::sqrt(vtkMath::Distance2BetweenPoints(origin, to)));
      valid->SetValue(pixel, inside && free ? 1 : 0);
    }
    this->UpdateProgress(static_cast<double>(end) / static_cast<double>(rows));
    if (relievo::IsStopped(this))
    {
      relievo::Discard(outputs);
      return 1;
    }
  }
  image->SetDimensions(static_cast<int>(columns), static_cast<int>(rows), 1);
  image->GetPointData()->AddArray(flow);
  image->GetPointData()->AddArray(motion);
  image->GetPointData()->AddArray(valid);
  this->From.Camera->AddTo(image->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoFlow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "From: " << this->From.Scene << ", " << this->From.Camera << "\n";
  os << indent << "To: " << this->To.Scene << ", " << this->To.Camera << "\n";
}
