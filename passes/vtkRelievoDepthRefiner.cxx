// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthRefiner.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoCellGeometry.h"
#include "vtkRelievoMeshLinks.h"
#include "vtkRelievoView.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Not another surface altogether.
bool IsSameSurface(double a, double b)
{
  return std::abs(a - b) < 0.01 * b;
}
}

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::vtkRelievoDepthRefiner(const vtkRelievoDrawTable& draws,
  const vtkRelievoView& view, const std::uint32_t* words, int stride)
  : Draws(draws)
  , View(view)
  , Words(words)
  , Stride(stride)
{
}

//------------------------------------------------------------------------------
std::uint32_t vtkRelievoDepthRefiner::GetWord(int x, int y) const
{
  return this->Words[(static_cast<std::ptrdiff_t>(y) * this->View.Viewport[2] + x) * this->Stride];
}

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::Triangle vtkRelievoDepthRefiner::GetTriangle(std::uint32_t word) const
{
  Triangle triangle;
  const vtkRelievoDrawTable::Hit hit = this->Draws.Find(word);
  if (hit.Mesh && !hit.Deformed)
  {
    const vtkRelievoCellGeometry cell(hit);
    triangle.Known = cell.Count == 3;
    for (int i = 0; i < cell.Count; ++i)
    {
      triangle.Corners[i] = glm::dvec3(*hit.ModelToView * glm::dvec4(cell.Corners[i], 1.0));
    }
  }
  return triangle;
}

//------------------------------------------------------------------------------
vtkRelievoDepthRefiner::Ray vtkRelievoDepthRefiner::GetRay(int x, int y) const
{
  using namespace relievo::f64;
  const glm::dvec2 ndc = relievoNdcFromPixel(
    glm::dvec2(x, y), glm::dvec2(this->View.Viewport[2], this->View.Viewport[3]));
  Ray ray;
  ray.From = relievoEyePosition(ndc, 0.0, this->View.ViewToNDC);
  ray.Along = relievoEyePosition(ndc, 1.0, this->View.ViewToNDC) - ray.From;
  return ray;
}

//------------------------------------------------------------------------------
double vtkRelievoDepthRefiner::GetDepth(const Triangle& triangle, const Ray& ray, bool& inside)
{
  // Volumes between the ray and the edges: the barycentric coordinates of the meeting point.
  glm::dvec3 p[3];
  for (int i = 0; i < 3; ++i)
  {
    p[i] = triangle.Corners[i] - ray.From;
  }
  double w[3];
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    w[i] = glm::dot(ray.Along, glm::cross(p[(i + 1) % 3], p[(i + 2) % 3]));
    sum += w[i];
  }
  const double sign = sum < 0.0 ? -1.0 : 1.0;
  inside = true;
  sum = 0.0;
  for (double& weight : w)
  {
    inside = inside && weight * sign >= 0.0;
    weight = std::max(0.0, weight * sign);
    sum += weight;
  }
  // Corners' eye-space z is minus their depth.
  return -(w[0] * triangle.Corners[0].z + w[1] * triangle.Corners[1].z +
           w[2] * triangle.Corners[2].z) /
    sum;
}

//------------------------------------------------------------------------------
double vtkRelievoDepthRefiner::GetNeighbourDepth(int x, int y, const Ray& ray, double depth) const
{
  const std::uint32_t own = this->GetWord(x, y);
  // Of all that hold the centre the nearest is seen.
  double best = std::numeric_limits<double>::infinity();
  for (int j = std::max(0, y - 1); j <= std::min(this->View.Viewport[3] - 1, y + 1); ++j)
  {
    for (int i = std::max(0, x - 1); i <= std::min(this->View.Viewport[2] - 1, x + 1); ++i)
    {
      const std::uint32_t word = this->GetWord(i, j);
      const Triangle triangle = word == own ? Triangle() : this->GetTriangle(word);
      if (!triangle.Known)
      {
        continue;
      }
      bool inside = false;
      const double candidate = GetDepth(triangle, ray, inside);
      if (inside && IsSameSurface(candidate, depth))
      {
        best = std::min(best, candidate);
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
double vtkRelievoDepthRefiner::GetAdjacentDepth(
  int x, int y, double depth, vtkRelievoMeshLinks& links) const
{
  const vtkRelievoDrawTable::Hit hit = this->Draws.Find(this->GetWord(x, y));
  const Ray ray = this->GetRay(x, y);
  vtkRelievoMeshLinks::Links& cells = links.Get(hit.Mesh);
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIdList> ids;
  hit.Mesh->GetCellPoints(hit.Cell, corners);
  double best = std::numeric_limits<double>::infinity();
  for (vtkIdType c = 0; c < corners->GetNumberOfIds(); ++c)
  {
    const vtkIdType point = corners->GetId(c);
    for (vtkIdType k = 0; k < cells.GetNumberOfCells(point); ++k)
    {
      hit.Mesh->GetCellPoints(cells.GetCells(point)[k], ids);
      // As VTK's mappers cut polygons: into fans.
      for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
      {
        Triangle triangle;
        const vtkIdType fan[3] = { ids->GetId(0), ids->GetId(i - 1), ids->GetId(i) };
        for (int j = 0; j < 3; ++j)
        {
          glm::dvec3 model;
          hit.Mesh->GetPoint(fan[j], &model[0]);
          triangle.Corners[j] = glm::dvec3(*hit.ModelToView * glm::dvec4(model, 1.0));
        }
        bool inside = false;
        const double candidate = GetDepth(triangle, ray, inside);
        if (inside && IsSameSurface(candidate, depth))
        {
          best = std::min(best, candidate);
        }
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRefiner::Refine(float* depths, vtkRelievoMeshLinks& links)
{
  vtkSMPThreadLocal<std::vector<Pixel>> open;
  const vtkIdType width = this->View.Viewport[2];
  vtkSMPTools::For(0, this->View.Viewport[3], [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType y = from; y < to; ++y)
    {
      this->RefineRow(static_cast<int>(y), depths + y * width, open.Local());
    }
  });
  // A few in ten thousand.
  for (const std::vector<Pixel>& pixels : open)
  {
    for (const Pixel& pixel : pixels)
    {
      float& depth = depths[pixel.Y * width + pixel.X];
      const double found = this->GetAdjacentDepth(pixel.X, pixel.Y, depth, links);
      depth = std::isfinite(found) ? static_cast<float>(found) : depth;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRefiner::RefineRow(int y, float* depths, std::vector<Pixel>& open) const
{
  std::uint32_t last = 0xffffffffu;
  Triangle triangle;
  for (int x = 0; x < this->View.Viewport[2]; ++x)
  {
    const std::uint32_t word = this->GetWord(x, y);
    if (word != last)
    {
      last = word;
      triangle = this->GetTriangle(word);
    }
    if (!triangle.Known || !std::isfinite(depths[x]))
    {
      continue;
    }
    const Ray ray = this->GetRay(x, y);
    bool inside = false;
    double depth = GetDepth(triangle, ray, inside);
    if (!inside && std::isfinite(depth))
    {
      const double found = this->GetNeighbourDepth(x, y, ray, depth);
      if (std::isfinite(found))
      {
        depth = found;
      }
      else
      {
        open.push_back(Pixel{ x, y });
      }
    }
    if (std::isfinite(depth))
    {
      depths[x] = static_cast<float>(depth);
    }
  }
}
