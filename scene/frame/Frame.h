// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the options ask of the frame around a scene: stages, shadows, and points with values.
 */
#ifndef Frame_h
#define Frame_h

#include "Points.h"

#include <string>
#include <vector>

class vtkRelievoPass;
class vtkRenderer;

namespace scene
{
struct RenderOptions;

/// Every file that the options name; throws UsageError or WorkError for one that cannot be opened
/// or that is not what its option takes.
std::vector<std::string> CheckInputs(const RenderOptions& options);

/// Whether the picture needs a frame: a plain one is VTK's own, and nothing of Relievo is attached.
bool NeedsFrame(const RenderOptions& options);

/// Sets the pass, a new one, as asked. Throws UsageError.
void SetFrame(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options,
  const FramePoints& points);
}

#endif
