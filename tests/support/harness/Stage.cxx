// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "Scenes.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkPoints.h>

namespace relievoTest
{
//------------------------------------------------------------------------------
Stage::Stage(int width, int height, const glm::dvec3& origin)
  : Window(MakeWindow(width, height, Renderer))
{
  SetReferenceCamera(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double* eye = camera->GetPosition();
  camera->SetPosition(eye[0] + origin.x, eye[1] + origin.y, eye[2] + origin.z);
  const double* focus = camera->GetFocalPoint();
  camera->SetFocalPoint(focus[0] + origin.x, focus[1] + origin.y, focus[2] + origin.z);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBox(double x, double y, double z)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(x);
  cube->SetYLength(y);
  cube->SetZLength(z);
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cube->Update();
  return cube->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePolygons(const std::vector<glm::dvec3>& points)
{
  vtkNew<vtkPoints> all;
  all->SetDataTypeToDouble();
  for (const glm::dvec3& p : points)
  {
    all->InsertNextPoint(p.x, p.y, p.z);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(all);
  mesh->SetPolys(vtkNew<vtkCellArray>());
  return mesh;
}
}
