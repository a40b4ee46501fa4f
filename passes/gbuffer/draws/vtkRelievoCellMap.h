// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps the OpenGL primitives of a mesh, in one representation, to its cells. VTK's mappers have
// such a map as well, but only one at a time: the next actor or piece overwrites it.
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
  // VTK draws verts, lines, polygons and strips in this order.
  static constexpr int Kinds = 4;
  // The number of every kind's first primitive in VTK's count, which sometimes leaves gaps.
  using Offsets = std::array<vtkIdType, Kinds>;

  vtkRelievoCellMap(vtkPolyData* mesh, int representation);

  // The primitive's cell in the mesh, or -1; and the primitive's index within the cell.
  vtkIdType GetCell(const Offsets& offsets, vtkIdType primitive) const;
  vtkIdType GetPrimitiveInCell(const Offsets& offsets, vtkIdType primitive) const;

  // The number after the last primitive's.
  vtkIdType GetEnd(const Offsets& offsets) const;

private:
  struct Part
  {
    vtkIdType FirstCell = 0;
    vtkIdType Size = 0;               // primitives
    vtkIdType PerCell = 0;            // in every cell; 0: see Cells
    std::vector<std::uint32_t> Cells; // by primitive, from FirstCell on
  };
  // Finds the primitive's part and its index there; nullptr if there is no such primitive.
  const Part* Find(const Offsets& offsets, vtkIdType primitive, vtkIdType& place) const;
  void Fill(Part& part, vtkPolyData* mesh, int kind, int representation);

  Part Parts[Kinds];
};

// The maps of the meshes in use, rebuilt after a change of cells or points.
class vtkRelievoCellMaps
{
public:
  std::shared_ptr<const vtkRelievoCellMap> Get(vtkPolyData* mesh, int representation);

  // Removes the maps of deleted meshes.
  void Prune();

  // A time after every change of the mesh's cells and points.
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
