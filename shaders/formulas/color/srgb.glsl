// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The sRGB curve (IEC 61966-2-1), exactly: a straight part near black, then a power of 2.4. Values
// are in [0, 1]; above 1 the power continues, below 0 the straight part.

float relievoSrgbFromLinear(float linear)
{
  return linear <= float(0.0031308)
    ? float(12.92) * linear
    : float(1.055) * pow(linear, float(1.0) / float(2.4)) - float(0.055);
}

float relievoLinearFromSrgb(float srgb)
{
  return srgb <= float(0.04045)
    ? srgb / float(12.92)
    : pow((srgb + float(0.055)) / float(1.055), float(2.4));
}

vec3 relievoSrgbColorFromLinear(vec3 linear)
{
  return vec3(relievoSrgbFromLinear(linear.x), relievoSrgbFromLinear(linear.y),
    relievoSrgbFromLinear(linear.z));
}

vec3 relievoLinearColorFromSrgb(vec3 srgb)
{
  return vec3(relievoLinearFromSrgb(srgb.x), relievoLinearFromSrgb(srgb.y),
    relievoLinearFromSrgb(srgb.z));
}
