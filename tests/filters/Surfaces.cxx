// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace relievoTest
{
//------------------------------------------------------------------------------
SurfacePoint PlanePoint(double u, double v)
{
  return { { u, v, 0. }, { 0., 0., 1. }, { 1., 0., 0. } };
}

//------------------------------------------------------------------------------
SurfacePoint SpherePoint(double u, double v)
{
  const double a = 2. * vtkMath::Pi() * u;
  const double b = vtkMath::Pi() * (v - 0.5);
  const glm::dvec3 place(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
  return { place, place, { -std::sin(a), std::cos(a), 0. } };
}

//------------------------------------------------------------------------------
SurfacePoint TorusPoint(double u, double v)
{
  const double a = 2. * vtkMath::Pi() * u;
  const double b = 2. * vtkMath::Pi() * v;
  const glm::dvec3 normal(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
  const glm::dvec3 ring(std::cos(a), std::sin(a), 0.);
  return { ring + 0.4 * normal, normal, { -std::sin(a), std::cos(a), 0. } };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSurface(const Surface& surface, int columns, int rows)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkFloatArray> truth;
  vtkNew<vtkFloatArray> texture;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  truth->SetName("truth");
  truth->SetNumberOfComponents(3);
  texture->SetName("TCoords");
  texture->SetNumberOfComponents(2);
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const SurfacePoint p = surface(double(i) / columns, double(j) / rows);
      points->InsertNextPoint(p.Position.x, p.Position.y, p.Position.z);
      normals->InsertNextTuple3(p.Normal.x, p.Normal.y, p.Normal.z);
      truth->InsertNextTuple3(p.Tangent.x, p.Tangent.y, p.Tangent.z);
      texture->InsertNextTuple2(double(i) / columns, double(j) / rows);
    }
  }
  vtkNew<vtkCellArray> polys;
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    const vtkIdType ids[3] = { a, b, c };
    glm::dvec3 p[3];
    for (int i = 0; i < 3; ++i)
    {
      double place[3];
      points->GetPoint(ids[i], place);
      p[i] = glm::dvec3(place[0], place[1], place[2]);
    }
    if (glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) > 1e-12)
    {
      polys->InsertNextCell(3, ids);
    }
  };
  for (vtkIdType j = 0; j < rows; ++j)
  {
    for (vtkIdType i = 0; i < columns; ++i)
    {
      const vtkIdType p = j * (columns + 1) + i;
      const vtkIdType q = p + columns + 1;
      add(p, p + 1, q + 1);
      add(p, q + 1, q);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetTCoords(texture);
  mesh->GetPointData()->AddArray(truth);
  return mesh;
}
}
