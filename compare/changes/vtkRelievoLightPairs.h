// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lights of two frames in pairs, by name, otherwise by number, and the differences between
// their records.
#ifndef vtkRelievoLightPairs_h
#define vtkRelievoLightPairs_h

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"

#include <vector>

namespace relievo::compare
{
class LightPairs
{
public:
  // A light in both frames; -1: absent from that frame.
  struct Pair
  {
    int Before = -1, After = -1; // indices in Frame::Lights
    int Finding = -1;            // the difference between their records
  };

  LightPairs(const Frame& before, const Frame& after, CauseList& list);

  // Empty without records of lights.
  const std::vector<Pair>& Get() const { return this->Pairs; }

  // The visibility of a light in both frames; nullptr if a frame lacks the light or the layer.
  using Visibility = const std::vector<float>*;
  std::pair<Visibility, Visibility> GetVisibility(const Pair& pair) const;

  bool AnyChanged() const;

  // The index of a light's finding in the list, by its number in the frame before if it was there.
  int Find(const Pair& pair, Cause cause);

private:
  const Frame& A;
  const Frame& B;
  CauseList& List;
  std::vector<Pair> Pairs;
};
}

#endif
