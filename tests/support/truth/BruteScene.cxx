// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteScene.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace relievoTest
{
//------------------------------------------------------------------------------
void BruteScene::Add(vtkPolyData* mesh)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      std::array<glm::dvec3, 3> p;
      mesh->GetPoint(ids->GetId(0), &p[0].x);
      mesh->GetPoint(ids->GetId(i), &p[1].x);
      mesh->GetPoint(ids->GetId(i + 1), &p[2].x);
      if (this->Triangles.size() % GroupSize == 0)
      {
        this->Groups.push_back({ p[0], p[0] });
      }
      this->Triangles.push_back(p);
      Box& box = this->Groups.back();
      for (const glm::dvec3& corner : p)
      {
        box.Low = glm::min(box.Low, corner - 1e-9);
        box.High = glm::max(box.High, corner + 1e-9);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool BruteScene::Hits(const Box& box, const Ray& ray, double tMax)
{
  double first = 0.;
  double last = tMax;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box.Low[axis] - ray.Origin[axis];
    const double high = box.High[axis] - ray.Origin[axis];
    const double along = ray.Direction[axis];
    if (along == 0.)
    {
      if (low > 0. || high < 0.)
      {
        return false;
      }
      continue;
    }
    first = std::max(first, std::min(low / along, high / along) * (1. - 1e-12));
    last = std::min(last, std::max(low / along, high / along) * (1. + 1e-12));
  }
  return first <= last;
}

//------------------------------------------------------------------------------
template <typename Each>
void BruteScene::ForEach(const Ray& ray, double tMax, const Each& each) const
{
  for (std::size_t group = 0; group < this->Groups.size(); ++group)
  {
    if (!Hits(this->Groups[group], ray, tMax))
    {
      continue;
    }
    const std::size_t end = std::min(this->Triangles.size(), (group + 1) * GroupSize);
    for (std::size_t i = group * GroupSize; i < end; ++i)
    {
      const glm::dvec3 a = this->Triangles[i][0] - ray.Origin;
      const glm::dvec3 b = this->Triangles[i][1] - ray.Origin;
      const glm::dvec3 c = this->Triangles[i][2] - ray.Origin;
      // Volumes of the ray with each edge: of equal sign inside.
      const double u = glm::dot(ray.Direction, glm::cross(b, c));
      const double v = glm::dot(ray.Direction, glm::cross(c, a));
      const double w = glm::dot(ray.Direction, glm::cross(a, b));
      if ((u < 0. || v < 0. || w < 0.) && (u > 0. || v > 0. || w > 0.))
      {
        continue;
      }
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double along = glm::dot(normal, ray.Direction);
      if (along != 0. && each(i, glm::dot(normal, a) / along))
      {
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
BruteScene::Hit BruteScene::MakeHit(const Ray& ray, std::size_t triangle, double t) const
{
  const auto& p = this->Triangles[triangle];
  const glm::dvec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
  return { t, triangle, glm::dot(normal, ray.Direction) < 0. ? normal : -normal };
}

//------------------------------------------------------------------------------
BruteScene::Hit BruteScene::Cast(const Ray& ray, double tMin, double tMax) const
{
  const std::vector<Hit> hits = this->CastNear(ray, tMin, tMax, 0.);
  return hits.empty() ? Hit() : hits[0];
}

//------------------------------------------------------------------------------
std::vector<BruteScene::Hit> BruteScene::CastNear(
  const Ray& ray, double tMin, double tMax, double share) const
{
  std::vector<Hit> hits;
  double last = tMax;
  this->ForEach(ray, tMax, [&](std::size_t i, double t) {
    if (t >= tMin && t <= last)
    {
      last = std::min(last, (1. + share) * t);
      hits.push_back(this->MakeHit(ray, i, t));
    }
    return false;
  });
  hits.erase(std::remove_if(hits.begin(), hits.end(), [&](const Hit& hit) { return hit.T > last; }),
    hits.end());
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.T < b.T; });
  return hits;
}

//------------------------------------------------------------------------------
bool BruteScene::Occluded(const Ray& ray, double tMax, std::size_t own) const
{
  // Rounding of a shared edge's position in double: less than any distance of a scene.
  const double tMin = 1e-9 / glm::length(ray.Direction);
  bool occluded = false;
  this->ForEach(ray, tMax, [&](std::size_t i, double t) {
    occluded = i != own && t > tMin && t <= tMax;
    return occluded;
  });
  return occluded;
}
}
