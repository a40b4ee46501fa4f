// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinOrigin.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>

namespace relievo
{
namespace
{
double GetLargest(const glm::dvec3& v)
{
  return std::max({ v.x, v.y, v.z });
}
}

//------------------------------------------------------------------------------
SkinBox GetBox(vtkPolyData* mesh)
{
  SkinBox box;
  if (mesh->GetNumberOfPoints() > 0)
  {
    double b[6];
    mesh->GetPoints()->GetBounds(b);
    box.Add(glm::dvec3(b[0], b[2], b[4]));
    box.Add(glm::dvec3(b[1], b[3], b[5]));
  }
  return box;
}

//------------------------------------------------------------------------------
glm::dvec3 GetFarOrigin(const SkinBox& box, double sizes)
{
  const glm::dvec3 middle = 0.5 * (box.Low + box.High);
  // Also true if a number is not finite.
  const bool far = GetLargest(glm::abs(middle)) > sizes * GetLargest(box.High - box.Low);
  return far && GetLargest(glm::abs(middle)) < 1e30 ? glm::dvec3(glm::vec3(middle))
                                                    : glm::dvec3(0.);
}

//------------------------------------------------------------------------------
std::vector<glm::dmat4> GetMatricesAbout(
  const std::vector<glm::dmat4>& matrices, const glm::dvec3& rest, const glm::dvec3& moved)
{
  std::vector<glm::dmat4> about = matrices;
  for (glm::dmat4& m : about)
  {
    m[3] = m * glm::dvec4(rest, 1.) - glm::dvec4(moved, 0.);
  }
  return about;
}
}
