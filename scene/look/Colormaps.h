// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colour maps by name.
 */
#ifndef Colormaps_h
#define Colormaps_h

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;

namespace scene
{
std::vector<std::string> GetColormapNames();

/// Behind a map's word: the other way round.
constexpr const char* ReversedColormap = ":reversed";

/// Throws UsageError for words that MakeColormap does not take.
void CheckColormap(const std::string& word);

/// The map of that name, or of colours between commas, evenly placed, over a range of values; what
/// is no number is grey.
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& word, const std::array<double, 2>& range);
}

#endif
