// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The axes of a light's map, and the view that is fitted in them to what is visible.
#ifndef vtkRelievoLightSpace_h
#define vtkRelievoLightSpace_h

#include "vtkRelievoShadowFit.h"

#include <vector>

// How a map lies in its frame.
struct vtkRelievoMapPlacement
{
  bool Turned = false; // by the angle; otherwise as its sides are shortest
  double Angle = 0.0;
  double Widest = 1.0; // texel, where they are spent unevenly, over an even one
};

struct vtkRelievoLightSpace
{
  glm::dvec3 Origin;
  glm::dvec3 Forward;
  glm::dvec3 Up;
  glm::dvec3 Right;
  glm::dvec2 Shear{ 0.0 }; // right and up per forward: of oblique parallel rays

  // Nearest plane of a perspective map, as a share of the farthest: floats keep 4 digits then.
  // Casters before it are drawn onto it.
  static constexpr double NearestShare = 1e-3;

  vtkRelievoLightSpace(const glm::dvec3& origin, const glm::dvec3& forward, const glm::dvec3& up);
  vtkRelievoLightSpace(const glm::dvec3& origin, const glm::dvec3& forward);

  // Right, up, forward.
  glm::dvec3 Map(const glm::dvec3& world) const;

  // To the place with these right, up, forward.
  void MoveTo(const glm::dvec3& p);

  // The plane right * x + up * y + forward * z >= 0 through the origin, in world coordinates.
  glm::dvec4 GetPlane(double x, double y, double z) const;

  // A view of what is visible, a part of the whole scene. It depends on the visible part by a
  // choice between few views only. False if nothing casts into it.
  bool Fit(bool parallel, const std::vector<glm::dvec3>& visible,
    const std::vector<glm::dvec3>& scene, const std::vector<vtkRelievoBox>& casters,
    const vtkRelievoShadowFit::Request& request, vtkRelievoShadowView& view,
    const vtkRelievoMapPlacement& placement = {}) const;
};

#endif
