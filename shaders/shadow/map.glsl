// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The verdict of an even map: see receive.glsl.

//RELIEVO::Section(MethodDec)
float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
{
  return relievoShadowFilter(face, place, slope, texel);
}
