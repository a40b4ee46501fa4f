// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From files and options to a renderer, ready to draw: actors, lights, camera.
 */
#ifndef Scene_h
#define Scene_h

#include "Actors.h"
#include "Grid.h"
#include "Models.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scene
{
class Progress;
class ReadContext;
struct RenderOptions;

struct Scene
{
  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<PosedModel> Models;
  vtkSmartPointer<vtkActor> Ground;                       ///< null: none
  vtkSmartPointer<scene::Grid> Grid;                      ///< null: none
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; ///< of what is shown, without a ground
  bool HasLights = false;                                 ///< of its files
  int UpAxis = 1;          ///< by the first file: 0, 1, 2 for x, y, z
  std::vector<int> Counts; ///< how many actors each file gave, skeletons apart
  std::vector<std::array<int, 3>>
    Dimensions;      ///< points of images that are not shown as boxes, or zeros
  ArrayNames Arrays; ///< that can be layers
  std::optional<std::array<double, 2>> Times; ///< seconds that animations last; none: nothing moves
};

/// Reads every file. Throws WorkError with the name of the file that cannot be read or shows
/// nothing.
Scene ReadScene(const RenderOptions& options, ReadContext& context);

/// Shading, colours and lights of what was read, and the camera.
void DressScene(Scene& scene, const RenderOptions& options);

/// The options with the scene's up axis and lights, where they leave it to that.
RenderOptions FollowFile(RenderOptions options, const Scene& scene);

/// Fits the camera so that it sees every frame of a sequence, from one place.
void FitTimes(Scene& scene, const RenderOptions& options, Progress& progress);

/// Moves the models to a time in seconds; the camera stays.
void PlayScene(Scene& scene, const RenderOptions& options, double time, Progress& progress);
}

#endif
