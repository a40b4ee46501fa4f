// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prepares a picture of all directions for reflections and for lighting surfaces.
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
  bool SRGB = false;                            // integers are sRGB; floats are linear light
  vtkSmartPointer<vtkMultiBlockDataSet> Levels; // for rough mirrors
  vtkSmartPointer<vtkDataArray> Irradiance;     // for diffuse surfaces

  // False, with the expected shape in `failure`, unless the image shows all directions (twice as
  // wide as high) or a mirror ball (square).
  bool SetImage(vtkImageData* image, std::string& failure);

  // Each is made once. tolerance: as in vtkRelievoEnvironmentPrefilter. `watch` gets the filter,
  // which takes a second, before it runs.
  void MakeIrradiance();
  void MakeLevels(
    double tolerance = 5e-4, const std::function<void(vtkAlgorithm*)>& watch = nullptr);
};

#endif
