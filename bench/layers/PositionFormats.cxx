// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PositionFormats.h"

#include "vtkRelievoFormulas.h"

namespace relievoBench
{
using namespace relievo::f64;

namespace
{
double WindowZ(double depth, const DepthRange& range)
{
  return range.Parallel ? relievoParallelWindowZ(depth, range.Near, range.Far)
                        : relievoPerspectiveWindowZ(depth, range.Near, range.Far);
}

double DepthOfWindowZ(double z, const DepthRange& range)
{
  return range.Parallel ? relievoParallelDepth(z, range.Near, range.Far)
                        : relievoPerspectiveDepth(z, range.Near, range.Far);
}
}

// One number per call: GCC 12 omits the rounding if two doubles are converted to float and back
// side by side.
//------------------------------------------------------------------------------
double ThroughFloat(double value)
{
  return static_cast<float>(value);
}

//------------------------------------------------------------------------------
double ThroughHalf(double value)
{
  return unpackHalf2x16(packHalf2x16(vec2(value, 0.))).x;
}

//------------------------------------------------------------------------------
double ThroughDepth16F(double depth, const DepthRange& range)
{
  const double scale = relievoDepth16FScale(range.Far);
  return relievoUnpackDepth16F(relievoPackDepth16F(depth, scale), scale);
}

//------------------------------------------------------------------------------
double ThroughDepth32F(double depth, const DepthRange&)
{
  return ThroughFloat(depth);
}

//------------------------------------------------------------------------------
double ThroughWindowZ24(double depth, const DepthRange& range)
{
  const std::uint32_t word = relievoPackWindowZ24(WindowZ(depth, range));
  return DepthOfWindowZ(relievoUnpackWindowZ24(word), range);
}

//------------------------------------------------------------------------------
double ThroughWindowZ32F(double depth, const DepthRange& range)
{
  return DepthOfWindowZ(ThroughFloat(WindowZ(depth, range)), range);
}

//------------------------------------------------------------------------------
double ThroughReversed32F(double depth, const DepthRange& range)
{
  const double z =
    ThroughFloat(range.Parallel ? relievoParallelReversedZ(depth, range.Near, range.Far)
                                : relievoPerspectiveReversedZ(depth, range.Near, range.Far));
  return range.Parallel ? relievoParallelDepthFromReversed(z, range.Near, range.Far)
                        : relievoPerspectiveDepthFromReversed(z, range.Near, range.Far);
}
}
