//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// From what the delegate drew to linear light.
//RELIEVO::Include(formulas/half.glsl)
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(frame/drawn.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 drawn = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  vec3 linear = relievoLinearColorFromSrgb(drawn.rgb);
  // Mesa's software cuts the bits off that a half does not have.
  gl_FragData[0] = vec4(relievoRoundToHalf(linear.r), relievoRoundToHalf(linear.g),
    relievoRoundToHalf(linear.b), drawn.a);
}
