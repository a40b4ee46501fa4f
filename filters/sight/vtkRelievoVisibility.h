// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoVisibility
 * @brief Which cells and points of a mesh cameras see, in how many pixels, under which solid angle.
 *
 * Input 0: a vtkPolyData. Input 1 (by choice, several): what hides it as well, data sets. Output 0:
 * the mesh with the cell arrays
 * - seen (int, the active scalars): the number of cameras that see any of the cell;
 * - pixels (vtkIdType): pixels whose centres show it, of all cameras;
 * - solid_angle (double): steradians under which it is seen, summed over the cameras; 0 of parallel
 *   rays;
 *
 * and the point array seen (int): the number of cameras from which nothing lies before the point.
 * Output 1, if Cloud is on: what the pixels' centres show of the mesh, as points with the arrays
 * cell and camera (int) and normal (3 float, geometric, towards the camera).
 *
 * A ray goes through each pixel's centre. Further rays go to cells that none of these has met, and
 * to those smaller than 8 pixels, through points of their triangles, the middle and one beside each
 * corner: a cell smaller than a pixel is not lost. The solid angle of these cells is that of their
 * triangles (A. Van Oosterom, J. Strackee 1983) times the share of their points that are seen; that
 * of larger cells is the sum of their pixels' angles. Cells are seen from both sides. Of cameras
 * whose rays begin at one point, most of these answers are found without a ray for each.
 * Vertices and lines hide nothing, and no camera sees them.
 *
 * Errors: no cameras, a camera that has no places for points (vtkRelievoLidar).
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
  /** From where, and in what pictures. */
  void AddCamera(vtkRelievoCameraModel* camera);
  void RemoveAllCameras();
  int GetNumberOfCameras() { return static_cast<int>(this->Cameras.size()); }
  ///@}

  ///@{
  /** Whether output 1 has what is seen as points. Default off. */
  vtkSetMacro(Cloud, bool);
  vtkGetMacro(Cloud, bool);
  vtkBooleanMacro(Cloud, bool);
  ///@}

  /** That of the cameras as well. */
  vtkMTimeType GetMTime() override;

protected:
  vtkRelievoVisibility();
  ~vtkRelievoVisibility() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoVisibility(const vtkRelievoVisibility&) = delete;
  void operator=(const vtkRelievoVisibility&) = delete;

  std::vector<vtkSmartPointer<vtkRelievoCameraModel>> Cameras;
  bool Cloud = false;
};

#endif
