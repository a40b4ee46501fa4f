// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether this machine can draw what was asked: a display to make an OpenGL context on, and
 * pictures no larger than that context takes.
 */
#ifndef Display_h
#define Display_h

#include <array>

class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace scene
{
/// Throws WorkError if the display of the window cannot be reached: VTK would end the process then.
void CheckDisplay(vtkRenderWindow* window);

/// The most pixels each way that OpenGL draws in the window. Makes its context the current one.
int GetSizeLimit(vtkOpenGLRenderWindow* window);

/// Makes the window's context and throws WorkError if the size is above its limits.
void CheckSize(vtkRenderWindow* window, const std::array<int, 2>& size);
}

#endif
