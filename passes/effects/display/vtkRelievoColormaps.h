// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colour maps by name, for layers shown as the picture and for scenes.
#ifndef vtkRelievoColormaps_h
#define vtkRelievoColormaps_h

#include "vtkRelievoEffectsModule.h" // for the export macro

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;

namespace vtkRelievoColormaps
{
VTKRELIEVOEFFECTS_EXPORT const std::vector<std::string>& GetNames();

// Adds the map's points over a range of values, and sets the interpolation space. A `low` above the
// other end reverses the map. An unknown name adds nothing.
VTKRELIEVOEFFECTS_EXPORT void Fill(
  vtkColorTransferFunction* map, const std::string& name, double low, double high);

// Colours from the first to the last at even steps: red, green, blue, 0 to 1.
VTKRELIEVOEFFECTS_EXPORT std::vector<std::array<float, 3>> Sample(
  const std::string& name, bool reversed, int count);
}

#endif
