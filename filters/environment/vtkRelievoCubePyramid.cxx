// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCubePyramid.h"

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
// Solid angle of the rectangle from a face's middle to (x, y) in its plane.
double CornerAngle(double x, double y)
{
  return std::atan2(x * y, std::sqrt(x * x + y * y + 1.));
}

double SolidAngle(int size, int column, int row)
{
  const double x0 = 2. * column / size - 1.;
  const double y0 = 2. * row / size - 1.;
  const double x1 = 2. * (column + 1) / size - 1.;
  const double y1 = 2. * (row + 1) / size - 1.;
  return CornerAngle(x1, y1) - CornerAngle(x0, y1) - CornerAngle(x1, y0) + CornerAngle(x0, y0);
}

// Mean of all directions of a square. The integral of directions over the square is the sum over
// its edges of half their angle times the normal of their plane.
f64::vec3 MeanDirection(int face, int size, int column, int row)
{
  f64::vec3 corners[4];
  for (int k = 0; k < 4; ++k)
  {
    // The corners in order: (0, 0), (1, 0), (1, 1), (0, 1).
    const f64::vec2 at(column + (k == 1 || k == 2 ? 1. : 0.), row + k / 2);
    corners[k] =
      glm::normalize(f64::relievoDirectionFromCube(at / static_cast<double>(size), face));
  }
  f64::vec3 sum(0.);
  for (int k = 0; k < 4; ++k)
  {
    const f64::vec3 normal = glm::cross(corners[k], corners[(k + 1) % 4]);
    const double sine = glm::length(normal);
    sum += 0.5 * std::atan2(sine, glm::dot(corners[k], corners[(k + 1) % 4])) / sine * normal;
  }
  // Either winding gives the mean up to its sign.
  const f64::vec3 mean = sum / SolidAngle(size, column, row);
  return glm::dot(mean, corners[0]) < 0. ? -mean : mean;
}

float Brightness(const f32::vec3& light)
{
  return (std::abs(light.x) + std::abs(light.y) + std::abs(light.z)) / 3.f;
}

// The integral of relievoPrefilterWeight over the sphere: that of x / (g g), with g = a - b x.
double WholeWeight(double roughness)
{
  const double alpha2 = std::pow(roughness, 4.);
  const double a = 0.5 * (1. + alpha2);
  const double b = 0.5 * (1. - alpha2);
  return b < 1e-3 ? f64::relievoPi
                  : 2. * f64::relievoPi / (b * b) * (std::log(alpha2 / a) + a / alpha2 - 1.);
}

// Limit of divisions of a texel for lobes narrower than texels.
constexpr int PartsOfTexels = 4;
}

struct CubePyramid::Lobe
{
  f32::vec3 Axis;
  float Alpha2;
  float Brightness; // of the result, as estimated so far
  float Most;       // error that a square may have
  f64::vec3 Light = f64::vec3(0.);
  double Weight = 0.;

  // relievoPrefilterWeight, with the power computed only once.
  float At(float x) const
  {
    const float width = 0.5f * ((1.f - x) + this->Alpha2 * (1.f + x));
    return x > 0.f ? x / (width * width) : 0.f;
  }

  // Adds a whole square; false if it must be divided.
  bool Take(const f32::vec3& direction, float solidAngle, const f32::vec3& light, float unevenness,
    bool last)
  {
    const float x = glm::dot(this->Axis, direction); // the mean cosine
    const float radius =
      std::sqrt(solidAngle); // at least that of the square's circumscribed circle
    const float across = std::sqrt(std::max(1.f - x * x, 0.f)) * radius;
    const float reach = across + 0.5f * solidAngle;
    if (x + reach <= 0.f)
    {
      return true; // below the horizon
    }
    const float weight = this->At(x);
    const float inner = this->At(std::min(x + reach, 1.f));
    const float outer = this->At(x - reach);
    // The variance of a square's cosines about their mean is a twelfth of `across` squared.
    const float bend = (inner + outer - 2.f * weight) * (across * across) / (24.f * reach * reach);
    if (!last)
    {
      const float change = std::max(std::abs(inner - weight), std::abs(weight - outer));
      const float contrast =
        relievo::Brightness(light - this->Brightness) + 0.1f * this->Brightness;
      // With an inflection, the bend may be 0 although the weight changes.
      const float error = std::max(std::abs(bend), change / 64.f);
      if (solidAngle * error * contrast > this->Most || change * unevenness > 2.f * this->Most)
      {
        return false;
      }
    }
    const double part = static_cast<double>(weight + bend) * solidAngle;
    this->Light += part * f64::vec3(light);
    this->Weight += part;
    return true;
  }
};

//------------------------------------------------------------------------------
CubePyramid::CubePyramid(const float* texels, int size)
{
  for (int n = size; n > 0; n /= 2)
  {
    Level level = { n, std::vector<Square>(static_cast<std::size_t>(6) * n * n) };
    std::size_t index = 0;
    for (int face = 0; face < 6; ++face)
    {
      for (int row = 0; row < n; ++row)
      {
        for (int column = 0; column < n; ++column, ++index)
        {
          Square& square = level.Squares[index];
          square.Direction = f32::vec3(MeanDirection(face, n, column, row));
          square.SolidAngle = static_cast<float>(SolidAngle(n, column, row));
          if (n == size)
          {
            square.Light =
              f32::vec3(texels[3 * index], texels[3 * index + 1], texels[3 * index + 2]);
            square.Unevenness = 0.f;
            continue;
          }
          const Level& below = this->Levels.back();
          const Square* parts[4];
          f64::vec3 sum(0.);
          double angle = 0.;
          for (int k = 0; k < 4; ++k)
          {
            parts[k] =
              &below.Squares[(static_cast<std::size_t>(face) * below.Size + 2 * row + k / 2) *
                  below.Size +
                2 * column + k % 2];
            sum += static_cast<double>(parts[k]->SolidAngle) * f64::vec3(parts[k]->Light);
            angle += parts[k]->SolidAngle;
          }
          square.Light = f32::vec3(sum / angle);
          square.Unevenness = 0.f;
          for (const Square* part : parts)
          {
            square.Unevenness +=
              part->Unevenness + part->SolidAngle * Brightness(part->Light - square.Light);
          }
        }
      }
    }
    this->Levels.push_back(std::move(level));
  }
  for (const Square& face : this->Levels.back().Squares)
  {
    this->MeanBrightness += Brightness(face.Light) / 6.;
  }
}

//------------------------------------------------------------------------------
void CubePyramid::Visit(Lobe& lobe, int level, std::size_t index) const
{
  const Level& here = this->Levels[level];
  const Square& square = here.Squares[index];
  if (lobe.Take(square.Direction, square.SolidAngle, square.Light, square.Unevenness, false))
  {
    return;
  }
  const int column = static_cast<int>(index % here.Size);
  const int row = static_cast<int>(index / here.Size % here.Size);
  const auto face = static_cast<int>(index / here.Size / here.Size);
  if (level == 0)
  {
    this->VisitParts(lobe, square.Light, face, 2 * here.Size, 2 * column, 2 * row, PartsOfTexels);
    return;
  }
  const std::size_t size = 2 * static_cast<std::size_t>(here.Size);
  const std::size_t first = (face * size + 2 * row) * size + 2 * column;
  this->Visit(lobe, level - 1, first);
  this->Visit(lobe, level - 1, first + 1);
  this->Visit(lobe, level - 1, first + size);
  this->Visit(lobe, level - 1, first + size + 1);
}

//------------------------------------------------------------------------------
void CubePyramid::VisitParts(
  Lobe& lobe, const f32::vec3& light, int face, int size, int column, int row, int depth) const
{
  for (int k = 0; k < 4; ++k)
  {
    const int i = column + k % 2;
    const int j = row + k / 2;
    if (!lobe.Take(f32::vec3(MeanDirection(face, size, i, j)),
          static_cast<float>(SolidAngle(size, i, j)), light, 0.f, depth == 0))
    {
      this->VisitParts(lobe, light, face, 2 * size, 2 * i, 2 * j, depth - 1);
    }
  }
}

//------------------------------------------------------------------------------
f64::vec3 CubePyramid::LobeMean(const f64::vec3& axis, double roughness, double tolerance) const
{
  const double whole = WholeWeight(roughness);
  const double least = 1e-6 * this->MeanBrightness;
  double brightness = this->MeanBrightness;
  f64::vec3 mean(0.);
  // The tolerance and the contrast depend on the result: repeat while the result is far from its
  // estimate.
  for (int pass = 0; pass < 6; ++pass)
  {
    Lobe lobe;
    lobe.Axis = f32::vec3(axis);
    lobe.Alpha2 = static_cast<float>(std::pow(roughness, 4.));
    lobe.Brightness = static_cast<float>(brightness);
    lobe.Most = static_cast<float>(tolerance * whole * brightness);
    for (std::size_t face = 0; face < 6; ++face)
    {
      this->Visit(lobe, static_cast<int>(this->Levels.size()) - 1, face);
    }
    mean = lobe.Weight > 0. ? lobe.Light / lobe.Weight : f64::vec3(0.);
    const double found = std::max<double>(Brightness(f32::vec3(mean)), least);
    if (found >= 0.5 * brightness && found <= 2. * brightness)
    {
      break;
    }
    brightness = found;
  }
  return mean;
}
}
