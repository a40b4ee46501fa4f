// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible share of the sky at a point, by this frame's rays through the triangles of the scene.
//RELIEVO::Include(formulas/light/shadow.glsl)
//RELIEVO::Include(formulas/light/sky.glsl)
//RELIEVO::Include(rays/passes.glsl)
//RELIEVO::Include(rays/walk.glsl)
uniform samplerBuffer ambientNoise; // blue, 64 x 64
uniform vec2 ambientPoints[64];     // in the unit square, for the rays of this frame
uniform int ambientRays;
uniform float ambientStep;          // spacing of all frames' points
uniform float ambientRadius;        // 0: unlimited rays
uniform int ambientByCosine;

float relievoAmbientShift(ivec2 pixel)
{
  return texelFetch(ambientNoise, (pixel.y & 63) * 64 + (pixel.x & 63)).x;
}

// casters: number of nodes over the casters, or 0 to skip the traversal; from, up: position and
// normal in the tree's space; blur: see relievoTreeWalk.
float relievoAmbientSees(int casters, vec3 from, vec3 up, float blur, ivec2 pixel)
{
  vec3 right = normalize(relievoTangent(up));
  vec3 ahead = cross(up, right);
  vec2 shares =
    vec2(relievoAmbientShift(pixel), relievoAmbientShift(pixel + ivec2(37, 17)));
  bool ends = ambientRadius > 0.0;
  float sees = 0.0;
  for (int i = 0; i < ambientRays; ++i)
  {
    vec2 point = relievoSkyShift(ambientPoints[i], shares, ambientStep);
    vec3 ray = relievoSkyDirection(point.x, point.y, ambientByCosine != 0);
    ray = ray.x * right + ray.y * ahead + ray.z * up;
    sees += relievoTreeWalk(casters, from, ends ? ambientRadius * ray : ray, ends, blur, vec3(0.0));
  }
  return sees / float(ambientRays);
}
