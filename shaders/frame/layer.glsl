// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The delegate's drawing over an empty buffer, premultiplied, in VTK's display colours.
//RELIEVO::Include(formulas/color/blend.glsl)
//RELIEVO::Include(frame/drawn.glsl)
uniform int relievoAveraged; // alpha comes from VTK's weighted average

vec4 relievoFetchLayer(ivec2 pixel)
{
  vec4 layer = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  float cover = relievoAveraged != 0 ? relievoAveragedCover(layer.a) : layer.a;
  // Clamped like a byte texture: the cover stays between 0 and 1.
  return vec4(max(layer.rgb, vec3(0.0)), clamp(cover, 0.0, 1.0));
}
