// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A calibration file's contents, in the forms of OpenCV, ROS, Kalibr, EuRoC and COLMAP.
#ifndef vtkRelievoCalibrationFile_h
#define vtkRelievoCalibrationFile_h

#include <cmath>
#include <optional>
#include <string>
#include <vector>

struct vtkRelievoCalibrationFile
{
  std::string Kind;               // pinhole, brown, fisheye or division
  std::vector<double> Values;     // the coefficients
  std::vector<double> Intrinsics; // fx, fy, skew, cx, cy
  int Size[2] = { 0, 0 };
  std::string Error; // error message, or empty

  static vtkRelievoCalibrationFile Read(const std::string& path);

  // Whether the numbers form K row by row: fx, skew, cx, 0, fy, cy, 0, 0, 1.
  static bool IsMatrix(const std::vector<double>& k)
  {
    return k.size() == 9 && std::isfinite(k[0] + k[1] + k[2] + k[4] + k[5]) && k[0] > 0.0 &&
      k[4] > 0.0 && k[3] == 0.0 && k[6] == 0.0 && k[7] == 0.0 && k[8] == 1.0;
  }

  // In lower case, with its dot, including the extension before .gz.
  static std::string GetExtension(const std::string& path);

  // Parses a finite number, independently of the locale.
  static std::optional<double> ToNumber(const std::string& word);

  static std::vector<std::string> Split(const std::string& text, char separator);
};

#endif
