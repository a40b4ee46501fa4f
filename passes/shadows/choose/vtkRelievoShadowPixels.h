// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels of a view as rays in double, in the coordinates of vtkRelievoCasterRays, and lots that
// are the same on every machine.
#ifndef vtkRelievoShadowPixels_h
#define vtkRelievoShadowPixels_h

#include "vtkRelievoCasterRays.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoShadowRegion.h"

#include <cmath>
#include <cstdint>
#include <vector>

struct vtkRelievoShadowLight;

// Of a pixel: t is the distance from the eye along the view's axis, as the layer depth has it.
struct vtkRelievoPixelRay
{
  glm::dvec3 From;
  glm::dvec3 Ray;
};

class vtkRelievoShadowPixels
{
public:
  vtkRelievoShadowPixels(const vtkRelievoFrameCamera& view, const glm::dvec3& center);

  // x and y in pixels; the middle of the first is 0.5, 0.5.
  vtkRelievoPixelRay GetRay(double x, double y) const;

private:
  glm::dmat4 ViewToScene;
  glm::dmat4 ViewToNDC;
  glm::dvec2 Size;
};

// A light as a place of those coordinates sees it.
struct vtkRelievoToLight
{
  glm::dvec3 Ray;     // to the light; of a sun, unit
  double Last = 0.0;  // t of the light; infinite for a sun
  bool Lights = true; // within its cone and reach

  vtkRelievoToLight(
    const vtkRelievoShadowLight& light, const glm::dvec3& place, const glm::dvec3& center);
};

// Whether a ray may meet one of the boxes, which are of the world, from t = 0 to `last`.
bool vtkRelievoMeetsAny(const std::vector<vtkRelievoBox>& boxes, const glm::dvec3& center,
  const glm::dvec3& from, const glm::dvec3& ray, double last);

// Surfaces that turn less than this to the light, as n.l, are not judged.
constexpr double vtkRelievoLeastFacing = 0.05;

// How far the place of a pixel may be off, per distance from the eye: places so near a plane lie in
// it (docs/shadows.md).
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
  // 0 to 1, without 1.
  double NextShare() { return std::ldexp(static_cast<double>(this->Next() >> 11), -53); }

private:
  std::uint64_t State;
};

#endif
