// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTruth.h"

#include "EmbreeScene.h"

#include <vtkSMPTools.h>

#include <glm/geometric.hpp>

#include <limits>

namespace
{
int CountCrossings(
  const relievoTest::EmbreeScene& scene, const glm::dvec3& place, const glm::dvec3& direction)
{
  relievoTest::Ray ray;
  ray.Origin = place;
  ray.Direction = direction;
  int count = 0;
  double from = 0.;
  long long last = -1;
  for (; count < 1000; ++count)
  {
    const relievoTest::SurfacePoint hit =
      scene.Cast(ray, from, std::numeric_limits<double>::infinity(), last);
    if (!hit.Hit)
    {
      break;
    }
    from = hit.Depth;
    last = hit.Triangle;
  }
  return count;
}
}

//------------------------------------------------------------------------------
bool relievoTest::IsInsideByVote(const EmbreeScene& scene, const glm::dvec3& place)
{
  static const glm::dvec3 directions[3] = { glm::normalize(glm::dvec3(0.9, 0.31, 0.17)),
    glm::normalize(glm::dvec3(-0.22, 0.83, 0.41)), glm::normalize(glm::dvec3(0.13, -0.37, -0.78)) };
  int votes = 0;
  for (const glm::dvec3& direction : directions)
  {
    votes += CountCrossings(scene, place, direction) % 2;
  }
  return votes >= 2;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> relievoTest::CellsInside(const InsideFunction& isInside,
  const int cells[3], const double origin[3], const glm::dvec3& spacing)
{
  const vtkIdType count = static_cast<vtkIdType>(cells[0]) * cells[1] * cells[2];
  std::vector<unsigned char> inside(static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count, 1024, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const glm::dvec3 index(
        cell % cells[0] + 0.5, cell / cells[0] % cells[1] + 0.5, cell / cells[0] / cells[1] + 0.5);
      inside[static_cast<std::size_t>(cell)] =
        isInside(glm::dvec3(origin[0], origin[1], origin[2]) + index * spacing) ? 1 : 0;
    }
  });
  return inside;
}
