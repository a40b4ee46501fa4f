//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The factor by which the linear colour is multiplied.
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D ambientShare;
uniform float ambientStrength;

void main()
{
  float share = texelFetch(ambientShare, ivec2(floor(texCoord * relievoSize)), 0).x;
  gl_FragData[0] = vec4(1.0 - ambientStrength * (1.0 - share));
}
