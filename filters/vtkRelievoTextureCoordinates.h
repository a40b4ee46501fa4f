// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoTextureCoordinates
 * @brief Gives any mesh texture coordinates, so that it can wear a material.
 *
 * Input: a vtkPolyData of polygons of any size (its vertices and lines pass through).
 *
 * Output: the mesh with the float point array "TCoords" (u, v) as its active texture coordinates,
 * in tiles: a repeating texture covers the mesh with copies of TileSize. No triangle that winds
 * counter-clockwise seen from outside wears it mirrored; v grows towards Up where it can. By
 * Mapping:
 * - PLANE: laid on from PlaneNormal, or from the side of the plane that fits the points best. Exact
 *   in scale on that plane, stretched by 1 / cosine on surfaces that lean.
 * - BOX: each polygon from the one of the six sides that its own normal is nearest to: stretched at
 *   most by sqrt(3). Where two sides meet the texture has a seam.
 * - SPHERE: longitude and latitude about the middle of the mesh's bounds, the seam opposite of the
 *   first axis, for bodies that are seen whole from their middle. As many whole tiles around as
 *   come nearest to TileSize at the mean distance of the points.
 *
 * Points at seams are split, one for each (u, v), with all arrays copied; the first polygon keeps
 * the point's number, others get points at the end; "vtkOriginalPointIds" tells which point of the
 * input a point was. Behind a sphere's seam u goes on above 1; at a pole each polygon has a point
 * with the mean u of its other corners. Points of no polygon have (0, 0), but for PLANE. Cells stay
 * as they are; other texture coordinates of the mesh stay, but are not the active ones. Places are
 * counted from the lower corner of the mesh's bounds, in double, so they are exact far from the
 * origin.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: triangle strips (run
 * vtkTriangleFilter first). A mesh without points gives one without points.
 */
#ifndef vtkRelievoTextureCoordinates_h
#define vtkRelievoTextureCoordinates_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

class VTKRELIEVOFILTERS_EXPORT vtkRelievoTextureCoordinates : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoTextureCoordinates* New();
  vtkTypeMacro(vtkRelievoTextureCoordinates, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MappingType
  {
    PLANE = 0,
    BOX = 1,
    SPHERE = 2
  };

  ///@{
  /** How the texture is laid on: PLANE, BOX or SPHERE. Default is BOX. */
  vtkSetClampMacro(Mapping, int, PLANE, SPHERE);
  vtkGetMacro(Mapping, int);
  void SetMappingToPlane() { this->SetMapping(PLANE); }
  void SetMappingToBox() { this->SetMapping(BOX); }
  void SetMappingToSphere() { this->SetMapping(SPHERE); }
  ///@}

  ///@{
  /**
   * World units that one copy of the texture covers, both ways. 0 makes one copy cover the whole:
   * the longer way across a plane, the longest side of the bounds for a box, once around a sphere.
   * Default is 0; 0 or more.
   */
  vtkSetClampMacro(TileSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(TileSize, double);
  ///@}

  ///@{
  /** The axis that is up: 0 x, 1 y, 2 z. Default is 2. */
  vtkSetClampMacro(Up, int, 0, 2);
  vtkGetMacro(Up, int);
  ///@}

  ///@{
  /**
   * For PLANE: the way from which the texture is laid on, any length; (0, 0, 0) takes the plane
   * that fits the points best in the sense of least squares, from the side that the polygons show.
   * Default is (0, 0, 0).
   */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  /** Points that were added by splitting, in the last run. */
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);

protected:
  vtkRelievoTextureCoordinates() = default;
  ~vtkRelievoTextureCoordinates() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Mapping = BOX;
  double TileSize = 0.;
  int Up = 2;
  double PlaneNormal[3] = { 0., 0., 0. };
  vtkIdType NumberOfAddedPoints = 0;

  vtkRelievoTextureCoordinates(const vtkRelievoTextureCoordinates&) = delete;
  void operator=(const vtkRelievoTextureCoordinates&) = delete;
};

#endif
