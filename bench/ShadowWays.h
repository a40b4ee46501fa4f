// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowWays.h
 * @brief The ways to shadows that the benches compare, and the verdicts that their pictures give.
 */
#ifndef relievoBenchShadowWays_h
#define relievoBenchShadowWays_h

#include <vector>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;

namespace relievoBench
{
/** A way to shadows, with maps of a size. */
struct ShadowWay
{
  const char* Name;
  void (*SetUp)(vtkRenderer* renderer, int mapSize);
  int LargestMap; // larger ones take too long on software OpenGL
  bool IsSlow;    // there; timed in fewer frames
};

/** Every method of vtkRelievoShadowStage, then vtkShadowMapPass, the peer. */
const std::vector<ShadowWay>& ShadowWays();

/** vtkShadowMapPass with everything that it needs, in place of the renderer's pass. */
void UseShadowPeer(vtkRenderer* renderer, int mapSize);

/** vtkRelievoPass with shadows, by each of its methods, about the renderer's pass. */
void UseShadowMap(vtkRenderer* renderer, int mapSize);
void UseShadowForward(vtkRenderer* renderer, int mapSize);
void UseShadowWarped(vtkRenderer* renderer, int mapSize);
void UseShadowExact(vtkRenderer* renderer, int mapSize); // of any size

/** Plain frames again; what the pass held is released. */
void UseNoShadows(vtkRenderWindow* window, vtkRenderer* renderer);

/**
 * What is left of the light in each pixel, 0 to 1, row 0 at the bottom: the picture with shadows
 * over the one without, red + green + blue, 1 where that is black. Both need one light, no ambient
 * part and nothing brighter than white. `gamma`: what the pictures' values are to be raised to for
 * linear ones.
 */
std::vector<float> PictureVisibility(vtkImageData* shadowed, vtkImageData* plain, double gamma);
}

#endif
