// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The input of a probe of shadows: view and lights rounded to steps, so that most of their moves
// need no new rays.
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

// The camera rounded to the nearest of a grid of positions and directions: the spacing is a share
// of its distance to the boxes, and of its distance to the visible part, whose centre is given.
vtkRelievoFrameCamera GetStep(const vtkRelievoFrameCamera& view, const glm::dvec3& center,
  const std::vector<vtkRelievoBox>& boxes);

// The lights, rounded likewise.
std::vector<vtkRelievoShadowLight> GetStep(
  const std::vector<vtkRelievoShadowLight>& lights, const glm::dvec3& center);

// The smallest visible depth, in steps: the near plane's if it cuts any surface.
double GetFirst(const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoBox>& boxes);

// The part of the window that the boxes cover: its low corner and its size, as shares of the
// window.
glm::dvec4 GetPart(const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC);
}

#endif
