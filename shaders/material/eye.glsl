// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The direction of view in eye space: in stereo, off-axis and sheared views the eye is not at the
// origin.

#ifndef RELIEVO_EYE
#define RELIEVO_EYE
uniform vec3 relievoEyeVC;
uniform vec3 relievoTowardsEyeVC; // unit vector, for parallel projections

// From the eye to a position, of any length.
vec3 relievoGazeAt(vec3 placeVC, bool isParallel)
{
  return isParallel ? -relievoTowardsEyeVC : placeVC - relievoEyeVC;
}
#endif
