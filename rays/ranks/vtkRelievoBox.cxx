// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBox.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::array<glm::dvec3, 8> vtkRelievoBox::GetCorners() const
{
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = glm::dvec3(i & 1 ? this->Max.x : this->Min.x, i & 2 ? this->Max.y : this->Min.y,
      i & 4 ? this->Max.z : this->Min.z);
  }
  return corners;
}

//------------------------------------------------------------------------------
void vtkRelievoBox::Join(const vtkRelievoBox& box, std::vector<vtkRelievoBox>& boxes)
{
  const auto known = std::lower_bound(boxes.begin(), boxes.end(), box,
    [](const vtkRelievoBox& a, const vtkRelievoBox& b) { return a.Number < b.Number; });
  if (known != boxes.end() && known->Number == box.Number)
  {
    known->Min = glm::min(known->Min, box.Min);
    known->Max = glm::max(known->Max, box.Max);
    known->Loose = known->Loose || box.Loose;
  }
  else
  {
    boxes.insert(known, box);
  }
}
