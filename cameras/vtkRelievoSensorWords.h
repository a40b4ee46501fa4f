// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words for a sensor in vtkRelievoCalibration: each class listed in cameras/CMakeLists.txt
// returns its own from GetWords().
#ifndef vtkRelievoSensorWords_h
#define vtkRelievoSensorWords_h

#include <string>
#include <vector>

class vtkRelievoCameraModel;

// The view that a sensor is made for: its pixels and its extent in the world.
struct vtkRelievoSensorView
{
  int Columns, Rows;
  double HalfHeight; // world units from centre to edge, at the view's focal point
};

struct vtkRelievoSensorWords
{
  std::string Name;        // the first word: "equirectangular"
  std::string Form;        // the full form: "equirectangular[:H,V]"
  std::vector<int> Counts; // allowed numbers of coefficients
  std::string Range;       // of the numbers, for messages, after the form
  int Lens = -1;           // of vtkRelievoLensCamera, which has intrinsics in addition

  // For sensors that are not lenses. Whether the numbers are valid; an error message about a
  // picture of this size, or ""; and the sensor, owned by the caller.
  bool (*IsGood)(const std::vector<double>& numbers) = nullptr;
  std::string (*CheckSize)(int columns, int rows) = nullptr;
  vtkRelievoCameraModel* (*Make)(
    const std::vector<double>& numbers, const vtkRelievoSensorView& view) = nullptr;
};

#endif
