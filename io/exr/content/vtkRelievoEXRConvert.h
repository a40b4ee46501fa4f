// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoEXRConvert.h
 * @brief Values of VTK arrays as pixels of EXR channels, and back.
 *
 * | values                    | FLOAT         | HALF         | UINT                           |
 * |---------------------------|---------------|--------------|--------------------------------|
 * | float                     | the same bits | nearest half | -                              |
 * | double                    | nearest float | nearest half | -                              |
 * | integers                  | if exact      | if exact     | 32 bits, -1 becomes 0xFFFFFFFF |
 * | bytes of color and albedo | v / 255       | v / 255      | v                              |
 * | position                  | v - origin    | v - origin   | -                              |
 *
 * v / 255 gives its byte back from a half too: neighbours among the 256 values are at least eight
 * halfs apart.
 *
 * A position of exactly (0, 0, 0), which is the background, is stored as (-0, -0, -0): zero for
 * every program that reads it, and told from a surface point at the origin, whose difference is +0.
 * With an origin of (0, 0, 0) nothing is subtracted and nothing marked.
 */
#ifndef vtkRelievoEXRConvert_h
#define vtkRelievoEXRConvert_h

#include "vtkType.h"

#include <OpenEXR/ImfPixelType.h>

#include <string>

class vtkDataArray;

namespace relievo::exr
{
/** How an array's values are coded in its channels. */
enum class Coding
{
  Plain,
  Normalized, // bytes as v / 255
  Position    // three components, relative to the origin
};

/** Losses of conversion to narrower types; the first lost value is kept for the message. */
struct Losses
{
  vtkIdType Overflows = 0; // finite values that became infinite halfs or floats
  vtkIdType Inexact = 0;   // integers that the pixel type cannot hold
  vtkIdType Rounded = 0;   // whole numbers in arrays of double, as layers of integers have them
  vtkIdType Infinite = 0;  // infinities and NaN that the compression would turn into numbers
  vtkIdType Clipped = 0; // numbers beyond the range of halfs, in which the compression stores them
  std::string First;
};

/** One component of an array, as stored. */
struct Component
{
  vtkDataArray* Array; // with standard memory layout
  int Index;
  Coding Code;
  double Origin[3];
};

/**
 * Converts the `count` tuples from `first` on to pixels of the given type at `pixels`.
 * Not for arrays of float or double and UINT.
 */
void Encode(const Component& component, vtkIdType first, vtkIdType count, Imf::PixelType type,
  void* pixels, Losses& losses);

/**
 * Converts pixels of one component back and puts them into the `count` tuples from `first` on.
 * `uint`: whether the pixels are uint32_t; otherwise they are float.
 * Not for Coding::Position. Integers that do not fit (damaged files) are clamped.
 */
void Decode(
  const void* pixels, bool uint, const Component& component, vtkIdType first, vtkIdType count);

/** Converts pixels of x, y and z back to world positions in an array of float or double. */
void DecodePosition(const float* const pixels[3], vtkDataArray* array, const double origin[3],
  vtkIdType first, vtkIdType count);
}

#endif
