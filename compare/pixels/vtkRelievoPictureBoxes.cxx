// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPictureBoxes.h"

#include <algorithm>

namespace relievo::compare
{
//------------------------------------------------------------------------------
PictureBoxes::PictureBoxes(
  const Frame& before, const ObjectChanges& objects, const VolumeChanges& volumes)
  : A(before)
{
  for (std::size_t side = 0; side < 2; ++side)
  {
    const std::vector<Change>& changes =
      side == 0 ? objects.GetBeforeChanges() : objects.GetAfterChanges();
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      if (changes[i].IsTranslucent)
      {
        this->Translucent[side].push_back({ i, this->Project(changes[i].Bounds) });
      }
    }
  }
  for (const VolumeChanges::Region& region : volumes.GetRegions())
  {
    this->Volumes.push_back(
      { static_cast<std::size_t>(region.Finding), this->Project(region.Bounds) });
  }
}

//------------------------------------------------------------------------------
int PictureBoxes::FindVolume(std::size_t pixel) const
{
  for (const Cover& cover : this->Volumes)
  {
    if (this->Covers(cover, pixel))
    {
      return static_cast<int>(cover.Object);
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
std::array<double, 4> PictureBoxes::Project(const std::array<double, 6>& bounds) const
{
  constexpr double Most = 1e300;
  std::array<double, 4> range = { Most, -Most, Most, -Most };
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double point[3] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
      bounds[4 + (corner >> 2)] };
    double place[2];
    if (!this->A.Project(point, place))
    {
      return { -Most, Most, -Most, Most }; // the box reaches behind the camera
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      range[2 * i] = std::min(range[2 * i], place[i]);
      range[2 * i + 1] = std::max(range[2 * i + 1], place[i]);
    }
  }
  return range;
}

//------------------------------------------------------------------------------
bool PictureBoxes::Covers(const Cover& cover, std::size_t pixel) const
{
  const double x = static_cast<double>(pixel % static_cast<std::size_t>(this->A.Size[0])) + 0.5;
  const double y = static_cast<double>(pixel / static_cast<std::size_t>(this->A.Size[0])) + 0.5;
  const std::array<double, 4>& range = cover.Range;
  return x >= range[0] - 1. && x <= range[1] + 1. && y >= range[2] - 1. && y <= range[3] + 1.;
}
}
