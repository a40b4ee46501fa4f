// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoConvexPolygons
 * @brief Makes polygons that are not convex drawable, whatever corner they begin with.
 *
 * VTK's mappers before 9.7 draw a polygon as the fan of triangles around its first corner, and so
 * do shadow casters: of an outline that is not convex that covers too much. Input: a vtkPolyData.
 * Output: the same mesh, points and their numbers included, in which
 * - a polygon whose fan folds begins with another corner, if it has one whose fan does not;
 * - otherwise, and where vtkPolygon computes a normal that points to the other side, which
 *   vtkPolyDataNormals would take, it is cut into triangles, which get its cell data. The cell
 *   array `vtkRelievoPolygonIds` (vtkIdType) is there only if a polygon was cut; it says for each
 *   cell of the output which cell of the input it is of. The layer `cell` shows these numbers.
 *
 * A mesh without such polygons passes through, as its own arrays. Polygons may touch themselves,
 * have several corners at one place or on a line, and run to a hole and back. Those that are not
 * planar are cut as seen along their mean normal. One that crosses itself, or has no area, stays.
 *
 * A fan folds if a triangle of it turns against the polygon's normal with more than 1e-12 of the
 * polygon's area (1e-6 where points are floats, which round).
 *
 * Limit: the edges of cut polygons are drawn with the cuts.
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
  /** How many polygons begin with another corner, and are cut, after the last run. */
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
