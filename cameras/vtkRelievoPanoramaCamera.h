// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPanoramaCamera
 * @brief A camera that looks in all directions from one position: equirectangular, or six faces of
 * a cube.
 *
 * - EQUIRECTANGULAR: columns are equal steps of the angle around the camera's y axis, with forward
 *   in the middle and right beyond it; rows are equal steps of the elevation, from the highest. The
 *   full panorama spans 360 x 180 degrees; smaller ones are its middle.
 * - CUBE: square faces side by side from the left, each of 90 degrees and upright: front, right,
 *   back, left, up (its lower edge at the front), down (its upper edge at the front). The size must
 *   be six times as wide as high, otherwise GetCameraRay() sees nothing.
 */
#ifndef vtkRelievoPanoramaCamera_h
#define vtkRelievoPanoramaCamera_h

#include "vtkRelievoCameraModel.h"
#include "vtkRelievoSensorWords.h" // for words

#include <vector> // for words

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoPanoramaCamera : public vtkRelievoCameraModel
{
public:
  static vtkRelievoPanoramaCamera* New();
  vtkTypeMacro(vtkRelievoPanoramaCamera, vtkRelievoCameraModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    EQUIRECTANGULAR,
    CUBE
  };

  ///@{
  /** Kind of panorama; default EQUIRECTANGULAR. */
  vtkSetClampMacro(Layout, int, EQUIRECTANGULAR, CUBE);
  vtkGetMacro(Layout, int);
  ///@}

  ///@{
  /** Degrees spanned by the columns and rows of an equirectangular panorama; default 360, 180. */
  void SetFieldOfView(double horizontal, double vertical);
  vtkGetVector2Macro(FieldOfView, double);
  ///@}

#ifndef __VTK_WRAP__
  /** The words for this class, for vtkRelievoCalibration. */
  static std::vector<vtkRelievoSensorWords> GetWords();
#endif

  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  bool IsCentral() override
  {
    return true;
  }
  double GetColumnsOfTurn() override;
  double GetDepth(const double origin[3], const double point[3]) override;
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

protected:
  vtkRelievoPanoramaCamera() = default;
  ~vtkRelievoPanoramaCamera() override = default;

private:
  vtkRelievoPanoramaCamera(const vtkRelievoPanoramaCamera&) = delete;
  void operator=(const vtkRelievoPanoramaCamera&) = delete;

  int Layout = EQUIRECTANGULAR;
  double FieldOfView[2] = { 360.0, 180.0 };
};

#endif
