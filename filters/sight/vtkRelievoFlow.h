// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFlow
 * @brief Optical and scene flow: the movement of each pixel's surface point between two moments.
 *
 * Two states of a scene (vtkRelievoRayScene, the first usually made by CopyStateOf before things
 * move), each with a camera. A ray through each pixel's centre of the first picture hits a point of
 * a triangle; the point with the same weights in the same triangle of the second state is projected
 * into the second picture. Moved props, points and cameras are all handled in this way, in double.
 *
 * Output: vtkImageData of the first camera's columns and rows, row 0 at the bottom:
 * - flow (2 float): pixels from the first to the second position, x right, y down; NaN if the ray
 *   hits nothing, or the second camera cannot project the point. Between equirectangular panoramas
 *   of equal steps it goes the shorter way round, also across the seam, and then leads beyond the
 *   picture's edge: take the target modulo the columns of a whole turn;
 * - motion (3 float): the point's movement in world units; NaN if the ray hits nothing, or the
 *   point no longer exists;
 * - flow_valid (unsigned char): 1 if the point is within the second picture and unoccluded there,
 *   otherwise 0.
 *
 * Errors: a scene or a camera is missing; the second camera cannot project points
 * (see vtkRelievoLidar).
 */
#ifndef vtkRelievoFlow_h
#define vtkRelievoFlow_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for the scenes and cameras

class vtkRelievoCameraModel;
class vtkRelievoRayScene;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoFlow : public vtkImageAlgorithm
{
public:
  static vtkRelievoFlow* New();
  vtkTypeMacro(vtkRelievoFlow, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The state whose pixels are traced, and the other one. */
  void SetFrom(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera);
  void SetTo(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera);
  ///@}

  /** Always newer than before, because scenes can change without notice. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoFlow();
  ~vtkRelievoFlow() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkRelievoFlow(const vtkRelievoFlow&) = delete;
  void operator=(const vtkRelievoFlow&) = delete;

  struct State
  {
    vtkSmartPointer<vtkRelievoRayScene> Scene;
    vtkSmartPointer<vtkRelievoCameraModel> Camera;
  };
  State From;
  State To;
};

#endif
