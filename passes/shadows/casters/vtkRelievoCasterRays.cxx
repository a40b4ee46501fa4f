// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCasterRays.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
std::string vtkRelievoCasterRays::SetSurfaces(const std::vector<vtkRelievoSurface>& surfaces)
{
  this->Surfaces = surfaces;
  std::vector<vtkRelievoPlacedMesh> meshes;
  for (const vtkRelievoSurface& surface : surfaces)
  {
    meshes.push_back(surface.Caster);
  }
  std::string lack;
  this->Tree.SetMeshes(meshes, lack);
  if (!lack.empty())
  {
    this->Surfaces.clear();
  }
  return lack;
}

//------------------------------------------------------------------------------
vtkRelievoCasterRays::Hit vtkRelievoCasterRays::Find(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high, double wanted) const
{
  Hit found;
  this->Tree.Walk(from, ray, low, high, [&](int place, int triangle, double t) {
    const int surface = this->Tree.GetMesh(place);
    const vtkRelievoPlacedMesh& caster = this->Surfaces[surface].Caster;
    if (this->Surfaces[surface].Seen &&
      (found.Surface < 0 || std::abs(t - wanted) < std::abs(found.T - wanted)))
    {
      glm::dvec3 corner;
      const bool culls = caster.CullsFront || caster.CullsBack;
      const bool front =
        culls && glm::dot(this->Tree.GetNormal(place, triangle, corner), ray) < 0.0;
      if (!culls || !(front ? caster.CullsFront : caster.CullsBack))
      {
        found = { surface, place, triangle, t, glm::dvec3(0.0) };
      }
    }
    return found.Surface < 0 ? high : std::min(high, wanted + std::abs(found.T - wanted));
  });
  if (found.Surface >= 0)
  {
    glm::dvec3 corner;
    const glm::dvec3 normal = this->Tree.GetNormal(found.Place, found.Triangle, corner);
    found.Normal = glm::dot(normal, ray) > 0.0 ? -normal : normal;
  }
  return found;
}

//------------------------------------------------------------------------------
vtkRelievoCasterRays::Hit vtkRelievoCasterRays::FindFirst(
  const glm::dvec3& from, const glm::dvec3& ray, double low) const
{
  return this->Find(from, ray, low, std::numeric_limits<double>::infinity(), low);
}

//------------------------------------------------------------------------------
double vtkRelievoCasterRays::Pass(
  const glm::dvec3& from, const glm::dvec3& ray, double last, const Hit& own, double blur) const
{
  double passes = 1.0;
  this->Tree.Walk(from, ray, 0.0, last, [&](int place, int triangle, double) {
    const int surface = this->Tree.GetMesh(place);
    const vtkRelievoSurface& caster = this->Surfaces[surface];
    const bool counts =
      caster.Casts && (caster.Caster.Opacity == 1.0 || this->Tree.Owns(place, triangle, from, ray));
    if (counts && (place != own.Place || triangle != own.Triangle))
    {
      glm::dvec3 corner;
      const glm::dvec3 normal = glm::normalize(this->Tree.GetNormal(place, triangle, corner));
      const bool ends = std::isfinite(last);
      if (std::abs(glm::dot(normal, corner - from)) > blur &&
        (!ends || std::abs(glm::dot(normal, corner - from - last * ray)) > blur))
      {
        passes *= 1.0 - caster.Caster.Opacity;
      }
    }
    return passes > 0.0 ? last : -1.0;
  });
  return passes;
}
