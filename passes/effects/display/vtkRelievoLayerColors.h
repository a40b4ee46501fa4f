// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A layer in an image as colours: scalars through a colour map, vectors as 0.5 v + 0.5 (positions
// over their extent), ids as distinct colours.
#ifndef vtkRelievoLayerColors_h
#define vtkRelievoLayerColors_h

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace vtkRelievoLayerColors
{
// RGBA, alpha 0 where nothing is. `map`: the colours of scalars, from the first to the last. The
// range is taken from the values if it is empty; a light's visibility is grey, from 0 to 1, and
// nothing where the image has a depth without a surface.
// `shown`: gets the values of the first and the last colour, of the first component, infinite where
// no pixel has one. `same`: gets whether all pixels have one.
std::vector<unsigned char> Make(vtkImageData* image, const std::string& layer, bool visibility,
  const double range[2], const std::vector<std::array<float, 3>>& map, double shown[2], bool& same);
}

#endif
