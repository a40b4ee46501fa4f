// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColormaps.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkRelievoFormulas.h"

namespace
{
constexpr int FormulaSteps = 64; // of maps defined by a formula

using Map = vtkColorTransferFunction;

struct NamedMap
{
  const char* Name;
  void (*Fill)(Map* map, double low, double high);
};

const NamedMap NamedMaps[] = {
  // Perceptually uniform, also for colour-blind readers: S. van der Walt, N. Smith, 2015.
  { "viridis",
    [](Map* map, double low, double high) {
      for (int i = 0; i <= FormulaSteps; ++i)
      {
        const double share = double(i) / FormulaSteps;
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
  // Black, red, yellow, white: the colours of a heated body.
  { "hot",
    [](Map* map, double low, double high) {
      const double width = high - low;
      map->AddRGBPoint(low, 0.0, 0.0, 0.0);
      map->AddRGBPoint(low + 0.4 * width, 0.9, 0.0, 0.0);
      map->AddRGBPoint(low + 0.8 * width, 0.9, 0.9, 0.0);
      map->AddRGBPoint(high, 1.0, 1.0, 1.0);
    } },
  // Blue to red by hue, the older default of many tools.
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
const std::vector<std::string>& vtkRelievoColormaps::GetNames()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const NamedMap& each : NamedMaps)
    {
      all.emplace_back(each.Name);
    }
    return all;
  }();
  return names;
}

//------------------------------------------------------------------------------
void vtkRelievoColormaps::Fill(
  vtkColorTransferFunction* map, const std::string& name, double low, double high)
{
  for (const NamedMap& each : NamedMaps)
  {
    if (name == each.Name)
    {
      each.Fill(map, low, high);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::array<float, 3>> vtkRelievoColormaps::Sample(
  const std::string& name, bool reversed, int count)
{
  vtkNew<vtkColorTransferFunction> map;
  vtkRelievoColormaps::Fill(map, name, reversed ? 1.0 : 0.0, reversed ? 0.0 : 1.0);
  std::vector<std::array<float, 3>> colors(static_cast<std::size_t>(count));
  map->GetTable(0.0, 1.0, count, colors[0].data());
  return colors;
}
