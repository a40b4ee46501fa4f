// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Normal and height maps, environments and the colour scale as lines of Python.
 */
#ifndef PythonSurface_h
#define PythonSurface_h

#include <ostream>
#include <string>

class vtkRenderer;

namespace cli
{
struct RenderOptions;
struct Scene;
}

namespace viewer
{
/// Whether surfaces need texture coordinates.
bool IsMapped(const cli::RenderOptions& options);

/// Data with texture coordinates on every mesh.
std::string WriteMapped(const std::string& data, const cli::RenderOptions& options);

/// The materials of all actors, and the environment.
void WriteSurface(std::ostream& out, const cli::Scene& scene, const cli::RenderOptions& options);

/// The colour scale, of the last actor's `colors`, if the renderer shows one.
void WriteScalarBar(std::ostream& out, vtkRenderer* renderer);
}

#endif
