// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a probe of shadows looks at: view and lights in steps, so that most of their moves need no
// new rays.
#ifndef vtkRelievoProbeView_h
#define vtkRelievoProbeView_h

#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoShadowLight.h"
#include "vtkRelievoShadowRegion.h"

#include <vector>

class vtkRenderer;

namespace vtkRelievoProbeView
{
// The view of the whole picture, of which the frame's may be a tile.
vtkRelievoFrameCamera GetPicture(const vtkRelievoFrameCamera& view, vtkRenderer* renderer);

// The camera at the nearest of a few places and directions: places a share of its distance to the
// boxes apart, and of that to what it sees, the middle of which is given.
vtkRelievoFrameCamera GetStep(const vtkRelievoFrameCamera& view, const glm::dvec3& center,
  const std::vector<vtkRelievoBox>& boxes);

// The lights, likewise.
std::vector<vtkRelievoShadowLight> GetStep(
  const std::vector<vtkRelievoShadowLight>& lights, const glm::dvec3& center);

// The depth from which on surfaces are seen, in steps: the near plane's if it cuts something.
double GetFirst(const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoBox>& boxes);

// The part of the window that boxes are seen in: its low corner and its size, as shares of it.
glm::dvec4 GetPart(const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC);
}

#endif
