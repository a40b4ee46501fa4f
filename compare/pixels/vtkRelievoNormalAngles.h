// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The angle between the normals of a pixel in two frames: whether the filtering of a normal map
// explains it, and whether it explains the colours.
#ifndef vtkRelievoNormalAngles_h
#define vtkRelievoNormalAngles_h

#include "vtkRelievoComparisonLimits.h"
#include "vtkRelievoFramePair.h"
#include "vtkRelievoObjectChanges.h"

namespace relievo::compare
{
class NormalAngles
{
public:
  // The limits may change later.
  NormalAngles(const FramePair& frames, const ObjectChanges& objects, const Limits& limits)
    : Frames(frames)
    , Objects(objects)
    , Bounds(limits)
  {
  }

  // In degrees; 180 if only one of the frames has a normal, 0 without layers of normals.
  double Get(std::size_t pixel) const;

  // Whether an object of the frame before has the same normal map in both frames.
  bool IsMapped(int a) const;

  bool IsTexelRounded(std::size_t pixel, double angle) const;

  bool Explains(std::size_t pixel, double angle) const;

private:
  const FramePair& Frames;
  const ObjectChanges& Objects;
  const Limits& Bounds;
};
}

#endif
