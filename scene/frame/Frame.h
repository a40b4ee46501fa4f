// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the options ask of the frame around a scene: stages, shadows, and points with values.
 */
#ifndef Frame_h
#define Frame_h

#include "vtkRelievoFogSpheres.h" // for the points
#include "vtkRelievoLamps.h"
#include "vtkRelievoMarkers.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRelievoPass;
class vtkRenderer;

namespace scene
{
class Progress;
struct RenderOptions;

/// Every file that the options name; throws UsageError or WorkError for one that cannot be opened
/// or that is not what its option takes.
std::vector<std::string> CheckInputs(const RenderOptions& options);

struct FramePoints
{
  std::vector<vtkSmartPointer<vtkRelievoLamps>> Lamps;
  std::vector<vtkSmartPointer<vtkRelievoFogSpheres>> Fogs;
  std::vector<vtkSmartPointer<vtkRelievoMarkers>> Markers;
};

/// Throws WorkError with the file's name.
FramePoints ReadFramePoints(const RenderOptions& options, Progress& progress);

/// Whether the picture needs a frame: a plain one is VTK's own, and nothing of Relievo is attached.
bool NeedsFrame(const RenderOptions& options);

/// Sets the pass, a new one, as asked. Throws UsageError.
void SetFrame(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options,
  const FramePoints& points);

/// Gives the points to a pass that has none.
void AddFramePoints(vtkRelievoPass* pass, const RenderOptions& options, const FramePoints& points);
}

#endif
