// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels whose colours are mixtures of the surfaces around: near edges, and in frames of several
// samples per pixel.
#ifndef vtkRelievoSampleMixtures_h
#define vtkRelievoSampleMixtures_h

#include "vtkRelievoComparisonLimits.h"
#include "vtkRelievoFramePair.h"

#include <functional>

namespace relievo::compare
{
class SampleMixtures
{
public:
  SampleMixtures(const FramePair& frames, const Limits& limits);

  // Whether samples of the surfaces around explain the colours of a pixel. `isOpen` says of a pixel
  // whether its cause is still unknown.
  bool Explain(std::size_t pixel, const std::function<bool(std::size_t)>& isOpen) const;

private:
  bool IsEdge(std::size_t pixel) const;
  bool IsBetweenNeighbours(std::size_t pixel, double widening) const;
  bool IsMixture(std::size_t pixel) const;
  bool IsThin(std::size_t pixel) const;
  bool IsDarkerInSamples(std::size_t pixel) const; // in one frame no component is brighter

  const FramePair& Frames;
  Limits Bounds;
  const Frame* Smoother = nullptr; // the frame with more samples per pixel
};
}

#endif
