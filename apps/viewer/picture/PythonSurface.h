// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Normal and height maps, environments and the colour scale as lines of Python.
 */
#ifndef PythonSurface_h
#define PythonSurface_h

#include <ostream>

class vtkRenderer;

namespace cli
{
struct RenderOptions;
}

namespace viewer
{
/// Whether surfaces need texture coordinates.
bool IsMapped(const cli::RenderOptions& options);

/// The function mapped(data), which gives a mesh texture coordinates where it has none.
void WriteMapped(std::ostream& out, const cli::RenderOptions& options);

/// The material of all actors and what it reflects, with image(path), which the program has.
void WriteSurface(std::ostream& out, vtkRenderer* renderer, const cli::RenderOptions& options);

/// The colour scale, of the last actor's `colors`, if the renderer shows one.
void WriteScalarBar(std::ostream& out, vtkRenderer* renderer);
}

#endif
