// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window.h"

#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace relievoTest
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height, vtkRenderer* renderer)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  if (renderer)
  {
    window->AddRenderer(renderer);
  }
  return window;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Picture(vtkRenderWindow* window, bool alpha)
{
  window->Render();
  const int* size = window->GetSize();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  pixels->SetName("color");
  const int front = window->GetDoubleBuffer() ? 0 : 1;
  if (alpha)
  {
    window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, front, pixels);
  }
  else
  {
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, front, pixels);
  }
  image->GetPointData()->SetScalars(pixels);
  return image;
}
}
