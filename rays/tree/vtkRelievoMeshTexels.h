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
  // Whether there are not too many triangles.
  static bool Follows(vtkPolyData* data);

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
  void Pack(const std::vector<glm::vec3>& corners);

  vtkRelievoBoxTree Tree;
  std::vector<glm::vec4> Texels;
  glm::dvec3 Origin{ 0.0 };
  double CostWhenBuilt = 0.0;
  bool Refitted = false;
  std::vector<vtkMTimeType> Times; // of points, polygons and strips
};

#endif
