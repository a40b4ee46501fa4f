// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Cubes at a mask's cells: their size by the distance outside the mask, and their displacement by a
// repeller.

// 1 inside, falling to restSize over the transition; growth, 0 to 1, scales the excess over
// restSize.
float relievoCubeSize(float distance, float transition, float restSize, float growth)
{
  float share = distance > float(0.0) ? float(0.0) : float(1.0);
  if (distance > float(0.0) && distance < transition)
  {
    float rest = float(1.0) - distance / transition;
    share = rest * rest * (float(3.0) - float(2.0) * rest);
  }
  return restSize + (float(1.0) - restSize) * share * growth;
}

// A point at distance d below the radius r from the repeller moves to the distance (r + d^2 / r) /
// 2.
vec3 relievoCubePlace(vec3 place, vec3 repeller, float radius)
{
  vec3 way = place - repeller;
  float distance = length(way);
  return distance < radius && distance > float(0.0)
    ? repeller + way * ((radius + distance * distance / radius) / float(2.0) / distance)
    : place;
}
