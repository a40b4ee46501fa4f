// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowWays.h
 * @brief The shadow methods that the benches compare, and the verdicts of their pictures.
 */
#ifndef relievoBenchShadowWays_h
#define relievoBenchShadowWays_h

#include <vector>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

namespace relievoBench
{
/** A shadow method, with its map sizes. */
struct ShadowWay
{
  const char* Name;
  void (*SetUp)(vtkRenderer* renderer, int mapSize);
  int LargestMap; // larger maps take too long on software OpenGL
  bool IsSlow;    // on software OpenGL; timed in fewer frames
};

/** Every method of vtkRelievoShadowStage, then vtkShadowMapPass, the peer. */
const std::vector<ShadowWay>& ShadowWays();

/** Sets up vtkShadowMapPass, with everything it needs, as the renderer's pass. */
void UseShadowPeer(vtkRenderer* renderer, int mapSize);

/** Sets up vtkRelievoPass with each of its shadow methods around the renderer's pass. */
void UseShadowMap(vtkRenderer* renderer, int mapSize);
void UseShadowForward(vtkRenderer* renderer, int mapSize);
void UseShadowWarped(vtkRenderer* renderer, int mapSize);
void UseShadowExact(vtkRenderer* renderer, int mapSize); // ignores the map size

/** Restores plain frames; the pass is released. */
void UseNoShadows(vtkRenderWindow* window, vtkRenderer* renderer);

/**
 * The remaining share of the light in each pixel, 0 to 1, row 0 at the bottom: the picture with
 * shadows divided by the one without, red + green + blue; 1 where the latter is black. Both
 * pictures need one light, no ambient part and nothing brighter than white. `gamma`: exponent that
 * makes the pictures' values linear.
 */
std::vector<float> PictureVisibility(vtkImageData* shadowed, vtkImageData* plain, double gamma);
}

#endif
