// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fog.h"

#include "DataSets.h"
#include "Messages.h"
#include "Points.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkRelievoFogSpheres.h"
#include "vtkRelievoFogStage.h"
#include "vtkRelievoPass.h"

namespace cli
{
namespace
{
// Which values neither the file nor the command line gives, and what they are.
std::string ListDefaults(vtkDataObject* data, const FogChoice& choice)
{
  std::string defaults;
  const auto look = [&](const char* name, const PointValue& given) {
    bool found = given.Number || !given.Array.empty();
    ForEachDataSet(data,
      [&](vtkDataSet* part) { found = found || part->GetPointData()->GetArray(name) != nullptr; });
    if (!found)
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
    const vtkSmartPointer<vtkDataObject> data = ReadData(choice.File, progress);
    auto fog = vtkSmartPointer<vtkRelievoFogSpheres>::New();
    fog->SetInputData(data);
    const auto check = [&](const char* what, const std::string& name) {
      CheckArray("--fog", choice.File, data, what, name);
    };
    check("radius", choice.Radius.Array);
    check("density", choice.Density.Array);
    check("color", choice.Color.Array);
    TakeValue(fog.Get(), "radius", choice.Radius, &vtkRelievoFogSpheres::SetRadius);
    TakeValue(fog.Get(), "density", choice.Density, &vtkRelievoFogSpheres::SetDensity);
    TakeColor(fog.Get(), choice.Color);
    CheckPoints(fog, choice.File, "fog", "places must be finite, radii and densities above 0");
    const std::string defaults = ListDefaults(data, choice);
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
  vtkRelievoFogStage* stage = pass->GetFog();
  for (vtkRelievoFogSpheres* fog : fogs)
  {
    stage->AddFog(fog);
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
