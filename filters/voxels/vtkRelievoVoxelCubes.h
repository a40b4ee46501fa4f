// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVoxelCubes
 * @brief Points with sizes, to be drawn as cubes: 1 inside a mask, less and less outside.
 *
 * Input 0: vtkImageData with the cell array `mask` of vtkRelievoVoxelShell. Input 1, optional: a
 * data set whose point data color the cubes: each has those of the nearest point.
 *
 * Output: a point at the centre of each cell that has a cube, with the point arrays
 * - size (float): 1 inside, falling to RestSize over Transition outside;
 * - scale (3 float): size times the cell's sides, for vtkGlyph3DMapper's scaling by vector
 *   components with a unit cube;
 * - orientation (4 float): only where the image has a direction matrix that turns, the quaternion
 *   w x y z by which cubes are turned (SetOrientationModeToQuaternion). The matrix must be one of
 *   rotation, or of one and a mirror.
 * Places are double where float would move them by more than a thousandth of a cell's shortest
 * side, and else float.
 * Inner cells, whose six neighbours are inside, are left out: they are not seen.
 *
 * With Instanced, sizes and places are left to vtkRelievoVoxelCubesActor, which computes them as
 * the cubes are drawn: all cells up to Transition have a point, and it stays at their centre.
 * Instead of the above there is the point array `instance` (3 float): the cell's sides divided by
 * 1 + d, where d is how far outside it is, in longest sides of a cell.
 *
 * In pieces, each cell has its cube in one of them. Cells that are ghosts or blanked have none, and
 * blanked ones are outside. Ghost arrays of the second input are left out, and so, with a warning,
 * are arrays called `size`, `scale`, `orientation` or `instance`.
 *
 * Errors: an image without `mask` or with cells that are no boxes, more memory than MemoryLimit.
 */
#ifndef vtkRelievoVoxelCubes_h
#define vtkRelievoVoxelCubes_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

class VTKRELIEVOFILTERS_EXPORT vtkRelievoVoxelCubes : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoVoxelCubes* New();
  vtkTypeMacro(vtkRelievoVoxelCubes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Size of cubes that are farther outside than Transition, 0 to 1. Default is 0.05. */
  vtkSetClampMacro(RestSize, double, 0., 1.);
  vtkGetMacro(RestSize, double);
  ///@}

  ///@{
  /**
   * The distance, in world units from the nearest cell inside, over which sizes fall to RestSize.
   * Default 0: there are cubes inside only.
   */
  vtkSetClampMacro(Transition, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Transition, double);
  ///@}

  ///@{
  /** How much of the sizes above RestSize there is, 0 to 1, for animations. Default is 1. */
  vtkSetClampMacro(Growth, double, 0., 1.);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /** Whether cells farther outside than Transition have cubes, of RestSize. Default is off. */
  vtkSetMacro(WholeGrid, bool);
  vtkGetMacro(WholeGrid, bool);
  vtkBooleanMacro(WholeGrid, bool);
  ///@}

  ///@{
  /**
   * A place that cubes move away from: one at the distance d below RepellerRadius r moves to
   * (r + d d / r) / 2. Cells there have cubes inside as well. Default radius 0: nothing moves.
   */
  vtkSetVector3Macro(Repeller, double);
  vtkGetVector3Macro(Repeller, double);
  vtkSetClampMacro(RepellerRadius, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(RepellerRadius, double);
  ///@}

  ///@{
  /** Whether sizes and places are left to vtkRelievoVoxelCubesActor. Default is off. */
  vtkSetMacro(Instanced, bool);
  vtkGetMacro(Instanced, bool);
  vtkBooleanMacro(Instanced, bool);
  ///@}

  ///@{
  /**
   * The most bytes that the cubes may take; 0, the default: what the machine has left. More are
   * refused before they are made.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Parameters by name, with values in words, as of vtkRelievoStage. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoVoxelCubes();
  ~vtkRelievoVoxelCubes() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double RestSize = 0.05;
  double Transition = 0.;
  double Growth = 1.;
  bool WholeGrid = false;
  double Repeller[3] = { 0., 0., 0. };
  double RepellerRadius = 0.;
  bool Instanced = false;
  double MemoryLimit = 0.;
  vtkRelievoParameterList Parameters;

  vtkRelievoVoxelCubes(const vtkRelievoVoxelCubes&) = delete;
  void operator=(const vtkRelievoVoxelCubes&) = delete;
};

#endif
