// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCaveImage.h
 * @brief Samples caves on a grid, and evaluates as little noise as the noise's slope allows.
 *
 * A value of the noise at one place bounds it around there, because the noise is nowhere steeper
 * than relievoSimplexNoiseSlope: what is proven to be rock is not evaluated, first in blocks of
 * samples, then along rows. What is evaluated is what would be without that, so the result is the
 * same bit for bit, for any extent and number of threads.
 */
#ifndef vtkRelievoCaveImage_h
#define vtkRelievoCaveImage_h

#include "vtkRelievoCaveField.h"

#include "vtkType.h"

#include <array>
#include <functional>

namespace relievo
{
struct CaveGrid
{
  std::array<int, 6> Extent = {};
  std::array<double, 3> Origin = {};
  std::array<double, 3> Spacing = {};

  std::array<double, 3> PointAt(int i, int j, int k) const
  {
    return { this->Origin[0] + i * this->Spacing[0], this->Origin[1] + j * this->Spacing[1],
      this->Origin[2] + k * this->Spacing[2] };
  }
};

struct CaveSettings
{
  CaveField Field;
  bool Skipping = true;
  // Called from the thread of the caller with the part that is done; false stops.
  std::function<bool(double)> GoOn;
};

struct CaveCounts
{
  vtkTypeInt64 Evaluations = 0; // of one noise
  vtkTypeInt64 Air = 0;         // samples; of a mask
  bool Stopped = false;
};

/** Sets each sample, x fastest, to `air` where there is air, else to `rock`. */
CaveCounts MakeCaveMask(const CaveGrid& grid, const CaveSettings& settings, unsigned char air,
  unsigned char rock, unsigned char* values);

/** Sets each sample to the cave function's value, at most 1. */
CaveCounts MakeCaveDensity(const CaveGrid& grid, const CaveSettings& settings, float* values);
}

#endif
