//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Rectangles of pixels, at the farthest depth, in the raster of their samples.
uniform samplerBuffer relievoRuns; // x, y, width, height
uniform vec2 relievoSize;          // of the viewport
uniform mat4 relievoToRaster;      // from the viewport's NDC

void main()
{
  vec4 run = texelFetch(relievoRuns, gl_InstanceID);
  vec2 corner = vec2(float(gl_VertexID % 2), float(gl_VertexID / 2));
  // Enlarged, so that samples on the rim are inside.
  vec2 place = run.xy + corner * run.zw + 0.01 * (2.0 * corner - 1.0);
  gl_Position = relievoToRaster * vec4(2.0 * place / relievoSize - 1.0, 1.0, 1.0);
}
