// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The bar of colours with their values, from options.
 */
#ifndef ScalarBar_h
#define ScalarBar_h

#include "AnnotationOptions.h"
#include "LookNames.h"

#include <array>
#include <string>

class vtkColorTransferFunction;
class vtkRenderer;

namespace look
{
/// Values that a map colours.
struct ColoredValues
{
  std::string Name;
  std::array<double, 2> Range; ///< of the finite ones
  bool HasNan = false;
};

/// Adds a vtkRelievoColorBar, with boxes for values that the map's range leaves out. `steps`: the
/// number of the map's colours; 0: it is smooth.
void AddScalarBar(vtkRenderer* renderer, vtkColorTransferFunction* map, int steps,
  const ColoredValues& values, const BarChoice& choice, const PrintChoice& print);
}

#endif
