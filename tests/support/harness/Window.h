// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Window.h
 * @brief Off-screen windows for tests, and their pixels.
 */
#ifndef relievoTestWindow_h
#define relievoTestWindow_h

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

namespace relievoTest
{
/**
 * An off-screen window of width x height pixels, not multisampled, no line smoothing.
 * `renderer`, when given, is added.
 */
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height, vtkRenderer* renderer = nullptr);

/**
 * Renders and reads the window's picture: unsigned char, 3 components (4 with `alpha`), row 0 at
 * the bottom.
 */
vtkSmartPointer<vtkImageData> Picture(vtkRenderWindow* window, bool alpha = false);
}

#endif
