// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The light that a lamp of vtkRelievoLampList sends to a point. RELIEVO_ONE_LAMP: there is only one
// lamp; RELIEVO_LINEAR_LAMPS: all lamps have linear fall-off. Defines, because software OpenGL
// executes all branches of an `if`, and reads buffers slowly.
//RELIEVO::Include(formulas/light/lamp.glsl)
uniform samplerBuffer relievoLamps;            // position, radius; colour, fall-off
#ifdef RELIEVO_ONE_LAMP
uniform vec4 relievoOnlyLamp[2]; // its two texels
#endif
uniform samplerBuffer relievoLampAttenuations; // of each set

struct relievoLampRay
{
  vec3 light;   // incident light, without the surface's cosine
  vec3 toLamp;  // eye space
  float range;  // length of toLamp
  bool reaches; // the point lies within the radius
};

relievoLampRay relievoSeeLamp(int lamp, vec3 positionVC)
{
#ifdef RELIEVO_ONE_LAMP
  vec4 place = relievoOnlyLamp[0];
  vec4 color = relievoOnlyLamp[1];
#else
  vec4 place = texelFetch(relievoLamps, 2 * lamp);
  vec4 color = texelFetch(relievoLamps, 2 * lamp + 1);
#endif
  vec3 toLamp = place.xyz - positionVC;
  float range = length(toLamp);
  relievoLampRay ray = relievoLampRay(vec3(0.0), toLamp, range, range < place.w);
  if (!ray.reaches)
  {
    return ray;
  }
#ifdef RELIEVO_LINEAR_LAMPS
  float falloff = relievoLampLinear(range, place.w);
#else
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
#endif
  ray.light = color.rgb * falloff;
  return ray;
}
