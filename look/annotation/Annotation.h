// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Formatting of the numbers in a picture, shared by the colour bar, the grid and the scale bar.
 */
#ifndef Annotation_h
#define Annotation_h

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace scene
{
/// Black or white, whichever contrasts more with the background.
std::array<double, 3> GetInk(vtkRenderer* renderer);

/// The largest 1, 2 or 5 times a power of 10 not above the value, as the nearest double.
double RoundDown(double length);

/// A printf format, and the values written by it.
struct WrittenValues
{
  std::string Format;
  std::vector<std::string> Texts;
};

/// Writes at least two evenly spaced values with the fewest digits that are accurate to a few
/// hundredths of the step; exponents shorten long numbers.
WrittenValues WriteValues(const std::vector<double>& values);
}

#endif
