// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A camera's rays against spheres, in double: the coefficients per sphere by which
// shaders/formulas/light/fog.glsl computes the chord of each pixel's ray, and markers compute the
// distance of a pixel's point from the sphere's centre.
//
// The ray of a pixel keeps one NDC position at every depth t: B + t D, in eye space, with D.z = -1.
// In perspective B is the same for all pixels, in parallel projection D is; the other one is linear
// in the pixel. So is (B - C) x D for a sphere's centre C, and
//   |D|^2 - |(B - C) x D|^2 / radius^2,
// which is positive where the ray hits the sphere, is a polynomial of degree 2 in the pixel.
#ifndef vtkRelievoSphereRays_h
#define vtkRelievoSphereRays_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoSphereBounds.h"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

struct vtkRelievoFrameCamera;

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoSphereRays
{
public:
  explicit vtkRelievoSphereRays(const vtkRelievoFrameCamera& view);

  // False for a projection in which depth changes across the picture; its rays are not covered
  // here.
  bool IsUsual() const { return this->Usual; }

  // Values of a sphere that do not depend on the pixel. Pixels are counted from the viewport's
  // lower left corner, so pixel centres are at halves.
  struct Sphere
  {
    int Rectangle[4];   // pixels that may show it: x0, y0, and x1, y1 past the end
    glm::dvec2 Pixel;   // centre of the rectangle's middle pixel, the polynomial's origin
    glm::dvec3 Linear;  // coefficients of 1, x, y
    glm::dvec3 Square;  // coefficients of x^2, x y, y^2
    glm::dvec2 Offset;  // from the centre to the ray at the centre's depth, in radii
    glm::dmat2 Offsets; // change of Offset per pixel in x and y
    double MiddleDepth; // of the centre, from the rays' begin
  };

  // False if the rectangle, with a margin of `margin` pixels, contains no pixel's centre.
  bool Find(
    const glm::dvec3& centerWorld, double radius, Sphere& sphere, double margin = 0.0) const;

  // x and y of D at a position of the viewport, and the change per pixel in x and y.
  glm::dvec2 GetDirection(const glm::dvec2& pixel) const;
  const glm::dmat2& GetDirections() const { return this->Directions; }

  // The depth where rays begin: the eye, or in parallel projection the near plane if it lies
  // behind.
  double GetBegin() const { return this->Begin; }

private:
  glm::dmat4 WorldToView;
  vtkRelievoSphereBounds Bounds;
  glm::dvec2 Size;
  glm::dvec2 Base{ 0.0 };      // B of the pixel (0, 0), at the depth Apex
  glm::dmat2 Bases{ 0.0 };     // change of B per pixel
  glm::dvec2 Direction{ 0.0 }; // of the pixel (0, 0)
  glm::dmat2 Directions{ 0.0 };
  double Apex = 0.0; // the depth at which a perspective's rays converge
  double Begin = 0.0;
  double From = 0.0; // the depth in front of which no bounds are computed
  bool Usual = true;
};

#endif
