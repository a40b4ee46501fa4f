// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Light of a lamp at a point: its fall-off with distance, and the angle to the surface.

// Linear to zero at the radius.
float relievoLampLinear(float range, float radius)
{
  return max(float(0.0), float(1.0) - range / radius);
}

// 1 / d^2 with the window (1 - (d / r)^4)^2, after B. Karis, Real Shading in Unreal Engine 4, 2013.
// Constant below a hundredth of the radius.
float relievoLampInverseSquare(float range, float radius)
{
  float share = range / radius;
  float square = share * share;
  float window = max(float(0.0), float(1.0) - square * square);
  float nearest = max(range, float(0.01) * radius);
  return window * window / (nearest * nearest);
}

// The fall-off by vtkLight's attenuation values a, b, c: 1 / (a + b d + c d^2), 0 beyond the
// radius.
float relievoLampAttenuated(float range, float radius, vec3 values)
{
  float sum = values.x + range * (values.y + range * values.z);
  return range < radius && sum > float(0.0) ? float(1.0) / sum : float(0.0);
}

// Lambert's cosine of a unit normal and the vector from the surface to the lamp, of length range; 0
// if the lamp is on or behind the surface, or the surface has no normal.
float relievoLampCosine(vec3 normal, vec3 toLamp, float range)
{
  return range > float(0.0) ? max(float(0.0), dot(normal, toLamp) / range) : float(0.0);
}
