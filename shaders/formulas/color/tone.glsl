// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Tone mapping: from linear light of any size to linear light in [0, 1], and from there to 8 bits.
// Reinhard's operators: E. Reinhard and others, Photographic tone reproduction for digital images,
// 2002. Neutral: Khronos PBR Neutral Tone Mapper, Khronos Group, 2024.

// The largest half: larger values count as this.
const float relievoToneLargest = float(65504.0);

// The light of the first step of 8 bits, (1 / 255) / 12.92: darker values count as this in the
// measurement of a picture's brightness.
const float relievoToneLeast = float(0.00030352697);

// Relative luminance of linear light with sRGB's primaries.
float relievoLuminance(vec3 c)
{
  return float(0.2126) * c.x + float(0.7152) * c.y + float(0.0722) * c.z;
}

// Replaces negative and NaN light by 0. A comparison with NaN is false.
float relievoToneCleanLight(float x)
{
  return x > float(0.0) ? min(x, relievoToneLargest) : float(0.0);
}

vec3 relievoToneClean(vec3 c)
{
  return vec3(
    relievoToneCleanLight(c.x), relievoToneCleanLight(c.y), relievoToneCleanLight(c.z));
}

// Whether a pixel's light can be measured: no component is negative, infinite or NaN.
bool relievoToneIsLight(vec3 c)
{
  return c.x >= float(0.0) && c.x <= relievoToneLargest && c.y >= float(0.0) &&
    c.y <= relievoToneLargest && c.z >= float(0.0) && c.z <= relievoToneLargest;
}

// The value averaged for the automatic exposure.
float relievoToneLogLuminance(vec3 c)
{
  return log2(clamp(relievoLuminance(c), relievoToneLeast, relievoToneLargest));
}

// The factor that brings the mean of the logarithms to the key, the middle grey of 0.18.
float relievoToneAutoExposure(float meanLogLuminance)
{
  return float(0.18) / exp2(meanLogLuminance);
}

// x (1 + x / white^2) / (1 + x), written such that it is exactly 1 at x = white.
float relievoToneCurve(float x, float white)
{
  float share = x / white;
  return (x + share * share) / (float(1.0) + x);
}

vec3 relievoToneClamp(vec3 c)
{
  return vec3(min(c.x, float(1.0)), min(c.y, float(1.0)), min(c.z, float(1.0)));
}

// x / (1 + x) for each component: reaches 1 at infinity.
vec3 relievoToneSimple(vec3 c)
{
  return vec3(c.x / (float(1.0) + c.x), c.y / (float(1.0) + c.y), c.z / (float(1.0) + c.z));
}

// Reinhard's curve on the luminance: preserves the proportions of red, green and blue. A saturated
// component may exceed 1.
vec3 relievoToneReinhard(vec3 c, float white)
{
  float luminance = relievoLuminance(c);
  float shown = relievoToneCurve(luminance, white);
  return luminance > float(0.0) ? (shown / luminance) * c : c;
}

// Reinhard's curve for each component.
vec3 relievoToneReinhardRgb(vec3 c, float white)
{
  return vec3(
    relievoToneCurve(c.x, white), relievoToneCurve(c.y, white), relievoToneCurve(c.z, white));
}

// Moves a colour with a component above 1 towards the grey of its luminance until the component is
// 1: preserves hue and luminance, loses saturation. White if the luminance is 1 or above.
vec3 relievoToneIntoGamut(vec3 c)
{
  float most = max(c.x, max(c.y, c.z));
  float grey = min(relievoLuminance(c), float(1.0));
  float share = most > float(1.0) ? (float(1.0) - grey) / (most - grey) : float(1.0);
  return relievoToneClamp(
    most > float(1.0) ? vec3(grey) + share * (c - vec3(grey)) : c);
}

// Neutral: the light below 0.8 keeps its value, less the share of 0.04 that surfaces mirror; the
// brightest component is compressed above that, and the colour moves towards white.
vec3 relievoToneNeutral(vec3 c)
{
  const float mirrored = float(0.04);
  const float start = float(0.8) - mirrored; // of the compression
  const float rest = float(1.0) - start;
  float least = min(c.x, min(c.y, c.z));
  float offset = least < float(2.0) * mirrored ? least - float(6.25) * least * least : mirrored;
  vec3 base = c - vec3(offset);
  float peak = max(base.x, max(base.y, base.z));
  float shown = float(1.0) - rest * rest / (max(peak, start) + rest - start);
  float faded = float(1.0) - float(1.0) / (float(0.15) * (peak - shown) + float(1.0));
  return peak > start ? mix(base * (shown / peak), vec3(shown), faded) : base;
}

// By number: 0 clamp, 1 simple, 2 Reinhard on luminance, 3 Reinhard by component, 4 neutral. The
// input is clean; the result is in [0, 1].
vec3 relievoTone(int which, vec3 c, float white)
{
  if (which == 1)
  {
    return relievoToneSimple(c);
  }
  if (which == 2)
  {
    return relievoToneIntoGamut(relievoToneReinhard(c, white));
  }
  return relievoToneClamp(which == 3 ? relievoToneReinhardRgb(c, white)
      : which == 4                   ? relievoToneNeutral(c)
                                     : c);
}

// The linear light shown for a pixel's colour of which the share `cover` is covered: the covering
// colour is mapped without its cover, which it keeps.
vec3 relievoToneCovered(int which, vec3 c, float cover, float exposure, float white)
{
  return cover * relievoTone(which, relievoToneClean(c / cover) * exposure, white);
}

// Threshold of ordered dithering, between 0 and 1, both excluded: B. Bayer's matrix of 8 x 8, 1973.
float relievoToneBayer(uint x, uint y)
{
  uint a = x ^ y;
  uint code = ((a & uint(1)) << uint(5)) | ((y & uint(1)) << uint(4)) | ((a & uint(2)) << uint(2)) |
    ((y & uint(2)) << uint(1)) | ((a & uint(4)) >> uint(1)) | ((y & uint(4)) >> uint(2));
  return (float(code) + float(0.5)) / float(64.0);
}

// Rounds a value in [0, 1] to one of the two 8-bit steps around it. Over thresholds distributed
// evenly from 0 to 1 the mean equals the value.
float relievoToneDither(float value, float threshold)
{
  return min(floor(float(255.0) * value + threshold), float(255.0)) / float(255.0);
}
