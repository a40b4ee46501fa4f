//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A lit sample in the camera's view: marks the pixel as lit if the sample is on its visible
// surface.
uniform sampler2D relievoCameraDepth; // window z
uniform vec4 relievoDepthFromZ; // a, b, c, d: eye depth = (a + b z) / (c + d z) of NDC z
uniform float relievoTolerance; // in texels
in float relievoDepthVSOutput;
in float relievoTexelVSOutput;

void main()
{
  float z = 2.0 * texelFetch(relievoCameraDepth, ivec2(gl_FragCoord.xy), 0).r - 1.0;
  float seen = (relievoDepthFromZ.x + relievoDepthFromZ.y * z) /
    (relievoDepthFromZ.z + relievoDepthFromZ.w * z);
  if (abs(seen - relievoDepthVSOutput) > relievoTolerance * relievoTexelVSOutput)
  {
    discard;
  }
  gl_FragData[0] = vec4(1.0);
}
