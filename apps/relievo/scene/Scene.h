// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From files and options to a window with one renderer, ready to draw: actors, lights, camera.
 */
#ifndef Scene_h
#define Scene_h

#include "vtkSmartPointer.h"

#include <set>
#include <string>

class vtkRenderer;
class vtkRenderWindow;

namespace cli
{
class Progress;
struct RenderOptions;

struct Scene
{
  vtkSmartPointer<vtkRenderWindow> Window; ///< off screen, single sample, of the asked size
  vtkSmartPointer<vtkRenderer> Renderer;
  std::set<std::string> Arrays; ///< names of the point and cell arrays that can be layers
};

/// Reads every file. Throws WorkError with the name of the file that cannot be read or shows
/// nothing.
Scene BuildScene(const RenderOptions& options, Progress& progress);
}

#endif
