// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colour maps by name or of own colours, and what is said behind them.
 */
#ifndef Colormaps_h
#define Colormaps_h

#include "LookOptions.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;

namespace scene
{
std::vector<std::string> GetColormapNames();

/// The word of --colormap in its parts: MAP[:reversed][:log][:steps=N][:nan=COLOR].
struct Colormap
{
  std::string Map;       ///< a name, or colours between commas
  bool Reversed = false; ///< the other way round
  bool Log = false;      ///< by the logarithm of the values
  int Steps = 0;         ///< so many colours; 0: as many as there are
  std::string Nan;       ///< the colour of what is no number, in words; empty: grey

  /// Throws UsageError for a word that is none.
  static Colormap Parse(const std::string& word);
  std::string Write() const;
};

/// One of own colours.
struct ColorStop
{
  double Place = 0.0; ///< as a share of the range, of its logarithms if the map is by these
  Color Shown{};
};

///@{
/// Own colours as the map's word: "black,0.3=#ff8000,white". Without a place the first is at 0, the
/// last at 1, and those between two places are evenly apart. Parsing throws UsageError; it gives
/// none for a name.
std::vector<ColorStop> ParseStops(const std::string& map);
std::string WriteStops(std::vector<ColorStop> stops);
///@}

/// Throws UsageError for words that MakeColormap does not take.
void CheckColormap(const std::string& word);

/// The map over a range of values, which are positive if it is by logarithms. `sampled`: for who
/// takes samples at even steps, as VTK's volumes do, whatever the map's scale.
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& word, const std::array<double, 2>& range, bool sampled = false);
}

#endif
