// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCaveImage.h
 * @brief Samples caves on a grid, skipping evaluations that the noise's slope makes unnecessary.
 *
 * A value of the noise bounds the values around it, because the noise is nowhere steeper than
 * relievoSimplexNoiseSlope. Samples proven to be rock are not evaluated, first in blocks, then
 * along rows. All other samples are evaluated exactly, so the result is the same bit for bit, for
 * any extent and number of threads.
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
  // Called from the caller's thread with the fraction done; false stops.
  std::function<bool(double)> GoOn;
};

struct CaveCounts
{
  vtkTypeInt64 Evaluations = 0; // of one noise
  vtkTypeInt64 Air = 0;         // number of samples in air; for masks
  bool Stopped = false;
};

/** Sets each sample, x fastest, to `air` if it is in air, otherwise to `rock`. */
CaveCounts MakeCaveMask(const CaveGrid& grid, const CaveSettings& settings, unsigned char air,
  unsigned char rock, unsigned char* values);

/** Sets each sample to the cave function's value, at most 1. */
CaveCounts MakeCaveDensity(const CaveGrid& grid, const CaveSettings& settings, float* values);
}

#endif
