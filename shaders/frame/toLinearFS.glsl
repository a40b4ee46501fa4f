//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// From what the delegate drew to linear light.
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(frame/drawn.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 drawn = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  gl_FragData[0] = vec4(relievoLinearColorFromSrgb(drawn.rgb), drawn.a);
}
