//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums over squares of 8 x 8: logarithms of the luminance, and their number; over drawn pixels (x,
// y), and over all (z, w). RELIEVO_FIRST: sums the colour's pixels; else earlier sums.
#ifdef RELIEVO_FIRST
//RELIEVO::Include(formulas/color/tone.glsl)
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(frame/drawn.glsl)
uniform float toneBackgroundAlpha; // pixels with a greater alpha are drawn
#else
uniform sampler2D toneSums;
#endif
in vec2 texCoord;
uniform ivec2 toneSize;  // size of the input
uniform vec2 toneTarget; // size of the output

vec4 toneTerm(ivec2 at)
{
#ifdef RELIEVO_FIRST
  vec4 color = relievoFetchColor(at);
  bool drawn = texelFetch(relievoDrawnZ, at + relievoDrawnOffset, 0).r < 1.0 ||
    color.a > toneBackgroundAlpha;
  vec2 term =
    relievoToneIsLight(color.rgb) ? vec2(relievoToneLogLuminance(color.rgb), 1.0) : vec2(0.0);
  return vec4(drawn ? term : vec2(0.0), term);
#else
  return texelFetch(toneSums, at, 0);
#endif
}

void main()
{
  ivec2 first = 8 * ivec2(floor(texCoord * toneTarget));
  ivec2 end = min(first + 8, toneSize);
  vec4 sum = vec4(0.0);
  for (int y = first.y; y < end.y; ++y)
  {
    vec4 row = vec4(0.0);
    for (int x = first.x; x < end.x; ++x)
    {
      row += toneTerm(ivec2(x, y));
    }
    sum += row;
  }
  gl_FragData[0] = sum;
}
