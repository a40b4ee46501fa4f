// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SrgbCurve.h
 * @brief The sRGB curve by its definition, IEC 61966-2-1, independent of the product's code.
 */
#ifndef relievoTestSrgbCurve_h
#define relievoTestSrgbCurve_h

#include <cmath>

namespace relievoTest
{
/** The light, 0 to 1, of a display value, 0 to 1. */
inline double LinearFromSrgb(double shown)
{
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

/** The display value of a light. */
inline double SrgbFromLinear(double light)
{
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1. / 2.4) - 0.055;
}
}

#endif
