// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "Errors.h"
#include "Images.h"
#include "Progress.h"
#include "ReadContext.h"
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
}
