// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles that VTK's mappers cut a polygon into, in the order in which they are drawn.
#ifndef vtkRelievoPolygonCut_h
#define vtkRelievoPolygonCut_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPolyData;

class vtkRelievoPolygonCut
{
public:
  // Places in the polygon of a triangle's corners.
  using Triangle = std::array<vtkIdType, 3>;

  // Of a polygon of the mesh with these points, three or more. Valid until the next call.
  const std::vector<Triangle>& Cut(vtkPolyData* mesh, const vtkIdType* points, vtkIdType count);

private:
  void CutFan(vtkPolyData* mesh, const vtkIdType* points, vtkIdType count);

  std::vector<Triangle> Triangles;
  std::vector<int> Scratch[3];
};

#endif
