// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles of a mesh as shaders/shadow/exact.glsl walks them: in coordinates about the mesh's
// own middle, in the order of a tree.
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
  // At most so many triangles of a mesh are followed: a float counts them. Tests say fewer.
  static vtkIdType GetMostTriangles() { return MostTriangles; }
  static void SetMostTriangles(vtkIdType most) { MostTriangles = most; }

  // How many triangles there are if these are too many; otherwise 0.
  static vtkIdType CountTooMany(vtkPolyData* data);

  // Makes what has changed. Returns whether anything has.
  bool Update(vtkPolyData* data);

  // Nodes, then triangles: five texels for two.
  const std::vector<glm::vec4>& GetTexels() const { return this->Texels; }
  int GetNumberOfNodes() const { return static_cast<int>(this->Tree.GetNodes().size()); }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Tree.GetOrder().size()); }
  bool WasRefitted() const { return this->Refitted; } // by the last update

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
