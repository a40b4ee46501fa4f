//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The visible surface at a pixel: see seen.glsl.
//RELIEVO::Include(formulas/formats/octahedral.glsl)
in vec4 vertexVCVSOutput;
#ifdef RELIEVO_SEEN_OFFSET
uniform vec2 relievoSeenOffset; // of depths, as VTK's mappers move them: by slope, and constant
#endif

void main()
{
#ifdef RELIEVO_SEEN_OFFSET
  float slope = length(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)));
  gl_FragDepth = gl_FragCoord.z + relievoSeenOffset.x * slope + 1.0 * relievoSeenOffset.y / 65000.0;
#endif
  vec4 vertexVC = vertexVCVSOutput;
  vec3 normal = cross(normalize(dFdx(vertexVC.xyz)), normalize(dFdy(vertexVC.xyz)));
  vec2 code = floor((relievoOctEncode(normal) * 0.5 + 0.5) * 4095.0 + 0.5);
  gl_FragData[0] = vec4(vertexVC.z, code.x * 4096.0 + code.y, 0.0, 0.0);
}
