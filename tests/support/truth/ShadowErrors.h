// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowErrors.h
 * @brief Counts wrong shadow verdicts of a picture, against rays.
 */
#ifndef relievoTestShadowErrors_h
#define relievoTestShadowErrors_h

#include "Truth.h"

#include <string>
#include <vector>

class vtkLight;

namespace relievoTest
{
class EmbreeScene;

/** The true verdict of each pixel for a light: in shadow, lit, or excluded. */
struct ShadowTruth
{
  enum Verdict : unsigned char
  {
    Unjudged,
    Lit,
    Dark
  };
  int Width = 0;
  int Height = 0;
  std::vector<Verdict> Verdicts; // row 0 at the bottom
  long long Flipping = 0;        // pixels excluded because a small jitter flips the verdict
};

/** A picture's verdicts compared with that truth. */
struct ShadowErrors
{
  long long Compared = 0;
  long long Dark = 0;        // of these, truly in shadow
  long long FalseShadow = 0; // lit, but drawn in shadow
  long long FalseLight = 0;  // in shadow, but drawn lit
  long long Flipping = 0;

  /** Share of errors among the compared pixels. */
  double Wrong() const
  {
    return static_cast<double>(this->FalseShadow + this->FalseLight) /
      static_cast<double>(this->Compared > 0 ? this->Compared : 1);
  }
  std::string ToString() const;
};

/**
 * Traces rays from every pixel's position to the light. Compared are pixels whose surface has a
 * geometric normal n towards the light, n * l > 0.05 (within the cone of a spot), and whose verdict
 * agrees with four rays that start `jitter` (world units) beside it.
 */
ShadowTruth TraceShadow(
  const EmbreeScene& scene, const TruthImage& view, vtkLight* light, double jitter = 1e-5);

/**
 * Excludes pixels whose centre lies within 1/256 of a pixel of an edge of its triangle: OpenGL,
 * which rounds corners to such steps, may show the adjacent triangle.
 */
ShadowTruth WithoutEdges(const ShadowTruth& truth, const TruthImage& view);

/** `visibility`: 1 lit, 0 dark, per pixel of the truth, row 0 at the bottom; 0.5 divides. */
ShadowErrors CompareShadow(const ShadowTruth& truth, const float* visibility);
}

#endif
