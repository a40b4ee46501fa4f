// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFlow
 * @brief Where each pixel's surface point goes from one moment to another: optical and scene flow.
 *
 * Two states of a scene (vtkRelievoRayScene, the first one usually by CopyStateOf before things
 * move), each with a camera. A ray through each pixel's centre of the first picture meets a point
 * of a triangle; the point with the same weights of the same triangle in the second state is
 * projected into the second picture. Moved props, moved points and moved cameras are one thing for
 * it, all in double.
 *
 * Output: vtkImageData of the first camera's columns and rows, row 0 at the bottom:
 * - flow (2 float): pixels from here to there, x right, y down; NaN where nothing is seen, or the
 *   second camera has no place for the point. Between equirectangular panoramas of equal steps it
 *   goes the shorter way round, also across the seam, and then beyond the picture's edge: the place
 *   there is that modulo the columns of a whole turn;
 * - motion (3 float): the point's way in world units; NaN where nothing is seen, or the point is no
 *   longer there;
 * - flow_valid (unsigned char): 1 where the point is within the second picture and nothing lies
 *   before it there, else 0.
 *
 * Errors: a scene or a camera is missing; the second camera has no places for points
 * (vtkRelievoLidar).
 */
#ifndef vtkRelievoFlow_h
#define vtkRelievoFlow_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for what is given

class vtkRelievoCameraModel;
class vtkRelievoRayScene;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoFlow : public vtkImageAlgorithm
{
public:
  static vtkRelievoFlow* New();
  vtkTypeMacro(vtkRelievoFlow, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The state whose pixels are asked, and the other one. */
  void SetFrom(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera);
  void SetTo(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera);
  ///@}

  /** Always newer than before, because scenes may change without notice. */
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
