// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Rounding to half floats.

// The half nearest to x, as a float, for halves that are not denormal (6.1e-5 and more); ties go to
// even. Prevents the truncation with which some OpenGLs convert to half.
float relievoRoundToHalf(float x)
{
  uint bits = floatBitsToUint(x);
  uint rounded = (bits + 0xfffu + ((bits >> uint(13)) & 1u)) & 0xffffe000u;
  return isinf(x) || isnan(x) ? x : uintBitsToFloat(rounded);
}
