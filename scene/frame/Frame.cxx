// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame.h"

#include "Fog.h"
#include "Lamps.h"
#include "Markers.h"
#include "Options.h"
#include "Points.h"
#include "Readers.h"
#include "Shadows.h"
#include "Surface.h"

#include "vtkRelievoLampsStage.h"
#include "vtkRelievoMarkersStage.h"
#include "vtkRelievoPass.h"

#include <algorithm>

namespace scene
{
//------------------------------------------------------------------------------
std::vector<std::string> CheckInputs(const RenderOptions& options)
{
  for (const std::string& path : options.Files)
  {
    CheckExtension(path);
    CheckReadable(path);
  }
  CheckSurface(options);
  std::vector<std::string> inputs = options.Files;
  for (const LampChoice& choice : options.Lamps)
  {
    CheckPointFile("--lamps", choice.File);
    inputs.push_back(choice.File);
  }
  for (const FogChoice& choice : options.Fogs)
  {
    CheckPointFile("--fog", choice.File);
    inputs.push_back(choice.File);
  }
  for (const MarkerChoice& choice : options.Markers)
  {
    CheckPointFile("--markers", choice.File);
    inputs.push_back(choice.File);
  }
  inputs.insert(inputs.end(), { options.NormalMap, options.HeightMap, options.Environment });
  inputs.erase(std::remove(inputs.begin(), inputs.end(), std::string()), inputs.end());
  return inputs;
}

//------------------------------------------------------------------------------
FramePoints ReadFramePoints(const RenderOptions& options, Progress& progress)
{
  FramePoints points;
  points.Lamps = ReadLamps(options.Lamps, progress);
  points.Fogs = ReadFogs(options.Fogs, progress);
  points.Markers = ReadMarkers(options.Markers, options.UpAxis, progress);
  return points;
}

//------------------------------------------------------------------------------
bool NeedsFrame(const RenderOptions& options)
{
  return options.ShadowMethod != Shadows::Off || !options.Stages.empty() ||
    !options.Lamps.empty() || !options.Fogs.empty() || !options.Markers.empty();
}

//------------------------------------------------------------------------------
void SetFrame(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options,
  const FramePoints& points)
{
  SetShadows(pass, renderer, options);
  SetStages(pass, options.Stages);
  AddFramePoints(pass, options, points);
}

//------------------------------------------------------------------------------
void AddFramePoints(vtkRelievoPass* pass, const RenderOptions& options, const FramePoints& points)
{
  for (vtkRelievoLamps* each : points.Lamps)
  {
    vtkRelievoLampsStage::SafeDownCast(pass->GetStage("lamps"))->AddPoints(each);
  }
  AddFogs(pass, options.Fogs, points.Fogs);
  for (vtkRelievoMarkers* each : points.Markers)
  {
    pass->GetMarkersStage()->AddPoints(each);
  }
}
}
