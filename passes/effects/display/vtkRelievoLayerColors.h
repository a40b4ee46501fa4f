// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Converts a layer of an image to colours: scalars through a colour map, vectors as 0.5 v + 0.5
// (positions over their extent), ids as distinct colours.
#ifndef vtkRelievoLayerColors_h
#define vtkRelievoLayerColors_h

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace vtkRelievoLayerColors
{
// RGBA, alpha 0 in the background. `map`: the colours of scalars, from the first to the last. An
// empty range is replaced by the range of the values. A light's visibility is grey, from 0 to 1,
// and transparent where the image's depth has no surface.
// `shown` receives the values of the first and the last colour, of the first component, infinite if
// no pixel has one. `same` receives whether all pixels have one value.
std::vector<unsigned char> Make(vtkImageData* image, const std::string& layer, bool visibility,
  const double range[2], const std::vector<std::array<float, 3>>& map, double shown[2], bool& same);
}

#endif
