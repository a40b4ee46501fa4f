//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A quad over the viewport, from VTK's own corners, behind all geometry.
in vec4 ndCoordIn;
in vec2 texCoordIn;
out vec2 texCoord;

void main()
{
  gl_Position = vec4(ndCoordIn.xy, 1.0, 1.0);
  texCoord = texCoordIn;
}
