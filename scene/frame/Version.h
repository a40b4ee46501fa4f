// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What draws here: the versions of Relievo, VTK and OpenGL, for reports of defects.
 */
#ifndef Version_h
#define Version_h

#include <string>
#include <vector>

class vtkRenderWindow;

namespace scene
{
/// One line each. OpenGL is asked in a window of its own; where none can open, its line says why.
std::string DescribeVersions();

/// What has drawn a window, a line each: Relievo, VTK, and OpenGL's renderer and version.
std::vector<std::string> ListVersions(vtkRenderWindow* window);
}

#endif
