// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions into the sky above a surface.

// The direction about z that belongs to a point (x, y) of the unit square: points that are spread
// evenly become directions that are spread by the cosine to z (N. Malley: a disc, lifted to the
// hemisphere), or evenly.
vec3 relievoSkyDirection(float x, float y, bool byCosine)
{
  float sine = byCosine ? sqrt(x) : sqrt(x * (float(2.0) - x));
  float cosine = byCosine ? sqrt(max(float(1.0) - x, float(0.0))) : float(1.0) - x;
  float angle = float(6.283185307179586) * y;
  return vec3(sine * cos(angle), sine * sin(angle), cosine);
}

// The point of the unit square that lies beyond it by a shift, which wraps round.
vec2 relievoSkyShift(vec2 point, vec2 shift)
{
  float x = point.x + shift.x;
  float y = point.y + shift.y;
  return vec2(x - floor(x), y - floor(y));
}
