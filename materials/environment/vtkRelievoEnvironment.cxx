// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEnvironment.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoEnvironmentTextures.h"
#include "vtkRelievoParameter.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRelievoEnvironment);

//------------------------------------------------------------------------------
vtkRelievoEnvironment::vtkRelievoEnvironment()
  : Textures(new vtkRelievoEnvironmentTextures(this))
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Description;
  list
    .AddNumber(
      "rotation", this->Rotation, [this](double degrees) { this->SetRotation(degrees); }, -infinity,
      infinity, "degrees", "Rotation about the up axis, counter-clockwise seen from above.")
    .Usual = 360.0;
  list.AddChoice(
    "up", this->UpAxis, [this](int axis) { this->SetUpAxis(axis); }, { "x", "y", "z" },
    "The world axis that points up, towards the image's upper edge.");
  list
    .AddNumber(
      "intensity", this->Intensity, [this](double factor) { this->SetIntensity(factor); }, 0.0,
      infinity, "", "Factor of the environment's light.")
    .Usual = 4.0;
  list
    .AddFlag(
      "gamma_correct", this->GammaCorrect, [this](bool on) { this->SetGammaCorrect(on); },
      "Whether the picture is gamma-corrected by a power of 1/2.2, so that photographs look as "
      "they do elsewhere. If off, light is shown unchanged, except on PBR surfaces, which VTK "
      "always corrects.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoEnvironment::~vtkRelievoEnvironment() = default;

//------------------------------------------------------------------------------
bool vtkRelievoEnvironment::SetParameter(RELIEVO_TEXT name, RELIEVO_TEXT words)
{
  const std::string error = this->TrySetParameter(name, words);
  if (!error.empty())
  {
    vtkErrorMacro(<< name << ": " << error << ".");
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::SetImage(vtkImageData* image)
{
  if (this->Textures->Image != image)
  {
    this->Textures->Image = image;
    this->Textures->ChangeTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoEnvironment::GetImage()
{
  return this->Textures->Image;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::SetProjection(int projection)
{
  const int inRange = std::clamp<int>(projection, AUTOMATIC, SPHERE_MAP);
  if (this->Textures->Projection != inRange)
  {
    this->Textures->Projection = inRange;
    this->Textures->ChangeTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoEnvironment::GetProjection()
{
  return this->Textures->Projection;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::SetSRGB(bool on)
{
  if (this->Textures->SRGB != on)
  {
    this->Textures->SRGB = on;
    this->Textures->ChangeTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoEnvironment::GetSRGB()
{
  return this->Textures->SRGB;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::SetLevels(vtkMultiBlockDataSet* levels)
{
  if (this->Textures->Levels != levels)
  {
    this->Textures->Levels = levels;
    this->Textures->ChangeTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiBlockDataSet* vtkRelievoEnvironment::GetLevels()
{
  return this->Textures->Levels;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::SetIrradiance(vtkDataArray* coefficients)
{
  if (this->Textures->Coefficients != coefficients)
  {
    this->Textures->Coefficients = coefficients;
    this->Textures->ChangeTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* vtkRelievoEnvironment::GetIrradiance()
{
  return this->Textures->Coefficients;
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::GetWorldToEnvironment(vtkMatrix3x3* rotation)
{
  if (!rotation)
  {
    vtkErrorMacro("GetWorldToEnvironment was given no matrix; give it a vtkMatrix3x3 to fill.");
    return;
  }
  // Rows: the environment's x, y, z in the world, before the rotation about its up axis.
  static const double upright[3][3][3] = {
    { { 0, -1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } },
    { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },
  };
  // Multiples of 90 degrees are exact.
  const double turns = std::remainder(this->Rotation, 360.) / 90.;
  const double quarters = std::round(turns);
  const double rest = vtkMath::RadiansFromDegrees(90. * (turns - quarters));
  double c = std::cos(rest);
  double s = std::sin(rest);
  for (int i = 0; i < (static_cast<int>(quarters) + 4) % 4; ++i)
  {
    const double former = c;
    c = -s;
    s = former;
  }
  const auto& from = upright[this->UpAxis];
  for (int j = 0; j < 3; ++j)
  {
    rotation->SetElement(0, j, c * from[0][j] - s * from[2][j]);
    rotation->SetElement(1, j, from[1][j]);
    rotation->SetElement(2, j, s * from[0][j] + c * from[2][j]);
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoEnvironment::GetBytesHeld()
{
  return this->Textures->GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Textures->Release(window);
}

//------------------------------------------------------------------------------
void vtkRelievoEnvironment::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Image: " << this->GetImage() << "\n";
  os << indent << "Projection: " << this->GetProjection() << "\n";
  os << indent << "SRGB: " << this->GetSRGB() << "\n";
  os << indent << "Levels: " << this->GetLevels() << "\n";
  os << indent << "Irradiance: " << this->GetIrradiance() << "\n";
  this->Description.Print(os, indent);
}
