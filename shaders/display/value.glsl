// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The value of a pixel of depth, range or volume_depth (RELIEVO_SHOW_DEPTH, RELIEVO_SHOW_RANGE,
// RELIEVO_SHOW_VOLUME_DEPTH); infinity in the background. The including shader declares relievoSize
// and relievoProjection.
//RELIEVO::Include(frame/volume_depth.glsl)

float relievoShownValue(ivec2 pixel)
{
#ifdef RELIEVO_SHOW_VOLUME_DEPTH
  return relievoFetchVolumeDepth(pixel);
#else
  float depth = relievoFetchDepth(pixel);
#ifdef RELIEVO_SHOW_RANGE
  vec3 positionVC = relievoEyePosition(
    relievoNdcFromPixel(vec2(pixel), relievoSize), isinf(depth) ? 1.0 : depth, relievoProjection);
  return isinf(depth) ? depth : length(positionVC);
#else
  return depth;
#endif
#endif
}
