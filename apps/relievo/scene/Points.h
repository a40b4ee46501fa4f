// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What --lamps, --fog and --markers do with their files: points with values.
 */
#ifndef Points_h
#define Points_h

#include "PointValue.h"

#include "vtkRelievoPointValues.h"

#include <string>

class vtkDataObject;

namespace cli
{
/// Throws WordsError or WorkError, which name the option or the file, for one that cannot be read
/// or is no points.
void CheckPointFile(const std::string& option, const std::string& path);

/// Throws WordsError, with the arrays that there are, if the points have none of that name, which
/// an option asks for as `what`; an empty name asks for none.
void CheckArray(const std::string& option, const std::string& path, vtkDataObject* data,
  const std::string& what, const std::string& name);

/// Sets one number or colour for all points, which comes before an array that the file has, or the
/// array to take.
template <typename Points>
void TakeValue(
  Points* points, const char* name, const PointValue& value, void (Points::*set)(double))
{
  if (value.Number)
  {
    (points->*set)(*value.Number);
  }
  if (value.Number || !value.Array.empty())
  {
    points->SetArray(name, value.Array);
  }
}
template <typename Points>
void TakeColor(Points* points, const ColorValue& color)
{
  if (color.Color)
  {
    points->SetColor(color.Color->data());
  }
  if (color.Color || !color.Array.empty())
  {
    points->SetArray("color", color.Array);
  }
}

/// Reads the points. Throws WorkError with the file's name if arrays do not fit, or nothing of it
/// is one of `things` (such as "lamps"), which `needs` says. Notes how many are not.
void CheckPoints(vtkRelievoPointValues* points, const std::string& path, const std::string& things,
  const std::string& needs);
}

#endif
