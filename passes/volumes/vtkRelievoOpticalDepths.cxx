// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpticalDepths.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoVolumeExtinction.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

// The shader's formula, in double.
namespace relievo
{
namespace f64
{
namespace
{
#define float double
#include "volumes/texel.glsl"
#undef float
}
}
}

namespace
{
// Wider than this tangent of the angle to the axis, rays go in all directions.
constexpr double Widest = 1.5;

struct Range
{
  double Low = 0.0;
  double High = 0.0;
  bool Any = false;

  void Add(double value)
  {
    this->Low = this->Any ? std::min(this->Low, value) : value;
    this->High = this->Any ? std::max(this->High, value) : value;
    this->Any = true;
  }
  // Pieces of about this width.
  int Count(double width, int most) const
  {
    const double pieces = std::ceil((this->High - this->Low) / width - 1e-6);
    return static_cast<int>(std::min(std::max(pieces, 1.0), static_cast<double>(most)));
  }
  double GetPiece(int pieces) const
  {
    const double piece = (this->High - this->Low) / pieces;
    return piece > 0.0 ? piece : 1.0;
  }
};

// An axis across the direction, along an axis of the volume if one is: so the sides of a box lie
// between rays.
glm::dvec3 GetAcross(const glm::dmat3& axes, const glm::dvec3& direction)
{
  glm::dvec3 best(0.0);
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 axis = glm::normalize(axes[i]);
    const glm::dvec3 across = axis - direction * glm::dot(axis, direction);
    best = glm::length(across) > glm::length(best) + 1e-6 ? across : best;
  }
  return glm::normalize(best);
}

// The direction with these shares of longitude and of the angle to the third axis, also beyond 0
// and 1.
glm::dvec3 GetDirection(double longitude, double angle)
{
  constexpr double HalfTurn = 3.14159265358979;
  const double phi = (2.0 * longitude - 1.0) * HalfTurn;
  const double theta = angle * HalfTurn;
  return { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
}
}

//------------------------------------------------------------------------------
void vtkRelievoOpticalDepths::Make(
  const std::vector<vtkRelievoVolumeExtinction>& fields, const Source& source, int most)
{
  this->Depths.clear();
  this->Size = glm::ivec3(0);
  if (fields.empty())
  {
    return;
  }
  std::vector<glm::dvec3> corners;
  double spacing = fields[0].GetSpacing();
  for (const vtkRelievoVolumeExtinction& field : fields)
  {
    corners.insert(corners.end(), field.GetCorners().begin(), field.GetCorners().end());
    spacing = std::min(spacing, field.GetSpacing());
  }
  glm::dvec3 center(0.0);
  for (const glm::dvec3& corner : corners)
  {
    center += corner / static_cast<double>(corners.size());
  }
  const glm::dvec3 away = center - source.Position;
  const glm::dvec3 axis = glm::normalize(!source.Positional ? source.Direction
      : glm::length(away) > 0.0                             ? away
                                                            : glm::dvec3(0.0, 0.0, 1.0));
  const glm::dvec3 u = GetAcross(fields[0].GetAxes(), axis);
  const glm::dvec3 v = glm::cross(axis, u);
  const glm::dvec3 origin = source.Positional ? source.Position : center;

  Range x;
  Range y;
  Range z;
  this->Around = false;
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 off = corner - origin;
    const double far = glm::dot(off, axis);
    const double scale = source.Positional ? far : 1.0;
    x.Add(glm::dot(off, u) / scale);
    y.Add(glm::dot(off, v) / scale);
    z.Add(far);
    this->Around = this->Around || (source.Positional && far <= 0.0);
  }
  this->Around =
    this->Around || (source.Positional && std::max({ -x.Low, x.High, -y.Low, y.High }) > Widest);

  int across[2];
  int pieces = 0;
  std::function<void(int, int, glm::dvec3&, glm::dvec3&)> getRay; // at a texel
  if (this->Around)
  {
    z = Range();
    z.Add(0.0);
    for (const glm::dvec3& corner : corners)
    {
      z.Add(glm::length(corner - origin));
    }
    pieces = z.Count(spacing, most);
    const double piece = z.GetPiece(pieces);
    // At the farthest corner of the volumes a texel is about as wide as a voxel.
    across[0] = std::min(most, std::max(16, 6 * pieces));
    across[1] = std::min(most, std::max(16, 3 * pieces));
    this->WorldToMap = glm::dmat4(1.0 / piece);
    this->WorldToMap[3] = glm::dvec4(-origin / piece, 0.0);
    getRay = [=](int i, int j, glm::dvec3& from, glm::dvec3& step) {
      from = origin;
      step = piece * GetDirection((i - 0.5) / across[0], (j - 0.5) / across[1]);
    };
  }
  else
  {
    const double width = source.Positional ? spacing / glm::length(away) : spacing;
    across[0] = x.Count(width, most);
    across[1] = y.Count(width, most);
    pieces = z.Count(spacing, most);
    const double texel[2] = { x.GetPiece(across[0]), y.GetPiece(across[1]) };
    const double piece = z.GetPiece(pieces);
    // The sides of the volumes lie between a ray past them and the first one through them.
    const auto row = [&](const glm::dvec3& along, double low, double wide) {
      const glm::dvec3 scaled =
        source.Positional ? along / wide + axis * (0.5 - low / wide) : along / wide;
      return glm::dvec4(
        scaled, -glm::dot(scaled, origin) + (source.Positional ? 0.0 : 0.5 - low / wide));
    };
    const glm::dvec4 last = source.Positional ? glm::dvec4(axis, -glm::dot(axis, origin))
                                              : glm::dvec4(0.0, 0.0, 0.0, 1.0);
    this->WorldToMap = glm::transpose(glm::dmat4(row(u, x.Low, texel[0]), row(v, y.Low, texel[1]),
      glm::dvec4(axis / piece, -(glm::dot(axis, origin) + z.Low) / piece), last));
    getRay = [=](int i, int j, glm::dvec3& from, glm::dvec3& step) {
      const glm::dvec3 side =
        u * (x.Low + (i - 0.5) * texel[0]) + v * (y.Low + (j - 0.5) * texel[1]);
      const glm::dvec3 ray = source.Positional ? axis + side : axis;
      from = origin + (source.Positional ? z.Low * ray : side + z.Low * ray);
      step = piece * ray;
    };
  }
  const int samples = std::max(1, static_cast<int>(std::ceil(z.GetPiece(pieces) / spacing - 1e-6)));
  this->Size = glm::ivec3(across[0] + 2, across[1] + 2, pieces + 1);
  const auto slice = static_cast<std::size_t>(this->Size.x) * this->Size.y;
  this->Depths.assign(slice * this->Size.z, 0.f);
  vtkRelievoForAll(this->Size.y, [&](vtkIdType j) {
    std::vector<float> ray(pieces);
    std::vector<float> row(static_cast<std::size_t>(this->Size.x) * this->Size.z);
    for (int i = 0; i < this->Size.x; ++i)
    {
      glm::dvec3 from;
      glm::dvec3 step;
      getRay(i, static_cast<int>(j), from, step);
      std::fill(ray.begin(), ray.end(), 0.f);
      for (const vtkRelievoVolumeExtinction& field : fields)
      {
        field.AddDepths(from, step, samples, ray);
      }
      float sum = 0.f;
      for (int k = 0; k < pieces; ++k)
      {
        sum += ray[k];
        row[static_cast<std::size_t>(k + 1) * this->Size.x + i] = sum;
      }
    }
    for (int k = 0; k < this->Size.z; ++k)
    {
      std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(k) * this->Size.x, this->Size.x,
        this->Depths.begin() + static_cast<std::ptrdiff_t>(slice * k + j * this->Size.x));
    }
  });
}

//------------------------------------------------------------------------------
double vtkRelievoOpticalDepths::GetDepth(const glm::dvec3& world) const
{
  if (this->Depths.empty())
  {
    return 0.0;
  }
  const glm::dvec4 map = this->WorldToMap * glm::dvec4(world, 1.0);
  if (!this->Around && map.w <= 0.0)
  {
    return 0.0;
  }
  const glm::dvec3 size(this->Size);
  const glm::dvec3 texel = this->Around ? relievo::f64::relievoVolumeTexelAround(map, size)
                                        : relievo::f64::relievoVolumeTexel(map, size);
  double depth = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::size_t at = 0;
    for (int i = 2; i >= 0; --i)
    {
      const int low = std::min(static_cast<int>(texel[i]), std::max(0, this->Size[i] - 2));
      const double part = texel[i] - low;
      const int step = corner >> i & 1;
      weight *= step ? part : 1.0 - part;
      at = at * this->Size[i] + std::min(low + step, this->Size[i] - 1);
    }
    depth += weight * this->Depths[at];
  }
  return depth;
}
