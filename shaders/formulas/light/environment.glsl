// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The position of a direction in an environment image: equirectangular, cube, sphere map. This file
// alone defines the orientation of environments.
//
// A direction d points outwards from the middle and has any length but zero; axes are right-handed
// with +y up. Positions in an image are OpenGL's texture coordinates: (0, 0) is the outer corner of
// the first texel of the first row, (1, 1) that of the last.
//
// Equirectangular: the middle of the image is in direction +x, u grows from there towards +z (a
// quarter of the width further), and -x lies on the seam u = 0 = 1; v is 0 at -y and 1 at +y, so
// the first row is the lowest, as from VTK's readers. Seen from inside it is not mirrored. VTK's
// lighting agrees (vtkPBRIrradianceTexture, vtkEquirectangularToCubeMapTexture), and so does
// vtkSkybox with FloorRight (0, 0, 1); vtkSkybox's default is rotated by 90 degrees, with -z in the
// middle.
//
// Cube: the six faces +x -x +y -y +z -z (0 to 5) in the layout of OpenGL's samplerCube, neither
// rotated nor flipped: texture(cube, d) is the light from d. Row 0 of the four side faces is the
// highest. Pictures taken from inside, one per face, are mirrored with respect to this layout; for
// them vtkSkybox (since VTK 9.2) looks up (x, y, -z).
//
// Sphere map (GL_SPHERE_MAP): the picture of a mirror ball seen from far away on +z. The middle is
// +z, the inscribed circle is -z, and the corners outside it are unused. Equal areas are equal
// solid angles.

const float relievoPi = float(3.14159265358979324);

// Direction to the position in an equirectangular image; u of exactly +y and -y is 0.5.
vec2 relievoEquirectangularFromDirection(vec3 d)
{
  float across = length(vec2(d.x, d.z));
  float u = across > float(0.0) ? atan(d.z, d.x) / (float(2.0) * relievoPi) : float(0.0);
  return vec2(u + float(0.5), atan(d.y, across) / relievoPi + float(0.5));
}

// The unit direction of a position; u may leave [0, 1].
vec3 relievoDirectionFromEquirectangular(vec2 uv)
{
  float longitude = (uv.x - float(0.5)) * (float(2.0) * relievoPi);
  float latitude = (uv.y - float(0.5)) * relievoPi;
  float across = cos(latitude);
  return vec3(across * cos(longitude), sin(latitude), across * sin(longitude));
}

// Solid angle per area of the image [0, 1]^2, steradian.
float relievoEquirectangularDensity(vec2 uv)
{
  return float(2.0) * relievoPi * relievoPi * cos((uv.y - float(0.5)) * relievoPi);
}

// The face that a direction hits, 0 to 5; on an edge x precedes y precedes z.
int relievoCubeFace(vec3 d)
{
  float x = abs(d.x);
  float y = abs(d.y);
  float z = abs(d.z);
  if (x >= y && x >= z)
  {
    return d.x > float(0.0) ? 0 : 1;
  }
  if (y >= z)
  {
    return d.y > float(0.0) ? 2 : 3;
  }
  return d.z > float(0.0) ? 4 : 5;
}

// The position on `face` that a direction hits; in [0, 1]^2 if the face is relievoCubeFace(d).
// Table 3.21 of the OpenGL 3.2 specification.
vec2 relievoCubeFromDirection(vec3 d, int face)
{
  float s = d.x;
  float t = -d.y;
  float axis = abs(d.z);
  if (face < 2)
  {
    s = face == 0 ? -d.z : d.z;
    axis = abs(d.x);
  }
  else if (face < 4)
  {
    t = face == 2 ? d.z : -d.z;
    axis = abs(d.y);
  }
  else if (face == 5)
  {
    s = -d.x;
  }
  return vec2(float(0.5) * s / axis + float(0.5), float(0.5) * t / axis + float(0.5));
}

// The point of the cube [-1, 1]^3 at a position on a face: its direction, not normalised. A
// position outside of [0, 1]^2 is a point in the face's plane next to it.
vec3 relievoDirectionFromCube(vec2 st, int face)
{
  float a = float(2.0) * st.x - float(1.0);
  float b = float(2.0) * st.y - float(1.0);
  if (face == 0)
  {
    return vec3(float(1.0), -b, -a);
  }
  if (face == 1)
  {
    return vec3(float(-1.0), -b, a);
  }
  if (face == 2)
  {
    return vec3(a, float(1.0), b);
  }
  if (face == 3)
  {
    return vec3(a, float(-1.0), -b);
  }
  if (face == 4)
  {
    return vec3(a, -b, float(1.0));
  }
  return vec3(-a, -b, float(-1.0));
}

// Solid angle per area of a face [0, 1]^2, steradian.
float relievoCubeDensity(vec2 st)
{
  float a = float(2.0) * st.x - float(1.0);
  float b = float(2.0) * st.y - float(1.0);
  float square = float(1.0) + a * a + b * b;
  return float(4.0) / (square * sqrt(square));
}

// Direction to the position in a sphere map; exactly -z, to which the whole circle belongs, gives
// its lowest point. For unit d the position is (d.x, d.y) / (2 |d + z|) + 0.5.
vec2 relievoSphereMapFromDirection(vec3 d)
{
  float size = length(d);
  float side = length(vec2(d.x, d.y));
  if (side == float(0.0))
  {
    return vec2(float(0.5), d.z < float(0.0) ? float(0.0) : float(0.5));
  }
  // size + d.z, from its product with size - d.z if the sum would lose digits.
  float ahead = d.z < float(0.0) ? side * (side / (size - d.z)) : size + d.z;
  float twice = float(2.0) * length(vec2(side, ahead));
  return vec2(d.x / twice + float(0.5), d.y / twice + float(0.5));
}

// The unit direction of a position in a sphere map; outside of the circle, -z.
vec3 relievoDirectionFromSphereMap(vec2 st)
{
  float x = float(2.0) * st.x - float(1.0);
  float y = float(2.0) * st.y - float(1.0);
  float square = min(x * x + y * y, float(1.0));
  float twice = float(2.0) * sqrt(float(1.0) - square);
  return vec3(twice * x, twice * y, float(1.0) - float(2.0) * square);
}

// Solid angle per area of a sphere map [0, 1]^2, steradian; 0 outside of the circle.
float relievoSphereMapDensity(vec2 st)
{
  float x = st.x - float(0.5);
  float y = st.y - float(0.5);
  return x * x + y * y <= float(0.25) ? float(16.0) : float(0.0);
}
