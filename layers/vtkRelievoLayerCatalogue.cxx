// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerCatalogue.h"

#include "vtkType.h"

#include <algorithm>
#include <limits>

namespace
{
using L = vtkRelievoLayer;

constexpr double Infinity = std::numeric_limits<double>::infinity();

std::vector<L> MakeTable()
{
  return {
    { "depth", L::DISTANCE, L::FROM_DEPTH, VTK_FLOAT, 1, Infinity, "Z", false,
      "distance along the view direction, world units" },
    { "range", L::DISTANCE, L::FROM_DEPTH, VTK_FLOAT, 1, Infinity, "Z", false,
      "distance from the eye, world units" },
    { "normal", L::VECTOR, L::FROM_NORMAL, VTK_FLOAT, 3, 0.0, "X,Y,Z", false,
      "unit normal as it is lit, world space" },
    { "geometric_normal", L::VECTOR, L::FROM_GEOMETRIC_NORMAL, VTK_FLOAT, 3, 0.0, "X,Y,Z", false,
      "unit normal of the triangle, world space" },
    { "position", L::POSITION, L::FROM_DEPTH, VTK_DOUBLE, 3, 0.0, "X,Y,Z", false,
      "place in the world" },
    { "albedo", L::COLOR, L::FROM_ALBEDO, VTK_UNSIGNED_CHAR, 4, 0.0, "R,G,B,A", false,
      "surface colour before light" },
    { "actor", L::ID, L::FROM_ID, VTK_INT, 1, -1.0, "id", false, "actor, from 0" },
    { "block", L::ID, L::FROM_ID, VTK_INT, 1, -1.0, "id", false,
      "flat index of the block; 0 in data that is not composite" },
    { "cell", L::ID, L::FROM_ID, VTK_INT, 1, -1.0, "id", false, "cell of the mesh, from 0" },
    { "color", L::COLOR, L::FROM_PICTURE, VTK_FLOAT, 4, 0.0, "R,G,B,A", false,
      "the picture, scene-linear and premultiplied" },
    { "shadow_", L::SHARE, L::FROM_SHADOW, VTK_FLOAT, 1, 1.0, "V", true,
      "what is not blocked of a light: 1 lit, 0 dark" },
  };
}
}

//------------------------------------------------------------------------------
const std::vector<vtkRelievoLayer>& vtkRelievoLayerCatalogue::GetAll()
{
  static const std::vector<L> table = MakeTable();
  return table;
}

//------------------------------------------------------------------------------
const vtkRelievoLayer& vtkRelievoLayerCatalogue::GetOfLight()
{
  const std::vector<L>& all = GetAll();
  return *std::find_if(all.begin(), all.end(), [](const L& layer) { return layer.OfLight; });
}

//------------------------------------------------------------------------------
const vtkRelievoLayer& vtkRelievoLayerCatalogue::Find(const std::string& name)
{
  static const L array;
  for (const L& layer : GetAll())
  {
    if (layer.OfLight ? GetLight(name) >= 0 : layer.Name == name)
    {
      return layer;
    }
  }
  return array;
}

//------------------------------------------------------------------------------
int vtkRelievoLayerCatalogue::GetLight(const std::string& name)
{
  const std::string& prefix = GetOfLight().Name;
  const std::string word =
    name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : std::string();
  const bool isNumber = !word.empty() && word.size() < 4 &&
    std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  return isNumber ? std::stoi(word) : -1;
}
