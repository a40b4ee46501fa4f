//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// From linear light to the display, and the depth as the delegate left it.
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(frame/drawn.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoFetchColor(pixel);
  gl_FragData[0] = vec4(relievoSrgbColorFromLinear(color.rgb), color.a);
  gl_FragDepth = texelFetch(relievoDrawnZ, pixel + relievoDrawnOffset, 0).r;
}
