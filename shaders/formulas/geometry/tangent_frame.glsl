// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The frame of texture coordinates on a surface, from two small steps on it: positions change by px
// and py, texture coordinates by uvx and uvy (screen-space derivatives, or two edges of a
// triangle). After C. Schueler, Followup: normal mapping without precomputed tangents (2013).

// Signed area of the two steps in texture space; negative for mirrored coordinates.
float relievoTextureArea(vec2 uvx, vec2 uvy)
{
  return uvx.x * uvy.y - uvx.y * uvy.x;
}

// Whether the coordinates span an area: neither constant nor on a line, beyond the float rounding
// of coordinates of about 1. Compares squares, because roots cost more.
bool relievoHasTextureFrame(vec2 uvx, vec2 uvy)
{
  float area = relievoTextureArea(uvx, uvy);
  float xx = dot(uvx, uvx);
  float yy = dot(uvy, uvy);
  return area * area > max(float(1e-8) * xx * yy, float(1.6e-13) * (xx + yy));
}

// Derivatives of the position by u and v. The frame must exist.
vec3 relievoPositionPerU(vec3 px, vec3 py, vec2 uvx, vec2 uvy)
{
  return (px * uvy.y - py * uvx.y) / relievoTextureArea(uvx, uvy);
}
vec3 relievoPositionPerV(vec3 px, vec3 py, vec2 uvx, vec2 uvy)
{
  return (py * uvx.x - px * uvy.x) / relievoTextureArea(uvx, uvy);
}

// Changes of u and v along a direction: of its component in the plane of perU and perV, which need
// be neither of unit length nor perpendicular.
vec2 relievoTextureStep(vec3 direction, vec3 perU, vec3 perV)
{
  float uu = dot(perU, perU);
  float uv = dot(perU, perV);
  float vv = dot(perV, perV);
  float du = dot(direction, perU);
  float dv = dot(direction, perV);
  return vec2(du * vv - dv * uv, dv * uu - du * uv) / (uu * vv - uv * uv);
}

// A tangent-space normal in the space of the frame: x along `tangent` made perpendicular to the
// (unit) normal, z along the normal, y perpendicular to both: a quarter turn from x to y is
// counter-clockwise around the normal for handedness 1, clockwise for -1.
vec3 relievoFromTangentSpace(vec3 mapped, vec3 normal, vec3 tangent, float handedness)
{
  vec3 t = normalize(tangent - normal * dot(normal, tangent));
  return normalize(t * mapped.x + cross(normal, t) * (handedness * mapped.y) + normal * mapped.z);
}

// The normal of a surface displaced by a height along its unit normal. slopes: change of the
// height, in units of length, with u and with v.
vec3 relievoLiftedNormal(vec3 normal, vec3 perU, vec3 perV, vec2 slopes)
{
  vec3 alongU = cross(perV, normal);
  vec3 alongV = cross(normal, perU);
  float volume = dot(perU, alongU);
  return normalize(normal - (alongU * slopes.x + alongV * slopes.y) / volume);
}
