// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of the unit square for rays into the sky: formulas/sky.glsl makes directions of them.
#ifndef vtkRelievoSkySamples_h
#define vtkRelievoSkySamples_h

#include "vtkRelievoRaysModule.h" // for the export macro

#include <vector>

struct vtkRelievoSkySamples
{
  struct Point
  {
    double X = 0.0;
    double Y = 0.0;
  };

  // So many points, i / samples and the part of i times the golden ratio beyond a whole number, to
  // be moved by a share of 1 / samples and by any number: on the disc a spiral (H. Vogel, A better
  // way to construct the sunflower head, 1979). If `spread`, in an order in which the first ones
  // are spread out as well.
  VTKRELIEVORAYS_EXPORT static std::vector<Point> Get(int samples, bool spread);
};

#endif
