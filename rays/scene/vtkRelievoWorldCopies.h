// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Copies of meshes in world coordinates, where rays cannot be transformed by a mesh's matrix: it is
// singular, or its last row is not 0 0 0 1.
#ifndef vtkRelievoWorldCopies_h
#define vtkRelievoWorldCopies_h

#include "vtkPolyData.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

class vtkIdTypeArray;
struct vtkRelievoRaySource;

class vtkRelievoWorldCopies
{
public:
  // An update: copies that it does not enter are deleted at its end.
  void Begin();
  void End() { this->Before.clear(); }

  // Not if a matrix is not finite, or maps points to infinity or beyond, or the copies are too
  // large.
  static bool IsTraceable(const vtkRelievoPlacedMesh& placed);

  // Replaces the mesh by its copy if it needs one.
  void Enter(vtkRelievoPlacedMesh& placed, vtkRelievoRaySource& source);

  // Copies all places of a mesh to world coordinates; `cellsOfData`: the mesh's cells in the data,
  // or none.
  static void CopyInWorld(
    const vtkRelievoPlacedMesh& placed, vtkIdTypeArray* cellsOfData, vtkPolyData* copy);

private:
  struct Copy
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Time = 0;
    std::shared_ptr<const std::vector<glm::dmat4>> Places;
    vtkSmartPointer<vtkPolyData> InWorld;
  };
  using Key = std::tuple<vtkPolyData*, const void*, std::array<double, 16>>;

  std::map<Key, Copy> Copies; // in this update
  std::map<Key, Copy> Before; // in the update before
};

#endif
