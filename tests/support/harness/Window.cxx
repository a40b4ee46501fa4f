// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window.h"

#include "Check.h"

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
  const int right = size[0] - 1;
  const int top = size[1] - 1;
  const int read = alpha ? window->GetRGBACharPixelData(0, 0, right, top, front, pixels)
                         : window->GetPixelData(0, 0, right, top, front, pixels);
  RELIEVO_CHECK_THAT(read == VTK_OK, "the window's pixels cannot be read");
  image->GetPointData()->SetScalars(pixels);
  return image;
}
}
