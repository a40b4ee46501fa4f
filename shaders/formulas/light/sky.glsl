// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions into the sky above a surface.

// The direction about z for a point (x, y) of the unit square: evenly distributed points become
// directions distributed by the cosine to z (N. Malley: a disc, lifted to the hemisphere), or
// evenly.
vec3 relievoSkyDirection(float x, float y, bool byCosine)
{
  float sine = byCosine ? sqrt(x) : sqrt(x * (float(2.0) - x));
  float cosine = byCosine ? sqrt(max(float(1.0) - x, float(0.0))) : float(1.0) - x;
  float angle = float(6.283185307179586) * y;
  return vec3(sine * cos(angle), sine * sin(angle), cosine);
}

// The point of another set in place of a point whose set has x in equal steps: x moves by a share
// of the step, y by a share of 1, and wraps around.
vec2 relievoSkyShift(vec2 point, vec2 shares, float step)
{
  float y = point.y + shares.y;
  return vec2(point.x + shares.x * step, y - floor(y));
}
