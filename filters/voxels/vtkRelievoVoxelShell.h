// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVoxelShell
 * @brief Marks the cells of a grid inside a surface, by views or by parity.
 *
 * Input 0: a data set, or a composite of them. Data sets other than vtkPolyData count by their
 * outer surface. The data are needed in one piece.
 *
 * Input 1, optional: orthographic depth images, from each side of one, two or three axes, with the
 * layer `depth` and the field data of captures (vtkRelievoLayerSource, vtkRelievoDepthViews). Each
 * may be a vtkImageData or a vtkMultiBlockDataSet of them. They then replace the surface, of which
 * at most the bounds are used.
 *
 * Output: vtkImageData with the cell array `mask` (unsigned char, 1 inside, 0 outside). A cell is
 * inside if its centre is:
 * - TWO_VIEWS: between the surfaces seen from the front and from the back along Axis;
 * - SIX_VIEWS: that along all three axes. Both methods fill hidden hollows;
 * - PARITY: behind an odd number of crossings, which is exact for any closed surface. If the
 *   surface is not closed, all three axes vote, except columns with an odd total number of
 *   crossings, and the majority decides.
 *
 * Hits of rays through the columns' centres with triangles are computed in double; polygons are cut
 * into triangles. Results do not depend on the number of threads. The time depends on the
 * triangles, the columns that they cover and, for the output, on the cells.
 *
 * Field data, each also available as a method: `inside` (number of cells), `closed` (1 or 0),
 * `columns` and `open_columns` (of each counted axis), and `report`, a text.
 *
 * Each piece has its part of the cells and needs the whole surface; numbers and report are those of
 * the whole grid. If Bounds are the input's and the input changes in time, so does the whole
 * extent.
 *
 * Errors: no input, a grid that is infinite or needs more than MemoryLimit, invalid depth images.
 * An empty surface is no error: nothing is inside.
 */
#ifndef vtkRelievoVoxelShell_h
#define vtkRelievoVoxelShell_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for the internals
#include <string> // for the report

class VTKRELIEVOFILTERS_EXPORT vtkRelievoVoxelShell : public vtkImageAlgorithm
{
public:
  static vtkRelievoVoxelShell* New();
  vtkTypeMacro(vtkRelievoVoxelShell, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MethodType
  {
    TWO_VIEWS = 0,
    SIX_VIEWS = 1,
    PARITY = 2
  };

  ///@{
  /** The method. Default is PARITY. Depth images use views along the axes they look along. */
  vtkSetClampMacro(Method, int, TWO_VIEWS, PARITY);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * The axis that two views look along, and along which crossings of a closed surface are counted:
   * 0, 1, or 2 (the default).
   */
  vtkSetClampMacro(Axis, int, 0, 2);
  vtkGetMacro(Axis, int);
  ///@}

  ///@{
  /**
   * The box that the grid fills: x, y and z, each from and to. While a pair is not in order, as by
   * default (1, -1, ...), it is the input's bounds. Required if only depth images are given.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /** Cells along x, y and z, which fill the box. Default 0 0 0: set by CellSize or Resolution. */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /** Side of the cubic cells in world units. Default 0: set by Resolution. */
  vtkSetClampMacro(CellSize, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /** Cubic cells along the longest side of the box. Default is 100. */
  vtkSetClampMacro(Resolution, int, 1, VTK_INT_MAX);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /** Cells added on each side of the box. Default is 0. */
  vtkSetClampMacro(Padding, int, 0, 1000000);
  vtkGetMacro(Padding, int);
  ///@}

  ///@{
  /**
   * Whether the output has the cell arrays `front` and `back` (float): the distance of a cell's
   * centre behind the first surface of its column, and in front of the last one, in world units
   * along each viewed axis (PARITY: Axis). Negative outside, NaN in columns without a surface.
   * Default off.
   */
  vtkSetMacro(Distances, bool);
  vtkGetMacro(Distances, bool);
  vtkBooleanMacro(Distances, bool);
  ///@}

  ///@{
  /**
   * Upper bound of the grid's bytes, output included; 0, the default: all free memory. A larger
   * grid is refused before it is made.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /**
   * Results of the last update: cells inside; whether the surface uses each edge an even number of
   * times; columns along an axis with an odd number of crossings, and all of them (0 if crossings
   * were not counted); and a report of all of this as text.
   */
  vtkIdType GetNumberOfCellsInside();
  bool IsClosed();
  vtkIdType GetNumberOfOpenColumns(int axis);
  vtkIdType GetNumberOfColumns(int axis);
  std::string GetReport();
  ///@}

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoVoxelShell();
  ~vtkRelievoVoxelShell() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
  int Method = PARITY;
  int Axis = 2;
  double Bounds[6] = { 1., -1., 1., -1., 1., -1. };
  int Dimensions[3] = { 0, 0, 0 };
  double CellSize = 0.;
  int Resolution = 100;
  int Padding = 0;
  bool Distances = false;
  double MemoryLimit = 0.;
  vtkRelievoParameterList Parameters;

  vtkRelievoVoxelShell(const vtkRelievoVoxelShell&) = delete;
  void operator=(const vtkRelievoVoxelShell&) = delete;
};

#endif
