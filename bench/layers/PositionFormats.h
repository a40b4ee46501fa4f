// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PositionFormats.h
 * @brief A coordinate or a depth after it was stored in a texture.
 *
 * A separate file, since the formulas and the whole of GLM, which the tests' views need, cannot be
 * included together: both define packHalf2x16.
 */
#ifndef relievoBenchPositionFormats_h
#define relievoBenchPositionFormats_h

namespace relievoBench
{
/** The nearest float, and the nearest half, which is infinite beyond 65504. */
double ThroughFloat(double value);
double ThroughHalf(double value);

/** The clipping planes and the projection that a stored depth is read back with. */
struct DepthRange
{
  double Near;
  double Far;
  bool Parallel;
};

/** Depths after they were stored in a texture. */
double ThroughDepth16F(double depth, const DepthRange& range);
double ThroughDepth32F(double depth, const DepthRange& range);
double ThroughWindowZ24(double depth, const DepthRange& range);
double ThroughWindowZ32F(double depth, const DepthRange& range);
double ThroughReversed32F(double depth, const DepthRange& range);
}

#endif
