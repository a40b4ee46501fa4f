// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "Errors.h"
#include "Images.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "SurfaceOptions.h"

#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentLight.h"
#include "vtkRelievoSkybox.h"
#include "vtkRenderer.h"

namespace scene
{
namespace
{
// Tolerance of the levels' sums; smaller ones would make the command wait.
constexpr double LevelTolerance = 2e-3;
}

//------------------------------------------------------------------------------
void CheckEnvironment(const RenderOptions& options)
{
  if (!options.Environment.empty())
  {
    CheckImage("--environment", options.Environment);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoEnvironment> ReadEnvironment(
  const RenderOptions& options, Progress& progress)
{
  if (options.Environment.empty())
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkImageData> image = ReadImage(options.Environment, progress);
  vtkRelievoEnvironmentLight light;
  std::string failure;
  if (!light.SetImage(image, failure))
  {
    throw WorkError(options.Environment + ": expected " + failure);
  }
  progress.Begin("preparing " + options.Environment);
  light.MakeIrradiance();
  if (options.Roughness > 0.0)
  {
    light.MakeLevels(
      LevelTolerance, [&progress](vtkAlgorithm* levels) { progress.Observe(levels); });
  }
  auto environment = vtkSmartPointer<vtkRelievoEnvironment>::New();
  environment->SetImage(light.Image);
  environment->SetSRGB(light.SRGB);
  environment->SetLevels(light.Levels);
  environment->SetIrradiance(light.Irradiance);
  environment->SetRotation(options.EnvironmentRotation);
  environment->SetUpAxis(options.UpAxis);
  for (const vtkRelievoParameter& value : GetEnvironmentValues().Parameters)
  {
    environment->SetParameter(value.Name, GetSurfaceValue(options, value.Name));
  }
  progress.End();
  Messages::Check(options.Environment);
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
}
