// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fog.h"

#include "Messages.h"
#include "Points.h"

#include "vtkRelievoFogSpheres.h"
#include "vtkRelievoFogStage.h"
#include "vtkRelievoPass.h"

namespace scene
{
namespace
{
// Which values neither the file nor the command line gives, and what they are.
std::string ListDefaults(const PointFile& file, const FogChoice& choice)
{
  std::string defaults;
  const auto look = [&](const char* name, const PointValue& given) {
    if (!given.Number && given.Array.empty() && !file.Has(name))
    {
      defaults += std::string(defaults.empty() ? "" : " and ") + name + " 1";
    }
  };
  look("radius", choice.Radius);
  look("density", choice.Density);
  return defaults;
}
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRelievoFogSpheres>> ReadFogs(
  const std::vector<FogChoice>& choices, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoFogSpheres>> fogs;
  for (const FogChoice& choice : choices)
  {
    const PointFile file("--fog", choice.File, progress);
    auto fog = vtkSmartPointer<vtkRelievoFogSpheres>::New();
    fog->SetInputData(file.GetData());
    file.Take(fog.Get(), "radius", choice.Radius, &vtkRelievoFogSpheres::SetRadius);
    file.Take(fog.Get(), "density", choice.Density, &vtkRelievoFogSpheres::SetDensity);
    file.TakeColor(fog.Get(), choice.Color);
    file.Check(fog, "fog", "places must be finite, radii and densities above 0");
    const std::string defaults = ListDefaults(file, choice);
    if (!defaults.empty())
    {
      Messages::Note(choice.File + ": its fog has " + defaults + ", for it has no such array");
    }
    fogs.push_back(fog);
  }
  return fogs;
}

//------------------------------------------------------------------------------
void AddFogs(vtkRelievoPass* pass, const std::vector<FogChoice>& choices,
  const std::vector<vtkSmartPointer<vtkRelievoFogSpheres>>& fogs)
{
  vtkRelievoFogStage* stage = pass->GetFogStage();
  for (vtkRelievoFogSpheres* fog : fogs)
  {
    stage->AddPoints(fog);
  }
  for (const FogChoice& choice : choices) // also where the fog itself comes later, as in the viewer
  {
    if (!choice.Mode.empty())
    {
      stage->SetParameter("mode", choice.Mode);
    }
  }
}
}
