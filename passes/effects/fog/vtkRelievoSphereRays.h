// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A camera's rays against spheres, in double: what shaders/formulas/fog.glsl needs to know of each
// sphere to compute the chord of every pixel's ray, and markers to compute how far a pixel's point
// is from the sphere's centre.
//
// The ray of a pixel is where its NDC is the same at every depth t: B + t D, in eye space, with D.z
// -1. In perspective B is the same for all pixels, in parallel projection D is; the other is linear
// in the pixel. Then so is (B - C) x D for a sphere's centre C, and
//   |D|^2 - |(B - C) x D|^2 / radius^2,
// which is positive where the ray meets the sphere, is a polynomial of second degree in the pixel.
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

  // False for a projection in which depth changes across the picture: it has other rays.
  bool IsUsual() const { return this->Usual; }

  // What of a sphere does not depend on the pixel. Pixels are counted from the viewport's lower
  // left corner, so that centres are at halves.
  struct Sphere
  {
    int Rectangle[4];   // the pixels that it may be seen in: x0, y0, and x1, y1 after the last
    glm::dvec2 Pixel;   // the centre of a pixel in the middle of them, where the others are of
    glm::dvec3 Linear;  // of the polynomial: 1, x, y
    glm::dvec3 Square;  // x^2, x y, y^2
    glm::dvec2 Offset;  // from the centre to the ray at the centre's depth, in radii
    glm::dmat2 Offsets; // its change by pixels in x and y
    double MiddleDepth; // of the centre, from where rays begin
  };

  // False if the sphere, with `margin` pixels around its rectangle, covers the centre of no pixel.
  bool Find(
    const glm::dvec3& centerWorld, double radius, Sphere& sphere, double margin = 0.0) const;

  // x and y of D at a place of the viewport, and the change by pixels in x and y.
  glm::dvec2 GetDirection(const glm::dvec2& pixel) const;
  const glm::dmat2& GetDirections() const { return this->Directions; }

  // The depth where rays begin: the eye, or in parallel projection the near plane behind it.
  double GetBegin() const { return this->Begin; }

private:
  glm::dmat4 WorldToView;
  vtkRelievoSphereBounds Bounds;
  glm::dvec2 Size;
  glm::dvec2 Base{ 0.0 };      // B of the pixel (0, 0), at the depth Apex
  glm::dmat2 Bases{ 0.0 };     // its change by pixels
  glm::dvec2 Direction{ 0.0 }; // of the pixel (0, 0)
  glm::dmat2 Directions{ 0.0 };
  double Apex = 0.0; // the depth at which the rays of a perspective meet
  double Begin = 0.0;
  double From = 0.0; // the depth in front of which nothing is bounded
  bool Usual = true;
};

#endif
