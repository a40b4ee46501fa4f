// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The lists of vtkRelievoLampClusters: the lamps in each cell of the view.
uniform samplerBuffer relievoCells; // where each cell's list starts
uniform samplerBuffer relievoLists;
uniform int relievoColumns;
uniform int relievoRows;
uniform int relievoSlices;
uniform int relievoTile; // pixels
uniform float relievoSliceScale;
uniform float relievoSliceOffset;

// Start and end of the list of a pixel's cell. RELIEVO_LINEAR_SLICES: parallel projection.
ivec2 relievoFindLamps(ivec2 pixel, float depth)
{
#ifdef RELIEVO_LINEAR_SLICES
  float place = depth;
#else
  float place = log2(depth);
#endif
  // There is no lamp in front of the first slice or behind the last one.
  int slice =
    clamp(int(floor(place * relievoSliceScale + relievoSliceOffset)), 0, relievoSlices - 1);
  ivec2 tile = pixel / relievoTile;
  int cell = (slice * relievoRows + tile.y) * relievoColumns + tile.x;
  return ivec2(
    int(texelFetch(relievoCells, cell).x), int(texelFetch(relievoCells, cell + 1).x));
}

int relievoListedLamp(int i)
{
  return int(texelFetch(relievoLists, i).x);
}
