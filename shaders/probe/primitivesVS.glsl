//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangle i covers the pixel centres of row i of a viewport of relievoRows rows. RELIEVO_VARYINGS
// varyings like those of VTK's mappers accompany the primitive's number.
//RELIEVO::Defines
uniform int relievoRows;
out vec4 positionVSOutput;
#if RELIEVO_VARYINGS > 1
out vec3 normalVSOutput;
out vec2 textureVSOutput;
#endif
#if RELIEVO_VARYINGS > 3
flat out int instanceVSOutput;
out vec4 colorVSOutput;
out float weightVSOutput;
#endif

void main()
{
  int corner = gl_VertexID % 3;
  float row = float(gl_VertexID / 3);
  float center = (2.0 * row + 1.0) / float(relievoRows) - 1.0;
  float reach = 0.8 / float(relievoRows);
  gl_Position = vec4(float(corner - 1) * 4.0, center + (corner == 1 ? reach : -reach), 0.0, 1.0);
  positionVSOutput = vec4(0.25, 0.5, 0.75, 1.0) + float(corner);
#if RELIEVO_VARYINGS > 1
  normalVSOutput = vec3(0.5, 1.5, 2.5) * float(corner);
  textureVSOutput = vec2(0.125, 0.375) + float(corner);
#endif
#if RELIEVO_VARYINGS > 3
  instanceVSOutput = 77;
  colorVSOutput = vec4(3.5) + float(corner);
  weightVSOutput = 9.5 - float(corner);
#endif
}
