// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lights.h"

#include "Errors.h"
#include "LightOptions.h"
#include "Messages.h"
#include "Numbers.h"
#include "OptionRows.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkRelievoFillLight.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoNullLight.h"
#include "vtkRenderer.h"

#include <cmath>
#include <string>

namespace look
{
namespace
{
// Explains why a sun by date gives no light.
void NoteNight(const LightChoice& light)
{
  const double below = -GetSunAngles(*light.Time).Elevation;
  Messages::Note("--light sun:" + WriteSunTime(*light.Time) + ": night: the sun is " +
    WriteNumber(std::round(10.0 * below) / 10.0) + " degrees below the horizon");
}
}

//------------------------------------------------------------------------------
void AddLights(
  vtkRenderer* renderer, const std::vector<LightChoice>& lights, int up, bool environment)
{
  if (lights.empty())
  {
    if (environment && renderer->GetLights()->GetNumberOfItems() == 0)
    {
      vtkRelievoNullLight().Place(renderer, true); // light comes from the environment
    }
    return; // the file's lights, or the headlight that VTK makes
  }
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  for (const LightChoice& choice : lights)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(
      (choice.Is == LightChoice::Kind::Sun ? choice.GetDirection(up) : choice.Position).data());
    light->SetPositional(choice.Is != LightChoice::Kind::Sun);
    light->SetConeAngle(choice.ConeAngle);
    if (choice.Is == LightChoice::Kind::Spot)
    {
      light->SetFocalPoint(choice.FocalPoint.data());
    }
    else if (choice.Is == LightChoice::Kind::Point)
    {
      // A point light shines in all directions, but VTK needs a focal point away from its position.
      light->SetFocalPoint(choice.Position[0], choice.Position[1] - 1.0, choice.Position[2]);
    }
    else
    {
      light->SetFocalPoint(0.0, 0.0, 0.0);
    }
    light->SetColor(choice.Color[0], choice.Color[1], choice.Color[2]);
    light->SetIntensity(choice.IsNight() ? 0.0 : choice.Intensity);
    if (choice.Fills)
    {
      vtkRelievoFillLight::Make(light);
    }
    renderer->AddLight(light);
    if (choice.IsNight())
    {
      NoteNight(choice);
    }
  }
}

//------------------------------------------------------------------------------
// Checked before the first draw, also where no frame does so.
void CheckLights(vtkRenderer* renderer, const std::vector<LightChoice>& lights)
{
  const std::string error = vtkRelievoFramePass::CheckLights(renderer);
  if (!error.empty() && !lights.empty())
  {
    throw UsageError("--light: " + error + " Give them as points with --lamps FILE");
  }
  if (!error.empty())
  {
    throw WorkError("the files' lights: " + error + " Give --light, or points with --lamps FILE");
  }
}

//------------------------------------------------------------------------------
void AddLightOption(OptionRows& rows, std::vector<LightChoice>& lights)
{
  static const std::string help = DescribeLights(); // words are parsed often
  vtkRelievoOption& light =
    rows
      .Add("--light", "LIGHT", help,
        [&lights](const std::string& word) { lights.push_back(ParseLight(word)); })
      .NamedIn("Light", "Lights");
  light.Repeats = true;
  light.Words = { "sun:", "spot:", "point:" };
}
}
