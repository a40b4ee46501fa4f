// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayTree.h"

#include "vtkPolyData.h"
#include "vtkRelievoMemory.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>

namespace
{
constexpr double NoEnd = std::numeric_limits<double>::infinity();

constexpr int Turns = 8; // rays that take turns
// Least size of a mesh for turns: caches hold smaller ones.
constexpr std::size_t LeastBytesForTurns = std::size_t(1) << 19;

vtkRelievoPolygonCut::Rule GetRule(bool byOutline)
{
  return byOutline ? vtkRelievoPolygonCut::Rule::ByOutline : vtkRelievoPolygonCut::Rule::AsDrawn;
}

bool IsFiniteCorner(const glm::dvec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool IsSamePlace(const vtkRelievoPlacedMesh& a, const vtkRelievoPlacedMesh& b)
{
  return a.Mesh == b.Mesh && a.MeshToWorld == b.MeshToWorld && a.Places == b.Places &&
    a.ByOutline == b.ByOutline;
}
}

//------------------------------------------------------------------------------
bool vtkRelievoRayTree::UpdateMeshes(const std::vector<vtkRelievoPlacedMesh>& meshes)
{
  this->MeshesBuilt = 0;
  this->MeshesRefitted = 0;
  std::map<Key, Cached> before;
  before.swap(this->Trees);
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    const Key key(mesh.Mesh, mesh.ByOutline);
    Cached& cached = this->Trees[key];
    if (cached.Triangles)
    {
      continue;
    }
    const auto old = before.find(key);
    cached = old != before.end() && old->second.Data == mesh.Mesh
      ? old->second
      : Cached{ mesh.Mesh, std::make_shared<vtkRelievoMeshTree>() };
    if (!cached.Fixed && cached.Triangles->Update(mesh.Mesh, GetRule(mesh.ByOutline)))
    {
      ++(cached.Triangles->WasRefitted() ? this->MeshesRefitted : this->MeshesBuilt);
    }
  }
  return this->MeshesBuilt + this->MeshesRefitted > 0;
}

//------------------------------------------------------------------------------
double vtkRelievoRayTree::GetBytesToBuild(const std::vector<vtkRelievoPlacedMesh>& meshes) const
{
  double peak = 0.0;
  double kept = 0.0; // by the trees that are built first
  std::set<Key> counted;
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    const Key key(mesh.Mesh, mesh.ByOutline);
    const auto found = this->Trees.find(key);
    const bool isThere = found != this->Trees.end() && found->second.Data == mesh.Mesh;
    if (!counted.insert(key).second || (isThere && found->second.Fixed))
    {
      continue;
    }
    const vtkRelievoMeshTree none;
    const double bytes = (isThere ? *found->second.Triangles : none).GetBytesToBuild(mesh.Mesh);
    peak = std::max(peak, kept + bytes);
    if (!isThere)
    {
      kept += vtkRelievoMeshTree::LeastBytesOfTriangle *
        static_cast<double>(vtkRelievoPolygonCut::CountTriangles(mesh.Mesh));
    }
  }
  return peak;
}

//------------------------------------------------------------------------------
void vtkRelievoRayTree::SetMeshTree(vtkPolyData* mesh, bool byOutline,
  const std::shared_ptr<vtkRelievoMeshTree>& triangles, bool fixed)
{
  Cached& cached = this->Trees[{ mesh, byOutline }];
  if (cached.Data != mesh || cached.Triangles != triangles)
  {
    triangles->SetMesh(mesh, GetRule(byOutline));
    cached = { mesh, triangles, fixed };
    this->Meshes.clear(); // places refer to the former trees
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayTree::SetMeshes(
  const std::vector<vtkRelievoPlacedMesh>& meshes, std::string& lack)
{
  const double bytes = this->GetBytesToBuild(meshes);
  lack = bytes > 0.0 ? relievo::LackOfMemory(bytes, 0.0) : "";
  try
  {
    if (lack.empty())
    {
      this->PlacesRefitted = false;
      const bool changed = this->UpdateMeshes(meshes);
      const bool same = !changed &&
        std::equal(
          meshes.begin(), meshes.end(), this->Meshes.begin(), this->Meshes.end(), IsSamePlace);
      this->Meshes = meshes;
      if (!same)
      {
        this->Place();
      }
      return !same;
    }
  }
  catch (const std::bad_alloc&) // its peak depends on the mesh
  {
    lack = "it would take about " + std::to_string(static_cast<long long>(bytes)) +
      " bytes, and memory ran out";
  }
  *this = vtkRelievoRayTree();
  return true;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoRayTree::GetToScene(const Placed& placed) const
{
  glm::dmat4 toScene =
    this->Meshes[placed.Mesh].GetPlace(static_cast<std::size_t>(placed.Instance));
  toScene[3] = glm::dvec4(
    glm::dvec3(toScene * glm::dvec4(placed.Triangles->GetOrigin(), 1.0)) - this->Center, 1.0);
  return toScene;
}

//------------------------------------------------------------------------------
void vtkRelievoRayTree::Place()
{
  const std::size_t before = this->Places.size();
  this->Places.clear();
  std::vector<glm::dvec3> boxes; // least and greatest corners
  glm::dvec3 least(NoEnd);
  glm::dvec3 most(-NoEnd);
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    const vtkRelievoPlacedMesh& mesh = this->Meshes[i];
    Placed placed;
    placed.Triangles = this->Trees[{ mesh.Mesh, mesh.ByOutline }].Triangles.get();
    placed.Mesh = static_cast<int>(i);
    const std::size_t count = placed.Triangles->IsEmpty() ? 0 : mesh.GetNumberOfPlaces();
    for (std::size_t k = 0; k < count; ++k)
    {
      placed.Instance = static_cast<int>(k);
      const glm::dmat4 toWorld = mesh.GetPlace(k);
      const glm::dvec3& low = placed.Triangles->GetLow();
      const glm::dvec3& high = placed.Triangles->GetHigh();
      boxes.emplace_back(NoEnd);
      boxes.emplace_back(-NoEnd);
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::dvec3 p(
          corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
        const glm::dvec3 world(toWorld * glm::dvec4(p + placed.Triangles->GetOrigin(), 1.0));
        boxes[boxes.size() - 2] = glm::min(boxes[boxes.size() - 2], world);
        boxes.back() = glm::max(boxes.back(), world);
      }
      if (!IsFiniteCorner(boxes[boxes.size() - 2]) || !IsFiniteCorner(boxes.back()))
      {
        boxes.resize(boxes.size() - 2);
        continue; // by the matrix: nothing to hit
      }
      least = glm::min(least, boxes[boxes.size() - 2]);
      most = glm::max(most, boxes.back());
      this->Places.push_back(placed);
    }
  }
  this->Places.shrink_to_fit();
  this->Center = this->Places.empty() ? glm::dvec3(0.0) : 0.5 * least + 0.5 * most;
  this->Half = this->Places.empty() ? glm::dvec3(0.0) : 0.5 * most - 0.5 * least;
  const double reach = std::max({ this->Half.x, this->Half.y, this->Half.z });
  this->Scale = reach > 1e-290 ? 1.0 / reach : 1.0;
  std::vector<vtkRelievoWideTree::Box> rounded;
  rounded.reserve(this->Places.size());
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    this->Places[i].ToMesh = glm::inverse(this->GetToScene(this->Places[i]));
    rounded.push_back(vtkRelievoWideTree::Around(this->Scale * (boxes[2 * i] - this->Center),
      this->Scale * (boxes[2 * i + 1] - this->Center)));
  }
  this->PlacesRefitted = before == this->Places.size() && before > 0 && this->Tree.Refit(rounded);
  if (!this->PlacesRefitted)
  {
    this->Tree.Build(rounded, 1);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoRayTree::GetBytes() const
{
  std::size_t bytes = this->Places.capacity() * sizeof(Placed) + this->Tree.GetBytes();
  for (const auto& cached : this->Trees)
  {
    bytes += cached.second.Triangles->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
long long vtkRelievoRayTree::GetNumberOfTriangles() const
{
  long long count = 0;
  for (const Placed& placed : this->Places)
  {
    count += placed.Triangles->GetNumberOfTriangles();
  }
  return count;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayTree::IsBefore(const Hit& a, const Hit& b) const
{
  if (a.T != b.T || a.Place != b.Place)
  {
    return a.T < b.T || (a.T == b.T && a.Place < b.Place);
  }
  const vtkRelievoMeshTree& mesh = *this->Places[a.Place].Triangles;
  return mesh.GetCell(a.Triangle) < mesh.GetCell(b.Triangle);
}

//------------------------------------------------------------------------------
vtkRelievoRayTree::Hit vtkRelievoRayTree::FindNearest(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high) const
{
  Hit nearest;
  this->Walk(from, ray, low, high, [&](int place, int triangle, double t) {
    const Hit hit{ place, triangle, t };
    if (nearest.Place < 0 || this->IsBefore(hit, nearest))
    {
      nearest = hit;
    }
    return nearest.T;
  });
  return nearest;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayTree::HitsAny(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high) const
{
  bool any = false;
  this->Walk(from, ray, low, high, [&](int, int, double) {
    any = true;
    return -NoEnd;
  });
  return any;
}

//------------------------------------------------------------------------------
void vtkRelievoRayTree::FindNearest(
  const Line* lines, int count, double low, double high, Hit* hits) const
{
  this->Find<false>(lines, count, low, high, hits);
}

//------------------------------------------------------------------------------
void vtkRelievoRayTree::FindAny(
  const Line* lines, int count, double low, double high, Hit* hits) const
{
  this->Find<true>(lines, count, low, high, hits);
}

//------------------------------------------------------------------------------
template <bool OnlyAny>
void vtkRelievoRayTree::Find(const Line* lines, int count, double low, double high, Hit* hits) const
{
  const bool inTurns = this->Places.size() == 1 &&
    this->Places[0].Triangles->GetTree().HasSteps() &&
    this->Places[0].Triangles->GetBytes() >= LeastBytesForTurns;
  if (inTurns && vtkRelievoWideTree::UsesAvx2())
  {
    this->FindInTurnsByAvx2<OnlyAny>(lines, count, low, high, hits);
    return;
  }
  if (inTurns)
  {
    this->FindInTurns<OnlyAny, false>(lines, count, low, high, hits);
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3& from = lines[i].From;
    const glm::dvec3& ray = lines[i].Direction;
    if (OnlyAny)
    {
      hits[i] = Hit();
      hits[i].Place = this->HitsAny(from, ray, low, high) ? 0 : -1;
    }
    else
    {
      hits[i] = this->FindNearest(from, ray, low, high);
    }
  }
}

//------------------------------------------------------------------------------
template <bool OnlyAny>
void vtkRelievoRayTree::FindInTurnsByAvx2(
  const Line* lines, int count, double low, double high, Hit* hits) const
{
  this->FindInTurns<OnlyAny, true>(lines, count, low, high, hits);
}

//------------------------------------------------------------------------------
// In a scene of one place.
template <bool OnlyAny, bool ByAvx2>
RELIEVO_INLINED void vtkRelievoRayTree::FindInTurns(
  const Line* lines, int count, double low, double high, Hit* hits) const
{
  struct Turn
  {
    vtkRelievoMeshTree::Course Course;
    vtkRelievoWideTree::Steps Steps;
    Hit* Found = nullptr;
  };
  const Placed& placed = this->Places[0];
  const vtkRelievoMeshTree& mesh = *placed.Triangles;
  int next = 0;
  const auto start = [&](Turn& turn) {
    while (next < count)
    {
      const Line& line = lines[next];
      turn.Found = hits + next++;
      *turn.Found = Hit();
      if (turn.Course.Start(mesh, GetInner(placed, line.From, line.Direction), low, high))
      {
        turn.Steps.Start(turn.Course.GetRounded(mesh), turn.Course.GetLast());
        return true;
      }
    }
    return false;
  };
  Turn turns[Turns];
  Turn* order[Turns];
  int active = 0;
  while (active < Turns && start(turns[active]))
  {
    order[active] = turns + active;
    ++active;
  }
  while (active > 0)
  {
    for (int i = 0; i < active; ++i)
    {
      Turn& turn = *order[i];
      const auto take = [&](int triangle, double t) {
        const Hit hit{ 0, triangle, t };
        if (turn.Found->Place < 0 || this->IsBefore(hit, *turn.Found))
        {
          *turn.Found = hit;
        }
        return OnlyAny ? -NoEnd : turn.Found->T;
      };
      const auto test = [&](int first, int size) {
        return turn.Course.Test(mesh, first, size, ByAvx2, take);
      };
      if (!mesh.GetTree().Step<ByAvx2>(
            turn.Steps, mesh.GetCorners(0), 3 * sizeof(std::uint32_t), test) &&
        !start(turn))
      {
        order[i--] = order[--active];
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayTree::FindAll(const glm::dvec3& from, const glm::dvec3& ray, double low,
  double high, std::vector<Hit>& hits) const
{
  hits.clear();
  this->Walk(from, ray, low, high, [&](int place, int triangle, double t) {
    hits.push_back({ place, triangle, t });
    return high;
  });
  std::sort(
    hits.begin(), hits.end(), [this](const Hit& a, const Hit& b) { return this->IsBefore(a, b); });
}

//------------------------------------------------------------------------------
void vtkRelievoRayTree::GetCorners(int place, int triangle, glm::dvec3 corners[3]) const
{
  const Placed& placed = this->Places[place];
  const glm::dmat4 toScene = this->GetToScene(placed);
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = glm::dvec3(toScene * glm::dvec4(placed.Triangles->GetCorner(triangle, i), 1.0));
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoRayTree::GetNormal(int place, int triangle, glm::dvec3& corner) const
{
  glm::dvec3 p[3];
  this->GetCorners(place, triangle, p);
  corner = p[0];
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

//------------------------------------------------------------------------------
bool vtkRelievoRayTree::Owns(
  int place, int triangle, const glm::dvec3& from, const glm::dvec3& ray) const
{
  const Placed& placed = this->Places[place];
  const vtkRelievoMeshTree& mesh = *placed.Triangles;
  return GetInner(placed, from, ray)
    .Owns(mesh.GetCorner(triangle, 0), mesh.GetCorner(triangle, 1), mesh.GetCorner(triangle, 2));
}

//------------------------------------------------------------------------------
vtkRelievoRayTree::Details vtkRelievoRayTree::GetDetails(
  const Hit& hit, const glm::dvec3& from, const glm::dvec3& ray) const
{
  const Placed& placed = this->Places[hit.Place];
  const vtkRelievoMeshTree& mesh = *placed.Triangles;
  const glm::dvec3& a = mesh.GetCorner(hit.Triangle, 0);
  const glm::dvec3& b = mesh.GetCorner(hit.Triangle, 1);
  const glm::dvec3& c = mesh.GetCorner(hit.Triangle, 2);
  const vtkRelievoRay inner = GetInner(placed, from, ray);
  double t = 0.0;
  glm::dvec3 sides(1.0, 0.0, 0.0);
  inner.Hits(a, b, c, t, sides);
  Details details;
  details.Weights = sides / (sides.x + sides.y + sides.z);
  const glm::dmat4 toScene = this->GetToScene(placed);
  const glm::dvec3 own = details.Weights.x * a + details.Weights.y * b + details.Weights.z * c;
  details.Position = glm::dvec3(toScene * glm::dvec4(own, 1.0)) + this->Center;
  const glm::dmat3 turn(toScene);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  details.Front = glm::dot(normal, inner.Ray) <= 0.0;
  details.Normal = glm::cross(turn * (b - a), turn * (c - a));
  if (glm::determinant(turn) < 0.0)
  {
    details.Normal = -details.Normal; // mirrored: the front remains the front
  }
  return details;
}
