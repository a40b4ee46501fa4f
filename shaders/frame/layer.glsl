// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// What the delegate drew over nothing, premultiplied, as VTK makes it for display.
//RELIEVO::Include(formulas/blend.glsl)
//RELIEVO::Include(frame/drawn.glsl)
uniform int relievoAveraged; // alpha is that of VTK's weighted average

vec4 relievoFetchLayer(ivec2 pixel)
{
  vec4 layer = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  float cover = relievoAveraged != 0 ? relievoAveragedCover(layer.a) : layer.a;
  // The layer is clamped as bytes would clamp it: what adds to alpha covers no more than all, nor
  // less than nothing.
  return vec4(max(layer.rgb, vec3(0.0)), clamp(cover, 0.0, 1.0));
}
