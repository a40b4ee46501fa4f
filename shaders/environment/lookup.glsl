// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The light of an environment by direction, in the environment's own axes.
//
// Defines: RELIEVO_ENVIRONMENT (the image's projection, a code of codes.glsl) and
// RELIEVO_ENVIRONMENT_ROUGH (a cube with levels for rough mirrors exists).
//RELIEVO::Include(codes.glsl)
//RELIEVO::Include(formulas/light/environment.glsl)

#if RELIEVO_ENVIRONMENT == RELIEVO_ENVIRONMENT_CUBE
uniform samplerCube relievoEnvironmentImage;
#else
uniform sampler2D relievoEnvironmentImage;
#endif
uniform float relievoEnvironmentDetail; // texels per radian, in the middle of the image
#ifdef RELIEVO_ENVIRONMENT_ROUGH
uniform samplerCube relievoEnvironmentLevels;
uniform vec2 relievoEnvironmentLevel; // share of the levels against the image, and the level
#endif

// footprint: the pixel's angle in radians.
vec3 relievoSharpLight(vec3 direction, float footprint)
{
  float level = max(0.0, log2(max(footprint, 1e-9) * relievoEnvironmentDetail));
#if RELIEVO_ENVIRONMENT == RELIEVO_ENVIRONMENT_EQUIRECTANGULAR
  vec2 place = relievoEquirectangularFromDirection(direction);
  return textureLod(relievoEnvironmentImage, place, level).rgb;
#elif RELIEVO_ENVIRONMENT == RELIEVO_ENVIRONMENT_CUBE
  return textureLod(relievoEnvironmentImage, direction, level).rgb;
#else
  return textureLod(relievoEnvironmentImage, relievoSphereMapFromDirection(direction), level).rgb;
#endif
}

// direction: a unit vector.
vec3 relievoEnvironmentLight(vec3 direction, float footprint)
{
#ifdef RELIEVO_ENVIRONMENT_ROUGH
  vec3 light = vec3(0.0);
  if (relievoEnvironmentLevel.x < 1.0)
  {
    light = relievoSharpLight(direction, footprint);
  }
  if (relievoEnvironmentLevel.x > 0.0)
  {
    vec3 rough = textureLod(relievoEnvironmentLevels, direction, relievoEnvironmentLevel.y).rgb;
    light = mix(light, rough, relievoEnvironmentLevel.x);
  }
  return light;
#else
  return relievoSharpLight(direction, footprint);
#endif
}
