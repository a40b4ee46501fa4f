// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's shaders by vtkRelievoMaterial: what a surface mirrors of an environment, and
// how the environment lights it.
//
// Defines: those of environment/lookup.glsl, RELIEVO_IRRADIANCE (the environment has coefficients),
// RELIEVO_ENCODED (colours stand for light by a power of 1 / 2.2), RELIEVO_PBR (they do so in VTK's
// shader already, but for those that it computes with) and RELIEVO_HAS_ENV_MATRIX (VTK declares
// envMatrix).

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(environment/lookup.glsl)
//RELIEVO::Include(formulas/fresnel.glsl)
#ifndef RELIEVO_HAS_ENV_MATRIX
uniform mat3 envMatrix; // VTK sets it: from the view to the world and the renderer's axes there
#endif
uniform mat3 relievoEnvironmentFromWorld;
uniform vec4 relievoReflection; // reflectivity, roughness, weight, intensity
vec3 relievoReflected = vec3(0.0); // direction in the environment
float relievoReflectedWidth = 0.0; // radians that the pixel sees of it
float relievoMirrored = 0.0; // share of the light

#ifdef RELIEVO_ENCODED
vec3 relievoLightOf(vec3 color)
{
  return pow(max(color, vec3(0.0)), vec3(2.2));
}
vec3 relievoColorOf(vec3 light)
{
  return pow(max(light, vec3(0.0)), vec3(1.0 / 2.2));
}
#else
vec3 relievoLightOf(vec3 color)
{
  return color;
}
vec3 relievoColorOf(vec3 light)
{
  return light;
}
#endif

#ifdef RELIEVO_IRRADIANCE
//RELIEVO::Include(formulas/irradiance.glsl)
uniform vec3 relievoIrradiance[9]; // with intensity and weight, over pi
#endif

//RELIEVO::Section(Look)
  {
    vec3 gazeVC = cameraParallel != 0 ? vec3(0.0, 0.0, -1.0) : normalize(vertexVC.xyz);
    mat3 fromVC = relievoEnvironmentFromWorld * envMatrix;
    relievoReflected = normalize(fromVC * reflect(gazeVC, normalVCVSOutput));
    relievoReflectedWidth = max(length(dFdx(relievoReflected)), length(dFdy(relievoReflected)));
    float cosine = -dot(gazeVC, normalVCVSOutput);
    relievoMirrored =
      relievoReflection.z * relievoFresnel(relievoReflection.x, cosine, relievoReflection.y);
  }

//RELIEVO::Section(Light)
#ifdef RELIEVO_IRRADIANCE
  {
    vec3 upwards = normalize(relievoEnvironmentFromWorld * envMatrix * normalVCVSOutput);
    vec3 fromAround = max(relievoShIrradiance(upwards, relievoIrradiance), vec3(0.0));
#ifdef RELIEVO_PBR
    fromAround *= (1.0 - metallic) * albedo;
#else
    fromAround *= relievoLightOf(diffuseColor);
#endif
    gl_FragData[0].rgb = relievoColorOf(relievoLightOf(gl_FragData[0].rgb) + fromAround);
  }
#endif

//RELIEVO::Section(Mirror)
  // The mirror lies before the surface and what is seen through it: it takes its share of both.
  {
    vec3 mirrored =
      relievoReflection.w * relievoEnvironmentLight(relievoReflected, relievoReflectedWidth);
    float opacity = 1.0 - (1.0 - gl_FragData[0].a) * (1.0 - relievoMirrored);
    vec3 own = relievoLightOf(gl_FragData[0].rgb) * gl_FragData[0].a * (1.0 - relievoMirrored);
    vec3 light = (own + relievoMirrored * mirrored) / max(opacity, 1e-6);
    gl_FragData[0] = vec4(relievoColorOf(light), opacity);
  }
