// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCaveField.h"

#include "vtkRelievoCaveNoise.h"

namespace relievo
{
//------------------------------------------------------------------------------
std::array<double, 2> CaveField::WallsAt(const CavePlace& place) const
{
  std::array<double, 2> walls;
  for (int which = 0; which < 2; ++which)
  {
    walls[which] = this->WallOf(CaveNoise(*this, place, which).Value());
  }
  return walls;
}

//------------------------------------------------------------------------------
std::array<double, 3> CaveField::GradientAt(const CavePlace& place, int which) const
{
  const CaveNoise noise(*this, place, which);
  const double side = noise.Value() < this->Middle ? -this->PerHalf : this->PerHalf;
  const f64::vec3 slope = noise.Gradient();
  return { side * slope.x, side * slope.y, side * slope.z };
}
}
