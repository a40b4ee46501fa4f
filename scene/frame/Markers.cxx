// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Markers.h"

#include "Messages.h"
#include "Points.h"

#include "vtkRelievoMarkers.h"

namespace scene
{
//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRelievoMarkers>> ReadMarkers(
  const std::vector<MarkerChoice>& choices, int upAxis, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoMarkers>> all;
  for (const MarkerChoice& choice : choices)
  {
    const PointFile file("--markers", choice.File, progress);
    auto markers = vtkSmartPointer<vtkRelievoMarkers>::New();
    markers->SetInputData(file.GetData());
    markers->SetShape(choice.Shape);
    file.Take(markers.Get(), "radius", choice.Radius, &vtkRelievoMarkers::SetRadius);
    file.Take(markers.Get(), "width", choice.Width, &vtkRelievoMarkers::SetWidth);
    file.Take(markers.Get(), "reach", choice.Reach, &vtkRelievoMarkers::SetReach);
    file.Take(markers.Get(), "opacity", choice.Opacity, &vtkRelievoMarkers::SetOpacity);
    file.TakeColor(markers.Get(), choice.Color);
    markers->SetUp(upAxis == 0, upAxis == 1, upAxis == 2);
    if (choice.Up)
    {
      markers->SetUp(choice.Up->data());
    }
    file.Check(markers, "markers",
      "places must be finite, radii, opacities, widths of rings and reaches of shadows above 0");
    if (!choice.Radius.Number && choice.Radius.Array.empty() && !file.Has("radius"))
    {
      Messages::Note(choice.File + ": its markers have radius 1, for it has no array 'radius'");
    }
    all.push_back(markers);
  }
  return all;
}
}
