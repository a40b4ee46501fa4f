// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormaps.h"

#include "Errors.h"
#include "LookOptions.h"
#include "Values.h"

#include "vtkColorTransferFunction.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <utility>

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

// Without what says that it is reversed.
std::string GetMap(const std::string& word)
{
  const std::string end = ReversedColormap;
  const bool reversed =
    word.size() > end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
  return reversed ? word.substr(0, word.size() - end.size()) : word;
}

// None for a name.
std::vector<std::string> SplitColors(const std::string& map)
{
  return map.find(',') == std::string::npos ? std::vector<std::string>() : Split(map, ',');
}
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
void CheckColormap(const std::string& word)
{
  const std::string map = GetMap(word);
  const std::vector<std::string> names = GetColormapNames();
  if (map.find(',') == std::string::npos &&
    std::find(names.begin(), names.end(), map) == names.end())
  {
    RefuseValue("--colormap", word,
      "one of " + Join(names, ", ") + ", or colours between commas, such as black,#ff8000,white");
  }
  for (const std::string& color : SplitColors(map))
  {
    ParseColor("--colormap", color);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> MakeColormap(
  const std::string& word, const std::array<double, 2>& range)
{
  auto map = vtkSmartPointer<vtkColorTransferFunction>::New();
  map->SetNanColor(0.5, 0.5, 0.5);
  const std::string name = GetMap(word);
  double from = range[0];
  double to = range[1] > range[0] ? range[1] : range[0] + 1.0;
  if (name != word)
  {
    std::swap(from, to);
  }
  for (const Row& row : Rows)
  {
    if (name == row.Name)
    {
      row.Fill(map, from, to);
    }
  }
  const std::vector<std::string> colors = SplitColors(name);
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(colors.size() - 1);
    const Color color = ParseColor("--colormap", colors[i]);
    map->AddRGBPoint(from + share * (to - from), color[0], color[1], color[2]);
  }
  map->Build();
  return map;
}
}
