//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// What lamps add to the linear colour: their light times the surface's colour.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(deferred/light.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 albedo = relievoFetchAlbedo(pixel);
  float diffuse = 1.0;
#ifdef RELIEVO_MATERIAL_WORD
  vec4 material = relievoFetchMaterial(pixel);
  diffuse = material.x * (1.0 - material.y);
#endif
  gl_FragData[0] =
    vec4(diffuse * relievoLinearColorFromSrgb(albedo.rgb) * relievoFetchLight(pixel), 0.0);
}
