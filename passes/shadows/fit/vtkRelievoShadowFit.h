// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The views that a light's maps are drawn from: fitted in steps to where shadows can be seen, and
// in depth to what can cast there. One view for a sun and for a lamp that sees everything within a
// cone, up to six sides of a cube for others.
#ifndef vtkRelievoShadowFit_h
#define vtkRelievoShadowFit_h

#include "vtkRelievoShadowView.h"

#include <vector>

struct vtkRelievoShadowLight;

namespace vtkRelievoShadowFit
{
struct Request
{
  int Size = 2048; // of the map, in texels
  int Border = 2;  // texels around the region that the filter reaches

  // The camera, for maps that spend their texels by what it sees.
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Gaze{ 0.0, 0.0, -1.0 }; // unit
  glm::dvec3 ViewUp{ 0.0, 1.0, 0.0 };
  bool ParallelEye = false;
};

// Views of evenly spaced maps. What is visible is a part of the scene, both as polygons. A function
// of what it is given and of nothing else. Empty if no shadow can be seen.
std::vector<vtkRelievoShadowView> Fit(const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoShadowRegion::Polygon>& visible,
  const std::vector<vtkRelievoShadowRegion::Polygon>& scene,
  const std::vector<vtkRelievoBox>& casters, const Request& request);

// Around all places that light would reach through what casts: elsewhere no shadow falls, so that a
// wide ground takes no texels. Empty where that is not known.
std::vector<glm::dvec4> GetShadowPlanes(const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoBox>& casters, const std::vector<vtkRelievoBox>& receivers);

// Whether some camera in this scene needs several maps of the light.
bool IsCube(
  const vtkRelievoShadowLight& light, const std::vector<vtkRelievoShadowRegion::Polygon>& scene);
}

#endif
