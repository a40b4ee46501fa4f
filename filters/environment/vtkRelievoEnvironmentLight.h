// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is made of a picture of all directions before it can be mirrored and light surfaces.
#ifndef vtkRelievoEnvironmentLight_h
#define vtkRelievoEnvironmentLight_h

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRelievoFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkAlgorithm;

struct VTKRELIEVOFILTERS_EXPORT vtkRelievoEnvironmentLight
{
  vtkSmartPointer<vtkImageData> Image;
  bool SRGB = false;                            // whole numbers are; floats are linear light
  vtkSmartPointer<vtkMultiBlockDataSet> Levels; // for rough mirrors
  vtkSmartPointer<vtkDataArray> Irradiance;     // for diffuse surfaces

  // False, with words of what was expected in `failure`, for an image of another shape than that
  // of all directions (twice as wide as high) or of a mirror ball (square).
  bool SetImage(vtkImageData* image, std::string& failure);

  // Each is made once. tolerance: as of vtkRelievoEnvironmentPrefilter. `watch` sees the filter,
  // which takes a second, before it runs.
  void MakeIrradiance();
  void MakeLevels(
    double tolerance = 5e-4, const std::function<void(vtkAlgorithm*)>& watch = nullptr);
};

#endif
