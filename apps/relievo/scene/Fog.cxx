// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fog.h"

#include "DataSets.h"
#include "Failure.h"
#include "Messages.h"
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
void CheckFogFiles(const std::vector<FogChoice>& choices)
{
  for (const FogChoice& choice : choices)
  {
    CheckExtension(choice.File);
    if (IsGLTF(choice.File))
    {
      throw WordsError("--fog: " + choice.File + " is a scene; expected a file of points");
    }
    CheckReadable(choice.File);
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
    if (choice.Radius.Number)
    {
      fog->SetRadius(*choice.Radius.Number);
    }
    if (choice.Density.Number)
    {
      fog->SetDensity(*choice.Density.Number);
    }
    if (choice.Color)
    {
      fog->SetColor(choice.Color->data());
    }
    // One value for all comes before an array that the file has.
    const auto takes = [&fog](const char* value, const std::string& array, bool forAll) {
      if (forAll || !array.empty())
      {
        fog->SetArray(value, array);
      }
    };
    takes("radius", choice.Radius.Array, choice.Radius.Number.has_value());
    takes("density", choice.Density.Array, choice.Density.Number.has_value());
    takes("color", choice.ColorArray, choice.Color.has_value());
    const int spheres = fog->GetNumberOfPoints();
    const int leftOut = fog->GetNumberLeftOut();
    Messages::Check(choice.File, spheres == 0,
      leftOut == 0 ? "holds no points, expected one for each sphere of fog"
                   : "holds no fog: places, radii and densities must be finite, radii and "
                     "densities above 0");
    if (leftOut > 0)
    {
      Messages::Note(choice.File + ": left out " + std::to_string(leftOut) + " of " +
        std::to_string(spheres + leftOut) +
        " spheres of fog, which are not finite or have a radius or density of 0 or less");
    }
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
  for (std::size_t i = 0; i < fogs.size(); ++i)
  {
    stage->AddFog(fogs[i]);
    if (!choices[i].Mode.empty())
    {
      stage->SetParameter("mode", choices[i].Mode);
    }
  }
}
}
