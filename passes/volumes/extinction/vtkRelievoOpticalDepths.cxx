// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpticalDepths.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoVolumeExtinction.h"

#include <glm/common.hpp>
#include <glm/ext/scalar_constants.hpp>
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

// The values that are stored of a ray: depths at its nodes, or the terms of a series.
class Series
{
public:
  Series(int pieces, int harmonics)
  {
    // The extinction is constant in each piece.
    const double turn = 2.0 * glm::pi<double>();
    for (int m = 1; m <= harmonics; ++m)
    {
      for (int k = 0; k < pieces; ++k)
      {
        const double half = 0.5 * turn * m / pieces;
        const double middle = turn * m * (k + 0.5) / pieces;
        const double width = 2.0 * std::sin(half) / half / (turn * m);
        this->Cosines.push_back(static_cast<float>(width * std::cos(middle)));
        this->Sines.push_back(static_cast<float>(width * std::sin(middle)));
      }
    }
  }

  // `stride`: between two stored values.
  template <typename Value>
  void Store(const std::vector<Value>& parts, Value* to, std::size_t stride) const
  {
    Value sum(0.f);
    if (this->Cosines.empty())
    {
      for (std::size_t k = 0; k < parts.size(); ++k)
      {
        sum += parts[k];
        to[(k + 1) * stride] = sum;
      }
      return;
    }
    std::vector<Value> dimming(parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      const Value before = sum;
      sum = glm::min(sum + parts[k], Value(vtkRelievoOpticalDepths::Deepest));
      dimming[k] = sum - before;
    }
    to[0] = sum;
    for (std::size_t first = 0; first < this->Cosines.size(); first += parts.size())
    {
      Value even(0.f);
      Value odd(0.f);
      for (std::size_t k = 0; k < parts.size(); ++k)
      {
        even += this->Cosines[first + k] * dimming[k];
        odd += this->Sines[first + k] * dimming[k];
      }
      const std::size_t m = first / parts.size();
      to[(2 * m + 1) * stride] = even;
      to[(2 * m + 2) * stride] = odd;
    }
  }

private:
  std::vector<float> Cosines; // of each harmonic, for each piece
  std::vector<float> Sines;
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
vtkRelievoOpticalDepths::Extent vtkRelievoOpticalDepths::GetExtent(
  const std::vector<vtkRelievoVolumeExtinction>& fields)
{
  Extent extent;
  for (const vtkRelievoVolumeExtinction& field : fields)
  {
    if (extent.Corners.empty())
    {
      extent.Spacing = field.GetSpacing();
      extent.Axes = field.GetAxes();
    }
    extent.Corners.insert(
      extent.Corners.end(), field.GetCorners().begin(), field.GetCorners().end());
    extent.Spacing = std::min(extent.Spacing, field.GetSpacing());
    extent.Tinted = extent.Tinted || field.HasTints();
  }
  return extent;
}

//------------------------------------------------------------------------------
void vtkRelievoOpticalDepths::Lay(
  const Extent& extent, const Source& source, int most, int harmonics)
{
  this->ReleaseNodes();
  this->Harmonics = harmonics;
  this->Size = glm::ivec3(0);
  const std::vector<glm::dvec3>& corners = extent.Corners;
  const double spacing = extent.Spacing;
  if (corners.empty())
  {
    return;
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
  const glm::dvec3 u = GetAcross(extent.Axes, axis);
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
    this->GetRay = [=](double i, double j, glm::dvec3& from, glm::dvec3& step) {
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
    this->GetRay = [=](double i, double j, glm::dvec3& from, glm::dvec3& step) {
      const glm::dvec3 side =
        u * (x.Low + (i - 0.5) * texel[0]) + v * (y.Low + (j - 0.5) * texel[1]);
      const glm::dvec3 ray = source.Positional ? axis + side : axis;
      from = origin + (source.Positional ? z.Low * ray : side + z.Low * ray);
      step = piece * ray;
    };
  }
  this->Samples = std::max(1, static_cast<int>(std::ceil(z.GetPiece(pieces) / spacing - 1e-6)));
  this->Size = glm::ivec3(across[0] + 2, across[1] + 2, pieces + 1);
}

//------------------------------------------------------------------------------
void vtkRelievoOpticalDepths::Make(const std::vector<vtkRelievoVolumeExtinction>& fields,
  const Source& source, int most, int harmonics)
{
  const Extent extent = GetExtent(fields);
  this->Lay(extent, source, most, harmonics);
  this->Fill(fields, extent.Tinted);
}

//------------------------------------------------------------------------------
void vtkRelievoOpticalDepths::Fill(
  const std::vector<vtkRelievoVolumeExtinction>& fields, bool tinted)
{
  const auto slice = static_cast<std::size_t>(this->Size.x) * this->Size.y;
  const int stored = this->GetStored().z;
  const Series series(this->Size.z - 1, this->Harmonics);
  this->Depths.assign(slice * stored, 0.f);
  this->Tints.assign(tinted ? slice * stored : 0, glm::vec3(0.f));
  vtkRelievoForAll(this->Size.y, [&](vtkIdType j) {
    const int pieces = this->Size.z - 1;
    const auto width = static_cast<std::size_t>(this->Size.x);
    std::vector<float> ray(pieces);
    std::vector<glm::vec3> tints(tinted ? pieces : 0);
    std::vector<float> row(width * stored);
    std::vector<glm::vec3> tintedRow(tinted ? row.size() : 0);
    for (std::size_t i = 0; i < width; ++i)
    {
      this->March(fields, static_cast<int>(i), static_cast<int>(j), ray, tints);
      series.Store(ray, &row[i], width);
      if (tinted)
      {
        series.Store(tints, &tintedRow[i], width);
      }
    }
    for (int k = 0; k < stored; ++k)
    {
      const auto to = static_cast<std::ptrdiff_t>(slice * k + j * width);
      std::copy_n(
        row.begin() + static_cast<std::ptrdiff_t>(k * width), width, this->Depths.begin() + to);
      if (tinted)
      {
        std::copy_n(tintedRow.begin() + static_cast<std::ptrdiff_t>(k * width), width,
          this->Tints.begin() + to);
      }
    }
  });
}

//------------------------------------------------------------------------------
// The pieces of a texel's ray.
void vtkRelievoOpticalDepths::March(const std::vector<vtkRelievoVolumeExtinction>& fields, int i,
  int j, std::vector<float>& depths, std::vector<glm::vec3>& tints) const
{
  glm::dvec3 from;
  glm::dvec3 step;
  this->GetRay(i, j, from, step);
  std::fill(depths.begin(), depths.end(), 0.f);
  std::fill(tints.begin(), tints.end(), glm::vec3(0.f));
  for (const vtkRelievoVolumeExtinction& field : fields)
  {
    field.AddDepths(from, step, this->Samples, depths, tints);
  }
}

//------------------------------------------------------------------------------
// False where no ray leads.
bool vtkRelievoOpticalDepths::FindTexel(const glm::dvec3& world, glm::dvec3& texel) const
{
  const glm::dvec4 map = this->WorldToMap * glm::dvec4(world, 1.0);
  if (this->Size.x == 0 || (!this->Around && map.w <= 0.0))
  {
    return false;
  }
  const glm::dvec3 size(this->Size);
  texel = this->Around ? relievo::f64::relievoVolumeTexelAround(map, size)
                       : relievo::f64::relievoVolumeTexel(map, size);
  return true;
}

//------------------------------------------------------------------------------
double vtkRelievoOpticalDepths::GetDepth(const glm::dvec3& world) const
{
  glm::dvec3 texel;
  if (this->Depths.empty() || !this->FindTexel(world, texel))
  {
    return 0.0;
  }
  if (this->Harmonics == 0)
  {
    return this->Interpolate(texel);
  }
  const auto term = [&](int number) { return this->Interpolate({ texel.x, texel.y, number }); };
  const double share = texel.z / (this->Size.z - 1);
  double depth = share * term(0);
  for (int m = 1; m <= this->Harmonics; ++m)
  {
    const double turn = 2.0 * glm::pi<double>() * m * share;
    depth += term(2 * m - 1) * std::sin(turn) + term(2 * m) * (1.0 - std::cos(turn));
  }
  return std::max(depth, 0.0);
}

//------------------------------------------------------------------------------
// Between stored values.
double vtkRelievoOpticalDepths::Interpolate(const glm::dvec3& texel) const
{
  const glm::ivec3 size = this->GetStored();
  double depth = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::size_t at = 0;
    for (int i = 2; i >= 0; --i)
    {
      const int low = std::min(static_cast<int>(texel[i]), std::max(0, size[i] - 2));
      const double part = texel[i] - low;
      const int step = corner >> i & 1;
      weight *= step ? part : 1.0 - part;
      at = at * size[i] + std::min(low + step, size[i] - 1);
    }
    depth += weight * this->Depths[at];
  }
  return depth;
}

//------------------------------------------------------------------------------
double vtkRelievoOpticalDepths::GetExactDepth(const std::vector<vtkRelievoVolumeExtinction>& fields,
  const Source& source, const glm::dvec3& world)
{
  double depth = 0.0;
  for (const vtkRelievoVolumeExtinction& field : fields)
  {
    double far = 0.0; // of the field's corners, towards the light
    for (const glm::dvec3& corner : field.GetCorners())
    {
      far = std::max(far, glm::length(corner - world));
    }
    depth += field.GetDepth(
      source.Positional ? source.Position : world - 1.01 * far * source.Direction, world);
  }
  return depth;
}

//------------------------------------------------------------------------------
double vtkRelievoOpticalDepths::EstimateWrongShare(
  const std::vector<vtkRelievoVolumeExtinction>& fields, const Source& source, double slack,
  int places) const
{
  std::vector<char> shaded(places, 0);
  std::vector<char> differs(places, 0);
  vtkRelievoForAll(places, [&](vtkIdType place) {
    // R. Kronecker's sequence, by the plastic number's powers: even, and equal on every machine.
    const double number = static_cast<double>(place) + 1.0;
    const glm::dvec3 share =
      glm::fract(glm::dvec3(0.5) + number * glm::dvec3(0.8191725134, 0.6710436067, 0.5497004779));
    // A third of the places is behind the volumes.
    const glm::dvec3 texel(share.x * (this->Size.x - 1.001), share.y * (this->Size.y - 1.001),
      std::min(1.5 * share.z, 1.0) * (this->Size.z - 1));
    const glm::ivec3 low(glm::min(texel, glm::dvec3(this->Size) - 2.0));
    std::vector<float> ray(this->Size.z - 1);
    std::vector<glm::vec3> none;
    double depth = 0.0;
    glm::dvec3 from;
    glm::dvec3 step;
    this->GetRay(texel.x, texel.y, from, step);
    const glm::dvec3 world = from + texel.z * step;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int i = low.x + (corner & 1);
      const int j = low.y + (corner >> 1);
      const double x = texel.x - low.x;
      const double y = texel.y - low.y;
      const double weight = (corner & 1 ? x : 1.0 - x) * (corner >> 1 ? y : 1.0 - y);
      this->March(fields, i, j, ray, none);
      double sum = 0.0;
      for (int k = 0; k < low.z; ++k)
      {
        sum += ray[k];
      }
      depth += weight * (sum + (texel.z - low.z) * ray[low.z]);
    }
    const double exact = std::exp(-GetExactDepth(fields, source, world));
    const double drawn = std::exp(-depth);
    shaded[place] = exact < 1.0 - slack || drawn < 1.0 - slack;
    differs[place] = std::abs(exact - drawn) > slack;
  });
  const double count = static_cast<double>(std::count(shaded.begin(), shaded.end(), 1));
  return count > 0.0 ? static_cast<double>(std::count(differs.begin(), differs.end(), 1)) / count
                     : -1.0;
}
