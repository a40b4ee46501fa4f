// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// What the delegate drew, in linear light.
//RELIEVO::Include(formulas/half.glsl)
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(frame/drawn.glsl)

vec4 relievoFetchLinear(ivec2 pixel)
{
  vec4 drawn = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  vec3 linear = relievoLinearColorFromSrgb(drawn.rgb);
  // Mesa's software cuts the bits off that a half does not have.
  return vec4(relievoRoundToHalf(linear.r), relievoRoundToHalf(linear.g),
    relievoRoundToHalf(linear.b), drawn.a);
}
