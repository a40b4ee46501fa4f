// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a lamp's light that a surface scatters, in linear light.
// RELIEVO_APPROXIMATE_SRGB: for a picture.
//RELIEVO::Include(formulas/color/srgb.glsl)

vec3 relievoMatte(relievoSurface surface)
{
#ifdef RELIEVO_APPROXIMATE_SRGB
  vec3 color = relievoApproximateLinearColorFromSrgb(surface.color);
#else
  vec3 color = relievoLinearColorFromSrgb(surface.color);
#endif
  return surface.shading == RELIEVO_SHADING_PHONG
    ? surface.diffuse * color
    : surface.shading == RELIEVO_SHADING_PBR ? (1.0 - surface.metallic) * surface.color
                                             : vec3(0.0);
}
