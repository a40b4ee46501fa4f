// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Builds a renderer, ready to draw, from files and options: actors, lights, camera.
 */
#ifndef Scene_h
#define Scene_h

#include "Actors.h"
#include "Grid.h"
#include "Models.h"
#include "SceneNames.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reading
{
class Progress;
class ReadContext;
}

namespace scene
{
struct RenderOptions;

struct Scene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<PosedModel> Models;
  vtkSmartPointer<vtkActor> Ground;                       ///< null: none
  vtkSmartPointer<look::Grid> Grid;                       ///< null: none
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; ///< of the visible props but the ground
  bool HasLights = false;                                 ///< whether the files have lights
  int UpAxis = 1;          ///< by the first file: 0, 1, 2 for x, y, z
  std::vector<int> Counts; ///< number of actors from each file, without skeletons
  std::vector<std::array<int, 3>> Dimensions; ///< dimensions of images not shown as boxes, or zeros
  ArrayNames Arrays;                          ///< that can be layers
  std::optional<std::array<double, 2>> Times; ///< first and last second of animations
};

/// Reads every file. Throws WorkError naming the file that cannot be read or is empty.
Scene ReadScene(const RenderOptions& options, ReadContext& context);

/// Applies shading, colours, lights and camera to the actors.
void StyleScene(Scene& scene, const RenderOptions& options);

/// The options with the scene's own up axis and lights where the options leave these open.
RenderOptions FollowFile(RenderOptions options, const Scene& scene);

/// Fits one camera to all frames of a sequence.
void FitTimes(Scene& scene, const RenderOptions& options, Progress& progress);

/// Moves the models to a time in seconds; the camera stays.
void PlayScene(Scene& scene, const RenderOptions& options, double time, Progress& progress);
}

#endif
