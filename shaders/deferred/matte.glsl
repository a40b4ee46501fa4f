// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a lamp's light that a surface scatters, in linear light. RELIEVO_ONLY_SHOWN: for a
// picture of 8 bits.
//RELIEVO::Include(formulas/color/srgb.glsl)

vec3 relievoMatte(relievoSurface surface)
{
#ifdef RELIEVO_ONLY_SHOWN
  vec3 color = relievoLinearColorFromShown(surface.color);
#else
  vec3 color = relievoLinearColorFromSrgb(surface.color);
#endif
  return surface.shading == RELIEVO_SHADING_PHONG
    ? surface.diffuse * color
    : surface.shading == RELIEVO_SHADING_PBR ? (1.0 - surface.metallic) * surface.color
                                             : vec3(0.0);
}
