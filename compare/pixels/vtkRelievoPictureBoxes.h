// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The boxes of the picture that translucent objects and changed volumes cover: they appear in no
// layer.
#ifndef vtkRelievoPictureBoxes_h
#define vtkRelievoPictureBoxes_h

#include "vtkRelievoComparedFrame.h"
#include "vtkRelievoObjectChanges.h"
#include "vtkRelievoVolumeChanges.h"

#include <array>
#include <cstddef>
#include <vector>

namespace relievo::compare
{
class PictureBoxes
{
public:
  // A box of the picture: first and last x, first and last y, in pixels.
  struct Cover
  {
    std::size_t Object; // of volumes: the finding
    std::array<double, 4> Range;
  };

  // Projects all boxes by the camera of the frame before, which both frames share.
  PictureBoxes(const Frame& before, const ObjectChanges& objects, const VolumeChanges& volumes);

  // Translucent objects of the frame before (side 0) or after (1).
  const std::vector<Cover>& GetTranslucent(std::size_t side) const
  {
    return this->Translucent[side];
  }

  // The finding of a changed volume whose box covers the pixel; -1: none.
  int FindVolume(std::size_t pixel) const;

  bool Covers(const Cover& cover, std::size_t pixel) const;

private:
  std::array<double, 4> Project(const std::array<double, 6>& bounds) const;

  const Frame& A;
  std::vector<Cover> Translucent[2];
  std::vector<Cover> Volumes;
};
}

#endif
