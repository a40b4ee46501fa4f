// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleStart.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStaticPointLocator.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
struct Triangle
{
  glm::dvec3 Corners[3] = { glm::dvec3(0.), glm::dvec3(0.), glm::dvec3(0.) };
  double Area = 0.;
};

// A polygon is a fan of triangles: returns the one that ends at corner `last`, from 2 on.
Triangle GetTriangle(vtkPolyData* surface, vtkIdList* points, vtkIdType last)
{
  Triangle triangle;
  const vtkIdType corners[3] = { 0, last - 1, last };
  for (int i = 0; i < 3; ++i)
  {
    surface->GetPoint(points->GetId(corners[i]), &triangle.Corners[i].x);
  }
  const glm::dvec3* p = triangle.Corners;
  triangle.Area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2.;
  return triangle;
}
}

//------------------------------------------------------------------------------
vtkRelievoParticleStart::vtkRelievoParticleStart(
  const vtkRelievoParticleMaps& maps, bool inside, unsigned int seed)
  : Maps(maps)
  , Inside(inside)
  , Seed(seed)
  , Low(std::numeric_limits<double>::infinity())
  , High(-std::numeric_limits<double>::infinity())
{
  double sum = 0.;
  for (std::size_t v = 0; v < maps.Views.size(); ++v)
  {
    const vtkRelievoParticleView& view = maps.Views[v];
    const auto texels = static_cast<vtkIdType>(view.GetNumberOfTexels());
    std::vector<float> areas(static_cast<std::size_t>(texels), 0.F);
    vtkSMPTools::For(0, texels, 4096, [&](vtkIdType begin, vtkIdType end) {
      for (auto texel = static_cast<std::size_t>(begin); texel < static_cast<std::size_t>(end);
           ++texel)
      {
        if (view.IsSeen(texel))
        {
          const vtkRelievoParticlePlace place = view.At(texel);
          const double square = view.GetTexelSize() * view.GetTexelSize();
          areas[texel] = maps.IsSeenBetter(static_cast<int>(v), place)
            ? 0.F
            : static_cast<float>(square / std::max(place.Facing, 0.1));
        }
      }
    });
    for (std::size_t texel = 0; texel < areas.size(); ++texel)
    {
      if (areas[texel] > 0.F)
      {
        const glm::dvec3 position = view.At(texel).Position;
        this->Low = glm::min(this->Low, position);
        this->High = glm::max(this->High, position);
        sum += static_cast<double>(areas[texel]);
        this->Parts.push_back({ static_cast<int>(v), texel });
        this->Shares.push_back(sum);
      }
    }
  }
  if (!inside)
  {
    this->MeasurePolygons();
  }
  if (inside && !this->Parts.empty())
  {
    this->Space = std::make_unique<vtkRelievoParticleInterior>(maps, this->Low, this->High, seed);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoParticleStart::MeasurePolygons()
{
  double sum = 0.;
  vtkNew<vtkIdList> points;
  for (vtkPolyData* surface : this->Maps.Surfaces)
  {
    if (surface->GetNumberOfStrips() > 0)
    {
      this->Areas.clear(); // particles are spread over texels
      return;
    }
    this->Firsts.push_back(this->Areas.size());
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      surface->GetPolys()->GetCellAtId(cell, points);
      double area = 0.;
      for (vtkIdType i = 2; i < points->GetNumberOfIds(); ++i)
      {
        area += GetTriangle(surface, points, i).Area;
      }
      sum += std::isfinite(area) ? area : 0.;
      this->Areas.push_back(sum);
    }
  }
}

//------------------------------------------------------------------------------
// Samples by area, again if the sample is not visible: even to within the texel by which a position
// is moved.
bool vtkRelievoParticleStart::SpreadOnPolygons(
  vtkIdType i, double share, glm::dvec3& position, int& view) const
{
  constexpr unsigned int Tries = 32;
  vtkNew<vtkIdList> points;
  for (unsigned int attempt = 0; attempt < Tries && !this->Areas.empty(); ++attempt)
  {
    const auto random = [&](unsigned int which) {
      return vtkRelievoParticleRandom(i, 3 * attempt + which, this->Seed);
    };
    const double area = (attempt == 0 ? share : random(0)) * this->Areas.back();
    const auto found = std::upper_bound(this->Areas.begin(), this->Areas.end(), area);
    const auto polygon = static_cast<std::size_t>(std::min<std::ptrdiff_t>(
      found - this->Areas.begin(), static_cast<std::ptrdiff_t>(this->Areas.size()) - 1));
    const auto after = std::upper_bound(this->Firsts.begin(), this->Firsts.end(), polygon);
    const auto which = static_cast<std::size_t>(after - this->Firsts.begin()) - 1;
    vtkPolyData* surface = this->Maps.Surfaces[which];
    surface->GetPolys()->GetCellAtId(static_cast<vtkIdType>(polygon - this->Firsts[which]), points);
    double rest = area - (polygon > 0 ? this->Areas[polygon - 1] : 0.);
    Triangle triangle;
    for (vtkIdType corner = 2; corner < points->GetNumberOfIds(); ++corner)
    {
      triangle = GetTriangle(surface, points, corner);
      rest -= triangle.Area;
      if (rest <= 0.)
      {
        break;
      }
    }
    const double root = std::sqrt(random(1));
    const double across = random(2);
    const glm::dvec3* corners = triangle.Corners;
    position = corners[0] +
      root * ((1. - across) * (corners[1] - corners[0]) + across * (corners[2] - corners[0]));
    if (this->Maps.FindNearest(position, view))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleStart::GetBox(glm::dvec3& low, glm::dvec3& high) const
{
  low = this->Low;
  high = this->High;
  return !this->Parts.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoParticleStart::SpreadOne(
  vtkIdType i, vtkIdType count, glm::dvec3& position, int& view) const
{
  view = 0;
  if (this->Space && this->Space->Find(i, position))
  {
    return;
  }
  const auto random = [&](unsigned int which) {
    return vtkRelievoParticleRandom(i, which, this->Seed);
  };
  const double share = (static_cast<double>(i) + random(0)) / static_cast<double>(count);
  if (this->SpreadOnPolygons(i, share, position, view))
  {
    return;
  }
  const auto found =
    std::upper_bound(this->Shares.begin(), this->Shares.end(), share * this->Shares.back());
  const auto index = std::min<std::ptrdiff_t>(
    found - this->Shares.begin(), static_cast<std::ptrdiff_t>(this->Parts.size()) - 1);
  const Part& part = this->Parts[static_cast<std::size_t>(index)];
  view = part.View;
  position = this->Maps.Views[static_cast<std::size_t>(view)]
               .At(part.Texel, 0.998 * (random(1) - 0.5), 0.998 * (random(2) - 0.5))
               .Position;
  if (this->Inside)
  {
    this->Maps.PushInside(position, 4. * this->Maps.GetTexelSize());
  }
}

//------------------------------------------------------------------------------
vtkRelievoParticleState vtkRelievoParticleStart::Spread(
  vtkIdType begin, vtkIdType end, vtkIdType count) const
{
  vtkRelievoParticleState state;
  if (this->Parts.empty() || begin >= end)
  {
    return state;
  }
  state.Positions.resize(static_cast<std::size_t>(end - begin));
  state.Views.resize(state.Positions.size());
  vtkSMPTools::For(begin, end, 4096, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const auto at = static_cast<std::size_t>(i - begin);
      int view = 0;
      this->SpreadOne(i, count, state.Positions[at], view);
      state.Views[at] = static_cast<unsigned char>(view);
    }
  });
  return state;
}

//------------------------------------------------------------------------------
vtkRelievoParticleState vtkRelievoParticleStart::AtPoints(
  vtkDataSet* points, vtkIdType begin, vtkIdType end) const
{
  vtkRelievoParticleState state = this->Spread(begin, end, points->GetNumberOfPoints());
  if (state.Positions.empty())
  {
    return state;
  }
  vtkNew<vtkPoints> centers;
  centers->SetDataTypeToDouble();
  centers->SetNumberOfPoints(static_cast<vtkIdType>(this->Parts.size()));
  vtkSMPTools::For(0, centers->GetNumberOfPoints(), 4096, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const Part& part = this->Parts[static_cast<std::size_t>(i)];
      const auto& view = this->Maps.Views[static_cast<std::size_t>(part.View)];
      const glm::dvec3 center = view.At(part.Texel).Position;
      centers->SetPoint(i, &center.x);
    }
  });
  vtkNew<vtkPolyData> seen;
  seen->SetPoints(centers);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(seen);
  locator->BuildLocator();
  double any[3];
  points->GetPoint(0, any); // a data set may first build caches, which threads then share
  vtkSMPTools::For(begin, end, 1024, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const auto at = static_cast<std::size_t>(i - begin);
      glm::dvec3 position;
      points->GetPoint(i, &position.x);
      if (!(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)))
      {
        continue;
      }
      if (this->Inside && this->Maps.IsInside(position))
      {
        state.Positions[at] = position;
        continue;
      }
      const vtkIdType nearest = locator->FindClosestPoint(&position.x);
      const Part& part = this->Parts[static_cast<std::size_t>(std::max<vtkIdType>(nearest, 0))];
      const auto& view = this->Maps.Views[static_cast<std::size_t>(part.View)];
      vtkRelievoParticlePlace place = view.At(part.Texel);
      vtkRelievoParticlePlace held;
      if (view.Find(position, false, held) &&
        glm::distance(held.Position, position) < glm::distance(place.Position, position))
      {
        place = held;
      }
      state.Positions[at] = place.Position;
      state.Views[at] = static_cast<unsigned char>(part.View);
      if (this->Inside)
      {
        this->Maps.PushInside(state.Positions[at], 4. * this->Maps.GetTexelSize());
      }
    }
  });
  return state;
}
