// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoTangents
 * @brief Computes the tangents of a triangle mesh that normal maps are baked with (MikkTSpace).
 *
 * Input: a vtkPolyData of triangles (its vertices and lines pass through) with texture coordinates
 * of two or three components in its point data: the active ones, or SetInputArrayToProcess(1, ...).
 * Normals are those of the points (the active ones, or SetInputArrayToProcess(0, ...)), otherwise
 * those of the cells, otherwise those of the triangles by their winding: a mesh without point
 * normals is drawn flat.
 *
 * Output: the mesh with a float point array (TangentsName) of four components: the unit tangent,
 * across the point's normal, along growing u; and the handedness w, 1 or -1, by which
 *
 *     bitangent = w * cross(normal, tangent)
 *
 * points along growing v, as in glTF, also where triangles wind against their normals. The first
 * three components are also the point data's active tangents ("Tangents"), which
 * vtkRelievoMaterial and VTK's PBR shading use directly. The former determines the side of v
 * itself; the latter assumes that w is 1 and shades mirrored halves wrongly. A point with several
 * tangents, at the seam of a mirrored half, is split: the first triangle that uses it keeps the
 * point's number, and the others get points at the end, with all arrays copied. Flat meshes are
 * split at every edge whose faces differ in normal, and get point normals. Points without triangles
 * have the tangent 0 0 0 0. Cells and cell data are unchanged. The id array "vtkOriginalPointIds"
 * says which point of the input each point was.
 *
 * Method: M. Mikkelsen, Simulation of Wrinkled Surfaces Revisited, master's thesis, University of
 * Copenhagen, 2008 (MikkTSpace). Corners with equal position, normal and texture coordinate are one
 * vertex, whichever points they belong to. Each triangle's tangents come from its texture
 * coordinates. Around a vertex, triangles that share edges and have the same handedness are
 * averaged, projected into the plane of the vertex's normal and weighted by the angle of the
 * corner. To recover exactly what was baked, shaders must use the interpolated normal and tangent
 * without normalising them first.
 *
 * Triangles without texture area (constant or collinear coordinates, NaN, or less area than the
 * rounding of floats) take the tangent of adjacent triangles, then of any triangle at the vertex,
 * then of any at the position; if there is none, any unit vector across the normal, with w 1.
 * GetNumberOfDegenerateTriangles() counts them.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: no texture coordinates; polygons
 * that are not triangles, or triangle strips (run vtkTriangleFilter first). A mesh without points
 * gives one without points.
 */
#ifndef vtkRelievoTangents_h
#define vtkRelievoTangents_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

class VTKRELIEVOFILTERS_EXPORT vtkRelievoTangents : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoTangents* New();
  vtkTypeMacro(vtkRelievoTangents, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the array of tangents. Default is "tangent". */
  vtkSetStringMacro(TangentsName);
  vtkGetStringMacro(TangentsName);
  ///@}

  /** Triangles without texture area, and points added by splitting, in the last run. */
  vtkGetMacro(NumberOfDegenerateTriangles, vtkIdType);
  vtkGetMacro(NumberOfAddedPoints, vtkIdType);

  /** The parameter `tangents_name` by its name; see vtkRelievoTextureCoordinates. */
  vtkRelievoParametersMacro();

protected:
  vtkRelievoTangents();
  ~vtkRelievoTangents() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoParameterList Parameters;
  char* TangentsName = nullptr;
  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfAddedPoints = 0;

  vtkRelievoTangents(const vtkRelievoTangents&) = delete;
  void operator=(const vtkRelievoTangents&) = delete;
};

#endif
