// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The delegate's drawing, in linear light. RELIEVO_APPROXIMATE_SRGB: for a picture.
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(frame/drawn.glsl)

vec4 relievoFetchLinear(ivec2 pixel)
{
  vec4 drawn = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
#ifdef RELIEVO_APPROXIMATE_SRGB
  return vec4(relievoApproximateLinearColorFromSrgb(drawn.rgb), drawn.a);
#else
  return vec4(relievoLinearColorFromSrgb(drawn.rgb), drawn.a);
#endif
}
