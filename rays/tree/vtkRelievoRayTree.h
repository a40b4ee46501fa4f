// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays in double precision past the triangles of a scene, on the CPU: a tree over places, and for
// each mesh, once however often it is placed, a tree over its triangles.
//
// Coordinates are the world's axes about the scene's centre. A ray's t counts in lengths of it.
#ifndef vtkRelievoRayTree_h
#define vtkRelievoRayTree_h

#include "vtkRelievoMeshTree.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkWeakPointer.h"

#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoRayTree
{
public:
  // Where a ray meets a triangle.
  struct Meeting
  {
    int Place = -1; // none
    int Triangle = -1;
    double T = std::numeric_limits<double>::infinity();
  };

  // What a meeting is, in the world.
  struct Details
  {
    glm::dvec3 Weights;  // of the triangle's corners
    glm::dvec3 Position; // of the corners by their weights
    glm::dvec3 Normal;   // of the plane, by the corners' order; not unit
    bool Front = true;   // whether the ray meets the side that the normal is on
  };

  // Meshes that have not changed keep their trees, and so do places. Returns whether anything has
  // changed. The meshes must live as long as rays are asked.
  bool SetMeshes(const std::vector<vtkRelievoPlacedMesh>& meshes);

  // By the last SetMeshes: meshes whose trees were built, and those that were fitted to moved
  // points.
  int GetMeshesBuilt() const { return this->MeshesBuilt; }
  int GetMeshesRefitted() const { return this->MeshesRefitted; }
  bool WerePlacesRefitted() const { return this->PlacesRefitted; }

  const glm::dvec3& GetCenter() const { return this->Center; }
  int GetNumberOfPlaces() const { return static_cast<int>(this->Places.size()); }
  long long GetNumberOfTriangles() const; // of all places
  std::size_t GetBytes() const;

  // Which of the meshes is at a place, and which of its own places this is.
  int GetMesh(int place) const { return this->Places[place].Mesh; }
  int GetInstance(int place) const { return this->Places[place].Instance; }
  const vtkRelievoMeshTree& GetMeshTree(int place) const { return *this->Places[place].Triangles; }
  const glm::dmat4& GetToMesh(int place) const { return this->Places[place].ToMesh; }
  glm::dmat4 GetToScene(int place) const { return this->GetToScene(this->Places[place]); }

  // Calls visit(place, triangle, t) for every meeting between, near ones first, but not in order;
  // it returns the t up to which more are of interest.
  template <typename Visit>
  void Walk(
    const glm::dvec3& from, const glm::dvec3& ray, double low, double high, Visit visit) const;

  ///@{
  // The first meeting between, whether there is one, and all of them in order.
  Meeting FindNearest(const glm::dvec3& from, const glm::dvec3& ray, double low, double high) const;
  bool MeetsAny(const glm::dvec3& from, const glm::dvec3& ray, double low, double high) const;
  void FindAll(const glm::dvec3& from, const glm::dvec3& ray, double low, double high,
    std::vector<Meeting>& meetings) const;
  ///@}

  Details GetDetails(const Meeting& meeting, const glm::dvec3& from, const glm::dvec3& ray) const;

  // Of the plane, and one of its points; not unit.
  glm::dvec3 GetNormal(int place, int triangle, glm::dvec3& corner) const;

  // Of triangles that share an edge which the ray meets, one on either side.
  bool Owns(int place, int triangle, const glm::dvec3& from, const glm::dvec3& ray) const;

private:
  struct Placed
  {
    const vtkRelievoMeshTree* Triangles = nullptr;
    int Mesh = 0;
    int Instance = 0;
    glm::dmat4 ToMesh{ 1.0 }; // about its origin
  };
  using Key = std::pair<vtkPolyData*, bool>; // and whether its polygons are taken by their outlines
  struct Held
  {
    vtkWeakPointer<vtkPolyData> Data;
    std::shared_ptr<vtkRelievoMeshTree> Triangles;
  };
  bool UpdateMeshes(const std::vector<vtkRelievoPlacedMesh>& meshes);
  void Place();
  // In the order along the ray; at one place of it by number: it does not depend on the trees.
  bool IsBefore(const Meeting& a, const Meeting& b) const;
  glm::dmat4 GetToScene(const Placed& placed) const;
  void GetCorners(int place, int triangle, glm::dvec3 corners[3]) const; // of the scene
  static vtkRelievoRay GetInner(const Placed& placed, const glm::dvec3& from, const glm::dvec3& ray)
  {
    return vtkRelievoRay(
      glm::dvec3(placed.ToMesh * glm::dvec4(from, 1.0)), glm::dmat3(placed.ToMesh) * ray);
  }

  std::map<Key, Held> Trees;
  std::vector<vtkRelievoPlacedMesh> Meshes;
  std::vector<Placed> Places; // of Meshes, one or more each
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
