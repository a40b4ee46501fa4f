//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture of the linear colour: exposure, tone operator RELIEVO_TONE_OPERATOR, sRGB curve,
// dithering; and the delegate's depth, if that has not been copied.
// RELIEVO_TONE_PREMULTIPLIED: the colour of pixels with alpha below 1 is multiplied by alpha.
// RELIEVO_TONE_MEASURED: the exposure starts from the measured luminance.
// RELIEVO_TONE_DITHER: by Bayer's matrix, with RELIEVO_TONE_DITHER_TEXTURE by the texture.
#define RELIEVO_APPROXIMATE_SRGB
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(formulas/color/tone.glsl)
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(frame/drawn.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform float toneWhite;
uniform float toneExposure; // a factor
#ifdef RELIEVO_TONE_DITHER_TEXTURE
uniform sampler2D toneThresholds;
#endif
#ifdef RELIEVO_TONE_MEASURED
uniform sampler2D toneSums; // output of measureFS.glsl, one texel
#endif

float toneExposureFactor()
{
#ifdef RELIEVO_TONE_MEASURED
  vec4 sums = texelFetch(toneSums, ivec2(0), 0);
  // If no pixel is drawn, all pixels count.
  vec2 sum = sums.y > 0.0 ? sums.xy : sums.zw;
  return sum.y > 0.0 ? toneExposure * relievoToneAutoExposure(sum.x / sum.y) : toneExposure;
#else
  return toneExposure;
#endif
}

#if defined(RELIEVO_TONE_DITHER_TEXTURE)
float toneThreshold(ivec2 pixel)
{
  return texelFetch(toneThresholds, pixel & (textureSize(toneThresholds, 0) - 1), 0).r;
}
#elif defined(RELIEVO_TONE_DITHER)
float toneThreshold(ivec2 pixel)
{
  return relievoToneBayer(uint(pixel.x), uint(pixel.y));
}
#endif

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoFetchColor(pixel);
#ifdef RELIEVO_TONE_PREMULTIPLIED
  float cover = color.a > 0.0 && color.a < 1.0 ? color.a : 1.0;
#else
  float cover = 1.0;
#endif
  vec3 shown = relievoApproximateSrgbColorFromLinear(relievoToneCovered(
    RELIEVO_TONE_OPERATOR, color.rgb, cover, toneExposureFactor(), toneWhite));
#ifdef RELIEVO_TONE_DITHER
  float threshold = toneThreshold(pixel);
  shown = vec3(relievoToneDither(shown.r, threshold), relievoToneDither(shown.g, threshold),
    relievoToneDither(shown.b, threshold));
#endif
  gl_FragData[0] = vec4(shown, color.a);
#ifdef RELIEVO_DEPTH_LEFT
  gl_FragDepth = texelFetch(relievoDrawnZ, pixel + relievoDrawnOffset, 0).r;
#endif
}
