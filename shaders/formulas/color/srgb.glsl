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

// The same curves, approximated by fourth roots and polynomials, for pictures: in software OpenGL
// they take half the time of powers. Polynomials of least relative error for root^(5/3) and
// root^1.6.

// The polynomial holds for light up to 1, brighter light is scaled by powers of 2; above 65536 it
// counts as 65536. The relative error is at most 2.8e-7, of the power, and of roundings.
float relievoApproximateSrgbFromLinear(float linear)
{
  bool isAbove = linear > float(256.0);
  float scale = isAbove ? float(1.0) / float(65536.0) : float(1.0) / float(256.0);
  float light = linear > float(65536.0) ? float(1.0)
                                        : linear > float(1.0) ? scale * linear : linear;
  float r = sqrt(sqrt(light));
  float r2 = r * r;
  float r4 = r2 * r2;
  float power = ((float(-0.00237415688) + float(0.102213915) * r) +
      r2 * (float(1.4902488) - float(1.50133536) * r)) +
    r4 * (((float(2.09087622) - float(2.21082622) * r) +
        r2 * (float(1.55658552) - float(0.642225034) * r)) + r4 * float(0.116836581));
  float unscaled = isAbove ? float(101.593667325964788) : float(10.0793683991589853);
  power = linear > float(1.0) ? unscaled * power : power; // the scale to the power of -1 / 2.4
  return linear <= float(0.0031308) ? float(12.92) * linear
                                    : float(1.055) * power - float(0.055);
}

// Values above 107.2, the light of the largest half, count as this. The relative error is at most
// 5.6e-7, and of roundings.
float relievoApproximateLinearFromSrgb(float srgb)
{
  float value = srgb > float(107.2) ? float(107.2) : srgb;
  float base = (value + float(0.055)) * float(0.9478672985781991); // over 1.055
  float r = sqrt(sqrt(base));
  float r2 = r * r;
  float r4 = r2 * r2;
  float power = ((float(-0.0123060189) + float(0.237523758) * r) +
      r2 * (float(1.09658343) - float(0.538048726) * r)) +
    r4 * (((float(0.331602081) - float(0.157978088) * r) +
        r2 * (float(0.0527266964) - float(0.0114768512) * r)) +
        r4 * (float(0.00145529094) - float(0.0000812782107) * r));
  return srgb <= float(0.04045) ? srgb * float(0.07739938080495357) : (base * base) * power;
}

vec3 relievoApproximateSrgbColorFromLinear(vec3 linear)
{
  return vec3(relievoApproximateSrgbFromLinear(linear.x),
    relievoApproximateSrgbFromLinear(linear.y), relievoApproximateSrgbFromLinear(linear.z));
}

vec3 relievoApproximateLinearColorFromSrgb(vec3 srgb)
{
  return vec3(relievoApproximateLinearFromSrgb(srgb.x),
    relievoApproximateLinearFromSrgb(srgb.y), relievoApproximateLinearFromSrgb(srgb.z));
}
