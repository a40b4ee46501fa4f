// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCalibration
 * @brief Makes a sensor from a few words, or from a calibration file.
 *
 * Words, with the coefficients of vtkRelievoLensCamera; those in brackets default to 0:
 * - `pinhole`, `brown:K1,K2[,P1,P2[,K3[,K4,K5,K6]]]`, `fisheye[:K1[,K2[,K3[,K4]]]]`, `division:K`.
 *   Optionally followed by `,K=FX/FY/CX/CY`, the intrinsics in pixels. Without intrinsics, pixels
 *   are square, the principal point is in the middle, and the picture's height spans an angle:
 *   `,angle=DEG`, also above 180, or the view's.
 * - `equirectangular[:H,V]`, degrees that the picture spans (360,180); `cube`, for pictures six
 *   times as wide as high; `orthographic[:PIXELS]`, pixels per world unit (the view's).
 *
 * Files, by their extension:
 * - `.yml`, `.yaml`, `.json`: files of OpenCV (cv::FileStorage) and of ROS's calibrator:
 *   `image_width`, `image_height`, `camera_matrix`, `distortion_coefficients`, and
 *   `distortion_model` (plumb_bob, rational_polynomial, equidistant, fisheye, division) or
 *   `fisheye_model`. Or a CameraInfo of ROS, with `width`, `height`, `K` or `k`, `D` or `d`.
 *   Matrices are objects of `rows`, `cols` and `data`, or lists. Only this subset of YAML is read;
 *   other entries are ignored. Or Kalibr's chain of one camera, and EuRoC's sensor.yaml, with
 *   `resolution`, `intrinsics`, `camera_model` pinhole, and `distortion_model` radtan,
 *   radial-tangential, equidistant or none.
 * - `.xml`: OpenCV's. All of OpenCV's files may be compressed, with `.gz` appended.
 * - `.txt`: COLMAP's cameras.txt of one camera: SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL,
 *   OPENCV, FULL_OPENCV, OPENCV_FISHEYE, SIMPLE_RADIAL_FISHEYE, RADIAL_FISHEYE.
 *
 * A file's intrinsics apply to its size; for a picture of another size and the same shape they are
 * scaled.
 *
 * Errors: words or a file that do not describe a sensor, or an impossible size or angle.
 */
#ifndef vtkRelievoCalibration_h
#define vtkRelievoCalibration_h

#include "vtkObject.h"
#include "vtkRelievoCamerasModule.h" // for the export macro
#include "vtkRelievoText.h"          // for names that are given

#include <string> // for words
#include <vector> // for coefficients

class vtkCamera;
class vtkRelievoCameraModel;

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoCalibration : public vtkObject
{
public:
  static vtkRelievoCalibration* New();
  vtkTypeMacro(vtkRelievoCalibration, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The words, or the name of a file, which is not read yet. False, with an error, if they are
   * invalid. Default `pinhole`.
   */
  bool SetWords(RELIEVO_TEXT words);
  std::string GetWords() { return this->Words; }
  ///@}

  /** Error message for words: "got ..., expected ..."; empty if they are valid. */
  static std::string Check(RELIEVO_TEXT words);

  ///@{
  /**
   * GetForms: the forms of all words, separated by commas, for lenses, which may be followed by
   * intrinsics or an angle, or for other sensors. GetNames: their names, followed by a colon if
   * they need numbers.
   */
  static std::string GetForms(bool ofLenses);
  static std::vector<std::string> GetNames();
  ///@}

  /** Whether the words name a file. */
  static bool IsFile(RELIEVO_TEXT words);

  /** Reads the file, if the words name one. False, with an error, if it contains no calibration. */
  bool Read();

  ///@{
  /** Columns and rows of the file's calibration; 0, 0 without a file, or before Read(). */
  vtkGetVector2Macro(FileSize, int);
  ///@}

  ///@{
  /**
   * The angle, in degrees, that the picture's height spans if the words give neither intrinsics nor
   * an angle; 0, the default: the view's angle.
   */
  vtkSetClampMacro(ViewAngle, double, 0.0, 360.0);
  vtkGetMacro(ViewAngle, double);
  ///@}

  /** The angle given by the words, in degrees; 0 if they give none. */
  double GetAngleOfWords() { return this->Angle; }

  /**
   * A new sensor with the position, the directions and the angle (or parallel scale) of a view, for
   * a picture of these columns and rows. Null, with an error, if this is impossible. The sensor
   * lives until the next call.
   */
  vtkRelievoCameraModel* MakeCamera(vtkCamera* view, int columns, int rows);

  /** Error message of the last call; empty if it succeeded. */
  std::string GetFailureText() { return this->FailureText; }

protected:
  vtkRelievoCalibration();
  ~vtkRelievoCalibration() override;

private:
  vtkRelievoCalibration(const vtkRelievoCalibration&) = delete;
  void operator=(const vtkRelievoCalibration&) = delete;

  bool Fail(const std::string& text);
  vtkRelievoCameraModel* MakeLens(vtkCamera* view, int columns, int rows);

  std::string Words = "pinhole";
  std::string Kind = "pinhole";
  std::vector<double> Numbers;
  std::vector<double> Intrinsics; // fx, fy, skew, cx, cy; empty: from the angle
  int FileSize[2] = { 0, 0 };
  double Angle = 0.0;
  double ViewAngle = 0.0;
  std::string FailureText;
  vtkRelievoCameraModel* Camera = nullptr;
};

#endif
