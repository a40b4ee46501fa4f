//VTK::System::Dec
//RELIEVO::Extensions
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// One pixel per input: reads two texels of words, writes the words of the case.
uniform usampler2D inputA;
uniform usampler2D inputB;
uniform int whichCase;
in vec2 texCoord;
out uvec4 result;
//RELIEVO::Formulas
//RELIEVO::Cases

void main()
{
  ivec2 at = ivec2(texCoord * vec2(textureSize(inputA, 0)));
  result = relievoTestCase(whichCase, texelFetch(inputA, at, 0), texelFetch(inputB, at, 0));
}
