// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The verdict of a map with more texels near the camera: see receive.glsl.

//RELIEVO::Section(MethodDec)
// Along u, texels are distributed in up to four linear pieces: after each break, scale and offset
// grow by the next number.
uniform vec4 relievoShadowBreaks[RELIEVO_SHADOW_FACES];
uniform vec4 relievoShadowScales[RELIEVO_SHADOW_FACES];
uniform vec4 relievoShadowOffsets[RELIEVO_SHADOW_FACES];
uniform float relievoShadowAcross[RELIEVO_SHADOW_FACES]; // height of the map over its width
uniform float relievoShadowBias;                         // in texels

float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
{
  vec4 pieces = vec4(1.0, step(relievoShadowBreaks[face].xyz, place.xxx));
  float scale = dot(pieces, relievoShadowScales[face]);
  place.x = scale * place.x + dot(pieces, relievoShadowOffsets[face]);
  slope.x /= scale;
  // The longer side of a texel, relative to the longer side of an even one.
  float across = relievoShadowAcross[face];
  texel *= max(1.0 / scale, across) / max(1.0, across);
  place.z -= relievoShadowBias * texel;
  return relievoShadowFilter(face, place, slope, texel);
}
