//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The rectangle around each piece of a dashed line, as a strip of 4 corners.
uniform samplerBuffer linesPieces; // see vtkRelievoDashes
uniform vec2 relievoSize;
uniform float linesHalfWidth;
flat out vec4 linesEnds;  // in pixels
flat out vec4 linesAlong; // nearness at both ends, number of dashes up to both

void main()
{
  linesEnds = texelFetch(linesPieces, 2 * gl_InstanceID);
  linesAlong = texelFetch(linesPieces, 2 * gl_InstanceID + 1);
  vec2 way = linesEnds.zw - linesEnds.xy;
  float far = length(way);
  float reach = linesHalfWidth + 1.0;
  vec2 ahead = far > 0.0 ? reach / far * way : vec2(reach, 0.0);
  vec2 corner = (gl_VertexID & 1) == 0 ? linesEnds.xy - ahead : linesEnds.zw + ahead;
  corner += ((gl_VertexID & 2) == 0 ? -1.0 : 1.0) * vec2(-ahead.y, ahead.x);
  gl_Position = vec4(2.0 * corner / relievoSize - 1.0, 0.0, 1.0);
}
