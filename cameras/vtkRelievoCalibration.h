// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCalibration
 * @brief Makes a sensor of a few words, or of a file that a calibration wrote.
 *
 * Words, with the coefficients of vtkRelievoLensCamera; those in brackets are 0 by default:
 * - `pinhole`, `brown:K1,K2[,P1,P2[,K3[,K4,K5,K6]]]`, `fisheye[:K1[,K2[,K3[,K4]]]]`, `division:K`.
 *   Behind them `,K=FX/FY/CX/CY`, the intrinsics in pixels. Without, pixels are square, the
 *   principal point is in the middle, and the picture's height spans an angle: `,angle=DEG`, also
 *   above 180, or the view's.
 * - `equirectangular[:H,V]`, degrees that the picture spans (360,180); `cube`, for pictures six
 *   times as wide as high; `orthographic[:PIXELS]`, pixels for a world unit (the view's).
 *
 * Files, by their names:
 * - `.yml`, `.yaml`, `.json`: OpenCV's (cv::FileStorage) and those of ROS's calibrator:
 *   `image_width`, `image_height`, `camera_matrix`, `distortion_coefficients`, and
 *   `distortion_model` (plumb_bob, rational_polynomial, equidistant, fisheye, division) or
 *   `fisheye_model`. Or a CameraInfo of ROS, with `width`, `height`, `K` or `k`, `D` or `d`.
 *   Matrices are objects of `rows`, `cols` and `data`, or lists. Of YAML this subset is read; other
 *   entries are left. Or Kalibr's chain of one camera, and EuRoC's sensor.yaml, with `resolution`,
 *   `intrinsics`, `camera_model` pinhole, and `distortion_model` radtan, radial-tangential,
 *   equidistant or none.
 * - `.xml`: OpenCV's. All of OpenCV's may be packed, with `.gz` behind.
 * - `.txt`: COLMAP's cameras.txt of one camera: SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL,
 *   OPENCV, FULL_OPENCV, OPENCV_FISHEYE, SIMPLE_RADIAL_FISHEYE, RADIAL_FISHEYE.
 *
 * A file's intrinsics hold for its size; for a picture of another size and the same shape they are
 * scaled.
 *
 * Errors: words or a file that say no sensor, a size or an angle that it cannot have.
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
   * wrong. Default `pinhole`.
   */
  bool SetWords(RELIEVO_TEXT words);
  std::string GetWords() { return this->Words; }
  ///@}

  /** What is wrong with words: "got ..., expected ..."; empty if nothing is. */
  static std::string Check(RELIEVO_TEXT words);

  ///@{
  /**
   * The forms of all words, with commas between them: those of lenses, which may have intrinsics or
   * an angle behind them, or those of others. Their names, with a colon behind those that need
   * numbers.
   */
  static std::string GetForms(bool ofLenses);
  static std::vector<std::string> GetNames();
  ///@}

  /** Whether words name a file. */
  static bool IsFile(RELIEVO_TEXT words);

  /** Reads the file, if the words name one. False, with an error, if it says no calibration. */
  bool Read();

  ///@{
  /** Columns and rows that the file is for; 0, 0 without one, or before Read(). */
  vtkGetVector2Macro(FileSize, int);
  ///@}

  ///@{
  /**
   * The angle, in degrees, that the picture's height spans if the words say neither intrinsics nor
   * an angle; 0, the default: that of the view.
   */
  vtkSetClampMacro(ViewAngle, double, 0.0, 360.0);
  vtkGetMacro(ViewAngle, double);
  ///@}

  /** The angle that the words say, in degrees; 0 if they say none. */
  double GetAngleOfWords() { return this->Angle; }

  /**
   * A new sensor with the place, the directions and the angle (or parallel scale) of a view, for a
   * picture of these columns and rows. Null, with an error, if there is none. It lives until the
   * next call.
   */
  vtkRelievoCameraModel* MakeCamera(vtkCamera* view, int columns, int rows);

  /** Why the last call failed; empty if it did not. */
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
  std::vector<double> Intrinsics; // fx, fy, skew, cx, cy; empty: by the angle
  int FileSize[2] = { 0, 0 };
  double Angle = 0.0;
  double ViewAngle = 0.0;
  std::string FailureText;
  vtkRelievoCameraModel* Camera = nullptr;
};

#endif
