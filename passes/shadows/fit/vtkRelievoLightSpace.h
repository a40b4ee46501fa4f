// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The axes of a light's map, and the view fitted in them to the visible region.
#ifndef vtkRelievoLightSpace_h
#define vtkRelievoLightSpace_h

#include "vtkRelievoShadowFit.h"

#include <vector>

// How a map is oriented in its frame.
struct vtkRelievoMapPlacement
{
  bool Turned = false; // by Angle; otherwise for the shortest sides
  double Angle = 0.0;
  double Widest = 1.0; // ratio of the widest texel to an even one, for uneven maps
};

struct vtkRelievoLightSpace
{
  glm::dvec3 Origin;
  glm::dvec3 Forward;
  glm::dvec3 Up;
  glm::dvec3 Right;
  glm::dvec2 Shear{ 0.0 }; // right and up per forward, for oblique parallel rays

  // Nearest plane of a perspective map, as a share of the farthest, which leaves 4 digits in
  // floats. Casters in front of it are drawn onto it.
  static constexpr double NearestShare = 1e-3;

  vtkRelievoLightSpace(const glm::dvec3& origin, const glm::dvec3& forward, const glm::dvec3& up);
  vtkRelievoLightSpace(const glm::dvec3& origin, const glm::dvec3& forward);

  // Right, up, forward.
  glm::dvec3 Map(const glm::dvec3& world) const;

  // To the place with these right, up, forward.
  void MoveTo(const glm::dvec3& p);

  // The plane right * x + up * y + forward * z >= 0 through the origin, in world coordinates.
  glm::dvec4 GetPlane(double x, double y, double z) const;

  // The view of the visible region, a part of the whole scene. The region only selects among a few
  // views. False if nothing casts into it.
  bool Fit(bool parallel, const std::vector<glm::dvec3>& visible,
    const std::vector<glm::dvec3>& scene, const std::vector<vtkRelievoBox>& casters,
    const vtkRelievoShadowFit::Request& request, vtkRelievoShadowView& view,
    const vtkRelievoMapPlacement& placement = {}) const;
};

#endif
