// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Markers.h"

#include "DataSets.h"
#include "Messages.h"
#include "Points.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkRelievoMarkers.h"

namespace cli
{
namespace
{
bool HasArray(vtkDataObject* data, const char* name)
{
  bool found = false;
  ForEachDataSet(data,
    [&](vtkDataSet* part) { found = found || part->GetPointData()->GetArray(name) != nullptr; });
  return found;
}
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRelievoMarkers>> ReadMarkers(
  const std::vector<MarkerChoice>& choices, int upAxis, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoMarkers>> all;
  for (const MarkerChoice& choice : choices)
  {
    const vtkSmartPointer<vtkDataObject> data = ReadData(choice.File, progress);
    auto markers = vtkSmartPointer<vtkRelievoMarkers>::New();
    markers->SetInputData(data);
    markers->SetShape(choice.Shape);
    const auto check = [&](const char* what, const std::string& name) {
      CheckArray("--markers", choice.File, data, what, name);
    };
    check("radius", choice.Radius.Array);
    check("width", choice.Width.Array);
    check("reach", choice.Reach.Array);
    check("opacity", choice.Opacity.Array);
    check("color", choice.Color.Array);
    TakeValue(markers.Get(), "radius", choice.Radius, &vtkRelievoMarkers::SetRadius);
    TakeValue(markers.Get(), "width", choice.Width, &vtkRelievoMarkers::SetWidth);
    TakeValue(markers.Get(), "reach", choice.Reach, &vtkRelievoMarkers::SetReach);
    TakeValue(markers.Get(), "opacity", choice.Opacity, &vtkRelievoMarkers::SetOpacity);
    TakeColor(markers.Get(), choice.Color);
    markers->SetUp(upAxis == 0, upAxis == 1, upAxis == 2);
    if (choice.Up)
    {
      markers->SetUp(choice.Up->data());
    }
    CheckPoints(markers, choice.File, "markers",
      "places must be finite, radii, opacities, widths of rings and reaches of shadows above 0");
    if (!choice.Radius.Number && choice.Radius.Array.empty() && !HasArray(data, "radius"))
    {
      Messages::Note(choice.File + ": its markers have radius 1, for it has no array 'radius'");
    }
    all.push_back(markers);
  }
  return all;
}
}
