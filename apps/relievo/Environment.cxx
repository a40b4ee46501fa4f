// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "Failure.h"
#include "Images.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentIrradiance.h"
#include "vtkRelievoEnvironmentPrefilter.h"
#include "vtkRelievoSkybox.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

namespace cli
{
namespace
{
// Texels across a face of the sharpest of the levels for rough mirrors, and what their sums may err
// by: a second's work.
constexpr int LevelSize = 128;
constexpr double LevelTolerance = 2e-3;

//------------------------------------------------------------------------------
void CheckShape(vtkImageData* image, const std::string& path)
{
  const int* size = image->GetDimensions();
  if (size[0] != 2 * size[1] && size[0] != size[1])
  {
    throw WorkError(path + ": is " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " pixels, expected twice as wide as high (all directions: equirectangular) or square (a "
      "mirror ball: a sphere map)");
  }
}
}

//------------------------------------------------------------------------------
void CheckEnvironment(const RenderOptions& options)
{
  if (!options.Environment.empty())
  {
    CheckImage("--environment", options.Environment, { ".exr", ".hdr", ".png", ".jpg", ".jpeg" });
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
  CheckShape(image, options.Environment);
  const int type = image->GetScalarType();
  const bool sRGB = type != VTK_FLOAT && type != VTK_DOUBLE;

  auto environment = vtkSmartPointer<vtkRelievoEnvironment>::New();
  environment->SetImage(image);
  environment->SetSRGB(sRGB);
  environment->SetRotation(options.EnvironmentRotation);
  environment->SetUpAxis(options.UpAxis);
  environment->GammaCorrectOn(); // pictures are for displays: the sky's are to look as they did

  progress.Begin("preparing " + options.Environment);
  vtkNew<vtkRelievoEnvironmentIrradiance> irradiance;
  irradiance->SetInputData(image);
  irradiance->SetInputSRGB(sRGB);
  irradiance->Update();
  environment->SetIrradiance(
    vtkDataArray::SafeDownCast(irradiance->GetOutput()->GetColumnByName("radiance")));
  if (options.Roughness > 0.0)
  {
    vtkNew<vtkRelievoEnvironmentPrefilter> levels;
    levels->SetInputData(image);
    levels->SetInputSRGB(sRGB);
    levels->SetSize(LevelSize);
    levels->SetTolerance(LevelTolerance);
    progress.Observe(levels);
    levels->Update();
    environment->SetLevels(levels->GetOutput());
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
  // Rays that are parallel would all see one place of it.
  sky->SetParallelViewAngle(renderer->GetActiveCamera()->GetViewAngle());
  renderer->AddViewProp(sky);
}
}
