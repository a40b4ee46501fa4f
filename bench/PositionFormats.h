// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PositionFormats.h
 * @brief What textures keep of a coordinate or a depth.
 *
 * A room of its own since the formulas and the whole of GLM, which the tests' views need, do not
 * go into one file: both define packHalf2x16.
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

/** Depths after they were kept in a texture. */
double ThroughDepth16F(double depth, const DepthRange& range);
double ThroughDepth32F(double depth, const DepthRange& range);
double ThroughWindowZ24(double depth, const DepthRange& range);
double ThroughWindowZ32F(double depth, const DepthRange& range);
double ThroughReversed32F(double depth, const DepthRange& range);
}

#endif
