// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Rotations between keys, and points moved by blended bones. A quaternion is (x, y, z, w) with the
// real part in w; a rigid motion is a unit quaternion and its dual part, after L. Kavan et al.,
// Geometric skinning with approximate dual quaternion blending (2008).

vec4 relievoQuaternionProduct(vec4 a, vec4 b)
{
  return vec4(a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
    a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
    a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);
}

// The quaternion of the same rotation in the hemisphere of `to`.
vec4 relievoQuaternionNear(vec4 q, vec4 to)
{
  return dot(q, to) < float(0.0) ? -q : q;
}

// Interpolation of two unit quaternions along the shorter arc, by the chord: at most 8.2 degrees
// from slerp, for keys half a turn apart.
vec4 relievoQuaternionNlerp(vec4 a, vec4 b, float share)
{
  return normalize(a * (float(1.0) - share) + relievoQuaternionNear(b, a) * share);
}

// Interpolation of two unit quaternions along the shorter arc, at constant angular speed. The arc
// tangent is accurate for small angles too.
vec4 relievoQuaternionSlerp(vec4 a, vec4 b, float share)
{
  vec4 c = relievoQuaternionNear(b, a);
  float angle = float(2.0) * atan(length(a - c), length(a + c));
  if (angle < float(1e-4))
  {
    return relievoQuaternionNlerp(a, b, share);
  }
  return normalize(
    (a * sin((float(1.0) - share) * angle) + c * sin(share * angle)) / sin(angle));
}

vec3 relievoQuaternionRotate(vec4 q, vec3 v)
{
  vec3 axis = vec3(q.x, q.y, q.z);
  vec3 t = cross(axis, v) * float(2.0);
  return v + t * q.w + cross(axis, t);
}

// The rotation as columns.
mat3 relievoQuaternionMatrix(vec4 q)
{
  return mat3(relievoQuaternionRotate(q, vec3(float(1.0), float(0.0), float(0.0))),
    relievoQuaternionRotate(q, vec3(float(0.0), float(1.0), float(0.0))),
    relievoQuaternionRotate(q, vec3(float(0.0), float(0.0), float(1.0))));
}

// The unit quaternion of a rotation, from its largest component, by which the others are divided.
vec4 relievoQuaternionOf(mat3 r)
{
  vec4 squares = vec4(r[0].x - r[1].y - r[2].z, r[1].y - r[0].x - r[2].z,
    r[2].z - r[0].x - r[1].y, r[0].x + r[1].y + r[2].z);
  vec4 q;
  if (squares.w >= max(squares.x, max(squares.y, squares.z)))
  {
    q = vec4(r[1].z - r[2].y, r[2].x - r[0].z, r[0].y - r[1].x, squares.w + float(1.0));
  }
  else if (squares.x >= max(squares.y, squares.z))
  {
    q = vec4(squares.x + float(1.0), r[0].y + r[1].x, r[2].x + r[0].z, r[1].z - r[2].y);
  }
  else if (squares.y >= squares.z)
  {
    q = vec4(r[0].y + r[1].x, squares.y + float(1.0), r[1].z + r[2].y, r[2].x - r[0].z);
  }
  else
  {
    q = vec4(r[2].x + r[0].z, r[1].z + r[2].y, squares.z + float(1.0), r[0].y - r[1].x);
  }
  return normalize(q);
}

// The dual part of the motion that rotates by q and then translates by t.
vec4 relievoDualOf(vec4 q, vec3 t)
{
  return relievoQuaternionProduct(vec4(t.x, t.y, t.z, float(0.0)), q) * float(0.5);
}

// Translation of a blended motion, after its rotation by normalize(real); neither part has to be of
// unit length.
vec3 relievoDualTranslation(vec4 real, vec4 dual)
{
  vec4 t = relievoQuaternionProduct(dual, vec4(-real.x, -real.y, -real.z, real.w));
  return vec3(t.x, t.y, t.z) * (float(2.0) / dot(real, real));
}

// The transform of normals for points transformed by m: its inverse transpose up to a factor, also
// if m is singular.
mat3 relievoNormalMatrix(mat3 m)
{
  mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
  return dot(m[0], cofactors[0]) < float(0.0) ? cofactors * float(-1.0) : cofactors;
}

// The unit direction after a transform by m. A direction in the kernel of m is unchanged.
vec3 relievoTurnDirection(mat3 m, vec3 v)
{
  vec3 turned = m * v;
  float size = max(abs(turned.x), max(abs(turned.y), abs(turned.z)));
  return size > float(1e-30) && size < float(1e30) ? normalize(turned / size) : v;
}

// The unit normal for points transformed by m. m is divided by its size, so that its cofactors
// neither overflow nor vanish.
vec3 relievoTurnNormal(mat3 m, vec3 normal)
{
  vec3 most = max(abs(m[0]), max(abs(m[1]), abs(m[2])));
  float size = max(most.x, max(most.y, most.z));
  mat3 unsized = size > float(1e-30) && size < float(1e30) ? m * (float(1.0) / size) : m;
  return relievoTurnDirection(relievoNormalMatrix(unsized), normal);
}

// The weight of a motion's quaternions in a blend: negative for one in the other hemisphere than
// the strongest's, since a quaternion and its negative are one rotation.
float relievoDualWeight(vec4 q, vec4 strongest, float weight)
{
  return dot(q, strongest) < float(0.0) ? -weight : weight;
}

// Whether weighted quaternions cancel, so that their rotations have no mean.
bool relievoDualCancels(vec4 real, float weights)
{
  return dot(real, real) < float(1e-12) * weights * weights;
}
