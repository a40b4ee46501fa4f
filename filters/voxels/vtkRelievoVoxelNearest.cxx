// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelNearest.h"

#include "vtkAbstractArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>

namespace
{
bool IsGhosts(const std::string& name)
{
  return name == vtkDataSetAttributes::GhostArrayName(); // the model's ghosts are not the cubes'
}

bool IsOwn(const std::string& name)
{
  return name == "size" || name == "scale" || name == "instance" || name == "orientation";
}

std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}
}

namespace vtkRelievoVoxelNearest
{
//------------------------------------------------------------------------------
std::string Add(vtkDataSet* model, vtkPoints* points, vtkPointData* output)
{
  std::string left;
  if (!model || model->GetNumberOfPoints() == 0 || points->GetNumberOfPoints() == 0)
  {
    return left;
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
    const std::string name = NameOf(array);
    if (IsGhosts(name))
    {
      continue;
    }
    if (IsOwn(name))
    {
      left += (left.empty() ? "'" : ", '") + name + "'";
      continue;
    }
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
  return left;
}

//------------------------------------------------------------------------------
double EstimateBytes(vtkDataSet* model, double points)
{
  if (!model || model->GetNumberOfPoints() == 0)
  {
    return 0.;
  }
  // The nearest points' numbers; a locator has, for each point, a number and an index in its list,
  // and about half a bucket.
  const double locator = 2.5 * sizeof(vtkIdType) * static_cast<double>(model->GetNumberOfPoints());
  double perPoint = sizeof(vtkIdType);
  vtkPointData* data = model->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = NameOf(array);
    if (!IsGhosts(name) && !IsOwn(name))
    {
      // Strings have no fixed size: a pointer and some letters are assumed.
      const int size = std::max(array->GetDataTypeSize(), array->IsNumeric() ? 1 : 48);
      perPoint += array->GetNumberOfComponents() * size;
    }
  }
  return locator + perPoint * points;
}
}
