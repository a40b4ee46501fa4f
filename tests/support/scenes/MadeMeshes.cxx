// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MadeMeshes.h"

#include <vtkAppendPolyData.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkTubeFilter.h>

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace relievoTest
{
namespace
{
// A mesh of only points and triangles.
vtkSmartPointer<vtkPolyData> GetTriangles(vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  triangles->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(triangles->GetOutput()->GetPoints());
  mesh->SetPolys(triangles->GetOutput()->GetPolys());
  return mesh;
}

struct Branches
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Radii;
  vtkNew<vtkCellArray> Lines;
  Lots Random{ 5 };

  void Grow(const glm::dvec3& from, const glm::dvec3& way, double length, double radius, int left)
  {
    const glm::dvec3 to = from + length * way;
    this->Lines->InsertNextCell(2);
    for (const glm::dvec3& end : { from, to })
    {
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(end.x, end.y, end.z));
    }
    this->Radii->InsertNextValue(static_cast<float>(radius));
    this->Radii->InsertNextValue(static_cast<float>(0.7 * radius));
    for (int i = 0; i < 3 && left > 0; ++i)
    {
      const glm::dvec3 aside(this->Random.Between(-1., 1.), this->Random.Between(-0.3, 0.7),
        this->Random.Between(-1., 1.));
      this->Grow(to, glm::normalize(way + 1.1 * aside), 0.72 * length, 0.62 * radius, left - 1);
    }
  }
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeThings(Lots& lots)
{
  vtkNew<vtkAppendPolyData> all;
  for (int i = 0; i < 5; ++i)
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(lots.Between(0.1, 1.1));
    box->SetYLength(lots.Between(0.1, 1.1));
    box->SetZLength(lots.Between(0.1, 1.1));
    vtkNew<vtkCylinderSource> cylinder;
    cylinder->SetRadius(lots.Between(0.05, 0.45));
    cylinder->SetHeight(lots.Between(0.2, 1.7));
    cylinder->SetResolution(24);
    const double at[3] = { lots.Between(-2., 2.), lots.Between(0.2, 1.2), lots.Between(-1.5, 2.) };
    const double axis[3] = { lots.Between(-1., 1.), lots.Between(-1., 1.), lots.Between(0.2, 1.) };
    vtkNew<vtkTransform> place;
    place->Translate(at);
    place->RotateWXYZ(lots.Between(0., 360.), axis);
    vtkNew<vtkTransformFilter> placed;
    placed->SetTransform(place);
    placed->SetInputConnection(i % 2 == 0 ? box->GetOutputPort() : cylinder->GetOutputPort());
    all->AddInputConnection(placed->GetOutputPort());
  }
  return GetTriangles(all);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFins()
{
  Lots random(7);
  vtkNew<vtkAppendPolyData> all;
  for (int i = 0; i < 40; ++i)
  {
    const double height = random.Between(0.3, 1.2);
    vtkNew<vtkCubeSource> fin;
    fin->SetCenter(-1.9977 + 0.1 * i, 0.5 * height, 0.);
    fin->SetXLength(0.0046);
    fin->SetYLength(height);
    fin->SetZLength(2.);
    all->AddInputConnection(fin->GetOutputPort());
  }
  return GetTriangles(all);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFolds()
{
  constexpr int Cells = 128;
  Lots random(11);
  std::vector<double> height((Cells + 1) * (Cells + 1), 0.);
  const auto at = [&](int i, int j) -> double& { return height[j * (Cells + 1) + i]; };
  // Each step halves the displacement of midpoints.
  for (int step = Cells; step > 1; step /= 2)
  {
    const int half = step / 2;
    const double most = 0.4 * step / Cells;
    for (int j = 0; j <= Cells; j += half)
    {
      for (int i = 0; i <= Cells; i += half)
      {
        const int x = i % step;
        const int y = j % step;
        if (x != 0 || y != 0)
        {
          at(i, j) =
            0.25 * (at(i - x, j - y) + at(i + x, j - y) + at(i - x, j + y) + at(i + x, j + y)) +
            random.Between(-most, most);
        }
      }
    }
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= Cells; ++j)
  {
    for (int i = 0; i <= Cells; ++i)
    {
      const vtkIdType a =
        points->InsertNextPoint(4. * i / Cells - 2., 0.5 + at(i, j), 2. - 4. * j / Cells);
      if (i < Cells && j < Cells)
      {
        triangles->InsertNextCell({ a, a + 1, a + Cells + 2 });
        triangles->InsertNextCell({ a, a + Cells + 2, a + Cells + 1 });
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeArrows()
{
  Lots random(3);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> vectors;
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < 1500; ++i)
  {
    const double x = random.Between(-1.6, 1.6);
    const double y = random.Between(0.1, 1.4);
    const double z = random.Between(-1.6, 1.6);
    points->InsertNextPoint(x, y, z);
    const double way[3] = { -z, 0.4 * std::sin(3. * x), x };
    vectors->InsertNextTuple(way);
  }
  vtkNew<vtkPolyData> field;
  field->SetPoints(points);
  field->GetPointData()->SetVectors(vectors);
  vtkNew<vtkArrowSource> arrow;
  vtkNew<vtkGlyph3D> arrows;
  arrows->SetInputData(field);
  arrows->SetSourceConnection(arrow->GetOutputPort());
  arrows->SetScaleModeToDataScalingOff();
  arrows->SetScaleFactor(0.25);
  return GetTriangles(arrows);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTree()
{
  Branches branches;
  branches.Grow({ 0., 0., 0. }, { 0., 1., 0. }, 0.6, 0.07, 6);
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(branches.Points);
  lines->SetLines(branches.Lines);
  lines->GetPointData()->SetScalars(branches.Radii);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(8);
  tubes->CappingOn();
  return GetTriangles(tubes);
}
}
