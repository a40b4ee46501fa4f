// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names of arrays that describe a raster of the world: in the field data of an image of it, and of
// a mesh made of it. Rows of a raster run downwards from row 0, those of a vtkImageData upwards.
#ifndef vtkRelievoRaster_h
#define vtkRelievoRaster_h

namespace relievo::raster
{
// Six numbers a, b, c, d, e, f (double): column and row, counted from the outer corner of the first
// cell, are at x = a column + b row + c and y = d column + e row + f.
constexpr const char* Transform = "raster_transform";

// The value of cells without data (double); missing: only values that are not finite.
constexpr const char* NoData = "raster_nodata";

// GeoTIFF's keys of the coordinate system: a directory (unsigned short), and the numbers (double)
// and text that it refers to.
constexpr const char* Keys = "raster_keys";
constexpr const char* KeyNumbers = "raster_key_numbers";
constexpr const char* KeyText = "raster_key_text";

// Columns and rows (int) of the raster of a mesh, and the cell of each point (vtkIdType), counted
// along the rows from row 0.
constexpr const char* Size = "raster_size";
constexpr const char* Cell = "raster_cell";
}

#endif
