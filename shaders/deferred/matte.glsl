// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a lamp's light that a surface scatters, in linear light.
//RELIEVO::Include(formulas/color/srgb.glsl)

vec3 relievoMatte(relievoSurface surface)
{
  return surface.shading == RELIEVO_SHADING_PHONG
    ? surface.diffuse * relievoLinearColorFromSrgb(surface.color)
    : surface.shading == RELIEVO_SHADING_PBR ? (1.0 - surface.metallic) * surface.color
                                             : vec3(0.0);
}
