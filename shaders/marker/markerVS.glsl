//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of each marker, as a strip of 4 corners, and the marker's values of
// vtkRelievoMarkerList.
uniform samplerBuffer markers;
uniform vec2 relievoSize;
flat out vec4 markerColor; // a: opacity
flat out vec4 markerOrigin;
flat out vec4 markerOffsets;
flat out vec4 markerDepth;
flat out vec4 markerEdges;
flat out vec4 markerAxisX;
flat out vec4 markerAxisY;
flat out vec4 markerAxisZ;

void main()
{
  int first = 9 * gl_InstanceID;
  vec4 rectangle = texelFetch(markers, first);
  markerColor = texelFetch(markers, first + 1);
  markerOrigin = texelFetch(markers, first + 2);
  markerOffsets = texelFetch(markers, first + 3);
  markerDepth = texelFetch(markers, first + 4);
  markerEdges = texelFetch(markers, first + 5);
  markerAxisX = texelFetch(markers, first + 6);
  markerAxisY = texelFetch(markers, first + 7);
  markerAxisZ = texelFetch(markers, first + 8);
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? rectangle.x : rectangle.z,
    (gl_VertexID & 2) == 0 ? rectangle.y : rectangle.w);
  gl_Position = vec4(2.0 * corner / relievoSize - 1.0, 0.0, 1.0);
}
