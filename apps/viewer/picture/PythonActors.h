// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What files show as lines of Python: from readers to actors, as they are dressed.
 */
#ifndef PythonActors_h
#define PythonActors_h

#include <ostream>
#include <string>

class vtkActor;
class vtkImageData;

namespace cli
{
struct RenderOptions;
struct Scene;
}

namespace viewer
{
class BareScene;

/// Adds the actors of all files to `renderer`, in their order, and skeletons behind them. Throws
/// cli::WorkError for a file that the program cannot say.
void WriteActors(std::ostream& out, const BareScene& bare, const cli::RenderOptions& options);

/// The image of an actor, of a file or within one. `array` is where a model names its own.
std::string WriteImage(
  const cli::Scene& scene, vtkActor* actor, vtkImageData* image, const char* array);
}

#endif
