//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture of the linear colour: exposure, tone operator, sRGB curve, dithering; and the depth
// as the delegate left it.
//RELIEVO::Include(formulas/srgb.glsl)
//RELIEVO::Include(formulas/tone.glsl)
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(frame/drawn.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform int toneOperator;
uniform float toneWhite;
uniform float toneExposure; // a factor
uniform int tonePremultiplied;
uniform int toneDither; // 0 none, 1 ordered, 2 by the texture
uniform sampler2D toneThresholds;
uniform int toneMeasured;
uniform sampler2D toneSums; // as measureFS.glsl makes them, one texel

float toneExposureFactor()
{
  vec4 sums = texelFetch(toneSums, ivec2(0), 0);
  // Where nothing is drawn, everything counts.
  vec2 sum = sums.y > 0.0 ? sums.xy : sums.zw;
  bool any = toneMeasured != 0 && sum.y > 0.0;
  return any ? toneExposure * relievoToneAutoExposure(sum.x / sum.y) : toneExposure;
}

float toneThreshold(ivec2 pixel)
{
  ivec2 last = textureSize(toneThresholds, 0) - 1;
  return toneDither == 1 ? relievoToneBayer(uint(pixel.x), uint(pixel.y))
                         : texelFetch(toneThresholds, pixel & last, 0).r;
}

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoFetchColor(pixel);
  // What covers a part of the pixel is toned as what it is, and covers as much afterwards.
  bool part = tonePremultiplied != 0 && color.a > 0.0 && color.a < 1.0;
  float cover = part ? color.a : 1.0;
  vec3 light = relievoToneClean(color.rgb / cover) * toneExposureFactor();
  vec3 shown = relievoSrgbColorFromLinear(cover * relievoTone(toneOperator, light, toneWhite));
  if (toneDither != 0)
  {
    float threshold = toneThreshold(pixel);
    shown = vec3(relievoToneDither(shown.r, threshold), relievoToneDither(shown.g, threshold),
      relievoToneDither(shown.b, threshold));
  }
  gl_FragData[0] = vec4(shown, color.a);
  gl_FragDepth = texelFetch(relievoDrawnZ, pixel + relievoDrawnOffset, 0).r;
}
