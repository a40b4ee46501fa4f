// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "Errors.h"
#include "Images.h"
#include "Numbers.h"
#include "OptionRows.h"
#include "Progress.h"
#include "ReadContext.h"
#include "SurfaceOptions.h"

#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentLight.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoSkybox.h"
#include "vtkRenderer.h"

#include <cmath>
#include <string>

namespace look
{
namespace
{
// Tolerance of the levels' sums; smaller ones would make the command wait.
constexpr double LevelTolerance = 2e-3;

// Mean light, where white is 1: beyond these bounds a picture is overexposed or black.
constexpr double Darkest = 0.1;
constexpr double Brightest = 1.0;
constexpr double Usual = 0.4;

// The factor that brings linear light that is very bright or dark to a usual mean; 1 for others.
double FindIntensity(const vtkRelievoEnvironmentLight& light)
{
  // The first coefficient of spherical harmonics is the mean light over all directions.
  double mean = 0.0;
  constexpr double weights[] = { 0.2126, 0.7152, 0.0722 };
  for (int i = 0; i < 3; ++i)
  {
    mean += weights[i] * light.Irradiance->GetComponent(0, i) * 0.5 / std::sqrt(vtkMath::Pi());
  }
  const bool isUsual = light.SRGB || !(mean > 0.0) || (mean >= Darkest && mean <= Brightest);
  return isUsual ? 1.0 : Usual / mean;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoEnvironment> ReadEnvironment(
  const SurfaceChoice& surface, int up, ReadContext& context)
{
  if (surface.Environment.empty())
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkImageData> image = ReadImage(surface.Environment, context);
  Progress& progress = context.GetProgress();
  vtkRelievoEnvironmentLight light;
  std::string failure;
  if (!light.SetImage(image, failure))
  {
    throw WorkError(surface.Environment + ": expected " + failure);
  }
  progress.Begin("preparing " + surface.Environment);
  light.MakeIrradiance();
  if (surface.Roughness > 0.0)
  {
    light.MakeLevels(
      LevelTolerance, [&progress](vtkAlgorithm* levels) { progress.Observe(levels); });
  }
  auto environment = vtkSmartPointer<vtkRelievoEnvironment>::New();
  environment->SetImage(light.Image);
  environment->SetSRGB(light.SRGB);
  environment->SetLevels(light.Levels);
  environment->SetIrradiance(light.Irradiance);
  environment->SetRotation(surface.EnvironmentRotation);
  environment->SetUpAxis(up);
  for (const vtkRelievoParameter& value : GetEnvironmentValues().Parameters)
  {
    environment->SetParameter(value.Name, GetSurfaceValue(surface, value.Name));
  }
  const double found = surface.FindsIntensity ? FindIntensity(light) : 1.0;
  if (found != 1.0)
  {
    const std::string intensity = WriteNumber(RoundTo(found, 0.02 * found));
    environment->SetParameter("intensity", intensity);
    context.Note(surface.Environment + ": its light is " +
      (found < 1.0 ? "too bright" : "too dark") +
      " for a picture, and is drawn with intensity=" + intensity + "; intensity=1 keeps it");
  }
  progress.End();
  context.Check(surface.Environment);
  return environment;
}

//------------------------------------------------------------------------------
void ShowSky(vtkRenderer* renderer, vtkRelievoEnvironment* environment)
{
  vtkNew<vtkRelievoSkybox> sky;
  sky->SetEnvironment(environment);
  // With a parallel projection, all rays would see a single place of the sky.
  sky->SetParallelViewAngle(renderer->GetActiveCamera()->GetViewAngle());
  renderer->AddViewProp(sky);
}

//------------------------------------------------------------------------------
void AddEnvironmentOptions(OptionRows& rows, SurfaceChoice& surface)
{
  // Words are parsed often: long texts are made once.
  static const std::string images = vtkRelievoImageFile::ListExtensions("", "|");
  static const std::string listed = vtkRelievoImageFile::ListExtensions(".");
  static const std::string values = DescribeValues(GetEnvironmentValues());
  rows
    .Add("--environment", "F[,DEG][,NAME=VALUE]...",
      "light from all directions, for reflections and ambient light, from an image (" + listed +
        ") that is twice as wide as high, or square for a photograph of a mirror ball; "
        "rotated by DEG about the up axis (0). 8 and 16 bits are sRGB, floats linear light. "
        "Other values are" +
        values,
      surface, TakeEnvironment)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Light", "Environment")
    .Files = images;
  rows
    .Add("--reflectivity", "R[,ROUGHNESS]",
      "share of the environment's light that surfaces mirror at normal incidence, and "
      "roughness of the mirror, each 0 to 1 (0.04,0.2)",
      surface, TakeReflectivity)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Light", "Reflectivity");
  rows.AddFlag("--skybox", "shows the environment behind everything", surface.Skybox)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Light", "Show as sky");
}
}
