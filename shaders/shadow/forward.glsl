// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A fragment is lit where a sample of the mask in the camera's view reaches it. The map decides
// elsewhere: samples end at depth steps, and surfaces narrower than a texel have none. See
// receive.glsl.

//RELIEVO::Section(MethodDec)
uniform sampler2DArray relievoShadowMasks;
uniform int relievoShadowMask[RELIEVO_SHADOW_FACES]; // the mask of the face's light
uniform ivec2 relievoShadowOrigin; // of the viewport in the framebuffer
uniform int relievoShadowMasked;   // whether the masks apply to this draw

float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
{
  float reached = 0.0;
  if (relievoShadowMasked != 0)
  {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - relievoShadowOrigin;
    reached = texelFetch(relievoShadowMasks, ivec3(pixel, relievoShadowMask[face]), 0).r;
  }
  return max(reached, relievoShadowFilter(face, place, slope, texel));
}
