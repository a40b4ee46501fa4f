// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The views for a light's maps: fitted in steps to the region with visible shadows, and in depth to
// its casters. One view for a sun and for a lamp whose region is within a cone, up to six sides of
// a cube for other lamps.
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
  int Border = 2;  // texels that the filter reaches around the region

  // The camera, for maps with texels distributed by its view.
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Gaze{ 0.0, 0.0, -1.0 }; // unit
  glm::dvec3 ViewUp{ 0.0, 1.0, 0.0 };
  bool ParallelEye = false;
};

// Views of even maps. The visible region is a part of the scene; both are polygons. Depends only on
// the arguments. Empty if no shadow is visible.
std::vector<vtkRelievoShadowView> Fit(const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoShadowRegion::Polygon>& visible,
  const std::vector<vtkRelievoShadowRegion::Polygon>& scene,
  const std::vector<vtkRelievoBox>& casters, const Request& request);

// Polygons around all places behind casters, seen from the light: there are no shadows elsewhere,
// so that a wide ground takes no texels. Empty if unknown.
std::vector<glm::dvec4> GetShadowPlanes(const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoBox>& casters, const std::vector<vtkRelievoBox>& receivers);

// Whether some camera in this scene needs several maps of the light.
bool IsCube(
  const vtkRelievoShadowLight& light, const std::vector<vtkRelievoShadowRegion::Polygon>& scene);
}

#endif
