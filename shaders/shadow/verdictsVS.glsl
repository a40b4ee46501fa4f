//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Tiles of pixels with open verdicts, two triangles each; the others are clipped. If some verdicts
// stay, all others are written.
uniform sampler2D relievoSeenTiles; // see tilesFS.glsl
uniform ivec2 relievoSeenTileCount;
uniform int relievoSeenKeeps;
uniform vec2 relievoSeenSize; // in pixels

void main()
{
  int tile = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * tile;
  ivec2 at = ivec2(tile % relievoSeenTileCount.x, tile / relievoSeenTileCount.x);
  vec2 side = vec2(corner == 1 || corner == 2 || corner == 4 ? 1.0 : 0.0,
    corner == 2 || corner == 4 || corner == 5 ? 1.0 : 0.0);
  bool open = texelFetch(relievoSeenTiles, at, 0).x >= (relievoSeenKeeps != 0 ? -1.0 : 0.0);
  vec2 ndc = 16.0 * (vec2(at) + side) / relievoSeenSize - 1.0;
  gl_Position = open ? vec4(ndc, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
