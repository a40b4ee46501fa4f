// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps points of one state of a scene to another state: of the mesh of the same actor, or of data
// with the same index in AddData's list, and of the same block; several such meshes are matched in
// order. A mesh with another number of points has no corresponding points, and neither has a cell
// that the other state lacks.
#ifndef vtkRelievoMovedPoints_h
#define vtkRelievoMovedPoints_h

#include "vtkRelievoRayContent.h"
#include "vtkRelievoRayTree.h"

#include <cstddef>
#include <map>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkCellArray;
class vtkIdList;

class vtkRelievoMovedPoints
{
public:
  // `tree` of `from`.
  vtkRelievoMovedPoints(const vtkRelievoRayContent& from, const vtkRelievoRayTree& tree,
    const vtkRelievoRayContent& to);

  // NaN if there is no corresponding point.
  glm::dvec3 Get(const vtkRelievoRayTree::Hit& hit, const double weights[3]) const;

private:
  // A cell by its points' ids, or their indices in the data, in ascending order.
  using CellPoints = std::vector<vtkIdType>;

  struct HashOfCellPoints
  {
    std::size_t operator()(const CellPoints& points) const
    {
      std::size_t hash = points.size();
      for (const vtkIdType point : points)
      {
        hash = (hash ^ static_cast<std::size_t>(point)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  // Actor, index in AddData's list, block, and index among equal ones.
  using Key = std::tuple<vtkActor*, int, int, int>;

  struct Target
  {
    std::unordered_map<vtkIdType, std::size_t> Places; // of glyphs, by the input's point
    // In the mesh, by their ids, or their indices in the data; -1: in several places.
    std::unordered_map<vtkIdType, vtkIdType> Points;
    std::unordered_set<CellPoints, HashOfCellPoints> Cells; // only if they have changed
  };

  const vtkRelievoRayContent& From;
  const vtkRelievoRayTree& Tree;
  const vtkRelievoRayContent& To;
  std::vector<int> Meshes;       // index in To, for each mesh of From; -1: none
  std::vector<bool> IsChanged;   // for each mesh of From, whether its cells differ
  std::map<int, Target> Targets; // for each mesh of To

  // `ids` of the mesh's points; null: their indices.
  static void TakeCellPoints(
    vtkCellArray* cells, vtkIdType cell, vtkIdTypeArray* ids, vtkIdList* list, CellPoints& points);

  bool HasSameCells(std::size_t from, std::size_t to) const;

  // Points without ids are identified by their index in the data, so a change of the data's points
  // loses all.
  bool HasSamePoints(std::size_t from, std::size_t to) const;

  bool HasCell(std::size_t from, vtkIdType cell, const Target& target) const;

  void AddCells(int mesh);

  static std::vector<Key> GetKeys(const vtkRelievoRayContent& scene);

  void Add(int mesh);
};

#endif
