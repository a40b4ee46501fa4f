// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A volume's data and opacity as VTK's shader samples them, in double: to refine the place that the
// march on the GPU has found. GPUs filter with weights of about 8 bits, and march in float.
#ifndef vtkRelievoVolumeMarch_h
#define vtkRelievoVolumeMarch_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkGPUVolumeRayCastMapper;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkVolume;

class vtkRelievoVolumeMarch
{
public:
  // False if the volume is drawn in other ways than this class knows: one component of an image,
  // composited by a function of the value. `longest` is the greatest size of a texture, which
  // limits VTK's tables.
  bool Take(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, int longest);

  // Whether the values are those that were taken, as far as their array and image tell.
  bool IsUnchanged() const;

  // Makes the opacities of a step of this length in data units, for FindStep.
  void SetStep(double length);

  // Whether values between points are interpolated.
  bool IsLinear() const { return this->Linear; }

  // The value at a position in points of the image, from 0.
  double GetValue(const glm::dvec3& position) const;

  // Marches from a ray's entry with a constant step, in points, to `last` steps, and finds the
  // place of the rule (vtkRelievoVolumesStage) not before step `first`. Returns steps from the
  // entry; NaN if there is none.
  double FindStep(const glm::dvec3& entry, const glm::dvec3& step, int rule, double threshold,
    int first, int last) const;

private:
  double GetOpacity(double value) const;
  template <typename Value>
  double Interpolate(const Value* values, const glm::dvec3& position) const;
  template <typename Value>
  double March(const Value* values, const glm::dvec3& entry, const glm::dvec3& step, int rule,
    double threshold, int first, int last) const;

  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Values;
  vtkMTimeType Time = 0;        // the later one of both
  const void* Memory = nullptr; // of the values
  glm::ivec3 Size;              // values along each axis
  double Shift = 0.0;           // of the values of cells
  bool Linear = true;
  double Range[2] = { 0.0, 1.0 };
  double UnitDistance = 1.0;
  vtkSmartPointer<vtkPiecewiseFunction> Function; // opacity of the unit distance
  int Longest = 0;
  std::vector<double> Opacities; // of a step over the range
};

#endif
