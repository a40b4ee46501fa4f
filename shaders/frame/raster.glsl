// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A raster of samples of a picture's pixels (vtkRelievoSampleRaster), in VTK's display colours.
// RELIEVO_SAMPLES: samples per pixel.
uniform sampler2D relievoRasterColor;
uniform sampler2D relievoRasterZ;
uniform vec2 relievoRasterCells[RELIEVO_SAMPLES]; // in the viewport's first pixel; integers
uniform ivec2 relievoRasterFirst;                 // origin of these
uniform ivec2 relievoRasterRight;                 // step to the next pixel
uniform ivec2 relievoRasterUp;

// The cell of the sample nearest to a pixel's centre.
ivec2 relievoRasterCenter(ivec2 pixel)
{
  return relievoRasterFirst + pixel.x * relievoRasterRight + pixel.y * relievoRasterUp +
    ivec2(relievoRasterCells[0]);
}
