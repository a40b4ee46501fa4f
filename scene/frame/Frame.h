// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sets up the frame around a scene from the options: stages, shadows, and points with values.
 */
#ifndef Frame_h
#define Frame_h

#include "Points.h"
#include "SceneNames.h"

#include <string>
#include <vector>

class vtkRelievoPass;
class vtkRenderer;

namespace scene
{
struct RenderOptions;

/// Every file named by the options.
std::vector<std::string> GetInputs(const RenderOptions& options);

/// Returns GetInputs(); throws UsageError or WorkError for one that cannot be opened or
/// does not fit its option.
std::vector<std::string> CheckInputs(const RenderOptions& options);

/// Whether the picture needs a frame; otherwise VTK draws it, with nothing of Relievo attached.
bool NeedsFrame(const RenderOptions& options);

/// Sets up a new pass as requested. Throws UsageError.
void SetFrame(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options,
  const FramePoints& points);
}

#endif
