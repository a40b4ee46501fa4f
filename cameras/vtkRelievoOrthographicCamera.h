// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoOrthographicCamera
 * @brief A camera with parallel rays and a fixed number of pixels per world unit, as in a map.
 *
 * u = scale x + cx, v = scale y + cy in camera space (x right, y down, z forward). Rays start at z
 * = 0; points behind are not seen.
 */
#ifndef vtkRelievoOrthographicCamera_h
#define vtkRelievoOrthographicCamera_h

#include "vtkRelievoCameraModel.h"
#include "vtkRelievoSensorWords.h" // for words

#include <vector> // for words

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoOrthographicCamera : public vtkRelievoCameraModel
{
public:
  static vtkRelievoOrthographicCamera* New();
  vtkTypeMacro(vtkRelievoOrthographicCamera, vtkRelievoCameraModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Pixels per world unit, above 0; default 100. */
  vtkSetClampMacro(PixelsPerUnit, double, 1e-12, VTK_DOUBLE_MAX);
  vtkGetMacro(PixelsPerUnit, double);
  ///@}

  ///@{
  /** The pixel of the axis x = y = 0; default 319.5, 239.5, the middle of 640 x 480. */
  vtkSetVector2Macro(PrincipalPoint, double);
  vtkGetVector2Macro(PrincipalPoint, double);
  ///@}

#ifndef __VTK_WRAP__
  /** The words for this class, for vtkRelievoCalibration. */
  static std::vector<vtkRelievoSensorWords> GetWords();
#endif

  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

protected:
  vtkRelievoOrthographicCamera() = default;
  ~vtkRelievoOrthographicCamera() override = default;

private:
  vtkRelievoOrthographicCamera(const vtkRelievoOrthographicCamera&) = delete;
  void operator=(const vtkRelievoOrthographicCamera&) = delete;

  double PixelsPerUnit = 100.0;
  double PrincipalPoint[2] = { 319.5, 239.5 };
};

#endif
