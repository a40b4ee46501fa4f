// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoConvexPolygons
 * @brief Makes non-convex polygons drawable as fans of triangles.
 *
 * VTK's mappers before 9.7 draw a polygon as the fan of triangles around its first corner, and so
 * do shadow casters; the fan of a non-convex outline covers too much. Input: a vtkPolyData. Output:
 * the same mesh, points and their numbers included, in which
 * - a polygon whose fan folds begins with another corner, if there is one whose fan does not fold;
 * - otherwise the polygon is cut into triangles, which get its cell data; so are polygons whose
 *   normal by vtkPolygon, which vtkPolyDataNormals would take, points to the other side. The cell
 *   array `vtkRelievoPolygonIds` (vtkIdType) exists only if a polygon was cut; it gives the input
 *   cell of each output cell. The layer `cell` shows these numbers.
 *
 * A mesh without such polygons passes through with its own arrays. Polygons may touch themselves,
 * have several corners at one place or on a line, and run to a hole and back. Non-planar polygons
 * are cut as seen along their mean normal. A polygon that crosses itself or has no area stays.
 *
 * A fan folds if one of its triangles turns against the polygon's normal with more than 1e-12 of
 * the polygon's area (1e-6 if points are floats, because of rounding).
 *
 * Limit: edges of cut polygons are drawn with the cuts.
 *
 * Method: ears (G. H. Meisters, Polygons Have Ears, 1975).
 */
#ifndef vtkRelievoConvexPolygons_h
#define vtkRelievoConvexPolygons_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

class VTKRELIEVOFILTERS_EXPORT vtkRelievoConvexPolygons : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoConvexPolygons* New();
  vtkTypeMacro(vtkRelievoConvexPolygons, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Numbers of polygons given another first corner, and of polygons cut, in the last run. */
  vtkGetMacro(NumberOfTurnedPolygons, vtkIdType);
  vtkGetMacro(NumberOfCutPolygons, vtkIdType);
  ///@}

protected:
  vtkRelievoConvexPolygons() = default;
  ~vtkRelievoConvexPolygons() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkIdType NumberOfTurnedPolygons = 0;
  vtkIdType NumberOfCutPolygons = 0;

  vtkRelievoConvexPolygons(const vtkRelievoConvexPolygons&) = delete;
  void operator=(const vtkRelievoConvexPolygons&) = delete;
};

#endif
