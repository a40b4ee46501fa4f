// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A raster of samples of a picture's pixels (vtkRelievoSampleRaster), as VTK makes colours for
// display.
// RELIEVO_SAMPLES: of each pixel.
uniform sampler2D relievoRasterColor;
uniform sampler2D relievoRasterZ;
uniform vec2 relievoRasterCells[RELIEVO_SAMPLES]; // of the viewport's first pixel; whole numbers
uniform ivec2 relievoRasterFirst;                 // where these are counted from
uniform ivec2 relievoRasterRight;                 // to the next pixel
uniform ivec2 relievoRasterUp;

// The cell of the sample that is next to a pixel's centre.
ivec2 relievoRasterCenter(ivec2 pixel)
{
  return relievoRasterFirst + pixel.x * relievoRasterRight + pixel.y * relievoRasterUp +
    ivec2(relievoRasterCells[0]);
}
