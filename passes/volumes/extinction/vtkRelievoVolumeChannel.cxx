// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeChannel.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace
{
// An opaque sample lets this share of the light pass in a unit distance.
constexpr double Opaque = 1e-7;
// Colours are at least this bright where they colour light: a dark one blocks a channel at once.
constexpr double Darkest = 1.0 / 255.0;

// The range of scalars that VTK's tables cover.
void GetRange(vtkDataArray* array, int component, double range[2])
{
  array->GetFiniteRange(range, component);
  if (array->GetNumberOfComponents() == 4 && array->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    range[0] = 0.0;
    range[1] = 255.0;
  }
  range[1] = range[1] > range[0] ? range[1] : range[0] + 1.0;
}
}

//------------------------------------------------------------------------------
vtkRelievoVolumeChannel::vtkRelievoVolumeChannel(vtkVolumeProperty* property, vtkImageData* image,
  vtkDataArray* array, int component, int function, int opacity, double stretch)
  : Component(component)
  , Stretch(stretch)
{
  this->Weight = static_cast<float>(property->GetComponentWeight(function));
  double* range = this->Range;
  GetRange(array, component, range);
  this->Opacity.Set(property->GetScalarOpacity(opacity));
  this->Unit = std::max(1e-300, property->GetScalarOpacityUnitDistance(function));
  std::vector<float> opacities(Entries);
  property->GetScalarOpacity(opacity)->GetTable(range[0], range[1], Entries, opacities.data());
  this->Extinction.resize(Entries);
  std::transform(opacities.begin(), opacities.end(), this->Extinction.begin(),
    [this](float each) { return static_cast<float>(GetExtinction(each, this->Unit)); });
  this->First = static_cast<float>(range[0] / this->Stretch);
  this->PerScalar = static_cast<float>(this->Stretch * (Entries - 1) / (range[1] - range[0]));
  if (HasGradients(property, function))
  {
    vtkPiecewiseFunction* gradients = property->GetGradientOpacity(function);
    this->Gradient.Set(gradients);
    this->GradientOpacity.resize(Entries);
    this->Steepest = 0.25 * (range[1] - range[0]);
    gradients->GetTable(0.0, this->Steepest, Entries, this->GradientOpacity.data());
    const glm::dvec3 spacing(
      image->GetSpacing()[0], image->GetSpacing()[1], image->GetSpacing()[2]);
    const double mean = (spacing.x + spacing.y + spacing.z) / 3.0;
    this->Weights = glm::vec3(this->Stretch * mean / (2.0 * spacing));
  }
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeChannel::AddTints(
  vtkVolumeProperty* property, vtkDataArray* array, int function)
{
  const int components = array->GetNumberOfComponents();
  if (components == 4 && !property->GetIndependentComponents())
  {
    return; // the colours are in the data
  }
  // The first of two dependent components determines the colour.
  this->TintBy = components == 2 && !property->GetIndependentComponents() ? 0 : this->Component;
  double range[2];
  GetRange(array, this->TintBy, range);
  this->FirstTint = static_cast<float>(range[0] / this->Stretch);
  this->PerTint = static_cast<float>(this->Stretch * (Entries - 1) / (range[1] - range[0]));
  std::vector<float> colors(3 * Entries);
  if (property->GetColorChannels(function) == 1)
  {
    property->GetGrayTransferFunction(function)->GetTable(
      range[0], range[1], Entries, colors.data(), 3);
    for (int i = 0; i < Entries; ++i)
    {
      colors[3 * i + 1] = colors[3 * i + 2] = colors[3 * i];
    }
  }
  else
  {
    property->GetRGBTransferFunction(function)->GetTable(
      range[0], range[1], Entries, colors.data());
  }
  bool white = true;
  this->Tints.resize(Entries);
  for (int i = 0; i < Entries; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double color = std::min(std::max<double>(colors[3 * i + j], Darkest), 1.0);
      this->Tints[i][j] = static_cast<float>(-std::log(color));
      white = white && color == 1.0;
    }
  }
  if (white)
  {
    this->Tints.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeChannel::HasGradients(vtkVolumeProperty* property, int function)
{
  return property->HasGradientOpacity(function) && !property->GetDisableGradientOpacity(function);
}

//------------------------------------------------------------------------------
double vtkRelievoVolumeChannel::GetExtinction(double opacity, double unit)
{
  return -std::log1p(-std::min(opacity, 1.0 - Opaque)) / unit;
}
