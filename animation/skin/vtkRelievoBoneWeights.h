// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoBoneWeights
 * @brief Shows which bones move a mesh: each point's first bone, and the weights of one bone.
 *
 * Port 0 takes a mesh with bones, polydata or a composite of polydata, as vtkRelievoSkin does. Put
 * it before vtkRelievoSkin or vtkRelievoSkinnedActor, whose mesh keeps the added arrays; the mesh
 * alone shows them at rest. Port 1, optional, takes the skeleton, in whose point
 * array `name` BoneName is looked up.
 *
 * Added to the points:
 * - `first_bone` (int): the bone of the largest weight, as a point of the skeleton; -1 for none. A
 *   bone has the same number in all meshes of a model. Where the mesh has no field data `bone_node`
 *   (it was moved already) it is the place in the mesh's own list.
 * - `bone_weight` (float, 0 to 1), if Bone or BoneName is set and the mesh has `bone_node`: the
 *   share that the bone has in the point.
 *
 * Errors: one error event says that the mesh has no `joints` and `weights`, or that the skeleton
 * has no bone of that name; an array that cannot be computed is left out.
 */
#ifndef vtkRelievoBoneWeights_h
#define vtkRelievoBoneWeights_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoAnimationModule.h" // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

#include <memory> // for reported errors
#include <string>

namespace relievo
{
class ErrorOnce;
}

class VTKRELIEVOANIMATION_EXPORT vtkRelievoBoneWeights : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoBoneWeights* New();
  vtkTypeMacro(vtkRelievoBoneWeights, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The bone whose weights are shown, as an index in the skeleton; -1 for none. Default: -1. */
  vtkSetMacro(Bone, int);
  vtkGetMacro(Bone, int);
  ///@}

  ///@{
  /**
   * The name of the bone whose weights are shown; overrides Bone and needs the skeleton. Default:
   * none.
   */
  vtkSetStringMacro(BoneName);
  vtkGetStringMacro(BoneName);
  ///@}

  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();

  /** The skeleton (port 1). */
  void SetSkeletonConnection(vtkAlgorithmOutput* skeleton)
  {
    this->SetInputConnection(1, skeleton);
  }

protected:
  vtkRelievoBoneWeights();
  ~vtkRelievoBoneWeights() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoBoneWeights(const vtkRelievoBoneWeights&) = delete;
  void operator=(const vtkRelievoBoneWeights&) = delete;

  void Complain(const std::string& error);
  int FindBone(vtkPolyData* skeleton); // -1: none

  int Bone = -1;
  char* BoneName = nullptr;
  std::unique_ptr<relievo::ErrorOnce> Errors;
  vtkRelievoParameterList Parameters;
};

#endif
