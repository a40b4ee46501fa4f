// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lamps.h"

#include "Failure.h"
#include "Messages.h"
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
    if (choice.Radius.Number)
    {
      lamps->SetRadius(*choice.Radius.Number);
    }
    if (choice.Intensity.Number)
    {
      lamps->SetIntensity(*choice.Intensity.Number);
    }
    if (choice.Color)
    {
      lamps->SetColor(choice.Color->data());
    }
    // One number for all comes before an array that the file has.
    const auto takes = [&lamps](const char* value, const std::string& array, bool forAll) {
      if (forAll || !array.empty())
      {
        lamps->SetArray(value, array);
      }
    };
    takes("radius", choice.Radius.Array, choice.Radius.Number.has_value());
    takes("intensity", choice.Intensity.Array, choice.Intensity.Number.has_value());
    takes("color", choice.ColorArray, choice.Color.has_value());
    constexpr int kinds[] = { vtkRelievoLamps::LINEAR, vtkRelievoLamps::INVERSE_SQUARE,
      vtkRelievoLamps::VTK };
    lamps->SetFalloff(kinds[static_cast<int>(choice.Kind)]);
    if (choice.Attenuation)
    {
      lamps->SetAttenuationValues(choice.Attenuation->data());
    }
    const int count = lamps->GetNumberOfPoints();
    Messages::Check(choice.File);
    if (count == 0)
    {
      throw WorkError(choice.File +
        ": holds no points that are lamps: expected finite places, radii above 0 and intensities "
        "other than 0");
    }
    all.push_back(lamps);
  }
  return all;
}
}
