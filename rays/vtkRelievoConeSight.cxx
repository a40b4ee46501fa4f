// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoConeSight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Rounding = 1e-14; // of coordinates, in all products below
constexpr int MostSheets = 4;      // hits of one ray that are followed
constexpr int MostTriangles = 384; // of a sheet

double GetSize(const glm::dvec3& p)
{
  return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
}

// A small set of numbers.
class Set
{
public:
  // Whether the number is new.
  bool Add(int number)
  {
    auto slot = static_cast<unsigned>(number) * 2654435761u >> (32 - Bits);
    while (this->Slots[slot] != number + 1)
    {
      if (this->Slots[slot] == 0)
      {
        this->Slots[slot] = number + 1;
        return true;
      }
      slot = (slot + 1) & ((1u << Bits) - 1);
    }
    return false;
  }

private:
  static constexpr int Bits = 10; // more than twice MostTriangles
  int Slots[1 << Bits] = {};
};
}

//------------------------------------------------------------------------------
// The cone in the coordinates of a place's mesh.
class vtkRelievoConeSight::Local
{
public:
  Local(const vtkRelievoConeSight& sight, int place, const glm::dvec3& from, const Cone& cone)
    : Mesh(sight.Scene.GetMeshTree(place))
  {
    const glm::dmat4& toMesh = sight.Scene.GetToMesh(place);
    const glm::dmat3 turn(toMesh);
    const glm::dmat3 back = glm::transpose(sight.Turns[static_cast<std::size_t>(place)]);
    this->From = glm::dvec3(toMesh * glm::dvec4(from, 1.0));
    for (int i = 0; i < Cone::Sides; ++i)
    {
      this->Normals[i] = glm::normalize(back * cone.Normals[i]);
    }
    for (int i = 0; i < Cone::Corners; ++i)
    {
      this->Edges[i] = glm::normalize(turn * cone.Edges[i]);
    }
    // Far from the origin the way into the mesh's coordinates rounds more than the result shows.
    const glm::dvec3 moved(
      glm::dmat3(glm::abs(turn[0]), glm::abs(turn[1]), glm::abs(turn[2])) * glm::abs(from));
    this->Error = Rounding *
      (GetSize(moved) + GetSize(this->From) + GetSize(this->Mesh.GetLow()) +
        GetSize(this->Mesh.GetHigh()));
  }

  // Calls visit(triangle) for triangles, among them all that meet the cone; `visit` returns whether
  // to continue.
  template <typename Visit>
  void FindTriangles(Visit visit) const
  {
    vtkRelievoWideTree::HalfSpace spaces[Cone::Sides];
    for (int i = 0; i < Cone::Sides; ++i)
    {
      spaces[i] = { this->Normals[i], glm::dot(this->Normals[i], this->From) - this->Error };
    }
    this->Mesh.FindWithin(spaces, Cone::Sides, [&](int first, int count) {
      for (int triangle = first; triangle < first + count; ++triangle)
      {
        if (!visit(triangle))
        {
          return false;
        }
      }
      return true;
    });
  }

  bool MayMeet(int triangle) const
  {
    glm::dvec3 p[3];
    for (int i = 0; i < 3; ++i)
    {
      p[i] = this->GetCorner(triangle, i);
    }
    for (const glm::dvec3& normal : this->Normals)
    {
      if (glm::dot(normal, p[0]) < -this->Error && glm::dot(normal, p[1]) < -this->Error &&
        glm::dot(normal, p[2]) < -this->Error)
      {
        return false;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3& a = p[i];
      const glm::dvec3& b = p[i == 2 ? 0 : i + 1];
      const glm::dvec3& c = p[i == 0 ? 2 : i - 1];
      const glm::dvec3 side = glm::cross(a, b);
      const double inside = this->GetSide(side, a, b, c);
      if (inside != 0.0 && this->GetSideOfCone(side, a, b) == -std::copysign(1.0, inside))
      {
        return false;
      }
    }
    return true;
  }

  // Whether a triangle, and those that follow it over edges within the cone, cover the cone: the
  // directions that they block then have no end within it.
  bool IsCoveredFrom(int first, const vtkRelievoNeighbors& neighbors) const
  {
    Set found;
    int triangles[MostTriangles];
    int count = 0;
    found.Add(first);
    triangles[count++] = first;
    for (int next = 0; next < count; ++next)
    {
      const int triangle = triangles[next];
      for (int i = 0; i < 3; ++i)
      {
        const glm::dvec3 a = this->GetCorner(triangle, i);
        const glm::dvec3 b = this->GetCorner(triangle, i == 2 ? 0 : i + 1);
        const glm::dvec3 side = glm::cross(a, b);
        if (!this->MayMeetEdge(a, b, side))
        {
          continue;
        }
        const int other = neighbors.Get(triangle, i);
        if (other < 0)
        {
          return false;
        }
        const glm::dvec3 c = this->GetCorner(triangle, i == 0 ? 2 : i - 1);
        const glm::dvec3 d = this->GetCorner(other / 3, (other % 3 + 2) % 3);
        if (!(this->GetSide(side, a, b, c) * this->GetSide(side, a, b, d) < 0.0))
        {
          return false; // the outline, or seen edge-on
        }
        if (found.Add(other / 3))
        {
          if (count == MostTriangles)
          {
            return false;
          }
          triangles[count++] = other / 3;
        }
      }
    }
    return true;
  }

private:
  glm::dvec3 GetCorner(int triangle, int corner) const
  {
    return this->Mesh.GetCorner(triangle, corner) - this->From;
  }
  // The side of the plane of a and b on which c is; 0: not certain.
  double GetSide(
    const glm::dvec3& side, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const
  {
    const double value = glm::dot(side, c);
    const double ends = GetSize(a) + GetSize(b);
    return std::abs(value) > this->Error * ends * (ends + GetSize(c)) ? value : 0.0;
  }
  // 1 or -1 if the cone is on one side of the plane of a and b.
  double GetSideOfCone(const glm::dvec3& side, const glm::dvec3& a, const glm::dvec3& b) const
  {
    const double error = this->Error * (GetSize(a) + GetSize(b));
    int above = 0;
    int below = 0;
    for (const glm::dvec3& edge : this->Edges)
    {
      const double value = glm::dot(side, edge);
      above += value > error ? 1 : 0;
      below += value < -error ? 1 : 0;
    }
    return above == Cone::Corners ? 1.0 : below == Cone::Corners ? -1.0 : 0.0;
  }
  bool MayMeetEdge(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& side) const
  {
    for (const glm::dvec3& normal : this->Normals)
    {
      if (glm::dot(normal, a) < -this->Error && glm::dot(normal, b) < -this->Error)
      {
        return false;
      }
    }
    return this->GetSideOfCone(side, a, b) == 0.0;
  }

  const vtkRelievoMeshTree& Mesh;
  glm::dvec3 From;
  glm::dvec3 Normals[Cone::Sides];
  glm::dvec3 Edges[Cone::Corners];
  double Error; // of coordinates
};

//------------------------------------------------------------------------------
vtkRelievoConeSight::vtkRelievoConeSight(const vtkRelievoRayTree& scene)
  : Scene(scene)
{
  for (int place = 0; place < scene.GetNumberOfPlaces(); ++place)
  {
    this->Turns.emplace_back(scene.GetToScene(place));
    const vtkRelievoMeshTree& mesh = scene.GetMeshTree(place);
    this->Neighbors.try_emplace(&mesh, mesh);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoConeSight::IsFree(const glm::dvec3& from, const Cone& cone) const
{
  bool isFree = true;
  const auto look = [&](int place) {
    const Local local(*this, place, from, cone);
    local.FindTriangles([&](int triangle) {
      isFree = !local.MayMeet(triangle);
      return isFree;
    });
    return isFree;
  };
  if (this->Scene.GetNumberOfPlaces() == 1)
  {
    look(0);
    return isFree;
  }
  vtkRelievoWideTree::HalfSpace spaces[Cone::Sides];
  for (int i = 0; i < Cone::Sides; ++i)
  {
    spaces[i] = { cone.Normals[i], glm::dot(cone.Normals[i], from) };
  }
  this->Scene.FindWithin(spaces, Cone::Sides, look);
  return isFree;
}

//------------------------------------------------------------------------------
bool vtkRelievoConeSight::IsBlocked(
  const glm::dvec3& from, const Cone& cone, const glm::dvec3& within) const
{
  vtkRelievoRayTree::Hit sheets[MostSheets]; // the nearest hits
  int count = 0;
  this->Scene.Walk(from, within, 0.0, std::numeric_limits<double>::infinity(),
    [&](int place, int triangle, double t) {
      int at = std::min(count, MostSheets - 1);
      if (count < MostSheets || t < sheets[at].T)
      {
        count = std::min(count + 1, MostSheets);
        for (; at > 0 && sheets[at - 1].T > t; --at)
        {
          sheets[at] = sheets[at - 1];
        }
        sheets[at] = { place, triangle, t };
      }
      return count < MostSheets ? std::numeric_limits<double>::infinity() : sheets[count - 1].T;
    });
  return std::any_of(sheets, sheets + count, [&](const vtkRelievoRayTree::Hit& hit) {
    return Local(*this, hit.Place, from, cone)
      .IsCoveredFrom(hit.Triangle, this->Neighbors.at(&this->Scene.GetMeshTree(hit.Place)));
  });
}
