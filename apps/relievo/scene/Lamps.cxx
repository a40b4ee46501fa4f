// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps.h"

#include "Points.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkRelievoLamps.h"

namespace cli
{
//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRelievoLamps>> ReadLamps(
  const std::vector<LampChoice>& choices, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoLamps>> all;
  for (const LampChoice& choice : choices)
  {
    vtkSmartPointer<vtkDataObject> points = ReadData(choice.File, progress);
    auto lamps = vtkSmartPointer<vtkRelievoLamps>::New();
    lamps->SetInputData(points);
    const auto check = [&](const char* what, const std::string& name) {
      CheckArray("--lamps", choice.File, points, what, name);
    };
    check("radius", choice.Radius.Array);
    check("intensity", choice.Intensity.Array);
    check("color", choice.Color.Array);
    check("casts", choice.Casts.Array);
    TakeValue(lamps.Get(), "radius", choice.Radius, &vtkRelievoLamps::SetRadius);
    TakeValue(lamps.Get(), "intensity", choice.Intensity, &vtkRelievoLamps::SetIntensity);
    TakeColor(lamps.Get(), choice.Color);
    constexpr int kinds[] = { vtkRelievoLamps::LINEAR, vtkRelievoLamps::INVERSE_SQUARE,
      vtkRelievoLamps::VTK };
    lamps->SetFalloff(kinds[static_cast<int>(choice.Kind)]);
    if (choice.Attenuation)
    {
      lamps->SetAttenuationValues(choice.Attenuation->data());
    }
    if (choice.Casts.Number)
    {
      lamps->SetCasts(static_cast<int>(*choice.Casts.Number));
    }
    if (choice.Casts.Number || !choice.Casts.Array.empty())
    {
      lamps->SetArray("casts", choice.Casts.Array);
    }
    CheckPoints(lamps, choice.File, "lamps",
      "places must be finite, radii above 0 and intensities other than 0");
    all.push_back(lamps);
  }
  return all;
}
}
