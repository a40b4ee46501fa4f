// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of a mesh for rays in double, about the centre of its points, in the order of a
// tree's leaves.
#ifndef vtkRelievoMeshTree_h
#define vtkRelievoMeshTree_h

#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRay.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkRelievoStoredArray.h"
#include "vtkRelievoWideTree.h"
#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;
class vtkRelievoRayFileReader;
class vtkRelievoRayFileWriter;

class VTKRELIEVORAYS_EXPORT vtkRelievoMeshTree
{
public:
  // Maximum number of triangles per mesh: an int holds the place of a leaf's first triangle and the
  // number of its triangles.
  static constexpr vtkIdType MostTriangles = VTK_INT_MAX / vtkRelievoWideTree::Most;

  // Updates changed parts; moved points only refit the tree. Returns whether anything has changed.
  // No ray hits a triangle with a corner that is not finite. The rule of the first call is kept.
  bool Update(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule);
  bool WasRefitted() const { return this->Refitted; } // in the last update
  // Bytes that Update usually needs, at its peak and beyond those held now, to build the tree; 0
  // for a tree that is kept or refitted.
  double GetBytesToBuild(vtkPolyData* data) const;
  // That a built tree has at least for each triangle: three corners, a cell, and a share of a node.
  static constexpr double LeastBytesOfTriangle = 24.0;

  int GetNumberOfTriangles() const { return static_cast<int>(this->Corners.size() / 3); }
  const glm::dvec3& GetOrigin() const { return this->Origin; }
  // About the origin. Valid if some triangle is finite.
  const glm::dvec3& GetLow() const { return this->Low; }
  const glm::dvec3& GetHigh() const { return this->High; }
  bool IsEmpty() const { return !(this->Low.x <= this->High.x); }

  // About the origin.
  const glm::dvec3& GetCorner(int triangle, int corner) const
  {
    return this->Places[this->GetCorners(triangle)[corner]];
  }
  // All corners of triangles, once each, about the origin; and their indices in the mesh's points;
  // in the order of first use by triangles.
  const vtkRelievoStoredArray<glm::dvec3>& GetPlaces() const { return this->Places; }
  const vtkRelievoStoredArray<std::uint32_t>& GetPoints() const { return this->Points; }
  // Three indices into the corners, for a triangle.
  const std::uint32_t* GetCorners(int triangle) const
  {
    return this->Corners.data() + 3 * static_cast<std::size_t>(triangle);
  }
  const vtkRelievoWideTree& GetTree() const { return this->Tree; }
  // Index in the mesh.
  vtkIdType GetPoint(int triangle, int corner) const
  {
    return static_cast<vtkIdType>(this->Points[this->GetCorners(triangle)[corner]]);
  }
  // Index in the mesh.
  vtkIdType GetCell(int triangle) const
  {
    return this->CellOffset + static_cast<vtkIdType>(this->Cells[triangle]);
  }

  std::size_t GetBytes() const;

  void Write(vtkRelievoRayFileWriter& file) const;
  // Reads what Write has written, which stays in the file's memory. False if no such tree is there.
  bool Read(vtkRelievoRayFileReader& file);
  // The tree read is that of this mesh as it is now.
  void SetMesh(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule);
  // The largest indices of triangles in the mesh; -1: there are no triangles.
  vtkIdType GetLastCell() const;
  vtkIdType GetLastPoint() const;

  // Calls visit(triangle, t) for every hit in the range; `visit` returns the t up to which further
  // hits matter. Roughly from near to far. The ray is about the origin.
  template <typename Visit>
  void Walk(const vtkRelievoRay& ray, double low, double high, Visit visit) const;

  // Calls visit(first, count) for runs of triangles, among them all that reach into each of some
  // half-spaces about the origin; `visit` returns whether to continue.
  template <typename Visit>
  void FindWithin(vtkRelievoWideTree::HalfSpace* spaces, int count, Visit visit) const
  {
    for (int i = 0; i < count; ++i)
    {
      spaces[i].Least *= this->Scale;
    }
    this->Tree.FindWithin(spaces, count, visit);
  }

  class Course;

private:
  void TakePlaces(vtkPolyData* data, bool all);
  void TakeTriangles(vtkPolyData* data, vtkRelievoPolygonCut::Rule rule);
  vtkRelievoBoxTree::Box GetBox(int triangle) const;
  std::vector<vtkRelievoBoxTree::Box> GetBoxes() const;
  void SortTriangles();
  void SortPoints(vtkPolyData* data);

  std::vector<vtkMTimeType> Times; // of points, polygons and strips
  std::uint64_t Cuts = 0;          // hash of the triangulation that depends on points
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 Low{ 1.0 };
  glm::dvec3 High{ -1.0 };
  double Scale = 1.0; // from the mesh's to the tree's coordinates
  // Points of triangles, in the order of their use by leaves, so that a leaf's points lie together.
  vtkRelievoStoredArray<std::uint32_t> Points; // indices in the mesh
  vtkRelievoStoredArray<glm::dvec3> Places;
  vtkRelievoStoredArray<std::uint32_t> Corners; // three indices into Points per triangle
  vtkRelievoStoredArray<std::uint32_t> Cells;   // polygons, and then strips
  vtkIdType CellOffset = 0;                     // of the first polygon
  vtkRelievoWideTree Tree;
  bool Refitted = false;
};

// The range in which a ray is inside a box, slightly enlarged. False if it is empty between low and
// high.
inline bool vtkRelievoClip(const glm::dvec3& from, const glm::dvec3& inverse,
  const glm::dvec3& least, const glm::dvec3& greatest, double& low, double& high)
{
  const glm::dvec3 size = greatest - least;
  const double room = 4.0 * vtkRelievoWideTree::Room * std::max(std::max(size.x, size.y), size.z);
  for (int i = 0; i < 3; ++i)
  {
    const double a = (least[i] - room - from[i]) * inverse[i];
    const double b = (greatest[i] + room - from[i]) * inverse[i];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low <= high;
}

// Inverse of a direction, without infinities, which would lose rays inside a box's side.
inline glm::dvec3 vtkRelievoInvert(const glm::dvec3& ray)
{
  glm::dvec3 inverse;
  for (int i = 0; i < 3; ++i)
  {
    inverse[i] = std::abs(ray[i]) > 1e-290 ? 1.0 / ray[i] : std::copysign(1e290, ray[i]);
  }
  return inverse;
}

// A ray in a mesh, between its first point in the mesh's box and the farthest hit that matters.
class vtkRelievoMeshTree::Course
{
public:
  // False if the ray misses the mesh's box.
  bool Start(const vtkRelievoMeshTree& mesh, const vtkRelievoRay& ray, double low, double high)
  {
    this->Ray = ray;
    this->Low = low;
    this->High = high;
    this->Enters = low;
    this->Leaves = high;
    this->Inverse = vtkRelievoInvert(ray.Ray);
    if (!vtkRelievoClip(ray.From, this->Inverse, mesh.Low, mesh.High, this->Enters, this->Leaves))
    {
      return false;
    }
    // The tree's unit is the mesh's half size, and the ray's unit the largest coordinate of its
    // direction.
    this->Size = std::abs(ray.Ray[ray.Z]);
    this->ToTree = mesh.Scale * this->Size;
    return true;
  }
  vtkRelievoWideTree::Ray GetRounded(const vtkRelievoMeshTree& mesh) const
  {
    return { mesh.Scale * (this->Ray.From + this->Enters * this->Ray.Ray),
      this->Size * this->Inverse };
  }
  float GetLast() const
  {
    return static_cast<float>((this->Leaves - this->Enters) * this->ToTree * (1.0 + 1e-6) + 1e-6);
  }

  // Calls visit(triangle, t) for hits in a leaf, as vtkRelievoMeshTree::Walk; returns the end in
  // the tree.
  template <typename Visit>
  float Test(const vtkRelievoMeshTree& mesh, int first, int count, bool byFour, Visit visit)
  {
    const auto take = [&](int triangle, double t) {
      if (t >= this->Low && t <= this->High)
      {
        this->High = visit(triangle, t);
        this->Leaves = std::min(this->Leaves, this->High);
      }
    };
    const std::uint32_t* corners = mesh.GetCorners(first);
    if (byFour && count == 4)
    {
      double t[4];
      unsigned bits = vtkRelievoAvx2::HitTriangles(this->Ray, mesh.Places.data(), corners, t);
      for (; bits != 0; bits &= bits - 1)
      {
        const int i = vtkRelievoGetLowest(bits);
        take(first + i, t[i]);
      }
    }
    else
    {
      for (int i = 0; i < count; ++i, corners += 3)
      {
        double t = 0.0;
        glm::dvec3 sides;
        if (this->Ray.Hits(
              mesh.Places[corners[0]], mesh.Places[corners[1]], mesh.Places[corners[2]], t, sides))
        {
          take(first + i, t);
        }
      }
    }
    return this->High < this->Low ? -1.f : std::max(0.f, this->GetLast());
  }

private:
  vtkRelievoRay Ray{ glm::dvec3(0.0), glm::dvec3(1.0) };
  glm::dvec3 Inverse{ 1.0 };
  double Low = 0.0;
  double High = 0.0;
  double Enters = 0.0;
  double Leaves = 0.0;
  double Size = 1.0;
  double ToTree = 1.0;
};

//------------------------------------------------------------------------------
template <typename Visit>
void vtkRelievoMeshTree::Walk(const vtkRelievoRay& ray, double low, double high, Visit visit) const
{
  Course course;
  if (!course.Start(*this, ray, low, high))
  {
    return;
  }
  const bool byFour = vtkRelievoWideTree::UsesAvx2();
  this->Tree.Walk(course.GetRounded(*this), course.GetLast(), this->Corners.data(),
    3 * sizeof(std::uint32_t),
    [&](int first, int count) { return course.Test(*this, first, count, byFour, visit); });
}

#endif
