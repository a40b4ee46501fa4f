// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The bar of colours with their values, at the right of a picture.
 */
#ifndef ScalarBar_h
#define ScalarBar_h

#include <string>

class vtkColorTransferFunction;
class vtkRenderer;

namespace scene
{
/// Fits the bar to the renderer's present size: title and values are in the picture, in black or
/// white, and neighbouring values differ. A map in a few steps has values where its colours change;
/// a logarithmic map at the ends and powers of ten between them.
void AddScalarBar(
  vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title, int steps = 0);
}

#endif
