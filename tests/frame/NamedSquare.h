// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamedSquare.h
 * @brief A lit square that fills the window, with arrays that are called like resources of frames.
 */
#ifndef relievoTestNamedSquare_h
#define relievoTestNamedSquare_h

#include "ImageCompare.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <string>
#include <vector>

namespace relievoTest
{
// Resources that stages exchange, or that the frame itself has.
const std::vector<std::string> ResourceNames = { "visibility", "picture", "drawn", "shadow maps" };

// A square that fills the window, with arrays that have those names, of values 1, 2 ...
struct NamedSquare
{
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  NamedSquare()
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-2.0, -2.0, 0.0);
    plane->SetPoint1(2.0, -2.0, 0.0);
    plane->SetPoint2(-2.0, 2.0, 0.0);
    plane->Update();
    vtkPolyData* data = plane->GetOutput();
    for (std::size_t i = 0; i < ResourceNames.size(); ++i)
    {
      vtkNew<vtkFloatArray> array;
      array->SetName(ResourceNames[i].c_str());
      array->SetNumberOfTuples(data->GetNumberOfPoints());
      array->Fill(1.0 + static_cast<double>(i));
      data->GetPointData()->AddArray(array);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.8, 0.6, 0.4);
    this->Renderer->AddActor(actor);
    vtkNew<vtkLight> sun;
    sun->SetPosition(1.0, 0.5, 2.0);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(sun);
    this->Window = MakeWindow(60, 50, this->Renderer);
    this->Renderer->ResetCamera(-1.0, 1.0, -1.0, 1.0, 0.0, 0.0);
  }
};
}

#endif
