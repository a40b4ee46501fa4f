// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of lamps, before the surface's colour; pixel (0, 0) is the viewport's lower left one.
uniform sampler2D relievoLight;

vec3 relievoFetchLight(ivec2 pixel)
{
#ifdef RELIEVO_WHITE_LIGHT
  return texelFetch(relievoLight, pixel, 0).rrr;
#else
  return texelFetch(relievoLight, pixel, 0).rgb;
#endif
}
