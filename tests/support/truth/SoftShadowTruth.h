// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SoftShadowTruth.h
 * @brief The visible share of an area light for each pixel, by rays to points all over it.
 */
#ifndef relievoTestSoftShadowTruth_h
#define relievoTestSoftShadowTruth_h

#include "Truth.h"

#include <string>
#include <vector>

class vtkLight;

namespace relievoTest
{
class EmbreeScene;

struct SoftShadowTruth
{
  std::vector<float> Shares; // per pixel, row 0 at the bottom; negative: excluded
};

/** The edges of a light that is a parallelogram around its position, in world coordinates. */
struct LightEdges
{
  glm::dvec3 First;
  glm::dvec3 Second;
};

/** Errors of a picture's shares. */
struct SoftShadowErrors
{
  long long Compared = 0;
  long long Penumbra = 0; // of these, neither fully lit nor fully dark
  double Rms = 0.;        // over all compared pixels
  double PenumbraRms = 0.;
  double PenumbraMean = 0.; // drawn minus true
  std::string ToString() const;
};

/**
 * `size`: the apparent angle in degrees of a directional light, or the radius of a positional one:
 * a spot's disc across its axis, or a glowing ball, whose light counts as for a surface that faces
 * it; with `edges`, the light is a parallelogram instead. Rays go to 32 x 32 cells of equal area,
 * to a random point in each, or only to 8 x 8 of them if these agree. Compared are pixels whose
 * normal n turns to the light's middle, n * l > 0.05, within the cone of a spot, and whose verdict
 * for the light's middle agrees with four rays that start beside it. A point of the light behind
 * the pixel's own plane is blocked.
 */
SoftShadowTruth TraceSoftShadow(const EmbreeScene& scene, const TruthImage& view, vtkLight* light,
  double size, const LightEdges* edges = nullptr);

/** `visibility`: the drawn share for each pixel of the truth. */
SoftShadowErrors CompareSoftShadow(const SoftShadowTruth& truth, const float* visibility);
}

#endif
