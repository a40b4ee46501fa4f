// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormaps.h"

#include "Errors.h"
#include "LookOptions.h"
#include "Values.h"

#include "vtkColorTransferFunction.h"
#include "vtkRelievoColormaps.h"

#include <algorithm>
#include <utility>

namespace scene
{
namespace
{
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
  return vtkRelievoColormaps::GetNames();
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
  vtkRelievoColormaps::Fill(map, name, from, to);
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
