// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Versions of Relievo, VTK and OpenGL, for defect reports.
 */
#ifndef Version_h
#define Version_h

#include "SceneNames.h"

#include <string>
#include <vector>

class vtkRenderWindow;

namespace scene
{
/// One line each. OpenGL is queried in a window of its own; if none can open, its line gives the
/// reason.
std::string DescribeVersions();

/// The versions that draw a window, a line each: Relievo, VTK, and OpenGL's renderer.
std::vector<std::string> ListVersions(vtkRenderWindow* window);
}

#endif
