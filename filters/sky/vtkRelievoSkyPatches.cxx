// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkyPatches.h"

#include "vtkMath.h"
#include "vtkRelievoRayTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
// A patch's corners, its middle, and the great circles from each corner to the next.
struct vtkRelievoSkyPatches::Frame
{
  glm::dvec3 Corners[4];
  glm::dvec3 Middle;
  glm::dvec3 Normals[4]; // not unit; towards the middle

  Frame(const vtkRelievoSkyPatches& sky, int level, int column, int row)
  {
    const int width = Side >> level;
    const int places[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    for (int i = 0; i < 4; ++i)
    {
      this->Corners[i] =
        sky.GetCorner((column + places[i][0]) * width, (row + places[i][1]) * width);
    }
    this->Middle =
      glm::normalize(this->Corners[0] + this->Corners[1] + this->Corners[2] + this->Corners[3]);
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec3 normal = glm::cross(this->Corners[i], this->Corners[(i + 1) % 4]);
      this->Normals[i] = glm::dot(normal, this->Middle) < 0.0 ? -normal : normal;
    }
  }
};

//------------------------------------------------------------------------------
vtkRelievoSkyPatches::vtkRelievoSkyPatches(const glm::dmat3& world)
  : World(world)
{
  for (int level = FirstLevel; level <= LastLevel; ++level)
  {
    this->Levels[static_cast<std::size_t>(level - FirstLevel)].resize(
      static_cast<std::size_t>(1) << (2 * level));
  }
  this->Corners.reserve(static_cast<std::size_t>(Side + 1) * (Side + 1));
  for (int row = 0; row <= Side; ++row)
  {
    for (int column = 0; column <= Side; ++column)
    {
      this->Corners.push_back(world * GetLocal(2.0 * column / Side - 1.0, 2.0 * row / Side - 1.0));
    }
  }
  for (int level = FirstLevel; level <= LastLevel; ++level)
  {
    for (int row = 0; row < 1 << level; ++row)
    {
      for (int column = 0; column < 1 << level; ++column)
      {
        this->FindExcess(level, column, row);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Along each of its sides, which are smooth.
void vtkRelievoSkyPatches::FindExcess(int level, int column, int row)
{
  Patch& patch = this->Levels[static_cast<std::size_t>(level - FirstLevel)]
                             [static_cast<std::size_t>((row << level) + column)];
  if (level == LastLevel)
  {
    patch.Excess = this->Get(level - 1, column / 2, row / 2).Excess;
    return;
  }
  constexpr double safety = 1.25; // for places between those looked at
  constexpr double room = 1e-3;   // for sides that bend both ways
  double least = 0.0;
  const Frame frame(*this, level, column, row);
  const int width = Side >> level;
  const int step = std::max(1, width / 8);
  for (int along = step; along < width; along += step)
  {
    const int places[4][2] = { { along, 0 }, { width, along }, { along, width }, { 0, along } };
    for (const auto& [x, y] : places)
    {
      const glm::dvec3& corner = this->GetCorner(column * width + x, row * width + y);
      const double ahead = glm::dot(corner, frame.Middle);
      for (const glm::dvec3& normal : frame.Normals)
      {
        least =
          std::min(least, glm::dot(corner, normal) / (ahead * glm::dot(frame.Middle, normal)));
      }
    }
  }
  patch.Excess = -safety * least + room;
}

//------------------------------------------------------------------------------
vtkRelievoConeSight::Cone vtkRelievoSkyPatches::GetCone(
  int level, int column, int row, const glm::dvec3& normal, double& least, double& most) const
{
  const double excess = this->Get(level, column, row).Excess;
  const Frame frame(*this, level, column, row);
  const glm::dvec3& up = this->World[2];
  vtkRelievoConeSight::Cone cone;
  least = 1.0;
  most = -1.0;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3& corner = frame.Corners[i];
    const glm::dvec3& side = frame.Normals[i];
    const double ahead = glm::dot(corner, frame.Middle);
    cone.Normals[i] = side + excess * glm::dot(side, frame.Middle) * frame.Middle;
    cone.Edges[i] = corner + excess * (corner - ahead * frame.Middle);
    // A patch at the horizon ends there.
    const glm::dvec3 end = cone.Edges[i] - std::min(0.0, glm::dot(cone.Edges[i], up)) * up;
    const double cosine = glm::dot(end, normal) / ahead;
    least = std::min(least, cosine);
    most = std::max(most, cosine);
  }
  cone.Normals[4] = normal;
  cone.Normals[5] = up;
  return cone;
}

//------------------------------------------------------------------------------
// The direction of a point of the square from -1 to 1; its edge is the horizon.
glm::dvec3 vtkRelievoSkyPatches::GetLocal(double x, double y)
{
  const bool wide = std::abs(x) > std::abs(y);
  const double radius = wide ? x : y;
  const double turn = radius == 0.0 ? 0.0 : 0.25 * vtkMath::Pi() * (wide ? y : x) / radius;
  const double level = radius * std::sqrt(2.0 - radius * radius);
  const double along = level * std::cos(turn);
  const double across = level * std::sin(turn);
  return { wide ? along : across, wide ? across : along, 1.0 - radius * radius };
}

//------------------------------------------------------------------------------
vtkRelievoSkyPatches::Patch& vtkRelievoSkyPatches::FindPatch(const glm::dvec3& local)
{
  const bool wide = std::abs(local.x) > std::abs(local.y);
  const double major = wide ? local.x : local.y;
  const double radius = std::copysign(std::sqrt(std::max(0.0, 1.0 - local.z)), major);
  const double minor = major == 0.0
    ? 0.0
    : radius * std::atan((wide ? local.y : local.x) / major) / (0.25 * vtkMath::Pi());
  const auto find = [](double value) {
    return std::clamp(static_cast<int>(0.5 * (value + 1.0) * Side), 0, Side - 1);
  };
  const int column = find(wide ? radius : minor);
  const int row = find(wide ? minor : radius);
  return this->Levels.back()[static_cast<std::size_t>(row * Side + column)];
}

//------------------------------------------------------------------------------
void vtkRelievoSkyPatches::AddSun(
  const glm::dvec3& local, double direct, double diffuse, double hours)
{
  Patch& patch = this->FindPatch(local);
  const glm::dvec3 direction = this->World * local;
  patch.Direct += direct * direction;
  patch.DirectSize += direct;
  patch.Diffuse += diffuse * direction;
  patch.DiffuseSize += diffuse;
  patch.Insolation += hours * direction;
  patch.Hours += hours;
}

//------------------------------------------------------------------------------
void vtkRelievoSkyPatches::AddSky(double uniform, double horizon)
{
  // Of a uniform sky, pi times the radiance arrives on level ground; patches are equally large.
  const double light = 2.0 * uniform / (static_cast<double>(Side) * Side);
  for (int row = 0; row < Side; ++row)
  {
    for (int column = 0; column < Side; ++column)
    {
      Patch& patch = this->Levels.back()[static_cast<std::size_t>(row * Side + column)];
      patch.Diffuse += light * this->World *
        GetLocal((2.0 * column + 1.0) / Side - 1.0, (2.0 * row + 1.0) / Side - 1.0);
      patch.DiffuseSize += light;
    }
  }
  // Half of it for each radian, of which the cosines' mean leaves 2 in front of an upright plane.
  constexpr int parts = 4 * Side;
  const double share = 0.5 * horizon * 2.0 * vtkMath::Pi() / parts;
  for (int i = 0; i < parts; ++i)
  {
    const double turn = 2.0 * vtkMath::Pi() * (i + 0.5) / parts;
    const glm::dvec3 local(std::sin(turn), std::cos(turn), 0.0);
    Patch& patch = this->FindPatch(local);
    patch.Diffuse += share * this->World * local;
    patch.DiffuseSize += std::abs(share);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSkyPatches::Finish()
{
  for (int level = LastLevel - 1; level >= FirstLevel; --level)
  {
    std::vector<Patch>& patches = this->Levels[static_cast<std::size_t>(level - FirstLevel)];
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      const int column = 2 * (static_cast<int>(i) & ((1 << level) - 1));
      const int row = 2 * (static_cast<int>(i) >> level);
      for (int quarter = 0; quarter < 4; ++quarter)
      {
        const Patch& part = this->Get(level + 1, column + quarter % 2, row + quarter / 2);
        patches[i].Direct += part.Direct;
        patches[i].Diffuse += part.Diffuse;
        patches[i].Insolation += part.Insolation;
        patches[i].DirectSize += part.DirectSize;
        patches[i].DiffuseSize += part.DiffuseSize;
        patches[i].Hours += part.Hours;
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkRelievoSkyPatches::Receiver::Receiver(const vtkRelievoSkyPatches& sky,
  const vtkRelievoRayTree& tree, const vtkRelievoConeSight& sight, double tolerance)
  : Sky(sky)
  , Tree(tree)
  , Sight(sight)
  , Tolerance(tolerance)
  , Seen(sky.Corners.size())
{
}

//------------------------------------------------------------------------------
bool vtkRelievoSkyPatches::Receiver::IsFree(int column, int row)
{
  std::uint32_t& seen = this->Seen[static_cast<std::size_t>(row * (Side + 1) + column)];
  if (seen / 2 != this->Number)
  {
    constexpr double farthest = std::numeric_limits<double>::infinity();
    const bool hit =
      this->Tree.HitsAny(this->Place, this->Sky.GetCorner(column, row), 0.0, farthest);
    seen = 2 * this->Number + (hit ? 0 : 1);
  }
  return seen % 2 == 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSkyPatches::Receiver::Add(int level, int column, int row)
{
  const Patch& patch = this->Sky.Get(level, column, row);
  double least = 1.0; // cosines to the normal
  double most = -1.0;
  const vtkRelievoConeSight::Cone cone =
    this->Sky.GetCone(level, column, row, this->Normal, least, most);
  if (most <= 0.0 || patch.DirectSize + patch.DiffuseSize + patch.Hours == 0.0)
  {
    return;
  }
  double share = 1.0; // of the patch that is free
  bool isFree = false;
  if (level < RayLevel)
  {
    isFree = this->Sight.IsFree(this->Place, cone);
    if (!isFree)
    {
      this->Divide(level, column, row);
      return;
    }
  }
  else
  {
    const int width = Side >> level;
    glm::dvec3 within(0.0);
    int facing = 0;
    int free = 0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const int x = (column + corner % 2) * width;
      const int y = (row + corner / 2) * width;
      const glm::dvec3& direction = this->Sky.GetCorner(x, y);
      if (glm::dot(direction, this->Normal) > 0.0)
      {
        ++facing;
        free += this->IsFree(x, y) ? 1 : 0;
        within += direction;
      }
    }
    if (free == 0 && facing > 0 && this->Sight.IsBlocked(this->Place, cone, within))
    {
      return;
    }
    isFree = free == facing && this->Sight.IsFree(this->Place, cone);
    share = isFree ? 1.0 : facing > 0 ? static_cast<double>(free) / facing : 0.0;
  }
  // Patches across the plane of the surface have light from behind, which does not count; their
  // corners behind it say nothing.
  const auto receive = [&](const glm::dvec3& light) {
    const double all = glm::dot(light, this->Normal);
    return least < 0.0 ? std::max(0.0, all) : all;
  };
  const auto bound = [&](double size, double light) {
    const double largest = std::max(std::abs(light), size * most);
    // The free part of a patch across the plane may be the part in front, whatever its share.
    return isFree   ? size * std::max(0.0, std::min(most, -least))
      : least < 0.0 ? largest
                    : largest * std::max(share, 1.0 - share);
  };
  Node node{ level, column, row, {} };
  const double direct = receive(patch.Direct);
  const double diffuse = receive(patch.Diffuse);
  node.Light.Direct = share * direct;
  node.Light.Diffuse = share * diffuse;
  node.Light.Bound = bound(patch.DirectSize, direct) + bound(patch.DiffuseSize, diffuse);
  node.Light.Hours = share * patch.Hours;
  node.Light.HoursBound = isFree && least >= 0.0 ? 0.0 : patch.Hours * std::max(share, 1.0 - share);
  node.Light.Insolation = share * receive(patch.Insolation);
  this->Nodes.push_back(node);
}

//------------------------------------------------------------------------------
void vtkRelievoSkyPatches::Receiver::Divide(int level, int column, int row)
{
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    this->Add(level + 1, 2 * column + quarter % 2, 2 * row + quarter / 2);
  }
}

//------------------------------------------------------------------------------
vtkRelievoSkyPatches::Sums vtkRelievoSkyPatches::Receiver::Receive(
  const glm::dvec3& place, const glm::dvec3& normal)
{
  this->Place = place - this->Tree.GetCenter();
  this->Normal = normal;
  ++this->Number;
  this->Nodes.clear();
  for (int row = 0; row < 1 << FirstLevel; ++row)
  {
    for (int column = 0; column < 1 << FirstLevel; ++column)
    {
      this->Add(FirstLevel, column, row);
    }
  }
  for (;;)
  {
    Sums sums;
    for (const Node& node : this->Nodes)
    {
      sums.Direct += node.Light.Direct;
      sums.Diffuse += node.Light.Diffuse;
      sums.Bound += node.Light.Bound;
      sums.Hours += node.Light.Hours;
      sums.HoursBound += node.Light.HoursBound;
      sums.Insolation += node.Light.Insolation;
    }
    const double allowed = this->Tolerance * (sums.Direct + sums.Diffuse);
    if (!(sums.Bound > allowed))
    {
      return sums;
    }
    // The largest bounds first, until the others add up to half of the allowed one.
    std::stable_sort(this->Nodes.begin(), this->Nodes.end(),
      [](const Node& a, const Node& b) { return a.Light.Bound > b.Light.Bound; });
    const std::vector<Node> before = std::move(this->Nodes);
    this->Nodes.clear();
    double rest = sums.Bound;
    bool isDivided = false;
    for (const Node& node : before)
    {
      const bool divide = node.Level < LastLevel && node.Light.Bound > 0.0 && rest > 0.5 * allowed;
      rest -= node.Light.Bound;
      if (!divide)
      {
        this->Nodes.push_back(node);
        continue;
      }
      isDivided = true;
      this->Divide(node.Level, node.Column, node.Row);
    }
    if (!isDivided)
    {
      return sums;
    }
  }
}
