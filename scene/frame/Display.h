// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Whether this machine can draw the request: a display for an OpenGL context, and pictures within
 * the context's limits.
 */
#ifndef Display_h
#define Display_h

#include "SceneNames.h"

#include <array>

class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace scene
{
/// Throws WorkError if the window's display cannot be reached: VTK would end the process instead.
void CheckDisplay(vtkRenderWindow* window);

/// OpenGL's largest picture size in each direction; makes the window's context current.
int GetSizeLimit(vtkOpenGLRenderWindow* window);

/// Makes the window's context and throws WorkError if the size, of a part of the picture that was
/// asked for, exceeds its limits.
void CheckSize(
  vtkRenderWindow* window, const std::array<int, 2>& size, const std::array<int, 2>& asked);
}

#endif
