// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colour maps by name or as lists of colours, and their modifiers.
 */
#ifndef Colormaps_h
#define Colormaps_h

#include "LookNames.h"
#include "LookOptions.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;

namespace look
{
std::vector<std::string> GetColormapNames();

/// The parts of a --colormap value: MAP[:reversed][:log][:steps=N][:nan=COLOR].
struct Colormap
{
  std::string Map;       ///< a name, or colours between commas
  bool Reversed = false; ///< the other way round
  bool Log = false;      ///< logarithmic in the values
  int Steps = 0;         ///< number of colours; 0: continuous
  std::string Nan;       ///< colour of NaN, in words; empty: grey

  /// Throws UsageError for an invalid value.
  static Colormap Parse(const std::string& word);
  std::string Write() const;
};

/// A stop in a list of colours.
struct ColorStop
{
  double Place = 0.0; ///< as a share of the range, or of its logarithms in a logarithmic map
  Color Shown{};
};

///@{
/// A list of colours as the map's word: "black,0.3=#ff8000,white". Without places, the first colour
/// is at 0, the last at 1, and those between two places are evenly spaced. Parsing throws
/// UsageError; it returns none for a name.
std::vector<ColorStop> ParseStops(const std::string& map);
std::string WriteStops(std::vector<ColorStop> stops);
///@}

/// Throws UsageError for words that MakeColormap refuses.
void CheckColormap(const std::string& word);

/// The map over a range of values, which must be positive for a logarithmic map. `sampled`: for
/// users that sample at even steps, like VTK's volumes, whatever the map's scale.
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& word, const std::array<double, 2>& range, bool sampled = false);
}

#endif
