// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Ray intersection with boxes and triangles: from + t * ray, t from 0 to an upper limit.
//
// Triangles are watertight (after S. Woop, C. Benthin, I. Wald, Watertight ray/triangle
// intersection, 2013): a ray through an edge hits one of the triangles that share it, or both if
// requested.

// 1 / ray by component, without infinities.
vec3 relievoRayInverse(vec3 ray)
{
  float least = float(1e-30);
  return vec3(float(1.0) / (abs(ray.x) < least ? least : ray.x),
    float(1.0) / (abs(ray.y) < least ? least : ray.y),
    float(1.0) / (abs(ray.z) < least ? least : ray.z));
}

// True as well if rounding makes the result uncertain.
bool relievoRayHitsBox(vec3 from, vec3 inverse, float last, vec3 low, vec3 high)
{
  vec3 a = (low - from) * inverse;
  vec3 b = (high - from) * inverse;
  float enters = max(max(min(a.x, b.x), min(a.y, b.y)), max(min(a.z, b.z), float(0.0)));
  float leaves = min(min(max(a.x, b.x), max(a.y, b.y)), min(max(a.z, b.z), last));
  return enters <= leaves * float(1.000001);
}

// The side of the line from a to b on which the origin lies: above 0 on the left, below 0 on the
// right. Exactly the negated number for the line from b to a, however the products are rounded.
float relievoEdgeSide(vec2 a, vec2 b)
{
  bool turned = a.x > b.x || (a.x == b.x && a.y > b.y);
  vec2 p = turned ? b : a;
  vec2 q = turned ? a : b;
  float side = p.x * q.y - p.y * q.x;
  return turned ? -side : side;
}

// Whether the origin lies on the left if it is moved infinitesimally along y, and infinitesimally
// less against x, so that it lies on no line (H. Edelsbrunner, E. P. Muecke, Simulation of
// simplicity, 1990): then it is on the left of all lines that lead to a larger x, or else y.
bool relievoEdgeIsLeft(vec2 a, vec2 b, float side)
{
  bool turned = a.x > b.x || (a.x == b.x && a.y > b.y);
  return turned ? side > float(0.0) : side >= float(0.0);
}

// Whether the line along z through the origin passes the triangle with these corners across it; a
// triangle seen edge-on is not hit. closed: all edges belong to the triangle; otherwise an edge
// shared by triangles on both sides belongs to one of them, and so does a corner surrounded by
// triangles.
bool relievoLineHitsTriangle(vec2 a, vec2 b, vec2 c, bool closed)
{
  float ab = relievoEdgeSide(a, b);
  float bc = relievoEdgeSide(b, c);
  float ca = relievoEdgeSide(c, a);
  float least = min(min(ab, bc), ca);
  float most = max(max(ab, bc), ca);
  bool within = least < most ? least >= float(0.0) || most <= float(0.0) : least != float(0.0);
  bool left = relievoEdgeIsLeft(a, b, ab);
  bool same = left == relievoEdgeIsLeft(b, c, bc) && left == relievoEdgeIsLeft(c, a, ca);
  return within && (closed || same);
}
