// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoTextureCoordinates
 * @brief Gives any mesh texture coordinates, so that it can carry a material.
 *
 * Input: a vtkPolyData of polygons of any size (its vertices and lines pass through).
 *
 * Output: the mesh with the float point array "TCoords" (u, v) as its active texture coordinates,
 * in tiles: a repeating texture covers the mesh with copies of TileSize. It is mirrored on no
 * triangle that winds counter-clockwise seen from outside, and v grows towards Up where possible.
 * The Mapping is one of:
 * - PLANE: projected along PlaneNormal, or onto the plane that fits the points best, from its
 *   front. Exact in scale on that plane, stretched by 1 / cosine on inclined surfaces.
 * - BOX: each polygon is projected from the one of six sides that is nearest to its normal, and is
 *   stretched by at most sqrt(3). The texture has a seam where two sides meet.
 * - SPHERE: longitude and latitude about the middle of the mesh's bounds, with the seam opposite
 *   the first axis, for bodies whose whole surface is visible from their middle. The number of
 *   tiles around is the one that comes nearest to TileSize at the mean distance of the points.
 *
 * Points at seams are split, one for each (u, v), with all arrays copied; the first polygon keeps
 * the point's number, others get points at the end. "vtkOriginalPointIds" says which point of the
 * input each point was. Behind a sphere's seam u continues above 1; at a pole each polygon has a
 * point with the mean u of its other corners. Points without polygons have (0, 0), except for
 * PLANE. Cells are unchanged; other texture coordinates of the mesh are kept, but not as the active
 * ones. Positions are relative to the lower corner of the mesh's bounds, in double, so they are
 * exact far from the origin.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: triangle strips (run
 * vtkTriangleFilter first). A mesh without points gives one without points.
 */
#ifndef vtkRelievoTextureCoordinates_h
#define vtkRelievoTextureCoordinates_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

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
  /** How the texture is projected: PLANE, BOX or SPHERE. Default is BOX. */
  vtkSetClampMacro(Mapping, int, PLANE, SPHERE);
  vtkGetMacro(Mapping, int);
  void SetMappingToPlane() { this->SetMapping(PLANE); }
  void SetMappingToBox() { this->SetMapping(BOX); }
  void SetMappingToSphere() { this->SetMapping(SPHERE); }
  ///@}

  ///@{
  /**
   * Size of one copy of the texture in world units, in both directions, 0 or more. 0 makes one copy
   * cover the whole mesh: the longer side of a plane, the longest side of the bounds for a box,
   * once around a sphere. Default is 0.
   */
  vtkSetClampMacro(TileSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(TileSize, double);
  ///@}

  ///@{
  /** The axis that points up: 0 x, 1 y, 2 z. Default is 2. */
  vtkSetClampMacro(Up, int, 0, 2);
  vtkGetMacro(Up, int);
  ///@}

  ///@{
  /**
   * For PLANE: the direction from which the texture is projected, of any length. (0, 0, 0) uses the
   * plane that fits the points best by least squares, from the side that the polygons face. Default
   * is (0, 0, 0).
   */
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  /** Points added by splitting, in the last run. */
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoTextureCoordinates();
  ~vtkRelievoTextureCoordinates() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Mapping = BOX;
  double TileSize = 0.;
  int Up = 2;
  double PlaneNormal[3] = { 0., 0., 0. };
  vtkIdType NumberOfAddedPoints = 0;
  vtkRelievoParameterList Parameters;

  vtkRelievoTextureCoordinates(const vtkRelievoTextureCoordinates&) = delete;
  void operator=(const vtkRelievoTextureCoordinates&) = delete;
};

#endif
