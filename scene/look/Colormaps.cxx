// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormaps.h"

#include "vtkColorTransferFunction.h"
#include "vtkRelievoFormulas.h"

namespace scene
{
namespace
{
constexpr int Steps = 64; // of maps that a formula gives

using Map = vtkColorTransferFunction;

struct Row
{
  const char* Name;
  void (*Fill)(Map* map, double low, double high);
};

const Row Rows[] = {
  // Evenly lighter, also for the colour-blind: S. van der Walt, N. Smith, 2015.
  { "viridis",
    [](Map* map, double low, double high) {
      for (int i = 0; i <= Steps; ++i)
      {
        const double share = double(i) / Steps;
        const glm::dvec3 color = relievo::f64::relievoColormap(share);
        map->AddRGBPoint(low + share * (high - low), color.x, color.y, color.z);
      }
    } },
  // Diverging from the middle: K. Moreland, Diverging Color Maps for Scientific Visualization,
  // 2009.
  { "cool-warm",
    [](Map* map, double low, double high) {
      map->SetColorSpaceToDiverging();
      map->AddRGBPoint(low, 0.230, 0.299, 0.754);
      map->AddRGBPoint(high, 0.706, 0.016, 0.150);
    } },
  { "grey",
    [](Map* map, double low, double high) {
      map->AddRGBPoint(low, 0.0, 0.0, 0.0);
      map->AddRGBPoint(high, 1.0, 1.0, 1.0);
    } },
  // Black over red and yellow to white, as a body that is heated.
  { "hot",
    [](Map* map, double low, double high) {
      const double width = high - low;
      map->AddRGBPoint(low, 0.0, 0.0, 0.0);
      map->AddRGBPoint(low + 0.4 * width, 0.9, 0.0, 0.0);
      map->AddRGBPoint(low + 0.8 * width, 0.9, 0.9, 0.0);
      map->AddRGBPoint(high, 1.0, 1.0, 1.0);
    } },
  // Blue to red by hue, as older pictures have it.
  { "rainbow",
    [](Map* map, double low, double high) {
      map->SetColorSpaceToHSV();
      map->HSVWrapOff();
      map->AddHSVPoint(low, 2.0 / 3.0, 1.0, 1.0);
      map->AddHSVPoint(high, 0.0, 1.0, 1.0);
    } },
};
}

//------------------------------------------------------------------------------
std::vector<std::string> GetColormapNames()
{
  std::vector<std::string> names;
  for (const Row& row : Rows)
  {
    names.emplace_back(row.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& name, const std::array<double, 2>& range)
{
  auto map = vtkSmartPointer<vtkColorTransferFunction>::New();
  map->SetNanColor(0.5, 0.5, 0.5);
  const double high = range[1] > range[0] ? range[1] : range[0] + 1.0;
  for (const Row& row : Rows)
  {
    if (name == row.Name)
    {
      row.Fill(map, range[0], high);
    }
  }
  map->Build();
  return map;
}
}
