// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What --lamps, --fog and --markers do with their files: points with values.
 */
#ifndef Points_h
#define Points_h

#include "PointValue.h"

#include "vtkDataObject.h"
#include "vtkRelievoPointValues.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

namespace scene
{
class Progress;

/// Throws UsageError or WorkError, which name the option or the file, for one that cannot be read
/// or is no points.
void CheckPointFile(const std::string& option, const std::string& path);

/// A file of points, and what an option makes of it.
class PointFile
{
public:
  /// Reads the file. Throws WorkError if it cannot be read.
  PointFile(const std::string& option, const std::string& path, Progress& progress);

  vtkDataObject* GetData() const { return this->Data; }

  /// Whether any of the points have a value in an array of that name.
  bool Has(const std::string& array) const;

  /// Sets one number for all points, which comes before an array that the file has, or the array to
  /// take. Throws UsageError, with the arrays that there are, if there is none of that name.
  template <typename Points, typename Set>
  void Take(Points* points, const char* name, const PointValue& value, Set set) const
  {
    if (value.Number)
    {
      std::invoke(set, points, *value.Number);
    }
    this->TakeArray(points, name, value.Number.has_value(), value.Array);
  }

  /// Sets one colour for all points, or the array to take, by the rules of Take().
  template <typename Points>
  void TakeColor(Points* points, const ColorValue& color) const
  {
    if (color.Color)
    {
      points->SetColor(color.Color->data());
    }
    this->TakeArray(points, "color", color.Color.has_value(), color.Array);
  }

  /// Throws WorkError with the file's name if arrays do not fit, or nothing of it is one of
  /// `things` (such as "lamps"), which `needs` says. Notes how many are not.
  void Check(
    vtkRelievoPointValues* points, const std::string& things, const std::string& needs) const;

private:
  void TakeArray(
    vtkRelievoPointValues* points, const char* name, bool isSet, const std::string& array) const;

  std::string Option, Path;
  vtkSmartPointer<vtkDataObject> Data;
};
}

#endif
