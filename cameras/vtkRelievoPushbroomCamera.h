// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPushbroomCamera
 * @brief A line sensor that moves during the exposure, for satellites and conveyor belts.
 *
 * The position of row v is v times the velocity, in camera space (x right, y down, z forward):
 * column u has the ray ((u - cx) / f, 0, 1) there. The pose is that of row 0.
 */
#ifndef vtkRelievoPushbroomCamera_h
#define vtkRelievoPushbroomCamera_h

#include "vtkRelievoCameraModel.h"

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoPushbroomCamera : public vtkRelievoCameraModel
{
public:
  static vtkRelievoPushbroomCamera* New();
  vtkTypeMacro(vtkRelievoPushbroomCamera, vtkRelievoCameraModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The focal length along the line in pixels, above 0; default 640. */
  vtkSetClampMacro(FocalLength, double, 1e-12, VTK_DOUBLE_MAX);
  vtkGetMacro(FocalLength, double);
  ///@}

  ///@{
  /** The column of the axis; default 319.5. */
  vtkSetMacro(PrincipalColumn, double);
  vtkGetMacro(PrincipalColumn, double);
  ///@}

  ///@{
  /**
   * The sensor's motion from one row to the next, in camera space and world units; default (0,
   * 0.01, 0). Points have a picture position only if y is not 0.
   */
  vtkSetVector3Macro(Velocity, double);
  vtkGetVector3Macro(Velocity, double);
  ///@}

  bool HasPicture() override { return false; }
  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

protected:
  vtkRelievoPushbroomCamera() = default;
  ~vtkRelievoPushbroomCamera() override = default;

private:
  vtkRelievoPushbroomCamera(const vtkRelievoPushbroomCamera&) = delete;
  void operator=(const vtkRelievoPushbroomCamera&) = delete;

  double FocalLength = 640.0;
  double PrincipalColumn = 319.5;
  double Velocity[3] = { 0.0, 0.01, 0.0 };
};

#endif
