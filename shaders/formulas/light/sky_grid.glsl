// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a uniform sky's light on a surface with unit normal n, from the directions in which
// the sky is visible: their mean vector plus 0.5, and in w their share of all directions. By the
// harmonics up to l = 1 (formulas/light/irradiance.glsl), less what the few directions that run
// along a plane, of 26, add to it.
float relievoSkyGridShare(vec4 sky, vec3 n)
{
  vec3 mean = vec3(sky.x, sky.y, sky.z) - vec3(float(0.5), float(0.5), float(0.5));
  return clamp(sky.w + float(2.0) * dot(mean, n) - float(0.09), float(0.0), float(1.0));
}
