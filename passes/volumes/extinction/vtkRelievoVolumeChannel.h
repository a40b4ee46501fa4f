// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A component of a volume that has an opacity: its transfer functions, as tables.
#ifndef vtkRelievoVolumeChannel_h
#define vtkRelievoVolumeChannel_h

#include "vtkRelievoOpacityCurve.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkVolumeProperty;

struct vtkRelievoVolumeChannel
{
  static constexpr int Entries = 4096; // of tables

  // `function`: the index of the property's settings; `opacity`: of its opacity function.
  vtkRelievoVolumeChannel(vtkVolumeProperty* property, vtkImageData* image, vtkDataArray* array,
    int component, int function, int opacity, double stretch);

  int Component = 0;
  float Weight = 1.f;
  std::vector<float> Extinction; // of scalars, per unit of length in the volume's coordinates
  float First = 0.f;             // the image's scalar of its first entry
  float PerScalar = 0.f;         // entries
  // Opacity by the gradient's length, from 0 to a quarter of the scalars' range, constant beyond;
  // empty: none. The length is that of differences of neighbours, each times its weight.
  std::vector<float> GradientOpacity;
  glm::vec3 Weights{ 1.f };
  std::vector<glm::vec3> Tints; // of the scalars of the component TintBy; empty: none
  int TintBy = 0;
  float FirstTint = 0.f;
  float PerTint = 0.f;
  vtkRelievoOpacityCurve Opacity; // the functions themselves, for GetDepth
  vtkRelievoOpacityCurve Gradient;
  double Stretch = 1.0; // of scalars, where functions are looked up
  double Range[2] = { 0.0, 1.0 };
  double Unit = 1.0;
  double Steepest = 1.0; // gradient length, where the gradient's table ends

  // Adds the tables of colours, unless these are in the data or white.
  void AddTints(vtkVolumeProperty* property, vtkDataArray* array, int function);

  // Whether the property's function of this index has opacities of gradients.
  static bool HasGradients(vtkVolumeProperty* property, int function);

  // The extinction per unit of length of an opacity per `unit`.
  static double GetExtinction(double opacity, double unit);

  // The value between the entries of a table.
  template <typename V>
  static V Look(const std::vector<V>& table, float entry)
  {
    const float inside = std::min(std::max(entry, 0.f), Entries - 1.f);
    const int before = std::min(static_cast<int>(inside), Entries - 2);
    return table[before] +
      (inside - static_cast<float>(before)) * (table[before + 1] - table[before]);
  }
};

#endif
