// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EnvironmentMaps.h"

#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>

namespace relievoBench
{
namespace
{
namespace f64 = relievo::f64;
constexpr double Pi = 3.14159265358979323846;

bool IsCube(EnvironmentMap map)
{
  return map == EnvironmentMap::Cube || map == EnvironmentMap::WarpedCube;
}

double Warp(double place)
{
  return 0.5 + 0.5 * std::tan(Pi / 2. * (place - 0.5));
}

double Unwarp(double place)
{
  return 0.5 + 2. / Pi * std::atan(2. * place - 1.);
}
}

//------------------------------------------------------------------------------
int EnvironmentTexels::SizeFor(EnvironmentMap map, int texels)
{
  const double each = IsCube(map) ? 6. : (map == EnvironmentMap::Latitudes ? 2. : 1.);
  return std::max(2, static_cast<int>(std::lround(std::sqrt(texels / each))));
}

//------------------------------------------------------------------------------
glm::dvec3 EnvironmentTexels::DirectionOf(int face, const glm::dvec2& place) const
{
  switch (this->Map)
  {
    case EnvironmentMap::Cube:
      return glm::normalize(f64::relievoDirectionFromCube(place, face));
    case EnvironmentMap::WarpedCube:
      return glm::normalize(f64::relievoDirectionFromCube({ Warp(place.x), Warp(place.y) }, face));
    case EnvironmentMap::Octahedral:
      return f64::relievoOctDecode(2. * place - 1.);
    case EnvironmentMap::SphereMap:
      return f64::relievoDirectionFromSphereMap(place);
    default:
      return f64::relievoDirectionFromEquirectangular(place);
  }
}

//------------------------------------------------------------------------------
int EnvironmentTexels::PlaceOf(const glm::dvec3& direction, glm::dvec2& place) const
{
  switch (this->Map)
  {
    case EnvironmentMap::Octahedral:
      place = 0.5 * f64::relievoOctEncode(direction) + 0.5;
      return 0;
    case EnvironmentMap::SphereMap:
      place = f64::relievoSphereMapFromDirection(direction);
      return 0;
    case EnvironmentMap::Latitudes:
      place = f64::relievoEquirectangularFromDirection(direction);
      return 0;
    default:
      break;
  }
  const int face = f64::relievoCubeFace(direction);
  place = f64::relievoCubeFromDirection(direction, face);
  if (this->Map == EnvironmentMap::WarpedCube)
  {
    place = { Unwarp(place.x), Unwarp(place.y) };
  }
  return face;
}

//------------------------------------------------------------------------------
double EnvironmentTexels::DensityOf(int face, const glm::dvec2& place) const
{
  if (this->Map == EnvironmentMap::SphereMap)
  {
    return f64::relievoSphereMapDensity(place);
  }
  // By finite differences: the area spanned by the direction's two derivatives.
  constexpr double Step = 1e-5;
  const glm::dvec3 x = this->DirectionOf(face, place + glm::dvec2(Step, 0.)) -
    this->DirectionOf(face, place - glm::dvec2(Step, 0.));
  const glm::dvec3 y = this->DirectionOf(face, place + glm::dvec2(0., Step)) -
    this->DirectionOf(face, place - glm::dvec2(0., Step));
  return glm::length(glm::cross(x, y));
}

//------------------------------------------------------------------------------
EnvironmentTexels::EnvironmentTexels(
  EnvironmentMap map, int size, const Radiance& light, int samples)
  : Map(map)
  , Faces(IsCube(map) ? 6 : 1)
  , Width(map == EnvironmentMap::Latitudes ? 2 * size : size)
  , Height(size)
{
  this->Texels.reserve(static_cast<std::size_t>(this->Faces) * this->Width * this->Height);
  for (int face = 0; face < this->Faces; ++face)
  {
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        glm::dvec3 sum(0.);
        double weights = 0.;
        for (int k = 0; k < samples * samples; ++k)
        {
          const glm::dvec2 place((x + (k % samples + 0.5) / samples) / this->Width,
            (y + (k / samples + 0.5) / samples) / this->Height);
          const double weight = this->DensityOf(face, place);
          if (weight > 0.)
          {
            sum += weight * light(this->DirectionOf(face, place));
            weights += weight;
          }
        }
        this->Texels.push_back(weights > 0. ? sum / weights : sum);
      }
    }
  }
}

//------------------------------------------------------------------------------
const glm::dvec3& EnvironmentTexels::Fetch(int face, int x, int y) const
{
  const int inX = std::clamp(x, 0, this->Width - 1);
  const int inY = std::clamp(y, 0, this->Height - 1);
  if (this->Map == EnvironmentMap::SphereMap)
  {
    // Outside the circle: the nearest texel whose middle is inside.
    const double half = 0.5 * this->Width;
    const glm::dvec2 away = glm::dvec2(x, y) + 0.5 - half;
    const double distance = glm::length(away);
    if (distance > half)
    {
      const glm::dvec2 nearer = half + away * (std::max(half - 0.75, 0.) / distance);
      return this->At(0, static_cast<int>(nearer.x), static_cast<int>(nearer.y));
    }
  }
  if (x == inX && y == inY)
  {
    return this->At(face, x, y);
  }
  if (this->Map == EnvironmentMap::Latitudes)
  {
    const bool over = y != inY;
    return this->At(0, (x + this->Width + (over ? this->Width / 2 : 0)) % this->Width, inY);
  }
  if (this->Map == EnvironmentMap::Octahedral)
  {
    // Each side of the square is mirrored about its middle.
    const int last = this->Width - 1;
    const bool crossX = x != inX;
    const bool crossY = y != inY;
    return this->At(0, crossY ? last - inX : inX, crossX ? last - inY : inY);
  }
  // The adjacent face of a cube; beyond a corner, where three meet, the one across x.
  const double half = 0.5 / this->Width;
  const auto beside = [half, this](int index, int inside) {
    return (inside + 0.5) / this->Width + (index - inside) * (half + 1e-6);
  };
  const glm::dvec2 at(beside(x, inX), x != inX ? (inY + 0.5) / this->Width : beside(y, inY));
  glm::dvec2 place;
  const int other = this->PlaceOf(this->DirectionOf(face, at), place);
  return this->At(other, std::clamp(static_cast<int>(place.x * this->Width), 0, this->Width - 1),
    std::clamp(static_cast<int>(place.y * this->Width), 0, this->Width - 1));
}

//------------------------------------------------------------------------------
glm::dvec3 EnvironmentTexels::Read(const glm::dvec3& direction) const
{
  glm::dvec2 place;
  const int face = this->PlaceOf(direction, place);
  place = place * glm::dvec2(this->Width, this->Height) - 0.5;
  const glm::dvec2 low = glm::floor(place);
  const glm::dvec2 share = place - low;
  const int x = static_cast<int>(low.x);
  const int y = static_cast<int>(low.y);
  return glm::mix(glm::mix(this->Fetch(face, x, y), this->Fetch(face, x + 1, y), share.x),
    glm::mix(this->Fetch(face, x, y + 1), this->Fetch(face, x + 1, y + 1), share.x), share.y);
}
}
