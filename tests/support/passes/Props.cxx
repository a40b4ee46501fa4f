// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Props.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>

#include <cmath>

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
  vtkNew<vtkTransformFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(mesh);
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  filter->Update();
  return filter->GetPolyDataOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSquare()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1., -1., 0.);
  plane->SetPoint1(1., -1., 0.);
  plane->SetPoint2(-1., 1., 0.);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  return plane->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeChecker(bool holes)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, holes ? 4 : 3);
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 4; ++x)
    {
      const bool even = (x + y) % 2 == 0;
      const int rgba[4] = { even ? 255 : 0, 128, even ? 0 : 255, even ? 255 : 0 };
      for (int c = 0; c < (holes ? 4 : 3); ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, rgba[c]);
      }
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOff();
  texture->RepeatOff();
  return texture;
}

//------------------------------------------------------------------------------
int GetCheckerParity(const glm::dvec3& place)
{
  const double u = 2. * (place.x + 1.);
  const double v = 2. * (place.y + 1.);
  const double rim = 0.06;
  if (std::abs(u - std::round(u)) < rim || std::abs(v - std::round(v)) < rim)
  {
    return -1;
  }
  return (static_cast<int>(u) + static_cast<int>(v)) % 2;
}
}
