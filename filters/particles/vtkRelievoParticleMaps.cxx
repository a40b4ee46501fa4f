// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleMaps.h"

#include "vtkRelievoVoxelColumns.h"
#include "vtkRelievoVoxelDepths.h"
#include "vtkRelievoVoxelMeshes.h"
#include "vtkRelievoVoxelSurface.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
// Distance in texels up to which a moved position stays on the same surface.
constexpr double Reach = 1.5;

// Below this cosine, another view is tried. On any surface, one of six views has at least 0.577.
constexpr double Grazing = 0.5;

// The matrix with these rows.
glm::dmat3 Rows(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z)
{
  return glm::transpose(glm::dmat3(x, y, z));
}
}

//------------------------------------------------------------------------------
void vtkRelievoParticleMaps::SetSurface(vtkDataObject* data, const vtkRelievoVoxelGrid& grid)
{
  this->Views.clear();
  this->Surfaces.clear();
  this->Pairs = true;
  vtkRelievoVoxelSurface surface;
  for (vtkDataSet* leaf : vtkRelievoVoxelMeshes::GetLeaves(data))
  {
    this->Surfaces.push_back(vtkRelievoVoxelMeshes::GetSurface(leaf));
    surface.Add(this->Surfaces.back(), grid);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkRelievoVoxelViews both = vtkRelievoVoxelViews::Of(surface, grid, axis);
    const int across = vtkRelievoVoxelGrid::GetColumn(axis);
    const int up = vtkRelievoVoxelGrid::GetRow(axis);
    for (const int sign : { 1, -1 })
    {
      glm::dvec3 rows[3] = { glm::dvec3(0.), glm::dvec3(0.), glm::dvec3(0.) };
      rows[0][across] = 1. / grid.Spacing[across];
      rows[1][up] = 1. / grid.Spacing[up];
      rows[2][axis] = sign / grid.Spacing[axis];
      const glm::dvec3 offset(
        grid.ToGrid(0., across), grid.ToGrid(0., up), sign * grid.ToGrid(0., axis));
      vtkRelievoParticleView view(grid.Cells[across], grid.Cells[up],
        Rows(rows[0], rows[1], rows[2]), offset, grid.Spacing[axis]);
      for (std::size_t texel = 0; texel < view.GetNumberOfTexels(); ++texel)
      {
        view.SetDepth(texel, sign > 0 ? both.Front[texel] : -both.Back[texel]);
      }
      view.ComputeNormals();
      this->Views.push_back(std::move(view));
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoParticleMaps::SetImages(const std::vector<vtkImageData*>& images)
{
  this->Views.clear();
  this->Surfaces.clear();
  this->Pairs = false;
  for (std::size_t index = 0; index < images.size(); ++index)
  {
    const std::string which = "depth image " + std::to_string(index) + ": ";
    vtkImageData* image = images[index];
    vtkDataArray* depth = image->GetPointData()->GetArray("depth");
    const int* size = image->GetDimensions();
    if (!depth || depth->GetNumberOfComponents() != 1 || size[0] < 1 || size[1] < 1 || size[2] != 1)
    {
      return which + "it has no layer 'depth' on a single slice; capture the layer depth";
    }
    double camera[16];
    double ndc[16];
    if (!vtkRelievoVoxelDepths::GetMatrix(image, "worldToCamera", camera) ||
      !vtkRelievoVoxelDepths::GetMatrix(image, "worldToNDC", ndc))
    {
      return which +
        "its field data has no 'worldToCamera' and 'worldToNDC' of 16 numbers, as "
        "captures by a renderer's camera have";
    }
    const double scale = ndc[15];
    const bool parallel =
      std::abs(ndc[12]) + std::abs(ndc[13]) + std::abs(ndc[14]) <= 1e-12 * std::abs(scale);
    const glm::dvec3 across = glm::dvec3(ndc[0], ndc[1], ndc[2]) / scale * (size[0] / 2.);
    const glm::dvec3 up = glm::dvec3(ndc[4], ndc[5], ndc[6]) / scale * (size[1] / 2.);
    const double texel = std::max(1. / glm::length(across), 1. / glm::length(up));
    const glm::dvec3 look = glm::dvec3(camera[8], camera[9], camera[10]) / -texel;
    const glm::dmat3 map = Rows(across, up, look);
    if (!parallel || !(std::abs(glm::determinant(map)) > 0.) || !std::isfinite(texel))
    {
      return which + "its camera is not one of parallel projection (ParallelProjectionOn)";
    }
    const glm::dvec3 offset((ndc[3] / scale + 1.) / 2. * size[0] - 0.5,
      (ndc[7] / scale + 1.) / 2. * size[1] - 0.5, -camera[11] / texel);
    vtkRelievoParticleView view(size[0], size[1], map, offset, texel);
    for (std::size_t i = 0; i < view.GetNumberOfTexels(); ++i)
    {
      view.SetDepth(i, depth->GetComponent(static_cast<vtkIdType>(i), 0) / texel);
    }
    view.ComputeNormals();
    this->Views.push_back(std::move(view));
  }
  return this->Views.empty() ? "there are no depth images" : std::string();
}

//------------------------------------------------------------------------------
double vtkRelievoParticleMaps::GetTexelSize() const
{
  double texel = 0.;
  for (const vtkRelievoParticleView& view : this->Views)
  {
    texel = std::max(texel, view.GetTexelSize());
  }
  return texel;
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoParticleMaps::GetNumberOfSeenTexels() const
{
  std::size_t seen = 0;
  for (const vtkRelievoParticleView& view : this->Views)
  {
    for (std::size_t texel = 0; texel < view.GetNumberOfTexels(); ++texel)
    {
      seen += view.IsSeen(texel) ? 1 : 0;
    }
  }
  return seen;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleMaps::Hold(const glm::dvec3& position, const vtkRelievoParticlePlace& from,
  int& view, vtkRelievoParticlePlace& place) const
{
  const vtkRelievoParticleView& own = this->Views[static_cast<std::size_t>(view)];
  const double reach = Reach * own.GetTexelSize();
  if (!own.Find(position, false, place) || glm::distance(place.Position, position) > reach)
  {
    return this->GoOver(position, from, view, place);
  }
  if (place.Facing < Grazing)
  {
    vtkRelievoParticlePlace other;
    const int before = view;
    for (std::size_t i = 0; i < this->Views.size(); ++i)
    {
      const double texel = this->Views[i].GetTexelSize();
      if (static_cast<int>(i) != before && this->Views[i].Find(position, false, other) &&
        glm::distance(other.Position, position) <= texel && other.Facing > place.Facing + 0.05)
      {
        place = other;
        view = static_cast<int>(i);
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Used if the current view sees no surface here, or another one. Takes the nearest position that
// another view sees, or else the edge of the current view's surface. The other side of a sheet does
// not count: particles get there only around its edge.
bool vtkRelievoParticleMaps::GoOver(const glm::dvec3& position, const vtkRelievoParticlePlace& from,
  int& view, vtkRelievoParticlePlace& place) const
{
  constexpr float Opposite = -0.9F;
  double least = std::numeric_limits<double>::infinity();
  const int before = view;
  vtkRelievoParticlePlace other;
  const auto consider = [&](std::size_t i) {
    const vtkRelievoParticleView& each = this->Views[i];
    if (each.Find(position, true, other) && glm::dot(other.Normal, from.Normal) > Opposite)
    {
      const double distance = glm::distance(other.Position, position) / each.GetTexelSize();
      if (distance <= Reach && distance < least)
      {
        least = distance;
        place = other;
        view = static_cast<int>(i);
      }
    }
  };
  for (std::size_t i = 0; i < this->Views.size(); ++i)
  {
    if (static_cast<int>(i) != before)
    {
      consider(i);
    }
  }
  if (!std::isfinite(least))
  {
    consider(static_cast<std::size_t>(before));
  }
  return std::isfinite(least);
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleMaps::IsInside(const glm::dvec3& position) const
{
  return std::all_of(this->Views.begin(), this->Views.end(),
    [&position](const vtkRelievoParticleView& view) { return view.GetHeight(position) <= 0.; });
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleMaps::PushInside(glm::dvec3& position, double farthest) const
{
  constexpr int Pushes = 6;
  glm::dvec3 moved = position;
  vtkRelievoParticlePlace place;
  for (int push = 0; push < Pushes; ++push)
  {
    // Among the surfaces that the position is in front of, the one nearest along its normal.
    double least = std::numeric_limits<double>::infinity();
    glm::dvec3 inwards(0.);
    bool outside = false;
    for (const vtkRelievoParticleView& view : this->Views)
    {
      const double height = view.GetHeight(moved);
      if (!(height > 0.))
      {
        continue;
      }
      outside = true;
      if (!view.Find(moved, true, place))
      {
        continue;
      }
      // Beside everything that a view sees: towards the edge of the visible part.
      const bool before = std::isfinite(height);
      const glm::dvec3 way = place.Position - moved;
      const double distance = before ? height * std::max(place.Facing, 0.1) : glm::length(way);
      if (distance < least)
      {
        least = distance;
        inwards = before ? -distance * glm::dvec3(place.Normal) : way;
      }
    }
    if (!outside)
    {
      position = moved;
      return true;
    }
    // Slightly farther: on the border itself, rounding decides.
    moved += inwards * (1. + 1e-6) + glm::sign(inwards) * 1e-9 * this->GetTexelSize();
    if (!(glm::distance(moved, position) <= farthest))
    {
      return false;
    }
  }
  if (this->IsInside(moved))
  {
    position = moved;
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleMaps::FindNearest(glm::dvec3& position, int& view) const
{
  vtkRelievoParticlePlace place;
  glm::dvec3 nearest(0.);
  // At the border of the visible part, the nearest texel may be empty.
  for (const bool snap : { false, true })
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->Views.size(); ++i)
    {
      const double texel = this->Views[i].GetTexelSize();
      if (!this->Views[i].Find(position, snap, place))
      {
        continue;
      }
      const double distance = glm::distance(place.Position, position) / texel;
      // Views at grazing angles come last.
      const double rank = distance + (place.Facing < Grazing ? 1. : 0.);
      if (distance <= 1. && rank < least)
      {
        least = rank;
        nearest = place.Position;
        view = static_cast<int>(i);
      }
    }
    if (std::isfinite(least))
    {
      position = nearest;
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleMaps::IsSeenBetter(int view, const vtkRelievoParticlePlace& place) const
{
  vtkRelievoParticlePlace other;
  for (std::size_t i = 0; i < this->Views.size(); ++i)
  {
    const bool better = static_cast<int>(i) != view &&
      this->Views[i].Find(place.Position, false, other) &&
      glm::distance(other.Position, place.Position) <= Reach * this->Views[i].GetTexelSize() &&
      (other.Facing > place.Facing || (other.Facing == place.Facing && static_cast<int>(i) < view));
    if (better)
    {
      return true;
    }
  }
  return false;
}
