// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps.h"

#include "Points.h"

#include "vtkRelievoLamps.h"

namespace scene
{
//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRelievoLamps>> ReadLamps(
  const std::vector<LampChoice>& choices, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoLamps>> all;
  for (const LampChoice& choice : choices)
  {
    const PointFile file("--lamps", choice.File, progress);
    auto lamps = vtkSmartPointer<vtkRelievoLamps>::New();
    lamps->SetInputData(file.GetData());
    file.Take(lamps.Get(), "radius", choice.Radius, &vtkRelievoLamps::SetRadius);
    file.Take(lamps.Get(), "intensity", choice.Intensity, &vtkRelievoLamps::SetIntensity);
    file.Take(lamps.Get(), "casts", choice.Casts, &vtkRelievoLamps::SetCasts);
    file.TakeColor(lamps.Get(), choice.Color);
    constexpr int kinds[] = { vtkRelievoLamps::LINEAR, vtkRelievoLamps::INVERSE_SQUARE,
      vtkRelievoLamps::VTK };
    lamps->SetFalloff(kinds[static_cast<int>(choice.Kind)]);
    if (choice.Attenuation)
    {
      lamps->SetAttenuationValues(choice.Attenuation->data());
    }
    file.Check(lamps, "lamps", "places must be finite, radii above 0 and intensities other than 0");
    all.push_back(lamps);
  }
  return all;
}
}
