// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoNoiseCell.h
 * @brief Splits a coordinate into a noise cell and the fraction within it.
 */
#ifndef vtkRelievoNoiseCell_h
#define vtkRelievoNoiseCell_h

#include <cmath>

namespace relievo
{
struct NoiseCell
{
  int Cell = 0;
  double Part = 0.; // in [0, 1)

  /**
   * Splits a finite coordinate in cells. Noise takes cells from -2^29 to 2^29 - 1, so it repeats
   * after 2^30 cells along each axis.
   */
  static NoiseCell Of(double coordinate)
  {
    constexpr double Half = 536870912.;
    const double whole = std::floor(coordinate);
    const double turns = std::floor((whole + Half) / (2. * Half));
    return { static_cast<int>(whole - turns * 2. * Half), coordinate - whole };
  }
};
}

#endif
