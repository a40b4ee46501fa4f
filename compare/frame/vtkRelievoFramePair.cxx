// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFramePair.h"

#include "vtkMath.h"

#include <cmath>

namespace relievo::compare
{
//------------------------------------------------------------------------------
int FramePair::CountLevels() const
{
  const bool hasPictures = this->A.Picture.Components > 0 && this->B.Picture.Components > 0;
  return !hasPictures ? 0 : this->A.HasAlpha() && this->B.HasAlpha() ? 4 : 3;
}

//------------------------------------------------------------------------------
bool FramePair::IsEqual(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

//------------------------------------------------------------------------------
double FramePair::GetAngle(const float* a, const float* b)
{
  const double u[3] = { a[0], a[1], a[2] };
  const double v[3] = { b[0], b[1], b[2] };
  double cross[3];
  vtkMath::Cross(u, v, cross);
  return vtkMath::DegreesFromRadians(std::atan2(vtkMath::Norm(cross), vtkMath::Dot(u, v)));
}

//------------------------------------------------------------------------------
const Layer* FramePair::Find(const std::map<std::string, Layer>& layers, const std::string& name)
{
  const auto found = layers.find(name);
  return found == layers.end() ? nullptr : &found->second;
}
}
