// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which cell of a mesh each OpenGL primitive was cut from, in one representation. VTK's mappers
// have such a map as well, but one for all that they draw: the next actor or piece overwrites it.
#ifndef vtkRelievoCellMap_h
#define vtkRelievoCellMap_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

class vtkPolyData;

class vtkRelievoCellMap
{
public:
  // VTK draws verts, lines, polygons and strips one kind after the other.
  static constexpr int Kinds = 4;
  // The number of every kind's first primitive as VTK counts them: further apart than needed, now
  // and then.
  using Offsets = std::array<vtkIdType, Kinds>;

  vtkRelievoCellMap(vtkPolyData* mesh, int representation);

  // The primitive's cell in the mesh, or -1, and which primitive of the cell it is: 0 is the first.
  vtkIdType GetCell(const Offsets& offsets, vtkIdType primitive) const;
  vtkIdType GetPrimitiveInCell(const Offsets& offsets, vtkIdType primitive) const;

  // The number behind that of the last primitive.
  vtkIdType GetEnd(const Offsets& offsets) const;

private:
  struct Part
  {
    vtkIdType FirstCell = 0;
    vtkIdType Size = 0;               // primitives
    vtkIdType PerCell = 0;            // of every cell; 0: as Cells has it
    std::vector<std::uint32_t> Cells; // by primitive, from FirstCell on
  };
  // The part and the place in it; nullptr if there is no such primitive.
  const Part* Find(const Offsets& offsets, vtkIdType primitive, vtkIdType& place) const;
  void Fill(Part& part, vtkPolyData* mesh, int kind, int representation);

  Part Parts[Kinds];
};

// The maps of the meshes in use; built anew when cells or points have changed.
class vtkRelievoCellMaps
{
public:
  std::shared_ptr<const vtkRelievoCellMap> Get(vtkPolyData* mesh, int representation);

  // Forgets meshes that are gone.
  void Prune();

  // Later than every change of the mesh's cells and points.
  static vtkMTimeType GetTime(vtkPolyData* mesh);

private:
  struct Entry
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Time = 0;
    std::shared_ptr<const vtkRelievoCellMap> Map;
  };
  std::map<std::pair<vtkPolyData*, int>, Entry> Entries;
};

#endif
