// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// White, unlit objects on white, with the stage `lines`: dark pixels are lines.
#ifndef LinesScene_h
#define LinesScene_h

#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoLinesStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace linesTest
{
constexpr int Size = 201;

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRelievoLinesStage> Stage;
  vtkRelievoPass* Frame = nullptr;

  explicit Scene(int height = Size)
  {
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window = relievoTest::MakeWindow(Size, height, this->Renderer);
    this->Look(0.0, 0.0, 5.0);
    this->Frame = vtkRelievoPass::Attach(this->Renderer);
    this->Stage->SetWidth(1.0);
    this->Frame->AddStage(this->Stage);
  }

  void Look(double x, double y, double z)
  {
    this->Renderer->GetActiveCamera()->SetPosition(x, y, z);
    this->Renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
    this->Renderer->GetActiveCamera()->SetClippingRange(0.05, 100.0);
  }

  void Add(vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
  }

  void Add(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    this->Add(mapper);
  }

  vtkSmartPointer<vtkImageData> Picture() { return relievoTest::Picture(this->Window); }

  // How much of each pixel is covered, linear, from the lower left.
  std::vector<double> Cover()
  {
    vtkSmartPointer<vtkImageData> picture = this->Picture();
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    std::vector<double> cover(static_cast<std::size_t>(picture->GetNumberOfPoints()));
    for (std::size_t i = 0; i < cover.size(); ++i)
    {
      const double value = bytes[3 * i] / 255.0;
      cover[i] = 1.0 - (value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
    }
    return cover;
  }

  // Where a point is in the picture, pixels' centres at whole numbers.
  void Project(const double point[3], double pixel[2])
  {
    vtkMatrix4x4* matrix = this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      this->Renderer->GetTiledAspectRatio(), -1.0, 1.0);
    const double from[4] = { point[0], point[1], point[2], 1.0 };
    double to[4];
    matrix->MultiplyPoint(from, to);
    const int* size = this->Window->GetSize();
    for (int i = 0; i < 2; ++i)
    {
      pixel[i] = 0.5 * (to[i] / to[3] + 1.0) * size[i] - 0.5;
    }
  }
};

inline double Total(const std::vector<double>& cover)
{
  double sum = 0.0;
  for (double each : cover)
  {
    sum += each;
  }
  return sum;
}

inline bool SamePicture(vtkImageData* a, vtkImageData* b)
{
  return a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
    std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), 3 * a->GetNumberOfPoints()) == 0;
}
}

#endif
