//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Decodes the delegate's drawing to linear light.
//RELIEVO::Include(frame/linear.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  gl_FragData[0] = relievoFetchLinear(ivec2(floor(texCoord * relievoSize)));
}
