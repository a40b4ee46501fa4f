//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// One pixel per direction: the texel that the cube map holds there.
uniform samplerCube cube;
uniform sampler2D directions;
in vec2 texCoord;
out vec4 result;

void main()
{
  ivec2 at = ivec2(texCoord * vec2(textureSize(directions, 0)));
  result = textureLod(cube, texelFetch(directions, at, 0).xyz, 0.0);
}
