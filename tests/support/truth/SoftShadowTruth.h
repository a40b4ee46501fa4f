// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SoftShadowTruth.h
 * @brief Which share of a light with a size each pixel must show, by rays to points all over it.
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
  std::vector<float> Shares; // per pixel, row 0 at the bottom; negative: not to be judged
};

/** Of a light that is a parallelogram around its position, in world coordinates. */
struct LightEdges
{
  glm::dvec3 First;
  glm::dvec3 Second;
};

/** How far a picture's shares are from the truth. */
struct SoftShadowErrors
{
  long long Compared = 0;
  long long Penumbra = 0; // of these, neither all lit nor all dark
  double Rms = 0.;        // over all that is compared
  double PenumbraRms = 0.;
  double PenumbraMean = 0.; // drawn less true
  std::string ToString() const;
};

/**
 * `size`: the angle in degrees that a directional light appears under, or the radius of a
 * positional one: a spot's disc across its axis, or a glowing ball, of which a pixel gets what a
 * surface that faces it would; with `edges` the light is a parallelogram instead. Rays go to
 * 32 x 32 cells of equal area, each to a place of its own within its cell, or, if 8 x 8 of them
 * agree, to no more. Judged are pixels whose normal n turns to the light's middle, n * l > 0.05,
 * within the cone of a spot, and whose verdict to the light's middle four rays that start beside it
 * agree with. A point of the light behind the pixel's own plane is blocked.
 */
SoftShadowTruth TraceSoftShadow(const EmbreeScene& scene, const TruthImage& view, vtkLight* light,
  double size, const LightEdges* edges = nullptr);

/** `visibility`: the share that is drawn in each pixel of the truth. */
SoftShadowErrors CompareSoftShadow(const SoftShadowTruth& truth, const float* visibility);
}

#endif
