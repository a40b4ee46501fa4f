// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSkin
 * @brief Moves the points of a mesh with the bones of a skeleton.
 *
 * Port 0 takes the mesh, polydata or a composite of polydata, with
 * - the point arrays `joints` (whole numbers: places in the mesh's list of bones, -1 for none) and
 *   `weights` (at least 0) of the same number of components, any number;
 * - the field data `bone_node` (for each bone a point of the skeleton) and `bone_offset` (16
 *   components, by rows: from the mesh's rest points to the bone).
 *
 * Port 1 takes the skeleton: polydata with the point array `pose` (16 components, by rows: from the
 * bone to the world). KEY_MATRIX takes `pose_before` and `pose_after` instead, and the field data
 * `key_share`, 0 to 1. vtkRelievoModelReader (Pose REST, Skin off) gives all of these.
 *
 * The output has the mesh's cells and arrays; points (float or double, as they were or as
 * OutputPointsPrecision says), active normals and tangents are moved. Normals follow the inverse
 * transpose of the blended matrix, so they are right under non-uniform scale. Normals of cells are
 * left out. Weights that do not sum to 1 are rescaled; points without weight stay. The bones' field
 * data is left out: a second skin would start from moved points. Runs in threads.
 *
 * Errors: one error event says what is missing; the output is empty.
 *
 * Dual quaternions: L. Kavan et al., Geometric skinning with approximate dual quaternion blending,
 * ACM Transactions on Graphics 27(4), 2008; quaternions are taken from the half of the strongest
 * bone's.
 */
#ifndef vtkRelievoSkin_h
#define vtkRelievoSkin_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoAnimationModule.h" // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for reported errors

namespace relievo
{
class ErrorOnce;
}

class VTKRELIEVOANIMATION_EXPORT vtkRelievoSkin : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoSkin* New();
  vtkTypeMacro(vtkRelievoSkin, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    /// Matrices blended component by component, as files expect. Twisting joints lose volume, all
    /// of it at half a turn.
    LINEAR = 0,
    /// Rigid motions blended as dual quaternions after blended stretches: twisted limbs keep their
    /// radius; bent ones bulge slightly.
    DUAL_QUATERNION = 1,
    /// Matrices of the whole keys before and after, blended by time, then as LINEAR: the classic
    /// cheap method. Bones shrink between distant keys.
    KEY_MATRIX = 2
  };

  ///@{
  /** The blending of bones. Default: LINEAR. */
  vtkSetClampMacro(Method, int, LINEAR, KEY_MATRIX);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Precision of the points: SINGLE_PRECISION, DOUBLE_PRECISION (also computed in double, for poses
   * far from the origin, where floats have few digits), or that of the input. Default:
   * DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();

  /** The skeleton (port 1). */
  void SetSkeletonConnection(vtkAlgorithmOutput* skeleton)
  {
    this->SetInputConnection(1, skeleton);
  }

protected:
  vtkRelievoSkin();
  ~vtkRelievoSkin() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoSkin(const vtkRelievoSkin&) = delete;
  void operator=(const vtkRelievoSkin&) = delete;

  int Method = LINEAR;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  std::unique_ptr<relievo::ErrorOnce> Errors;
  vtkRelievoParameterList Parameters;
};

#endif
