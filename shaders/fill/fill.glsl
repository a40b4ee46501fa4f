// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders: the light of all fill lights by nine coefficients, in place
// of VTK's code for each.
//
// Defines: RELIEVO_FILL_SKY (there is a grid of the visible sky).
// Reads these names of VTK's shaders: vertexVC, normalVCVSOutput, diffuseColor, gl_FragData[0].

// The colour of a light that VTK's code leaves out.
//RELIEVO::Section(Black)
vec3(0.0)

//RELIEVO::Section(Dec)
//RELIEVO::Include(formulas/light/irradiance.glsl)
uniform vec3 relievoFillLight[9]; // in eye space
#ifdef RELIEVO_FILL_SKY
//RELIEVO::Include(formulas/light/sky_grid.glsl)
uniform sampler3D relievoFillSky;
uniform mat4 relievoFillToSky;     // texture coordinates, from eye space
uniform mat3 relievoFillToWorld;   // directions
uniform float relievoFillAway;     // distance at which a surface looks the sky up
uniform float relievoFillStrength; // of occlusion
uniform int relievoFillParallel;   // projection
#endif

//RELIEVO::Section(Impl)
  {
    vec3 fill = max(relievoShIrradiance(normalVCVSOutput, relievoFillLight), vec3(0.0));
#ifdef RELIEVO_FILL_SKY
    // Normals of files may point away from the visible side.
    vec3 gaze = relievoFillParallel != 0 ? vec3(0.0, 0.0, -1.0) : vertexVC.xyz;
    vec3 outwards = faceforward(normalVCVSOutput, gaze, normalVCVSOutput);
    vec3 away = vertexVC.xyz + relievoFillAway * outwards;
    vec4 sky = texture(relievoFillSky, (relievoFillToSky * vec4(away, 1.0)).xyz);
    float share = relievoSkyGridShare(sky, relievoFillToWorld * outwards);
    fill *= 1.0 - relievoFillStrength * (1.0 - sqrt(share));
#endif
    gl_FragData[0].rgb += diffuseColor * fill;
  }
