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

/// The map of that name over a range of values; what is no number is grey.
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& name, const std::array<double, 2>& range);
}

#endif
