// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options of texts, bars and grids over a picture.
 */
#ifndef AnnotationOptions_h
#define AnnotationOptions_h

#include "LookNames.h"

#include <optional>
#include <string>

namespace look
{
/// The scalar bar's place and texts.
struct BarChoice
{
  int Place = 0;                    ///< of vtkRelievoColorBar
  std::optional<std::string> Title; ///< none: the array's name
  std::string Unit;
};

/// A figure in print.
struct PrintChoice
{
  double Width = 0.0; ///< millimetres; 0: no figure, sizes follow the picture's
  double DPI = 0.0;

  /// Pixels of the font, for 8 points; 0: by the picture's size.
  double GetTextSize() const { return 8.0 / 72.0 * this->DPI; }

  /// Pixels of a line's width, for half a point; 0: by the picture's size.
  double GetLineWidth() const { return 0.5 / 72.0 * this->DPI; }
};
}

#endif
