// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The layers flow, motion and flow_valid of a sequence: from each frame to the one before, by rays.
 */
#ifndef Flow_h
#define Flow_h

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

/// Whether these options make a layer of this name one of them: those of several times.
bool IsFlowOfFrames(const RenderOptions& options, const std::string& name);

class FlowOfFrames
{
public:
  /// Takes its layers from a list.
  FlowOfFrames(const RenderOptions& options, std::vector<std::string>& layers);

  /// Adds them to an image of what the renderer shows now. In the first frame nothing has been
  /// anywhere before: NaN, and 0. Throws WorkError.
  void AddTo(vtkImageData* image, vtkRenderer* renderer, const RenderOptions& options);

private:
  std::vector<std::string> Layers;
  vtkSmartPointer<vtkRelievoRayScene> Scene, Before;
  vtkSmartPointer<vtkRelievoCameraModel> CameraBefore;
};
}

#endif
