// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh at a place of the world, or at many.
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
  // Of glyphs: from the mesh to the coordinates of MeshToWorld. Null: it is there once.
  std::shared_ptr<const std::vector<glm::dmat4>> Places;
  std::shared_ptr<const std::vector<vtkIdType>> Points; // of the glyphs' input, one for each place
  vtkActor* Actor = nullptr;                            // that draws it
  int Block = 0;           // its flat index in composite data; of glyphs, that of their points
  double Passes = 0.0;     // of the light: 1 - opacity; NaN: not known, or not one for all
  glm::dvec3 Color{ 1.0 }; // of what passes
  double Reach = 0.0;      // of the mesh, the largest coordinate that OpenGL rounds to draw it
  bool CullsFront = false; // to the eye; it casts from both sides
  bool CullsBack = false;
  bool ByOutline = false; // polygons are what their outlines enclose, not what VTK draws of them

  std::size_t GetNumberOfPlaces() const { return this->Places ? this->Places->size() : 1; }
  glm::dmat4 GetPlace(std::size_t i) const // to the world
  {
    return this->Places ? this->MeshToWorld * (*this->Places)[i] : this->MeshToWorld;
  }
};

#endif
