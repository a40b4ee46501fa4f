// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Truth.h
 * @brief The truth for a pixel, filled by both the Embree scenes and the analytic scenes.
 */
#ifndef relievoTestTruth_h
#define relievoTestTruth_h

#include "View.h"

#include <functional>
#include <limits>
#include <vector>

namespace relievoTest
{
/** A hit of a ray with a scene. */
struct SurfacePoint
{
  bool Hit = false;
  /** The ray's parameter: for a pixel's ray eye space -z, in world units. +infinity: no hit. */
  double Depth = std::numeric_limits<double>::infinity();
  glm::dvec3 Position{ 0. };
  /** Unit geometric normal, on the side of the ray's origin. */
  glm::dvec3 Normal{ 0. };
  /** Whether the ray hits the outside: vertices run counter-clockwise as seen from the eye. */
  bool FrontFacing = true;
  /** Index of the actor or shape, cell id in its vtkPolyData, triangle of the scene; -1: none. */
  int Actor = -1;
  long long Cell = -1;
  long long Triangle = -1;
};

/** The truth for a pixel, and how certain it is. */
struct PixelTruth : SurfacePoint
{
  /**
   * Whether the centres of all 8 neighbours and the pixel's own 4 corners hit one actor, and the
   * depth continues between them as on one surface: no edge is near, so the verdict does not depend
   * on the exact position of the sample in the pixel.
   */
  bool Inner = false;
  /**
   * Distance in pixels from the pixel's centre to the nearest edge of the triangle as drawn;
   * negative outside (rounding). +infinity for shapes without triangles.
   */
  double EdgeDistance = std::numeric_limits<double>::infinity();
  /** Smallest width in pixels of the triangle as drawn, the part before the near plane. */
  double TriangleWidth = std::numeric_limits<double>::infinity();
};

/** The truth for all pixels of a view: row 0 at the bottom, as in VTK. */
struct TruthImage
{
  int Width = 0;
  int Height = 0;
  std::vector<PixelTruth> Pixels;

  const PixelTruth& At(int x, int y) const
  {
    return this->Pixels[static_cast<size_t>(y) * this->Width + x];
  }
  /** Number of pixels with a hit, and of inner ones. */
  long long NumberOfHits() const;
  long long NumberOfInner() const;
};

/** Returns the first hit with t in [tMin, tMax]; called from several threads. */
using CastFunction = std::function<SurfacePoint(const Ray& ray, double tMin, double tMax)>;

/** Completes a pixel whose SurfacePoint is known; called from several threads. */
using FinishFunction = std::function<void(int x, int y, PixelTruth& pixel)>;

/**
 * Casts the ray of every pixel's centre and corner, from the near to the far plane, and finds the
 * inner pixels. Pixels at the border of the view are included: their outer neighbours are cast,
 * too.
 */
TruthImage TraceView(
  const View& view, const CastFunction& cast, const FinishFunction& finish = FinishFunction());

/** Angle between two vectors of any length, in degrees, exact for small angles. */
double AngleDegrees(const glm::dvec3& a, const glm::dvec3& b);
}

#endif
