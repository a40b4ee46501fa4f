//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Copies the pixels.
in vec2 texCoord;
uniform sampler2D relievoSource;
uniform vec2 relievoSize;

void main()
{
  gl_FragData[0] = texelFetch(relievoSource, ivec2(floor(texCoord * relievoSize)), 0);
}
