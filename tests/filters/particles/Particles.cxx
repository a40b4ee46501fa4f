// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles.h"

#include "Check.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
Places PlacesAt(vtkRelievoSurfaceParticles* filter, double time)
{
  filter->UpdateTimeStep(time);
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  vtkPolyData* output = filter->GetOutput();
  Places places(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    output->GetPoint(static_cast<vtkIdType>(i), &places[i].x);
  }
  return places;
}

//------------------------------------------------------------------------------
double LargestDistance(const Places& places, vtkPolyData* mesh)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double largest = 0.;
  for (const glm::dvec3& place : places)
  {
    double closest[3];
    double distance2 = NAN;
    vtkIdType id = -1;
    int part = 0;
    locator->FindClosestPoint(&place.x, closest, cell, id, part, distance2);
    largest = id < 0 ? NAN : std::max(std::sqrt(distance2), largest);
  }
  return largest;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithField(
  vtkPolyData* mesh, const std::function<glm::dvec3(const glm::dvec3&)>& field)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  vtkNew<vtkDoubleArray> array;
  array->SetName("field");
  array->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    mesh->GetPoint(i, &place.x);
    const glm::dvec3 value = field(place);
    array->InsertNextTuple(&value.x);
  }
  copy->GetPointData()->AddArray(array);
  return copy;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const glm::dvec3& by)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    mesh->GetPoint(i, &place.x);
    place += by;
    points->InsertNextPoint(&place.x);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  moved->SetPoints(points);
  return moved;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Sheet(int cells)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      points->InsertNextPoint(2. * i / cells - 1., 2. * j / cells - 1., 0.);
      if (i < cells && j < cells)
      {
        const vtkIdType at = j * (cells + 1) + i;
        const vtkIdType first[3] = { at, at + 1, at + cells + 2 };
        const vtkIdType second[3] = { at, at + cells + 2, at + cells + 1 };
        triangles->InsertNextCell(3, first);
        triangles->InsertNextCell(3, second);
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}
}
