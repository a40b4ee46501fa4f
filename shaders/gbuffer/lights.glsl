// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The first and last lines of the code for the renderer's lights in the fragment shaders of VTK's
// mappers, and the replacement if the light is left out. For PBR the last line is the one before
// the section's.

//RELIEVO::Section(HeadlightBegin)
  float df = max(0.0

//RELIEVO::Section(PhongBegin)
  vec3 diffuse = vec3(0,0,0);

//RELIEVO::Section(PhongEnd)
gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);

//RELIEVO::Section(PbrBegin)
  float NdL, NdH, HdL, distanceVC, attenuation, D, Vis;

//RELIEVO::Section(PbrEnd)
  // In IBL, we assume

//RELIEVO::Section(PbrEndWithoutEnvironment)
  vec3 iblSpecular = vec3(0.0);

//RELIEVO::Section(CoatBegin)
  vec3 coatF0 =

//RELIEVO::Section(Unlit)
  gl_FragData[0] = vec4(ambientColor, opacity);
