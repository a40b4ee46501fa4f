// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSimulation.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievoBench
{
using relievoTest::PixelTruth;

//------------------------------------------------------------------------------
ShadowSimulation::ShadowSimulation(const relievoTest::EmbreeScene& scene,
  const relievoTest::TruthImage& view, const glm::dvec3& toSun, int mapSize)
  : Size(mapSize)
{
  this->Axes[2] = -glm::normalize(toSun);
  const glm::dvec3 aside =
    std::abs(this->Axes[2].y) < 0.9 ? glm::dvec3(0., 1., 0.) : glm::dvec3(1., 0., 0.);
  this->Axes[0] = glm::normalize(glm::cross(aside, this->Axes[2]));
  this->Axes[1] = glm::cross(this->Axes[2], this->Axes[0]);

  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const PixelTruth& pixel : view.Pixels)
  {
    for (int i = 0; pixel.Hit && i < 3; ++i)
    {
      const double along = glm::dot(this->Axes[i], pixel.Position);
      low[i] = std::min(low[i], along);
      high[i] = std::max(high[i], along);
    }
  }
  // A margin of a texel on every side; rays start before anything that could cast into the view.
  for (int i = 0; i < 2; ++i)
  {
    this->Texel[i] = (high[i] - low[i]) / (mapSize - 2);
    low[i] -= this->Texel[i];
  }
  low.z -= 2. * scene.Size();
  this->Corner = low;

  this->Depths.resize(static_cast<std::size_t>(mapSize) * mapSize);
  vtkSMPTools::For(0, mapSize, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType y = from; y < to; ++y)
    {
      for (int x = 0; x < mapSize; ++x)
      {
        relievoTest::Ray ray;
        ray.Direction = this->Axes[2];
        ray.Origin = (low.x + (x + 0.5) * this->Texel[0]) * this->Axes[0] +
          (low.y + (static_cast<double>(y) + 0.5) * this->Texel[1]) * this->Axes[1] +
          low.z * this->Axes[2];
        this->Depths[static_cast<std::size_t>(y) * mapSize + x] =
          scene.Cast(ray, 0., std::numeric_limits<double>::infinity()).Depth;
      }
    }
  });
}

//------------------------------------------------------------------------------
glm::dvec3 ShadowSimulation::ToMap(const glm::dvec3& world) const
{
  return glm::dvec3((glm::dot(this->Axes[0], world) - this->Corner.x) / this->Texel[0],
    (glm::dot(this->Axes[1], world) - this->Corner.y) / this->Texel[1],
    glm::dot(this->Axes[2], world) - this->Corner.z);
}

//------------------------------------------------------------------------------
double ShadowSimulation::At(int x, int y) const
{
  x = std::clamp(x, 0, this->Size - 1);
  y = std::clamp(y, 0, this->Size - 1);
  return this->Depths[static_cast<std::size_t>(y) * this->Size + x];
}

//------------------------------------------------------------------------------
std::vector<float> ShadowSimulation::Visibility(
  const relievoTest::TruthImage& view, double bias, bool receiverPlane) const
{
  const double allowed = bias * std::max(this->Texel[0], this->Texel[1]);
  std::vector<float> visibility(view.Pixels.size(), 1.f);
  for (std::size_t i = 0; i < visibility.size(); ++i)
  {
    const PixelTruth& pixel = view.Pixels[i];
    if (!pixel.Hit)
    {
      continue;
    }
    const glm::dvec3 place = this->ToMap(pixel.Position);
    // The slope of depth of the pixel's plane from texel to texel.
    double slope[2] = { 0., 0. };
    const double facing = glm::dot(pixel.Normal, this->Axes[2]);
    for (int axis = 0; receiverPlane && facing != 0. && axis < 2; ++axis)
    {
      slope[axis] = -glm::dot(pixel.Normal, this->Axes[axis]) / facing * this->Texel[axis];
    }
    const double left = std::floor(place.x - 0.5);
    const double bottom = std::floor(place.y - 0.5);
    double lit = 0.;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double dx = left + (corner & 1) + 0.5 - place.x;
      const double dy = bottom + (corner >> 1) + 0.5 - place.y;
      const double depth = place.z + dx * slope[0] + dy * slope[1];
      const double first =
        this->At(static_cast<int>(left) + (corner & 1), static_cast<int>(bottom) + (corner >> 1));
      lit += depth - allowed <= first ? (1. - std::abs(dx)) * (1. - std::abs(dy)) : 0.;
    }
    visibility[i] = static_cast<float>(lit);
  }
  return visibility;
}
}
