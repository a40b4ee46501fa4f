// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles that VTK's mappers cut a polygon into, in the order in which they are drawn.
#ifndef vtkRelievoPolygonCut_h
#define vtkRelievoPolygonCut_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoPolygonCut
{
public:
  // Places in the polygon of a triangle's corners.
  using Triangle = std::array<vtkIdType, 3>;

  // Whether a polygon of that many points becomes a fan about its first.
  static bool IsFan(vtkIdType count);

  // Calls f with the points of each triangle of polygons and then strips, wound as VTK winds them,
  // and its cell, counted from the first polygon.
  template <typename Function>
  static void ForEachTriangle(vtkPolyData* mesh, Function f);

  // Of a polygon of the mesh with these points, three or more. Valid until the next call.
  const std::vector<Triangle>& Cut(vtkPolyData* mesh, const vtkIdType* points, vtkIdType count);

private:
  template <typename Function>
  static void ForEachCell(vtkCellArray* cells, Function f);

  void CutFan(vtkPolyData* mesh, const vtkIdType* points, vtkIdType count);

  std::vector<Triangle> Triangles;
  std::vector<int> Scratch[3];
};

template <typename Function>
void vtkRelievoPolygonCut::ForEachCell(vtkCellArray* cells, Function f)
{
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(count, ids);
    f(count, ids);
  }
}

template <typename Function>
void vtkRelievoPolygonCut::ForEachTriangle(vtkPolyData* mesh, Function f)
{
  vtkRelievoPolygonCut cut;
  vtkIdType cell = 0;
  ForEachCell(mesh->GetPolys(), [&](vtkIdType count, const vtkIdType* ids) {
    if (!vtkRelievoPolygonCut::IsFan(count))
    {
      for (const Triangle& triangle : cut.Cut(mesh, ids, count))
      {
        f(ids[triangle[0]], ids[triangle[1]], ids[triangle[2]], cell);
      }
    }
    else
    {
      for (vtkIdType i = 2; i < count; ++i)
      {
        f(ids[0], ids[i - 1], ids[i], cell);
      }
    }
    ++cell;
  });
  ForEachCell(mesh->GetStrips(), [&](vtkIdType count, const vtkIdType* ids) {
    for (vtkIdType i = 2; i < count; ++i)
    {
      const vtkIdType odd = i % 2;
      f(ids[i - 2 + odd], ids[i - 1 - odd], ids[i], cell);
    }
    ++cell;
  });
}

#endif
