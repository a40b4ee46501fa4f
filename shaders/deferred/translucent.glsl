// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders of translucent surfaces: adds the diffuse light of lamps, in
// linear light, to VTK's lighting. Defines, by vtkRelievoTranslucentLamps: RELIEVO_LINEAR_SLICES,
// RELIEVO_LAMPS_ON_PBR, RELIEVO_LAMPS_ON_BACKFACES (the back has its own property).
//
// Reads these names of VTK's shaders: vertexVC, normalVCVSOutput, gl_FragData[0]; diffuseColor and
// diffuseIntensity, ambientColor, or albedo and metallic.

//RELIEVO::Section(Dec)
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(deferred/lamp.glsl)
//RELIEVO::Include(deferred/clusters.glsl)
uniform int relievoLampsLight; // whether the actor is drawn translucent, and lit
uniform int relievoLampsCaught; // whether it is a shadow catcher, whose whole colour is ambient
uniform mat4 relievoLampProjection;
uniform vec2 relievoLampPixels; // of the viewport

vec3 relievoLampLight(vec3 positionVC, vec3 normalVC)
{
  // gl_FragCoord is unsuitable: VTK may draw into its own framebuffer.
  vec4 clip = relievoLampProjection * vec4(positionVC, 1.0);
  vec2 place = (0.5 * clip.xy / clip.w + 0.5) * relievoLampPixels;
  ivec2 pixel = clamp(ivec2(floor(place)), ivec2(0), ivec2(relievoLampPixels) - 1);
  ivec2 list = relievoFindLamps(pixel, -positionVC.z);
  vec3 light = vec3(0.0);
  for (int i = list.x; i < list.y; ++i)
  {
    relievoLampRay ray = relievoSeeLamp(relievoListedLamp(i), positionVC);
    light += ray.light * relievoLampCosine(normalVC, ray.toLamp, ray.range);
  }
  return light;
}

//RELIEVO::Section(Impl)
  if (relievoLampsLight != 0)
  {
#ifdef RELIEVO_LAMPS_ON_PBR
    vec3 relievoLampColor = (1.0 - metallic) * albedo;
#else
    float relievoLampShare = diffuseIntensity;
#ifdef RELIEVO_LAMPS_ON_BACKFACES
    relievoLampShare = gl_FrontFacing ? diffuseIntensity : diffuseIntensityBF;
#endif
    vec3 relievoLampColor = vec3(0.0);
    if (relievoLampsCaught != 0)
    {
      relievoLampColor = relievoLinearColorFromSrgb(ambientColor);
    }
    else if (relievoLampShare > 0.0)
    {
      relievoLampColor =
        relievoLampShare * relievoLinearColorFromSrgb(diffuseColor / relievoLampShare);
    }
#endif
    gl_FragData[0].rgb =
      relievoSrgbColorFromLinear(relievoLinearColorFromSrgb(gl_FragData[0].rgb) +
        relievoLampColor * relievoLampLight(vertexVC.xyz, normalVCVSOutput));
  }
