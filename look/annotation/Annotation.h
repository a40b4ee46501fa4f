// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the numbers in a picture have in common, of the colour bar, the grid and the scale
 * bar.
 */
#ifndef Annotation_h
#define Annotation_h

#include <array>
#include <string>
#include <vector>

class vtkRenderer;

namespace scene
{
/// Black or white, whatever is read better on the background.
std::array<double, 3> GetInk(vtkRenderer* renderer);

/// 1, 2 or 5 times a power of 10, at most that; the double nearest to it.
double RoundDown(double length);

/// A way to write numbers as printf has it, and values written so.
struct WrittenValues
{
  std::string Format;
  std::vector<std::string> Texts;
};

/// At least two values at even steps, with the fewest digits that are right to a few hundredths of
/// the step; exponents are for what would be long without.
WrittenValues WriteValues(const std::vector<double>& values);
}

#endif
