// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame.h"

#include "CameraPath.h"
#include "Options.h"
#include "Readers.h"
#include "ShadowOptions.h"
#include "Shadows.h"
#include "Surface.h"

#include "vtkRelievoCalibration.h"

#include <algorithm>

namespace scene
{
//------------------------------------------------------------------------------
std::vector<std::string> GetInputs(const RenderOptions& options)
{
  std::vector<std::string> inputs = options.Files;
  for (const PointsChoice& choice : options.Points)
  {
    inputs.push_back(choice.File);
  }
  inputs.push_back(options.Motion.Path);
  if (vtkRelievoCalibration::IsFile(options.Lens))
  {
    inputs.push_back(options.Lens);
  }
  inputs.insert(inputs.end(),
    { options.Surface.NormalMap, options.Surface.HeightMap, options.Surface.Environment });
  inputs.erase(std::remove(inputs.begin(), inputs.end(), std::string()), inputs.end());
  return inputs;
}

//------------------------------------------------------------------------------
std::vector<std::string> CheckInputs(const RenderOptions& options)
{
  for (const std::string& folder : options.AllowedFolders)
  {
    CheckFolder(folder);
  }
  for (const std::string& path : options.Files)
  {
    CheckExtension(path);
    CheckReadable(path);
  }
  CheckSurface(options.Surface);
  for (const PointsChoice& choice : options.Points)
  {
    CheckPointFile(choice);
  }
  if (!options.Motion.Path.empty())
  {
    CheckReadable(options.Motion.Path);
    CameraPath::Read(options.Motion.Path); // before the long work
  }
  if (vtkRelievoCalibration::IsFile(options.Lens))
  {
    CheckReadable(options.Lens);
  }
  return GetInputs(options);
}

//------------------------------------------------------------------------------
bool NeedsFrame(const RenderOptions& options)
{
  // --shadows off alone needs none.
  return ShowsShadows(options) || !options.Points.empty() ||
    std::any_of(options.Stages.begin(), options.Stages.end(),
      [](const StageChoice& choice) { return !IsOfSwitch(choice); });
}

//------------------------------------------------------------------------------
void SetFrame(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options,
  const FramePoints& points)
{
  SetShadows(pass, renderer, options);
  SetStages(pass, options.Stages);
  AddFramePoints(pass, points);
}
}
