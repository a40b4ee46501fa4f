// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SrgbCurve.h
 * @brief The curve of sRGB by its definition, IEC 61966-2-1; no code of the product's.
 */
#ifndef relievoTestSrgbCurve_h
#define relievoTestSrgbCurve_h

#include <cmath>

namespace relievoTest
{
/** Light, 0 to 1, of a value for display, 0 to 1. */
inline double LinearFromSrgb(double shown)
{
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

/** The value for display of a light. */
inline double SrgbFromLinear(double light)
{
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1. / 2.4) - 0.055;
}
}

#endif
