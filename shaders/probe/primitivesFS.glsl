//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The primitive's number; all varyings are read, without effect on the number.
#extension GL_ARB_explicit_attrib_location : require
//RELIEVO::Defines
in vec4 positionVSOutput;
#if RELIEVO_VARYINGS > 1
in vec3 normalVSOutput;
in vec2 textureVSOutput;
#endif
#if RELIEVO_VARYINGS > 3
flat in int instanceVSOutput;
in vec4 colorVSOutput;
in float weightVSOutput;
#endif
layout(location = 0) out uvec4 relievoOutput;

void main()
{
  float sum = dot(positionVSOutput, vec4(1.0));
#if RELIEVO_VARYINGS > 1
  sum += dot(normalVSOutput, vec3(1.0)) + dot(textureVSOutput, vec2(1.0));
#endif
#if RELIEVO_VARYINGS > 3
  sum += float(instanceVSOutput) + dot(colorVSOutput, vec4(1.0)) + weightVSOutput;
#endif
  relievoOutput = uvec4(uint(gl_PrimitiveID), uint(sum < -1e6), 0u, 0u);
}
