// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The delegate's drawing, in linear light. RELIEVO_ONLY_SHOWN: for a picture of 8 bits.
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(frame/drawn.glsl)

vec4 relievoFetchLinear(ivec2 pixel)
{
  vec4 drawn = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
#ifdef RELIEVO_ONLY_SHOWN
  return vec4(relievoLinearColorFromShown(drawn.rgb), drawn.a);
#else
  return vec4(relievoLinearColorFromSrgb(drawn.rgb), drawn.a);
#endif
}
