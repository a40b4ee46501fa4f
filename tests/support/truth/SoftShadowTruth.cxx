// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SoftShadowTruth.h"

#include "EmbreeScene.h"

#include <vtkLight.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace relievoTest
{
namespace
{
constexpr int Cells = 32;
constexpr int FirstCells = 8;
constexpr double Jitter = 1e-5; // of the pixel's position
constexpr double Pi = 3.14159265358979323846;

// A number from 0 to 1 that depends only on n.
double Hash(std::uint32_t n)
{
  n ^= n >> 16;
  n *= 0x7feb352du;
  n ^= n >> 15;
  n *= 0x846ca68bu;
  n ^= n >> 16;
  return n / 4294967296.;
}

struct Source
{
  bool Positional;
  bool Spot;
  glm::dvec3 Position;
  glm::dvec3 Axis;
  double Size; // radius, or half the angle in radians
  const LightEdges* Edges;

  // The vector to a point of the light, or to infinity for a sun. Equal areas of the unit square
  // are equal areas of the light.
  glm::dvec3 Toward(const glm::dvec3& from, double u, double v) const
  {
    if (this->Edges)
    {
      return this->Position + (u - 0.5) * this->Edges->First + (v - 0.5) * this->Edges->Second -
        from;
    }
    const double x = std::sqrt(u) * std::cos(2. * Pi * v);
    const double y = std::sqrt(u) * std::sin(2. * Pi * v);
    const glm::dvec3 axis =
      this->Spot || !this->Positional ? this->Axis : glm::normalize(from - this->Position);
    const glm::dvec3 any = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, any));
    const glm::dvec3 up = glm::cross(axis, right);
    if (!this->Positional)
    {
      // Maps equal areas of the disc to equal solid angles: 1 - cosine grows with the area.
      const double cosine = 1. - (x * x + y * y) * (1. - std::cos(this->Size));
      const double turn = std::atan2(y, x);
      const double sine = std::sqrt(std::max(0., 1. - cosine * cosine));
      return sine * (std::cos(turn) * right + std::sin(turn) * up) - cosine * axis;
    }
    if (!this->Spot)
    {
      // To the ball's front, evenly over the area visible to a surface that faces it.
      const double far = glm::length(this->Position - from);
      const glm::dvec3 off = this->Size / far * (x * right + y * up);
      const double sine2 = glm::dot(off, off);
      const double cosine = std::sqrt(1. - sine2);
      const double to =
        far * cosine - std::sqrt(std::max(0., this->Size * this->Size - far * far * sine2));
      return to * (off - cosine * axis);
    }
    return this->Position + this->Size * (x * right + y * up) - from;
  }
};

double GetShare(const EmbreeScene& scene, const SurfacePoint& point, const Source& source,
  int cells, std::uint32_t seed)
{
  const double far = source.Positional ? 1. : std::numeric_limits<double>::infinity();
  int lit = 0;
  for (int i = 0; i < cells * cells; ++i)
  {
    const double u = (i / cells + Hash(seed + 2u * i)) / cells;
    const double v = (i % cells + Hash(seed + 2u * i + 1u)) / cells;
    const glm::dvec3 way = source.Toward(point.Position, u, v);
    if (glm::dot(way, point.Normal) > 0.)
    {
      const Ray ray{ point.Position, way };
      const double first = 1e-6 * scene.Size() / glm::length(way);
      lit += scene.Cast(ray, first, far, point.Triangle).Hit ? 0 : 1;
    }
  }
  return static_cast<double>(lit) / (cells * cells);
}
}

//------------------------------------------------------------------------------
SoftShadowTruth TraceSoftShadow(const EmbreeScene& scene, const TruthImage& view, vtkLight* light,
  double size, const LightEdges* edges)
{
  Source source;
  source.Edges = edges;
  glm::dvec3 focus;
  light->GetTransformedPosition(source.Position.x, source.Position.y, source.Position.z);
  light->GetTransformedFocalPoint(focus.x, focus.y, focus.z);
  source.Axis = glm::normalize(focus - source.Position);
  source.Positional = light->GetPositional() != 0;
  source.Spot = source.Positional && light->GetConeAngle() < 90.;
  source.Size = source.Positional ? size : 0.5 * glm::radians(size);
  const double cosine = std::cos(glm::radians(light->GetConeAngle()));

  SoftShadowTruth truth;
  truth.Shares.assign(view.Pixels.size(), -1.f);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(view.Pixels.size()), [&](vtkIdType from, vtkIdType to) {
      for (vtkIdType i = from; i < to; ++i)
      {
        const PixelTruth& pixel = view.Pixels[i];
        const glm::dvec3 middle =
          source.Positional ? source.Position - pixel.Position : -source.Axis;
        const glm::dvec3 unit = glm::normalize(middle);
        if (!pixel.Hit || glm::dot(pixel.Normal, unit) <= 0.05 ||
          (source.Spot && glm::dot(-unit, source.Axis) < cosine + 1e-3))
        {
          continue;
        }
        const double far = source.Positional ? 1. : std::numeric_limits<double>::infinity();
        if (!scene.Shadow(pixel, middle, far, Jitter).Stable)
        {
          continue;
        }
        const auto seed = static_cast<std::uint32_t>(i) * 7919u;
        double share = GetShare(scene, pixel, source, FirstCells, seed);
        if (share > 0. && share < 1.)
        {
          share = GetShare(scene, pixel, source, Cells, seed);
        }
        truth.Shares[i] = static_cast<float>(share);
      }
    });
  return truth;
}

//------------------------------------------------------------------------------
SoftShadowErrors CompareSoftShadow(const SoftShadowTruth& truth, const float* visibility)
{
  SoftShadowErrors errors;
  double all = 0.;
  double penumbra = 0.;
  double mean = 0.;
  for (std::size_t i = 0; i < truth.Shares.size(); ++i)
  {
    const float share = truth.Shares[i];
    if (share < 0.f)
    {
      continue;
    }
    const double error = visibility[i] - share;
    ++errors.Compared;
    all += error * error;
    if (share > 0.f && share < 1.f)
    {
      ++errors.Penumbra;
      penumbra += error * error;
      mean += error;
    }
  }
  errors.Rms = std::sqrt(all / static_cast<double>(errors.Compared));
  errors.PenumbraRms = std::sqrt(penumbra / static_cast<double>(errors.Penumbra));
  errors.PenumbraMean = mean / static_cast<double>(errors.Penumbra);
  return errors;
}

//------------------------------------------------------------------------------
std::string SoftShadowErrors::ToString() const
{
  std::ostringstream out;
  out << "rms error " << this->Rms << " of " << this->Compared << " pixels, " << this->PenumbraRms
      << " of " << this->Penumbra << " in the penumbra (mean " << this->PenumbraMean << ")";
  return out.str();
}
}
