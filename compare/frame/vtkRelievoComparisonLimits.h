// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The largest differences between two frames that count as alike; vtkRelievoFrameComparison gives
// the reasons.
#ifndef vtkRelievoComparisonLimits_h
#define vtkRelievoComparisonLimits_h

namespace relievo::compare
{
struct Limits
{
  double ColorLevels = 2.0;         // of 255
  double NormalAngle = 0.02;        // degrees
  double DepthPixels = 1.0 / 256.0; // across the surface
};
}

#endif
