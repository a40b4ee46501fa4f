// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDepthRefiner.h"

#include "vtkRelievoCellGeometry.h"
#include "vtkRelievoView.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
double vtkRelievoDepthRefiner::GetNeighbourDepth(
  int x, int y, const Ray& ray, double depth) const
{
  const std::uint32_t own = this->GetWord(x, y);
  // Of all that hold the centre the nearest is seen, unless it is another surface altogether.
  const double reach = 0.01 * depth;
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
      if (inside && std::abs(candidate - depth) < reach)
      {
        best = std::min(best, candidate);
      }
    }
  }
  return std::isfinite(best) ? best : depth;
}

//------------------------------------------------------------------------------
void vtkRelievoDepthRefiner::RefineRow(int y, float* depths)
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
      depth = this->GetNeighbourDepth(x, y, ray, depth);
    }
    if (std::isfinite(depth))
    {
      depths[x] = static_cast<float>(depth);
    }
  }
}
