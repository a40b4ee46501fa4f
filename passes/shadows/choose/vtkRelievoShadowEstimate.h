// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What shadows are expected to cost and to err, before anything is drawn: for whoever chooses a
// method and the size of its maps.
#ifndef vtkRelievoShadowEstimate_h
#define vtkRelievoShadowEstimate_h

#include "vtkType.h"

// What is to be drawn.
struct vtkRelievoShadowDemand
{
  int MapSize = 2048; // side of a map in texels
  int Maps = 1;
  int Lights = 1; // that cast
  int Props = 0;  // that cast or receive, with one draw call each
  int Width = 0;  // of the picture in pixels
  int Height = 0;
  double Farness = 0.0; // how far casters and eye are, in halves of the view's height at the scene
};

struct vtkRelievoShadowEstimate
{
  vtkIdType Bytes = 0;     // held on the GPU
  int DrawCalls = 0;       // at most, in a frame that draws all maps anew
  double WrongShare = 0.0; // of the pixels that face the light, 0 to 1
};

// Wrong verdicts lie along the edges of shadows, in a band about a texel wide: their share falls as
// a power of the map's size n, At2048 * (n / 2048)^-Power.
struct vtkRelievoShadowErrorLaw
{
  double At2048;
  double Power;

  double GetShare(int mapSize) const;
};

#endif
