//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Pixels side by side, at the farthest depth, in the raster of their samples.
uniform samplerBuffer relievoRuns; // x, y of the first one, how many
uniform vec2 relievoSize;          // of the viewport
uniform mat4 relievoToRaster;      // from its NDC

void main()
{
  vec4 run = texelFetch(relievoRuns, gl_InstanceID);
  vec2 corner = vec2(float(gl_VertexID % 2), float(gl_VertexID / 2));
  // Samples on the rim are within.
  vec2 place = run.xy + corner * vec2(run.z, 1.0) + 0.01 * (2.0 * corner - 1.0);
  gl_Position = relievoToRaster * vec4(2.0 * place / relievoSize - 1.0, 1.0, 1.0);
}
