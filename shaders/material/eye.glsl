// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a surface is seen from, in eye space: in stereo, off axis and in sheared views not from the
// origin.

#ifndef RELIEVO_EYE
#define RELIEVO_EYE
uniform vec3 relievoEyeVC;
uniform vec3 relievoTowardsEyeVC; // unit, of parallel projections

// From the eye to a place, of any length.
vec3 relievoGazeAt(vec3 placeVC, bool isParallel)
{
  return isParallel ? -relievoTowardsEyeVC : placeVC - relievoEyeVC;
}
#endif
