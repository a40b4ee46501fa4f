// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of a lamp's light reflected in addition to the light times the surface's colour.
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(formulas/light/shading.glsl)
relievoSurface relievoLit = relievoNoSurface; // at the pixel

bool relievoIsGlossy(relievoSurface surface)
{
  return surface.shading == RELIEVO_SHADING_PBR ||
    (surface.shading == RELIEVO_SHADING_PHONG && surface.specular != vec3(0.0));
}

vec3 relievoGloss(relievoSurface surface, vec3 normal, vec3 toLamp, vec3 toEye)
{
  if (surface.shading == RELIEVO_SHADING_PBR)
  {
    // The unit of a lamp's light is that reflected by a white matte surface: pi times the radiance.
    return 3.14159265358979 *
      relievoPbr(surface.color, surface.metallic, surface.roughness, normal, toLamp, toEye) -
      (1.0 - surface.metallic) * max(0.0, dot(normal, toLamp)) * surface.color;
  }
  return relievoLinearColorFromSrgb(surface.specular) *
    relievoPhongHighlight(normal, -toLamp, toEye, surface.power);
}
