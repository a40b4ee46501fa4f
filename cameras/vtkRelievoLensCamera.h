// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLensCamera
 * @brief A camera with one eye: intrinsics K, and a lens with or without distortion.
 *
 * A point (x, y, z) in camera space (x right, y down, z forward) has the normalized position (x/z,
 * y/z). The lens moves it to (a, b), and the pixel is u = fx a + skew b + cx, v = fy b + cy.
 *
 * Lenses, with r = sqrt(x² + y²) / z and coefficients in OpenCV's order:
 * - PINHOLE: a = x/z, b = y/z; no coefficients.
 * - BROWN_CONRADY (Brown 1971): k1 k2 p1 p2 k3 k4 k5 k6, or the first 2, 4 or 5; radial factor (1 +
 *   k1 r² + k2 r⁴ + k3 r⁶) / (1 + k4 r² + k5 r⁴ + k6 r⁶), and tangential terms of p1, p2.
 * - FISHEYE (Kannala and Brandt 2006): k1 k2 k3 k4, or the first of them; the angle t from the axis
 *   is mapped to the radius t (1 + k1 t² + k2 t⁴ + k3 t⁶ + k4 t⁸), also beyond 90 degrees.
 * - DIVISION (Fitzgibbon 2001): k1; the ray of (a, b) is (a, b, 1 + k1 (a² + b²)), also beyond 90
 *   degrees.
 *
 * A polynomial is used only while it grows: nothing beyond is seen, so that no point appears twice.
 *
 * ApplyTo() and TakeFrom() convert pinholes to and from vtkCamera.
 */
#ifndef vtkRelievoLensCamera_h
#define vtkRelievoLensCamera_h

#include "vtkRelievoCameraModel.h"
#include "vtkRelievoSensorWords.h" // for words

#include <string> // for words
#include <vector> // for words

class vtkCamera;

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoLensCamera : public vtkRelievoCameraModel
{
public:
  static vtkRelievoLensCamera* New();
  vtkTypeMacro(vtkRelievoLensCamera, vtkRelievoCameraModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    PINHOLE,
    BROWN_CONRADY,
    FISHEYE,
    DIVISION
  };

  enum
  {
    MOST_COEFFICIENTS = 8
  };

#ifndef __VTK_WRAP__
  /** The words for this class, for vtkRelievoCalibration. */
  static std::vector<vtkRelievoSensorWords> GetWords();
#endif

  ///@{
  /**
   * In pixels: focal lengths along columns and rows, above 0; the skew between them; the principal
   * point, anywhere. Default 640, 640, 0, 319.5, 239.5.
   */
  void SetIntrinsics(double fx, double fy, double skew, double cx, double cy);
  vtkGetMacro(FocalX, double);
  vtkGetMacro(FocalY, double);
  vtkGetMacro(Skew, double);
  vtkGetVector2Macro(PrincipalPoint, double);
  void GetIntrinsics(double matrix[9]); ///< K, row by row
  ///@}

  ///@{
  /**
   * The lens, one of the enumeration, and its coefficients; missing ones are 0. Default PINHOLE. An
   * unsupported number of coefficients, or values that are not finite, are an error.
   */
  void SetLens(int lens, int count, const double* coefficients) VTK_SIZEHINT(coefficients, count);
  vtkGetMacro(Lens, int);
  double GetCoefficient(int i);

  ///@{
  /**
   * Whether a lens accepts this number of coefficients; and the accepted numbers: "0, 2, 4, 5 or
   * 8".
   */
  static bool TakesCount(int lens, int count);
  static std::string GetCounts(int lens);
  ///@}

  ///@{
  /**
   * ApplyTo() sets a vtkCamera for a window or viewport of this shape; TakeFrom() takes intrinsics,
   * pose and size from one, seen in the given columns and rows. The clipping range is unchanged.
   * False, with an error, for a lens that is not a pinhole, and for a camera without a perspective
   * projection.
   *
   * Skew and different focal lengths become the camera's user transform. In a viewport of another
   * shape, the height, fx and fy are kept, and the principal point keeps its share of the width.
   */
  bool ApplyTo(vtkCamera* camera);
  bool TakeFrom(vtkCamera* camera, int columns, int rows);
  ///@}

  /** Whether a camera has intrinsics K: perspective, level rows, and a rotation as its view. */
  static bool IsPinhole(vtkCamera* camera);

  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  bool IsCentral() override
  {
    return true;
  }
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

protected:
  vtkRelievoLensCamera();
  ~vtkRelievoLensCamera() override = default;

private:
  vtkRelievoLensCamera(const vtkRelievoLensCamera&) = delete;
  void operator=(const vtkRelievoLensCamera&) = delete;

  double GetBent(double r, double* slope) const;
  double GetLimit() const;
  bool Straighten(const double bent[2], double direction[3]) const;
  bool Bend(const double point[3], double bent[2]) const;

  double FocalX = 640.0;
  double FocalY = 640.0;
  double Skew = 0.0;
  double PrincipalPoint[2] = { 319.5, 239.5 };
  int Lens = PINHOLE;
  double Coefficients[MOST_COEFFICIENTS] = {};
  double Limit; // of r, or of the angle
};

#endif
