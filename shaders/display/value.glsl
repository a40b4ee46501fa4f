// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The value of a pixel of depth or range (RELIEVO_SHOW_DEPTH, RELIEVO_SHOW_RANGE); infinity in the
// background. The including shader declares relievoSize and relievoProjection.
float relievoShownValue(ivec2 pixel)
{
  float depth = relievoFetchDepth(pixel);
#ifdef RELIEVO_SHOW_RANGE
  vec3 positionVC = relievoEyePosition(
    relievoNdcFromPixel(vec2(pixel), relievoSize), isinf(depth) ? 1.0 : depth, relievoProjection);
  return isinf(depth) ? depth : length(positionVC);
#else
  return depth;
#endif
}
