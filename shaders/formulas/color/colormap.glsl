// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A colour for a value, for debug views: dark blue over green to yellow, of evenly growing
// lightness.

// value in [0, 1] (clamped; NaN is black) to display RGB. Polynomials of degree 6 fitted by us to
// Viridis (S. van der Walt, N. Smith; CC0), at most 3/255 away from it.
vec3 relievoColormap(float value)
{
  if (isnan(value))
  {
    return vec3(float(0.0), float(0.0), float(0.0));
  }
  float t = clamp(value, float(0.0), float(1.0));
  vec3 c = vec3(float(-2.3289), float(2.75617), float(38.23992));
  c = c * t + vec3(float(-5.8870), float(-7.89702), float(-101.28305));
  c = c * t + vec3(float(20.14225), float(7.29992), float(97.29014));
  c = c * t + vec3(float(-13.16533), float(-2.01841), float(-40.52509));
  c = c * t + vec3(float(2.0825), float(-0.728870), float(5.12177));
  c = c * t + vec3(float(-0.137140), float(1.48925), float(0.954240));
  c = c * t + vec3(float(0.276930), float(0.003760), float(0.337710));
  return clamp(c, float(0.0), float(1.0));
}
