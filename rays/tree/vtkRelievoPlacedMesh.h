// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh with one or many placements in the world.
#ifndef vtkRelievoPlacedMesh_h
#define vtkRelievoPlacedMesh_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkType.h"

#include <memory>
#include <vector>

class vtkActor;
class vtkPolyData;

struct vtkRelievoPlacedMesh
{
  vtkPolyData* Mesh = nullptr;
  glm::dmat4 MeshToWorld{ 1.0 };
  // For glyphs: from the mesh to the coordinates of MeshToWorld. Null: a single placement.
  std::shared_ptr<const std::vector<glm::dmat4>> Places;
  std::shared_ptr<const std::vector<vtkIdType>> Points; // of the glyphs' input, one for each place
  vtkActor* Actor = nullptr;                            // the actor that draws the mesh
  int Block = 0;           // its flat index in composite data; for glyphs, that of their points
  double Opacity = 1.0;    // NaN: unknown, or not constant
  glm::dvec3 Color{ 1.0 }; // colour of the transmitted light
  double Reach = 0.0;      // the largest coordinate that OpenGL rounds to draw the mesh
  bool CullsFront = false; // towards the eye; shadows are cast from both sides
  bool CullsBack = false;
  bool ByOutline = false; // polygons are the areas inside their outlines, not VTK's triangles

  std::size_t GetNumberOfPlaces() const { return this->Places ? this->Places->size() : 1; }
  glm::dmat4 GetPlace(std::size_t i) const // to the world
  {
    return this->Places ? this->MeshToWorld * (*this->Places)[i] : this->MeshToWorld;
  }
};

#endif
