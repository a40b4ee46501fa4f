// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The edges of a mesh that may become lines: those of one triangle, or between two triangles that
// are not in one plane. Points at the same position are merged: meshes with normals have several at
// an edge.
#ifndef vtkRelievoFeatureEdges_h
#define vtkRelievoFeatureEdges_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

class vtkRelievoFeatureEdges
{
public:
  struct Edge
  {
    std::uint32_t Points[2];
    std::uint32_t Faces[2]; // twice the same one at a mesh's boundary
    bool Flipped;           // the second triangle's normal is to be reversed
  };

  // Finds the edges; anew only after a change of points or polygons.
  void Update(vtkPolyData* mesh);

  const std::vector<glm::dvec3>& GetPoints() const { return this->Points; }
  const std::vector<glm::dvec3>& GetNormals() const { return this->Normals; } // of triangles; unit
  const std::vector<Edge>& GetEdges() const { return this->Edges; }

private:
  // A side of a triangle, from the point with the smaller number to the other.
  struct Side
  {
    std::uint32_t Points[2];
    std::uint32_t Face;
    bool Backward; // the triangle runs along it from the greater number
  };

  std::vector<std::uint32_t> TakePoints(vtkPolyData* mesh);
  void AddEdge(const Side* sides, std::size_t count);

  std::vector<vtkMTimeType> Times; // of points, polygons and strips
  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<Edge> Edges;
};

#endif
