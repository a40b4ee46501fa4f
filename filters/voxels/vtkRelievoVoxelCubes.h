// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVoxelCubes
 * @brief Points with sizes, to be drawn as cubes: size 1 inside a mask, decreasing outside.
 *
 * Input 0: vtkImageData with the cell array `mask` of vtkRelievoVoxelShell. Input 1, optional: a
 * data set whose point data color the cubes: each cube gets those of the nearest point.
 *
 * Output: a point at the centre of each cell that has a cube, with the point arrays
 * - size (float): 1 inside, falling to RestSize over Transition outside;
 * - scale (3 float): size times the cell's sides, for vtkGlyph3DMapper's scaling by vector
 *   components with a unit cube;
 * - orientation (4 float): only if the image's direction matrix rotates, the quaternion w x y z of
 *   the cubes' rotation (SetOrientationModeToQuaternion). The matrix must be a rotation, or a
 *   rotation with a reflection.
 * Positions are double if float would move them by more than a thousandth of a cell's shortest
 * side, otherwise float. Inner cells, whose six neighbours are inside, are left out because they
 * are hidden.
 *
 * With Instanced, vtkRelievoVoxelCubesActor computes sizes and positions as the cubes are drawn:
 * all cells up to Transition have a point, which stays at their centre. Instead of the above there
 * is the point array `instance` (3 float): the cell's sides divided by 1 + d, where d is the cell's
 * distance outside, in longest sides of a cell.
 *
 * In pieces, each cell has its cube in one of them. Ghost and blanked cells have none, and blanked
 * cells count as outside. Ghost arrays of the second input are left out, and so, with a warning,
 * are arrays called `size`, `scale`, `orientation` or `instance`.
 *
 * Errors: an image without `mask` or with cells that are not boxes, more memory than MemoryLimit.
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
  /** Size of cubes farther outside than Transition, 0 to 1. Default is 0.05. */
  vtkSetClampMacro(RestSize, double, 0., 1.);
  vtkGetMacro(RestSize, double);
  ///@}

  ///@{
  /**
   * The distance from the nearest cell inside, in world units, over which sizes fall to RestSize.
   * Default 0: only cells inside have cubes.
   */
  vtkSetClampMacro(Transition, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Transition, double);
  ///@}

  ///@{
  /** Fraction of the sizes above RestSize, 0 to 1, for animations. Default is 1. */
  vtkSetClampMacro(Growth, double, 0., 1.);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /** Whether cells farther outside than Transition have cubes of RestSize. Default is off. */
  vtkSetMacro(WholeGrid, bool);
  vtkGetMacro(WholeGrid, bool);
  vtkBooleanMacro(WholeGrid, bool);
  ///@}

  ///@{
  /**
   * Centre of a repeller: cubes at distance d below RepellerRadius r move to (r + d d / r) / 2.
   * There, inner cells have cubes too. Default radius 0: nothing moves.
   */
  vtkSetVector3Macro(Repeller, double);
  vtkGetVector3Macro(Repeller, double);
  vtkSetClampMacro(RepellerRadius, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(RepellerRadius, double);
  ///@}

  ///@{
  /** Whether vtkRelievoVoxelCubesActor computes sizes and positions. Default is off. */
  vtkSetMacro(Instanced, bool);
  vtkGetMacro(Instanced, bool);
  vtkBooleanMacro(Instanced, bool);
  ///@}

  ///@{
  /**
   * Upper bound of the cubes' bytes; 0, the default: all free memory. If more are needed, no cubes
   * are made.
   */
  vtkSetClampMacro(MemoryLimit, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
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
