// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// For each edge of a mesh's triangles, the other triangle there, if two triangles share it by the
// positions of its ends, whatever points they use.
#ifndef vtkRelievoNeighbors_h
#define vtkRelievoNeighbors_h

#include <cstdint>
#include <vector>

class vtkRelievoMeshTree;

class vtkRelievoNeighbors
{
public:
  explicit vtkRelievoNeighbors(const vtkRelievoMeshTree& mesh);

  // Edge i of a triangle leads from its corner i to the next. The neighbour's edge is 3 times its
  // triangle plus the index of the edge; -1: none.
  int Get(int triangle, int edge) const
  {
    return this->Others[3 * static_cast<std::size_t>(triangle) + static_cast<std::size_t>(edge)];
  }

private:
  std::vector<std::int32_t> Others;
};

#endif
