// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of --markers.
 */
#ifndef MarkerOptions_h
#define MarkerOptions_h

#include "PointValue.h"

#include <array>
#include <optional>
#include <string>

namespace scene
{
struct MarkerChoice
{
  std::string File;
  int Shape = 0; ///< as of vtkRelievoMarkers
  PointValue Radius, Width, Reach, Opacity;
  ColorValue Color;
  std::optional<std::array<double, 3>> Up; ///< none: the up axis
};

/// FILE[,NAME=VALUE]...: shape, radius, width, reach, opacity, color, up. Throws UsageError.
MarkerChoice ParseMarkers(const std::string& word);
}

#endif
