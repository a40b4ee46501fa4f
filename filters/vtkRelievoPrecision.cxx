// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPrecision.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo
{
//------------------------------------------------------------------------------
bool NeedsDouble(vtkImageData* image, const int wholeExtent[6])
{
  double farthest = 0.;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double index[3] = { static_cast<double>(wholeExtent[corner & 1]),
      static_cast<double>(wholeExtent[2 + (corner >> 1 & 1)]),
      static_cast<double>(wholeExtent[4 + (corner >> 2)]) };
    double place[3];
    image->TransformContinuousIndexToPhysicalPoint(index, place);
    farthest = std::max({ farthest, std::abs(place[0]), std::abs(place[1]), std::abs(place[2]) });
  }
  const double* spacing = image->GetSpacing();
  const double shortest =
    std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  return 0.5 * std::numeric_limits<float>::epsilon() * farthest > 1e-3 * shortest;
}
}
