// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The bar of colours and their values at the right of a picture.
 */
#ifndef ScalarBar_h
#define ScalarBar_h

#include <string>

class vtkColorTransferFunction;
class vtkRenderer;

namespace scene
{
/// In the renderer's size as it is now: the title and the values are in the picture, in black or
/// white, and neighbouring values differ. Those of a map in a few steps are where its colours
/// change; of one by logarithms, powers of ten between the ends.
void AddScalarBar(
  vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title, int steps = 0);
}

#endif
