// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Traces rays in double precision through the triangles of a scene, on the CPU: a tree over places,
// and one tree over the triangles of each mesh, however often it is placed.
//
// Coordinates are the world's axes about the scene's centre. A ray's t is in units of its length.
#ifndef vtkRelievoRayTree_h
#define vtkRelievoRayTree_h

#include "vtkRelievoMeshTree.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkWeakPointer.h"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoRayTree
{
public:
  // A hit of a ray with a triangle.
  struct Hit
  {
    int Place = -1; // -1: no hit
    int Triangle = -1;
    double T = std::numeric_limits<double>::infinity();
  };

  // Details of a hit, in world coordinates.
  struct Details
  {
    glm::dvec3 Weights;  // of the triangle's corners
    glm::dvec3 Position; // mean of the corners by their weights
    glm::dvec3 Normal;   // of the plane, by the corners' order; not unit
    bool Front = true;   // whether the ray hits the side of the normal
  };

  // Sets the scene. Unchanged meshes and places keep their trees. Returns whether anything has
  // changed. The meshes must exist as long as rays are traced. Without enough memory the scene is
  // empty, with the numbers in `lack`.
  bool SetMeshes(const std::vector<vtkRelievoPlacedMesh>& meshes, std::string& lack);

  // Bytes that SetMeshes usually needs, at its peak, beyond those held now.
  double GetBytesToBuild(const std::vector<vtkRelievoPlacedMesh>& meshes) const;

  // Gives the tree of a mesh as it is now, which the next SetMeshes uses instead of building it.
  // `fixed`: the mesh does not change, and need not have the tree's points and cells.
  void SetMeshTree(vtkPolyData* mesh, bool byOutline,
    const std::shared_ptr<vtkRelievoMeshTree>& triangles, bool fixed);

  // In the last SetMeshes: meshes whose trees were built, and meshes whose trees were refitted to
  // moved points.
  int GetMeshesBuilt() const { return this->MeshesBuilt; }
  int GetMeshesRefitted() const { return this->MeshesRefitted; }
  bool WerePlacesRefitted() const { return this->PlacesRefitted; }

  const glm::dvec3& GetCenter() const { return this->Center; }
  int GetNumberOfPlaces() const { return static_cast<int>(this->Places.size()); }
  long long GetNumberOfTriangles() const; // over all places
  std::size_t GetBytes() const;

  // The mesh at a place, and the index among the mesh's own places.
  int GetMesh(int place) const { return this->Places[place].Mesh; }
  int GetInstance(int place) const { return this->Places[place].Instance; }
  const vtkRelievoMeshTree& GetMeshTree(int place) const { return *this->Places[place].Triangles; }
  // The tree of one of the meshes of the last SetMeshes.
  const vtkRelievoMeshTree& GetMeshTree(vtkPolyData* mesh, bool byOutline) const
  {
    return *this->Trees.at({ mesh, byOutline }).Triangles;
  }
  const glm::dmat4& GetToMesh(int place) const { return this->Places[place].ToMesh; }
  glm::dmat4 GetToScene(int place) const { return this->GetToScene(this->Places[place]); }

  // Calls visit(place, triangle, t) for every hit in the range, roughly from near to far; `visit`
  // returns the t up to which further hits matter.
  template <typename Visit>
  void Walk(
    const glm::dvec3& from, const glm::dvec3& ray, double low, double high, Visit visit) const;

  // Calls visit(place) for places, among them all that reach into each of some half-spaces; `visit`
  // returns whether to continue.
  template <typename Visit>
  void FindWithin(vtkRelievoWideTree::HalfSpace* spaces, int count, Visit visit) const
  {
    for (int i = 0; i < count; ++i)
    {
      spaces[i].Least *= this->Scale;
    }
    this->Tree.FindWithin(
      spaces, count, [&](int first, int) { return visit(this->Tree.GetOrder()[first]); });
  }

  ///@{
  // The first hit in the range, whether there is any, and all hits in order.
  Hit FindNearest(const glm::dvec3& from, const glm::dvec3& ray, double low, double high) const;
  bool HitsAny(const glm::dvec3& from, const glm::dvec3& ray, double low, double high) const;
  void FindAll(const glm::dvec3& from, const glm::dvec3& ray, double low, double high,
    std::vector<Hit>& hits) const;
  ///@}

  // A ray without a range.
  struct Line
  {
    glm::dvec3 From{ 0.0 };
    glm::dvec3 Direction{ 0.0 };
  };
  ///@{
  // FindNearest for many rays, and some hit of each if there is any. In large meshes rays take
  // turns, so that other rays are traversed while a ray's memory is read.
  void FindNearest(const Line* lines, int count, double low, double high, Hit* hits) const;
  void FindAny(const Line* lines, int count, double low, double high, Hit* hits) const;
  ///@}

  Details GetDetails(const Hit& hit, const glm::dvec3& from, const glm::dvec3& ray) const;

  // Normal of the plane, and one of its points; not unit.
  glm::dvec3 GetNormal(int place, int triangle, glm::dvec3& corner) const;

  // For triangles that share an edge hit by the ray, whether this one owns the hit.
  bool Owns(int place, int triangle, const glm::dvec3& from, const glm::dvec3& ray) const;

private:
  struct Placed
  {
    const vtkRelievoMeshTree* Triangles = nullptr;
    int Mesh = 0;
    int Instance = 0;
    glm::dmat4 ToMesh{ 1.0 }; // about the mesh's origin
  };
  using Key = std::pair<vtkPolyData*, bool>; // and whether polygons are triangulated by outline
  struct Cached
  {
    vtkWeakPointer<vtkPolyData> Data;
    std::shared_ptr<vtkRelievoMeshTree> Triangles;
    bool Fixed = false;
  };
  bool UpdateMeshes(const std::vector<vtkRelievoPlacedMesh>& meshes);
  void Place();
  // Order along the ray; at equal positions by number, independent of the trees.
  bool IsBefore(const Hit& a, const Hit& b) const;
  template <bool OnlyAny>
  void Find(const Line* lines, int count, double low, double high, Hit* hits) const;
  template <bool OnlyAny, bool ByAvx2>
  void FindInTurns(const Line* lines, int count, double low, double high, Hit* hits) const;
  template <bool OnlyAny>
  RELIEVO_AVX2 void FindInTurnsByAvx2(
    const Line* lines, int count, double low, double high, Hit* hits) const;
  glm::dmat4 GetToScene(const Placed& placed) const;
  // In the scene's coordinates.
  void GetCorners(int place, int triangle, glm::dvec3 corners[3]) const;
  static vtkRelievoRay GetInner(const Placed& placed, const glm::dvec3& from, const glm::dvec3& ray)
  {
    return vtkRelievoRay(
      glm::dvec3(placed.ToMesh * glm::dvec4(from, 1.0)), glm::dmat3(placed.ToMesh) * ray);
  }

  std::map<Key, Cached> Trees;
  std::vector<vtkRelievoPlacedMesh> Meshes;
  std::vector<Placed> Places; // one or more for each of Meshes
  vtkRelievoWideTree Tree;    // over Places, about the centre, in units of Size
  glm::dvec3 Center{ 0.0 };
  glm::dvec3 Half{ 0.0 }; // of the box of all
  double Scale = 1.0;
  int MeshesBuilt = 0;
  int MeshesRefitted = 0;
  bool PlacesRefitted = false;
};

//------------------------------------------------------------------------------
template <typename Visit>
void vtkRelievoRayTree::Walk(
  const glm::dvec3& from, const glm::dvec3& ray, double low, double high, Visit visit) const
{
  const auto walkPlace = [&](int place) {
    const Placed& placed = this->Places[place];
    placed.Triangles->Walk(GetInner(placed, from, ray), low, high, [&](int triangle, double t) {
      high = visit(place, triangle, t);
      return high;
    });
  };
  if (this->Places.size() == 1)
  {
    walkPlace(0);
    return;
  }
  double enters = low;
  double leaves = high;
  const glm::dvec3 inverse = vtkRelievoInvert(ray);
  if (this->Places.empty() ||
    !vtkRelievoClip(from, inverse, -this->Half, this->Half, enters, leaves))
  {
    return;
  }
  const glm::dvec3 sizes = glm::abs(ray);
  const double size = std::max({ sizes.x, sizes.y, sizes.z });
  const double toTree = this->Scale * size;
  const vtkRelievoWideTree::Ray rounded(this->Scale * (from + enters * ray), size * inverse);
  const auto getLast = [&](double t) {
    return static_cast<float>((t - enters) * toTree * (1.0 + 1e-6) + 1e-6);
  };
  const auto walkLeaf = [&](int first, int) {
    walkPlace(this->Tree.GetOrder()[first]);
    leaves = std::min(leaves, high);
    return high < low ? -1.f : std::max(0.f, getLast(leaves));
  };
  this->Tree.Walk(rounded, getLast(leaves), this->Tree.GetOrder().data(), sizeof(int), walkLeaf);
}

#endif
