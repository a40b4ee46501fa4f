// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of the unit square for rays into the sky, converted to directions by
// formulas/light/sky.glsl.
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

  // `samples` points: i / samples, and the fractional part of i times the golden ratio, to be
  // shifted by a share of 1 / samples and by any number; on the disc they form a spiral (H. Vogel,
  // A better way to construct the sunflower head, 1979). With `spread`, ordered such that the first
  // points are also spread out.
  VTKRELIEVORAYS_EXPORT static std::vector<Point> Get(int samples, bool spread);
};

#endif
