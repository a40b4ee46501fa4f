// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels of a view as rays in double, in the coordinates of vtkRelievoCasterRays, and random
// numbers that are equal on every machine.
#ifndef vtkRelievoShadowPixels_h
#define vtkRelievoShadowPixels_h

#include "vtkRelievoCasterRays.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoShadowRegion.h"

#include <cmath>
#include <cstdint>
#include <vector>

struct vtkRelievoShadowLight;

// The ray of a pixel: t is the distance from the eye along the view's axis, like the layer depth.
struct vtkRelievoPixelRay
{
  glm::dvec3 From;
  glm::dvec3 Ray;
};

class vtkRelievoShadowPixels
{
public:
  vtkRelievoShadowPixels(const vtkRelievoFrameCamera& view, const glm::dvec3& center);

  // x and y in pixels; the centre of the first pixel is 0.5, 0.5.
  vtkRelievoPixelRay GetRay(double x, double y) const;

private:
  glm::dmat4 ViewToScene;
  glm::dmat4 ViewToNDC;
  glm::dvec2 Size;
};

// A light seen from a place in those coordinates.
struct vtkRelievoToLight
{
  glm::dvec3 Ray;     // to the light; unit length for a sun
  double Last = 0.0;  // t of the light; infinite for a sun
  bool Lights = true; // whether the place is within the cone and reach

  vtkRelievoToLight(
    const vtkRelievoShadowLight& light, const glm::dvec3& place, const glm::dvec3& center);
};

// Whether a ray may hit one of the boxes, in world coordinates, from t = 0 to `last`.
bool vtkRelievoMeetsAny(const std::vector<vtkRelievoBox>& boxes, const glm::dvec3& center,
  const glm::dvec3& from, const glm::dvec3& ray, double last);

// Surfaces with a smaller n.l are not judged.
constexpr double vtkRelievoLeastFacing = 0.05;

// Bound of the error of a pixel's place per distance from the eye: places this close to a plane
// count as lying in it (docs/shadows.md).
constexpr double vtkRelievoPlaceBlur = 5e-7;

// S. Vigna's splitmix64.
class vtkRelievoSplitMix64
{
public:
  explicit vtkRelievoSplitMix64(std::uint64_t seed)
    : State(seed)
  {
  }
  std::uint64_t Next()
  {
    std::uint64_t z = (this->State += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  // From 0 to 1, excluding 1.
  double NextShare() { return std::ldexp(static_cast<double>(this->Next() >> 11), -53); }

private:
  std::uint64_t State;
};

#endif
