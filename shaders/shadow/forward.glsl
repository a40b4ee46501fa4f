// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The verdict of a mask in the camera's view where there is one, else of the map: see
// receive.glsl.

//RELIEVO::Section(MethodDec)
uniform sampler2DArray relievoShadowMasks;
uniform int relievoShadowMask[RELIEVO_SHADOW_FACES]; // the mask of the face's light
uniform ivec2 relievoShadowOrigin; // of the viewport in what is drawn to
uniform int relievoShadowMasked;   // whether the masks hold for what is drawn

float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
{
  if (relievoShadowMasked != 0)
  {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - relievoShadowOrigin;
    return texelFetch(relievoShadowMasks, ivec3(pixel, relievoShadowMask[face]), 0).r;
  }
  return relievoShadowFilter(face, place, slope, texel);
}
