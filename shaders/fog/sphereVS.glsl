//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of each sphere, as a strip of 4 corners, and the sphere's values of
// vtkRelievoSphereRays.
uniform samplerBuffer fogSpheres;
uniform vec2 relievoSize;
flat out vec4 fogLinear; // w: depth of the centre
flat out vec4 fogLinearLacks;
flat out vec4 fogSquare; // w: 1 / radius
flat out vec4 fogSquareLacks; // w: density
flat out vec4 fogOrigin; // offset of the ray from the centre, and its pixel
flat out vec4 fogOffset; // change of the offset per pixel in x and y
flat out vec3 fogColor;

void main()
{
  int first = 8 * gl_InstanceID;
  vec4 rectangle = texelFetch(fogSpheres, first);
  fogLinear = texelFetch(fogSpheres, first + 1);
  fogLinearLacks = texelFetch(fogSpheres, first + 2);
  fogSquare = texelFetch(fogSpheres, first + 3);
  fogSquareLacks = texelFetch(fogSpheres, first + 4);
  fogOrigin = texelFetch(fogSpheres, first + 5);
  fogOffset = texelFetch(fogSpheres, first + 6);
  fogColor = texelFetch(fogSpheres, first + 7).rgb;
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? rectangle.x : rectangle.z,
    (gl_VertexID & 2) == 0 ? rectangle.y : rectangle.w);
  gl_Position = vec4(2.0 * corner / relievoSize - 1.0, 0.0, 1.0);
}
