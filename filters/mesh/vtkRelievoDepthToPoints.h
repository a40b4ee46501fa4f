// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoDepthToPoints
 * @brief Turns a depth image into a point cloud in world coordinates, in double.
 *
 * Input: a vtkImageData of one slice, one point per pixel, row 0 at the bottom, the whole viewport,
 * as vtkRelievoLayerSource and vtkRelievoEXRReader give it:
 * - a point array of linear depth (eye space -z, world units), one component; see DepthArrayName;
 * - field arrays worldToCamera and worldToNDC: 16 numbers each, row by row as vtkMatrix4x4 stores
 *   them. Both act on unshifted world coordinates, however far from the origin.
 *
 * An image without pixels gives no points; with several processes only one has the image.
 *
 * Output: one vertex per pixel with a finite depth, at that depth on the ray through the pixel's
 * centre; coordinates are double. Every projection is supported: perspective, parallel, off-centre,
 * oblique. The formulas are those of shaders/formulas/geometry/unproject.glsl, in double. The field
 * data is passed on.
 *
 * Without the arrays, or with a camera that cannot be inverted, the filter reports one error, sets
 * the error code vtkErrorCode::UserError, and its output is empty.
 */
#ifndef vtkRelievoDepthToPoints_h
#define vtkRelievoDepthToPoints_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

class VTKRELIEVOFILTERS_EXPORT vtkRelievoDepthToPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoDepthToPoints* New();
  vtkTypeMacro(vtkRelievoDepthToPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the point array of linear depth. Default is "depth". */
  vtkSetStringMacro(DepthArrayName);
  vtkGetStringMacro(DepthArrayName);
  ///@}

  ///@{
  /**
   * Whether each point has the values of all point arrays at its pixel, including depth. Default is
   * on.
   */
  vtkSetMacro(KeepArrays, bool);
  vtkGetMacro(KeepArrays, bool);
  vtkBooleanMacro(KeepArrays, bool);
  ///@}

  ///@{
  /**
   * Uses every Stride-th column and row, from the lower left pixel; at least 1. Default is 1, every
   * pixel.
   */
  vtkSetClampMacro(Stride, int, 1, VTK_INT_MAX);
  vtkGetMacro(Stride, int);
  ///@}

  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();

protected:
  vtkRelievoDepthToPoints();
  ~vtkRelievoDepthToPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  char* DepthArrayName = nullptr;
  bool KeepArrays = true;
  int Stride = 1;
  vtkRelievoParameterList Parameters;

  vtkRelievoDepthToPoints(const vtkRelievoDepthToPoints&) = delete;
  void operator=(const vtkRelievoDepthToPoints&) = delete;
};

#endif
