// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's shaders by vtkRelievoMaterial: reflection of an environment, and lighting by
// it.
//
// Defines: those of environment/lookup.glsl, RELIEVO_IRRADIANCE (the environment has coefficients),
// RELIEVO_ENCODED (colours are encoded by a power of 1 / 2.2), RELIEVO_PBR (VTK's shader encodes
// its output itself, but computes with linear colours) and RELIEVO_HAS_ENV_MATRIX (VTK declares
// envMatrix).

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(environment/lookup.glsl)
//RELIEVO::Include(formulas/light/fresnel.glsl)
//RELIEVO::Include(material/eye.glsl)
#ifndef RELIEVO_HAS_ENV_MATRIX
uniform mat3 envMatrix; // set by VTK: from the view to the renderer's axes in the world
#endif
uniform mat3 relievoEnvironmentFromWorld;
uniform vec4 relievoReflection; // reflectivity, roughness, weight, intensity
vec3 relievoReflected = vec3(0.0); // direction in the environment
float relievoReflectedWidth = 0.0; // angle of the environment seen by the pixel, in radians
float relievoGaze = 0.0; // cosine of the view to the normal

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
//RELIEVO::Include(formulas/light/irradiance.glsl)
uniform vec3 relievoIrradiance[9]; // with intensity and weight, over pi
#endif

//RELIEVO::Section(Look)
  {
    vec3 gazeVC = normalize(relievoGazeAt(vertexVC.xyz, cameraParallel != 0));
    mat3 fromVC = relievoEnvironmentFromWorld * envMatrix;
    relievoReflected = normalize(fromVC * reflect(gazeVC, normalVCVSOutput));
    relievoReflectedWidth = max(length(dFdx(relievoReflected)), length(dFdy(relievoReflected)));
    relievoGaze = -dot(gazeVC, normalVCVSOutput);
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
  // The mirror lies in front of the surface and of everything visible through it: it covers a share
  // of both.
  {
    vec3 mirrored =
      relievoReflection.w * relievoEnvironmentLight(relievoReflected, relievoReflectedWidth);
    vec3 share =
      vec3(relievoFresnel(relievoReflection.x, relievoGaze, relievoReflection.y));
#ifdef RELIEVO_PBR
    // A metal's reflection has its colour.
    vec3 ofMetal = vec3(relievoFresnel(albedo.r, relievoGaze, relievoReflection.y),
      relievoFresnel(albedo.g, relievoGaze, relievoReflection.y),
      relievoFresnel(albedo.b, relievoGaze, relievoReflection.y));
    share = mix(share, ofMetal, metallic);
#endif
    share *= relievoReflection.z;
    float hidden = max(share.r, max(share.g, share.b)); // covered share of everything behind
    float opacity = 1.0 - (1.0 - gl_FragData[0].a) * (1.0 - hidden);
    vec3 own = relievoLightOf(gl_FragData[0].rgb) * gl_FragData[0].a * (1.0 - share);
    vec3 light = (own + share * mirrored) / max(opacity, 1e-6);
    gl_FragData[0] = vec4(relievoColorOf(light), opacity);
  }
