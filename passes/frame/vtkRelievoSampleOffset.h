// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Moves a frame's drawing by a part of a pixel during its lifetime: to the position of one of the
// samples whose mean is a picture with smooth edges.
#ifndef vtkRelievoSampleOffset_h
#define vtkRelievoSampleOffset_h

#include "vtkRelievoAccess.h"

#include <glm/vec2.hpp>

#include <optional>

class vtkRelievoFrameContext;

class vtkRelievoSampleOffset
{
public:
  // Moves the context's camera, and its View, if its samples have offsets.
  explicit vtkRelievoSampleOffset(vtkRelievoFrameContext& context);

  // Offset from the pixel's centre, -0.5 to 0.5 in each direction: Halton's sequence in the bases 2
  // and 3, shifted so that the mean of all offsets is the centre.
  static glm::dvec2 Get(int sample, int samples);

private:
  std::optional<vtkRelievoAccess::Camera::Projection> Projection;
};

#endif
