// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words of a sensor, as vtkRelievoCalibration takes them: each class that is listed in
// cameras/CMakeLists.txt has them in its GetWords().
#ifndef vtkRelievoSensorWords_h
#define vtkRelievoSensorWords_h

#include <string>
#include <vector>

class vtkRelievoCameraModel;

// What a sensor is made for: pixels, and what of the world a view has in them.
struct vtkRelievoSensorView
{
  int Columns, Rows;
  double HalfHeight; // world units from the middle to the edge, at the view's focal point
};

struct vtkRelievoSensorWords
{
  std::string Name;        // the first word: "equirectangular"
  std::string Form;        // the whole: "equirectangular[:H,V]"
  std::vector<int> Counts; // of its numbers
  std::string Range;       // of its numbers, for messages, behind the form
  int Lens = -1;           // of vtkRelievoLensCamera, which has intrinsics besides

  // Of sensors that are no lenses. Whether the numbers are good, if there are any; what is wrong
  // with a picture of this size, "" if nothing is; and the sensor, which the caller owns.
  bool (*IsGood)(const std::vector<double>& numbers) = nullptr;
  std::string (*CheckSize)(int columns, int rows) = nullptr;
  vtkRelievoCameraModel* (*Make)(
    const std::vector<double>& numbers, const vtkRelievoSensorView& view) = nullptr;
};

#endif
