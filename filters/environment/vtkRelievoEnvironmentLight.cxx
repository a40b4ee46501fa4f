// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironmentLight.h"

#include "vtkNew.h"
#include "vtkRelievoEnvironmentIrradiance.h"
#include "vtkRelievoEnvironmentPrefilter.h"
#include "vtkTable.h"

namespace
{
// Texels across a face of the sharpest level: takes about a second.
constexpr int LevelSize = 128;
}

//------------------------------------------------------------------------------
bool vtkRelievoEnvironmentLight::SetImage(vtkImageData* image, std::string& failure)
{
  const int* size = image->GetDimensions();
  if (size[0] != 2 * size[1] && size[0] != size[1])
  {
    failure = "an image twice as wide as high (all directions: equirectangular) or square (a "
              "mirror ball: a sphere map), but it has " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]) + " pixels";
    return false;
  }
  const int type = image->GetScalarType();
  *this = { image, type != VTK_FLOAT && type != VTK_DOUBLE, nullptr, nullptr };
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentLight::MakeIrradiance()
{
  if (this->Irradiance)
  {
    return;
  }
  vtkNew<vtkRelievoEnvironmentIrradiance> irradiance;
  irradiance->SetInputData(this->Image);
  irradiance->SetInputSRGB(this->SRGB);
  irradiance->Update();
  this->Irradiance =
    vtkDataArray::SafeDownCast(irradiance->GetOutput()->GetColumnByName("radiance"));
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironmentLight::MakeLevels(
  double tolerance, const std::function<void(vtkAlgorithm*)>& watch)
{
  if (this->Levels)
  {
    return;
  }
  vtkNew<vtkRelievoEnvironmentPrefilter> levels;
  levels->SetInputData(this->Image);
  levels->SetInputSRGB(this->SRGB);
  levels->SetSize(LevelSize);
  levels->SetTolerance(tolerance);
  if (watch)
  {
    watch(levels);
  }
  levels->Update();
  this->Levels = levels->GetOutput();
}
