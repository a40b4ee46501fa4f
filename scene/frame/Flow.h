// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Layers flow, motion and flow_valid of a sequence: from each frame to the previous one, by rays.
 */
#ifndef Flow_h
#define Flow_h

#include "SceneNames.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoCameraModel;
class vtkRelievoRayScene;
class vtkRenderer;

namespace scene
{
struct RenderOptions;

/// Whether the options have a sequence and the name is one of these layers.
bool IsFlowOfFrames(const RenderOptions& options, const std::string& name);

class FlowOfFrames
{
public:
  /// Removes its layers from a list.
  FlowOfFrames(const RenderOptions& options, std::vector<std::string>& layers);

  /// Adds the layers to an image of the renderer's present view. The first frame has no earlier
  /// positions: NaN, and 0. Throws WorkError.
  void AddTo(vtkImageData* image, vtkRenderer* renderer, const RenderOptions& options);

private:
  std::vector<std::string> Layers;
  vtkSmartPointer<vtkRelievoRayScene> Scene, Before;
  vtkSmartPointer<vtkRelievoCameraModel> CameraBefore;
};
}

#endif
