// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleView.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr float Nothing = std::numeric_limits<float>::infinity();

// In texels: a steeper slope to a neighbour may be a step.
constexpr float Steepest = 6.F;

// The slope from two differences to neighbours; either may be missing, or a step to another
// surface.
float Slope(bool hasBefore, float before, bool hasAfter, float after)
{
  if (hasBefore && hasAfter)
  {
    const bool both = std::max(std::abs(before), std::abs(after)) <= Steepest;
    return both ? (before + after) / 2.F : std::abs(before) < std::abs(after) ? before : after;
  }
  return hasBefore ? before : hasAfter ? after : 0.F;
}
}

//------------------------------------------------------------------------------
vtkRelievoParticleView::vtkRelievoParticleView(
  int width, int height, const glm::dmat3& toMap, const glm::dvec3& offset, double texel)
  : Width(width)
  , Height(height)
  , Map(toMap)
  , Offset(offset)
  , World(glm::inverse(toMap))
  , Look(glm::normalize(World[2]))
  , TexelSize(texel)
  , Texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
      Texel{ Nothing, glm::vec3(0.F), glm::vec3(0.F) })
{
}

//------------------------------------------------------------------------------
void vtkRelievoParticleView::SetDepth(std::size_t texel, double depth)
{
  this->Texels[texel].Depth = std::isfinite(depth) ? static_cast<float>(depth) : Nothing;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleView::IsSeen(std::size_t texel) const
{
  return this->Texels[texel].Depth < Nothing;
}

//------------------------------------------------------------------------------
void vtkRelievoParticleView::ComputeNormals()
{
  // The surface is where depth(u, v) - w = 0; its gradient points away from the viewer's side.
  const glm::dmat3 toWorld = glm::transpose(this->Map);
  vtkSMPTools::For(0, this->Height, 16, [&](vtkIdType begin, vtkIdType end) {
    for (int j = static_cast<int>(begin); j < end; ++j)
    {
      for (int i = 0; i < this->Width; ++i)
      {
        Texel& texel = this->Texels[static_cast<std::size_t>(j) * this->Width + i];
        if (!(texel.Depth < Nothing))
        {
          continue;
        }
        const auto slope = [&](int di, int dj) {
          const Texel* before = this->GetSeen(i - di, j - dj);
          const Texel* after = this->GetSeen(i + di, j + dj);
          return Slope(before != nullptr, before ? texel.Depth - before->Depth : 0.F,
            after != nullptr, after ? after->Depth - texel.Depth : 0.F);
        };
        const glm::dvec3 gradient(slope(1, 0), slope(0, 1), -1.);
        texel.Normal = glm::vec3(glm::normalize(toWorld * gradient));
      }
    }
  });
}

//------------------------------------------------------------------------------
vtkRelievoParticlePlace vtkRelievoParticleView::At(
  std::size_t texel, double partX, double partY) const
{
  const auto width = static_cast<std::size_t>(this->Width);
  const Texel& nearest = this->Texels[texel];
  const glm::dvec3 map(static_cast<double>(texel % width) + partX,
    static_cast<double>(texel / width) + partY, nearest.Depth);
  return this->Blend(map, nearest);
}

//------------------------------------------------------------------------------
void vtkRelievoParticleView::SetVelocity(std::size_t texel, const glm::vec3& velocity)
{
  this->Texels[texel].Velocity = velocity;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleView::Snap(glm::dvec3& map, int& i, int& j) const
{
  constexpr double Edge = 0.499;
  double least = std::numeric_limits<double>::infinity();
  const glm::dvec3 from = map;
  const int column = i;
  const int row = j;
  for (int y = row - 1; y <= row + 1; ++y)
  {
    for (int x = column - 1; x <= column + 1; ++x)
    {
      const Texel* texel = this->GetSeen(x, y);
      const glm::dvec3 to(std::clamp(from.x, x - Edge, x + Edge),
        std::clamp(from.y, y - Edge, y + Edge), texel ? texel->Depth : 0.);
      const double distance = glm::dot(to - from, to - from);
      if (texel && distance < least)
      {
        least = distance;
        map = glm::dvec3(to.x, to.y, from.z);
        i = x;
        j = y;
      }
    }
  }
  return least < std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleView::Find(
  const glm::dvec3& position, bool snap, vtkRelievoParticlePlace& place) const
{
  glm::dvec3 map = this->ToMap(position);
  int i = 0;
  int j = 0;
  const Texel* nearest = this->GetNearest(map, i, j);
  if (!nearest && snap && this->Snap(map, i, j))
  {
    nearest = this->GetSeen(i, j);
  }
  if (nearest)
  {
    place = this->Blend(map, *nearest);
  }
  return nearest != nullptr;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleView::FindVelocity(const glm::dvec3& position, glm::vec3& velocity) const
{
  const glm::dvec3 map = this->ToMap(position);
  if (!(map.x >= 0. && map.x < this->Width - 1 && map.y >= 0. && map.y < this->Height - 1))
  {
    return false;
  }
  const int x = WholeOf(map.x);
  const int y = WholeOf(map.y);
  const auto partX = static_cast<float>(map.x - x);
  const auto partY = static_cast<float>(map.y - y);
  const Texel* lower = &this->Texels[static_cast<std::size_t>(y) * this->Width + x];
  const Texel* upper = lower + this->Width;
  const auto depth = static_cast<float>(map.z);
  const float apart = std::max({ std::abs(lower[0].Depth - depth), std::abs(lower[1].Depth - depth),
    std::abs(upper[0].Depth - depth), std::abs(upper[1].Depth - depth) });
  velocity = (1.F - partY) * ((1.F - partX) * lower[0].Velocity + partX * lower[1].Velocity) +
    partY * ((1.F - partX) * upper[0].Velocity + partX * upper[1].Velocity);
  return apart <= Step;
}

//------------------------------------------------------------------------------
double vtkRelievoParticleView::GetHeight(const glm::dvec3& position) const
{
  const glm::dvec3 map = this->ToMap(position);
  int i = 0;
  int j = 0;
  const Texel* nearest = this->GetNearest(map, i, j);
  return nearest ? (nearest->Depth - map.z) * this->TexelSize
                 : std::numeric_limits<double>::infinity();
}
