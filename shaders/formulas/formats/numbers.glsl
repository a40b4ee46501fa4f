// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Quantising a number to an integer code and back; the base of every packed format.

// -1 for a negative v, else 1: unlike sign(), never 0, so that a direction in a coordinate plane
// lies on one side.
float relievoSignNotZero(float v)
{
  return v < float(0.0) ? float(-1.0) : float(1.0);
}

// The integer nearest to x, for x in [0, 2^24]; halves are rounded up. floor(x + 0.5) would be off
// by one for odd x above 2^23, where x + 0.5 is not a float.
uint relievoRound(float x)
{
  float whole = floor(x);
  return uint(whole) + (x - whole >= float(0.5) ? uint(1) : uint(0));
}

// Code of x in [0, 1] in steps of 1 / maxCode; x outside is clamped, NaN gives 0.
uint relievoQuantizeUnorm(float x, float maxCode)
{
  return x > float(0.0) ? relievoRound(min(x, float(1.0)) * maxCode) : uint(0);
}

// The number in [0, 1] of a code in [0, maxCode].
float relievoDequantizeUnorm(uint code, float maxCode)
{
  return float(code) / maxCode;
}

// Code of x in [-1, 1] in steps of 1 / maxCode (the steps of GL's snorm), offset so that it is in
// [1, 2 * maxCode + 1]; x outside is clamped, NaN gives 1. Code 0 is free to mean background.
// The offset is added after rounding: added before, it would cost the low bits of x.
uint relievoQuantizeSnorm(float x, float maxCode)
{
  float scaled = x > float(-1.0) ? min(x, float(1.0)) * maxCode : -maxCode;
  float whole = floor(scaled);
  float up = scaled - whole >= float(0.5) ? float(1.0) : float(0.0);
  return uint(whole + up + (maxCode + float(1.0)));
}

// The number in [-1, 1] of an offset code in [1, 2 * maxCode + 1].
float relievoDequantizeSnorm(uint code, float maxCode)
{
  return (float(code) - (maxCode + float(1.0))) / maxCode;
}

// x, or the largest half with its sign if x is finite and larger: an overflow would become
// infinity, which means background in a depth.
float relievoSaturateHalf(float x)
{
  return isinf(x) ? x : clamp(x, float(-65504.0), float(65504.0));
}
