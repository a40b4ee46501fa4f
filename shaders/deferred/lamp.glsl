// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// What one lamp of vtkRelievoLampList adds at a point.
//RELIEVO::Include(formulas/lamp.glsl)
uniform samplerBuffer relievoLamps;            // place, radius; colour, fall-off
uniform samplerBuffer relievoLampAttenuations; // of each set

// Light of the lamp at a point of eye space with this normal. `reaches` says whether the point is
// within its radius.
vec3 relievoLampLight(int lamp, vec3 positionVC, vec3 normalVC, out bool reaches)
{
  vec4 place = texelFetch(relievoLamps, 2 * lamp);
  vec4 color = texelFetch(relievoLamps, 2 * lamp + 1);
  vec3 toLamp = place.xyz - positionVC;
  float range = length(toLamp);
  reaches = range < place.w;
  if (!reaches)
  {
    return vec3(0.0);
  }
  float falloff = 0.0;
  if (color.w == 0.0)
  {
    falloff = relievoLampLinear(range, place.w);
  }
  else if (color.w == 1.0)
  {
    falloff = relievoLampInverseSquare(range, place.w);
  }
  else
  {
    vec4 values = texelFetch(relievoLampAttenuations, int(color.w) - 2);
    falloff = relievoLampAttenuated(range, place.w, values.xyz);
  }
  return color.rgb * (falloff * relievoLampCosine(normalVC, toLamp, range));
}
