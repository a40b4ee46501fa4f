// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVisibility
 * @brief The cells and points of a mesh that cameras see, their pixels and solid angles.
 *
 * Input 0: a vtkPolyData. Input 1 (optional, repeatable): data sets that also occlude it. Output 0:
 * the mesh with the cell arrays
 * - seen (int, the active scalars): the number of cameras that see any part of the cell;
 * - pixels (vtkIdType): the number of pixels whose centres show the cell, over all cameras;
 * - solid_angle (double): the visible solid angle in steradians, summed over the cameras; 0 for
 *   parallel rays;
 *
 * and the point array seen (int): the number of cameras from which the point is not occluded.
 * Output 1, if Cloud is on: the points of the mesh at the pixels' centres, with the arrays cell and
 * camera (int) and normal (3 float, geometric, towards the camera).
 *
 * A ray goes through each pixel's centre. Further rays go to cells that none of these hit, and to
 * cells smaller than 8 pixels, through points of their triangles: the middle and one near each
 * corner. Cells smaller than a pixel are thus not lost. The solid angle of these cells is that of
 * their triangles (A. Van Oosterom, J. Strackee 1983) times the share of their points that are
 * visible; that of larger cells is the sum of their pixels' angles. Cells are visible from both
 * sides. For cameras whose rays begin at one point, most results are found without a ray for each.
 * Vertices and lines occlude nothing and are never seen.
 *
 * Errors: no cameras, a camera that cannot project points (see vtkRelievoLidar).
 */
#ifndef vtkRelievoVisibility_h
#define vtkRelievoVisibility_h

#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkRelievoSightAlgorithm.h"
#include "vtkSmartPointer.h" // for the cameras

#include <vector> // for the cameras

class vtkRelievoCameraModel;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoVisibility : public vtkRelievoSightAlgorithm
{
public:
  static vtkRelievoVisibility* New();
  vtkTypeMacro(vtkRelievoVisibility, vtkRelievoSightAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The cameras, which define the viewpoints and pictures. */
  void AddCamera(vtkRelievoCameraModel* camera);
  void RemoveAllCameras();
  vtkRelievoCameraModel* GetCamera(int i);
  int GetNumberOfCameras() { return static_cast<int>(this->Cameras.size()); }
  ///@}

  ///@{
  /** Whether output 1 has the visible points. Default off. */
  vtkSetMacro(Cloud, bool);
  vtkGetMacro(Cloud, bool);
  vtkBooleanMacro(Cloud, bool);
  ///@}

  /** Includes the cameras' times. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoVisibility();
  ~vtkRelievoVisibility() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  bool Cloud = false;

private:
  vtkRelievoVisibility(const vtkRelievoVisibility&) = delete;
  void operator=(const vtkRelievoVisibility&) = delete;

  std::vector<vtkSmartPointer<vtkRelievoCameraModel>> Cameras;
};

#endif
