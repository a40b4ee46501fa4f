// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerCatalogue.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoFormulas.h"
#include "vtkType.h"

#include <algorithm>
#include <cctype>
#include <limits>

vtkStandardNewMacro(vtkRelievoLayerCatalogue);

namespace
{
using L = vtkRelievoLayer;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double OfRenderer = std::numeric_limits<double>::quiet_NaN();
constexpr double None = std::numeric_limits<double>::quiet_NaN();

void GetRange(const double point[3], double* range)
{
  *range = relievo::f64::relievoRange(glm::dvec3(point[0], point[1], point[2]));
}

void GetPlace(const double point[3], double* place)
{
  std::copy(point, point + 3, place);
}

std::vector<L> MakeTable()
{
  std::vector<L> table = {
    { "depth", L::NUMBER, L::FROM_DEPTH, VTK_FLOAT, 1, Infinity, "Z",
      "distance along the view direction, world units", "DEPTH" },
    { "range", L::NUMBER, L::FROM_DEPTH, VTK_FLOAT, 1, Infinity, "Z",
      "distance from the eye, world units", "RANGE", L::VIEW, GetRange },
    { "normal", L::VECTOR, L::FROM_NORMAL, VTK_FLOAT, 3, 0.0, "X,Y,Z",
      "unit shading normal, world space", "NORMAL" },
    { "geometric_normal", L::VECTOR, L::FROM_GEOMETRIC_NORMAL, VTK_FLOAT, 3, 0.0, "X,Y,Z",
      "unit normal of the triangle, world space", "GEOMETRIC_NORMAL" },
    { "position", L::POSITION, L::FROM_DEPTH, VTK_DOUBLE, 3, 0.0, "X,Y,Z", "position in the world",
      "", L::WORLD, GetPlace },
    { "albedo", L::COLOR, L::FROM_ALBEDO, VTK_UNSIGNED_CHAR, 4, 0.0, "R,G,B,A",
      "surface colour before lighting", "ALBEDO" },
    { "actor", L::ID, L::FROM_ID, VTK_INT, 1, -1.0, "id", "index of the actor, from 0" },
    { "block", L::ID, L::FROM_ID, VTK_INT, 1, -1.0, "id",
      "flat index of the block, 0 in data that is not composite" },
    { "cell", L::ID, L::FROM_ID, VTK_INT, 1, -1.0, "id", "index of the cell in its mesh, from 0" },
    { "light", L::COLOR, L::FROM_STAGE, VTK_FLOAT, 3, 0.0, "R,G,B",
      "light of lamps, before the surface's colour" },
    { "light_depth", L::NUMBER, L::FROM_STAGE, VTK_FLOAT, 1, Infinity, "Z",
      "depth in a light's shadow map: distance along the light's axis, world units" },
    { "lamp_evaluations", L::NUMBER, L::FROM_STAGE, VTK_FLOAT, 1, 0.0, "V",
      "number of lamps computed for the pixel" },
    { "lamps_reaching", L::NUMBER, L::FROM_STAGE, VTK_FLOAT, 1, 0.0, "V",
      "number of lamps that reach the pixel's surface" },
    { "blend", L::COLOR, L::FROM_STAGE, VTK_FLOAT, 4, 0.0, "R,G,B,A",
      "translucent surfaces, scene-linear and premultiplied" },
    { "color", L::COLOR, L::FROM_PICTURE, VTK_FLOAT, 4, OfRenderer, "R,G,B,A",
      "the picture, scene-linear and premultiplied" },
  };
  table.push_back({ "fog", L::SHARE, L::FROM_STAGE, VTK_FLOAT, 1, 1.0, "V",
    "transmittance of fog: 1 all, 0 nothing" });
  table.push_back({ "ambient", L::SHARE, L::FROM_STAGE, VTK_FLOAT, 1, 1.0, "V",
    "visible share of the sky at the surface: 1 all, 0 nothing" });
  table.push_back({ "marker", L::SHARE, L::FROM_STAGE, VTK_FLOAT, 1, 0.0, "V",
    "cover of the surface by markers: 0 nothing, 1 all" });
  table.push_back({ "volume_depth", L::NUMBER, L::FROM_STAGE, VTK_FLOAT, 1, Infinity, "Z",
    "depth of a volume by the rule of the stage volumes, world units", "VOLUME_DEPTH" });
  table.push_back({ "volume_position", L::POSITION, L::FROM_STAGE, VTK_DOUBLE, 3, 0.0, "X,Y,Z",
    "position in the world at the depth of a volume" });
  table.push_back({ "volume_value", L::NUMBER, L::FROM_STAGE, VTK_FLOAT, 1, None, "V",
    "value of the data at the depth of a volume" });
  table.push_back({ "volume_normal", L::VECTOR, L::FROM_STAGE, VTK_FLOAT, 3, 0.0, "X,Y,Z",
    "unit vector along falling values at the depth of a volume, world space" });
  table.push_back({ "volume_opacity", L::SHARE, L::FROM_STAGE, VTK_FLOAT, 1, 0.0, "V",
    "opacity of volumes before the surface: 0 nothing, 1 all" });
  table.push_back(
    { "volume", L::ID, L::FROM_STAGE, VTK_INT, 1, -1.0, "id", "index of the volume, from 0" });
  L shadow = { "shadow_", L::SHARE, L::FROM_SHADOW, VTK_FLOAT, 1, 1.0, "V",
    "visibility of a light: 1 lit, 0 dark" };
  shadow.OfLight = true;
  table.push_back(shadow);
  return table;
}

const L& At(int layer)
{
  static const L none;
  const std::vector<L>& all = vtkRelievoLayerCatalogue::GetAll();
  return layer >= 0 && layer < static_cast<int>(all.size()) ? all[layer] : none;
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
const vtkRelievoLayer& vtkRelievoLayerCatalogue::GetPicture()
{
  const std::vector<L>& all = GetAll();
  return *std::find_if(
    all.begin(), all.end(), [](const L& layer) { return layer.Source == L::FROM_PICTURE; });
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
bool vtkRelievoLayerCatalogue::GetIsLayer(const std::string& name)
{
  return Find(name).Kind != L::ARRAY;
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerCatalogue::GetIsOfLight(const std::string& name)
{
  const std::string& prefix = GetOfLight().Name;
  return name.compare(0, prefix.size(), prefix) == 0;
}

//------------------------------------------------------------------------------
int vtkRelievoLayerCatalogue::GetLight(const std::string& name)
{
  const std::string word =
    GetIsOfLight(name) ? name.substr(GetOfLight().Name.size()) : std::string();
  const bool isNumber = !word.empty() && word.size() < 4 &&
    std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  return isNumber ? std::stoi(word) : -1;
}

//------------------------------------------------------------------------------
int vtkRelievoLayerCatalogue::GetNumberOfLayers()
{
  return static_cast<int>(GetAll().size());
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerCatalogue::GetLayerName(int layer)
{
  return At(layer).GetLabel();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerCatalogue::GetLayerHelp(int layer)
{
  return At(layer).Help;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerCatalogue::GetLayerType(int layer)
{
  const int type = At(layer).Type;
  return type == VTK_VOID ? std::string() : vtkImageScalarTypeNameMacro(type);
}

//------------------------------------------------------------------------------
int vtkRelievoLayerCatalogue::GetLayerComponents(int layer)
{
  return At(layer).Name.empty() ? 0 : At(layer).Components;
}

//------------------------------------------------------------------------------
double vtkRelievoLayerCatalogue::GetLayerBackground(int layer)
{
  return At(layer).Background;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerCatalogue::GetLayerNames()
{
  std::string names;
  for (const L& layer : GetAll())
  {
    names += (names.empty() ? "" : ", ") + layer.GetLabel();
  }
  return names;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLayerCatalogue::GetTitle(const std::string& layer)
{
  const bool ofLight = GetIsOfLight(layer);
  if (!ofLight && !GetIsLayer(layer))
  {
    return layer;
  }
  if (layer == "range") // a range of values is another thing
  {
    return "Distance";
  }
  std::string words = layer;
  std::replace(words.begin(), words.end(), '_', ' ');
  if (ofLight)
  {
    return (GetLight(layer) < 0 ? "Shadow of " : "Shadow of light ") +
      words.substr(GetOfLight().Name.size());
  }
  const std::string american = "color";
  const std::size_t at = words.find(american);
  if (at != std::string::npos)
  {
    words.replace(at, american.size(), "colour");
  }
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerCatalogue::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << GetLayerNames() << "\n";
}
