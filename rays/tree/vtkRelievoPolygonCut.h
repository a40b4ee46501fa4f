// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates polygons and strips: by the triangles that VTK's mappers draw, in their order, or by
// triangles that cover each polygon once.
#ifndef vtkRelievoPolygonCut_h
#define vtkRelievoPolygonCut_h

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkRelievoPolygonOutline.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoPolygonCut
{
public:
  // Indices of a triangle's corners in the polygon.
  using Triangle = std::array<vtkIdType, 3>;

  // Rules of triangulation.
  enum class Rule
  {
    AsDrawn,  // by VTK's mappers: before 9.7 a fan, which covers too much of concave polygons
    ByOutline // by vtkRelievoPolygonOutline
  };

  // Whether a polygon with this number of points is drawn as a fan about its first point.
  static bool IsFan(vtkIdType count);

  // How many triangles the polygons and strips have.
  static vtkIdType CountTriangles(vtkPolyData* mesh)
  {
    vtkIdType triangles = 0;
    for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
    {
      triangles += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
    }
    return triangles;
  }

  // Calls f with the points of each triangle of polygons and then strips, with VTK's winding, and
  // its cell, counted from the first polygon.
  template <typename Function>
  static void ForEachTriangle(vtkPolyData* mesh, Function f, Rule rule = Rule::AsDrawn);

  // The triangles that VTK draws for a polygon of the mesh with these points, three or more. Valid
  // until the next call.
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
void vtkRelievoPolygonCut::ForEachTriangle(vtkPolyData* mesh, Function f, Rule rule)
{
  using Way = vtkRelievoPolygonOutline::Way;
  vtkRelievoPolygonCut cut;
  std::optional<vtkRelievoPolygonOutline> outline;
  if (rule == Rule::ByOutline && mesh->GetPoints())
  {
    outline.emplace(mesh->GetPoints());
  }
  vtkIdType cell = 0;
  ForEachCell(mesh->GetPolys(), [&](vtkIdType count, const vtkIdType* ids) {
    const auto add = [&](const auto& triangles) {
      for (const auto& triangle : triangles)
      {
        f(ids[triangle[0]], ids[triangle[1]], ids[triangle[2]], cell);
      }
    };
    const Way way = outline ? outline->Look(count, ids) : Way::AsItIs;
    if (way == Way::Cut)
    {
      add(outline->GetTriangles());
    }
    else if (outline || vtkRelievoPolygonCut::IsFan(count))
    {
      const auto first =
        way == Way::Turned ? static_cast<vtkIdType>(outline->GetFirst()) : vtkIdType(0);
      for (vtkIdType i = 2; i < count; ++i)
      {
        f(ids[first], ids[(first + i - 1) % count], ids[(first + i) % count], cell);
      }
    }
    else
    {
      add(cut.Cut(mesh, ids, count));
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
