// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Props.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

namespace relievoTest
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBall(double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(12);
  source->SetPhiResolution(9);
  source->Update();
  return source->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, double x, double y, double z)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(x, y, z);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(mesh);
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}
}
