// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of a mesh for shaders/rays/tree.glsl: in coordinates about the mesh's centre, in
// the order of a tree.
#ifndef vtkRelievoCasterMesh_h
#define vtkRelievoCasterMesh_h

#include "vtkRelievoBoxTree.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkType.h"

#include <vector>

class vtkPolyData;

class VTKRELIEVORAYS_EXPORT vtkRelievoMeshTexels
{
public:
  // Maximum number of triangles per mesh, since floats count leaves. Tests set a smaller one.
  static vtkIdType GetMostTriangles() { return MostTriangles; }
  static void SetMostTriangles(vtkIdType most) { MostTriangles = most; }

  // Updates changed parts. Returns whether anything has changed.
  bool Update(vtkPolyData* data);

  // Nodes, then triangles: five texels per pair.
  const std::vector<glm::vec4>& GetTexels() const { return this->Texels; }
  int GetNumberOfLeaves() const { return static_cast<int>(this->Tree.GetNodes().size() + 1) / 2; }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Tree.GetOrder().size()); }
  bool WasRefitted() const { return this->Refitted; } // in the last update

  const glm::dvec3& GetOrigin() const { return this->Origin; }
  void GetBounds(glm::dvec3& low, glm::dvec3& high) const; // about the origin

private:
  static vtkIdType MostTriangles;

  void Pack(const std::vector<glm::vec3>& corners);

  vtkRelievoBoxTree Tree;
  std::vector<glm::vec4> Texels;
  glm::dvec3 Origin{ 0.0 };
  double CostWhenBuilt = 0.0;
  bool Refitted = false;
  std::vector<vtkMTimeType> Times; // of points, polygons and strips
};

#endif
