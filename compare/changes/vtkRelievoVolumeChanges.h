// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The changes of volumes by the records of two frames. A volume is matched with one of equal data,
// otherwise by its number.
#ifndef vtkRelievoVolumeChanges_h
#define vtkRelievoVolumeChanges_h

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"

#include <array>
#include <cstddef>
#include <vector>

namespace relievo::compare
{
class VolumeChanges
{
public:
  // The box of a changed volume in one frame.
  struct Region
  {
    int Finding;
    std::array<double, 6> Bounds;
  };

  VolumeChanges(const Frame& before, const Frame& after, CauseList& list);

  const std::vector<Region>& GetRegions() const { return this->Regions; }

  // The index of a volume's change in the list, by its number in the frame before (side 0) or after
  // (1); -1: none.
  int GetFinding(std::size_t side, int volume) const;

private:
  void Match();
  int Compare(int before, int after);
  void Add(std::size_t side, std::size_t volume, int finding);

  const Frame& A;
  const Frame& B;
  CauseList& List;
  std::vector<int> Findings[2];
  std::vector<Region> Regions;
};
}

#endif
