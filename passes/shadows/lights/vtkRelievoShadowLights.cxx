// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowLights.h"

#include "vtkLightCollection.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLightSamples.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>

namespace
{
// The tangent of the angle between two directions.
double GetTangent(const glm::dvec3& a, const glm::dvec3& b)
{
  return glm::length(glm::cross(a, b)) / std::max(glm::dot(a, b), 1e-3);
}

// Clusters the parts around this number of centres (S. Lloyd, Least squares quantization in PCM,
// 1982).
void FindCenters(vtkRelievoShadowLight& light, int count)
{
  constexpr int Rounds = 16;
  for (int i = 0; i < count; ++i)
  {
    light.Centers.push_back({ light.Parts[static_cast<std::size_t>(i)].Direction });
  }
  for (int round = 0; round < Rounds; ++round)
  {
    std::vector<glm::dvec3> sums(light.Centers.size(), glm::dvec3(0.0));
    for (vtkRelievoShadowLight::Part& part : light.Parts)
    {
      const auto nearest = std::max_element(light.Centers.begin(), light.Centers.end(),
        [&part](const vtkRelievoShadowLight::Center& a, const vtkRelievoShadowLight::Center& b) {
          return glm::dot(a.Direction, part.Direction) < glm::dot(b.Direction, part.Direction);
        });
      part.Map = static_cast<int>(nearest - light.Centers.begin());
      sums[static_cast<std::size_t>(part.Map)] += part.Direction;
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      light.Centers[i].Direction =
        sums[i] == glm::dvec3(0.0) ? light.Direction : glm::normalize(sums[i]);
    }
  }
  for (const vtkRelievoShadowLight::Part& part : light.Parts)
  {
    vtkRelievoShadowLight::Center& center = light.Centers[static_cast<std::size_t>(part.Map)];
    center.Spread = std::max(center.Spread, GetTangent(part.Direction, center.Direction));
    light.Spread = std::max(light.Spread, GetTangent(part.Direction, light.Direction));
  }
}

// The renderer's lights. A sun with a size casts where it is at the eye, too.
std::vector<vtkRelievoShadowLight> Find(vtkRenderer* renderer, const vtkRelievoLightSizes* sizes)
{
  std::vector<vtkRelievoShadowLight> lights = vtkRelievoShadowLight::Collect(renderer);
  for (vtkRelievoShadowLight& light : lights)
  {
    if (light.AtEye && !light.Positional && sizes && sizes->IsSized(light.Light))
    {
      light.AtEye = false;
      light.NoShadow.clear();
    }
  }
  return lights;
}

std::string Identify(const std::string& name)
{
  std::string out;
  bool isNumber = true;
  for (const char c : name)
  {
    const bool digit = c >= '0' && c <= '9';
    const bool upper = c >= 'A' && c <= 'Z';
    const bool lower = c >= 'a' && c <= 'z';
    out += digit || lower ? c : upper ? static_cast<char>(c - 'A' + 'a') : '_';
    isNumber = isNumber && digit;
  }
  return isNumber ? "light_" + out : out; // shadow_3 means the light with index 3
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowLights::SetCasts(vtkLight* light, bool casts)
{
  auto& list = this->NotCasting;
  list.erase(std::remove_if(list.begin(), list.end(),
               [light](const vtkWeakPointer<vtkLight>& known) {
                 return !known || known.GetPointer() == light;
               }),
    list.end());
  if (!casts && light)
  {
    list.emplace_back(light);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowLights::Casts(vtkLight* light) const
{
  return std::find(this->NotCasting.begin(), this->NotCasting.end(), light) ==
    this->NotCasting.end();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowLights::SetName(vtkLight* light, const std::string& name)
{
  auto& names = this->Names;
  names.erase(std::remove_if(names.begin(), names.end(),
                [light](const auto& named) { return !named.first || named.first == light; }),
    names.end());
  if (light && !name.empty())
  {
    names.emplace_back(light, name);
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowLights::GetName(const vtkRelievoShadowLight& light) const
{
  for (const auto& named : this->Names)
  {
    if (named.first == light.Light)
    {
      return named.second;
    }
  }
  return "light " + std::to_string(light.Number);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowLights::GetName(vtkRenderer* renderer, vtkLight* light) const
{
  vtkRelievoShadowLight named;
  named.Light = light;
  named.Number = light ? renderer->GetLights()->IsItemPresent(light) - 1 : -1;
  return named.Number < 0 ? std::string() : this->GetName(named);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowLights::GetLayer(vtkRenderer* renderer, vtkLight* light) const
{
  std::vector<std::string> before;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* each = renderer->GetLights()->GetNextLight(it))
  {
    const std::string first =
      vtkRelievoLayerCatalogue::GetOfLight().Name + Identify(this->GetName(renderer, each));
    std::string layer = first;
    for (int n = 2; std::find(before.begin(), before.end(), layer) != before.end(); ++n)
    {
      layer = first + "_" + std::to_string(n);
    }
    if (each == light)
    {
      return layer;
    }
    before.push_back(layer);
  }
  return {};
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoShadowLights::GetLayers(
  vtkRenderer* renderer, const vtkRelievoLightSizes* sizes) const
{
  std::vector<std::string> layers;
  for (const vtkRelievoShadowLight& light : ::Find(renderer, sizes))
  {
    if (light.NoShadow.empty() && this->Casts(light.Light) &&
      light.Light->GetShadowAttenuation() > 0.0f)
    {
      layers.push_back(this->GetLayer(renderer, light.Light));
    }
  }
  return layers;
}

//------------------------------------------------------------------------------
std::map<std::string, int> vtkRelievoShadowLights::Find(
  const std::vector<std::string>& layers, vtkRenderer* renderer) const
{
  std::map<std::string, int> lights;
  for (const std::string& layer : layers)
  {
    const int number = vtkRelievoLayerCatalogue::GetLight(layer);
    if (number >= 0)
    {
      lights[layer] = number;
    }
    else if (vtkRelievoLayerCatalogue::GetIsOfLight(layer))
    {
      vtkCollectionSimpleIterator it;
      renderer->GetLights()->InitTraversal(it);
      int place = 0;
      while (vtkLight* each = renderer->GetLights()->GetNextLight(it))
      {
        if (this->GetLayer(renderer, each) == layer)
        {
          lights[layer] = place;
        }
        ++place;
      }
    }
  }
  return lights;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowLights::Collect(
  vtkRenderer* renderer, int mostMaps, const vtkRelievoLightSizes* sizes, bool separates)
{
  this->All = ::Find(renderer, sizes);
  this->Casting.clear();
  this->Unmoved.clear();
  // Lights at the eye come last: others take the maps.
  std::stable_partition(this->All.begin(), this->All.end(),
    [](const vtkRelievoShadowLight& light) { return !light.AtEye; });
  int maps = 0;
  for (vtkRelievoShadowLight& light : this->All)
  {
    const int room = light.Positional && !light.AtEye ? 6 : 1;
    if (light.AtEye && separates)
    {
      light.NoShadow.clear();
    }
    if (light.NoShadow.empty() && !this->Casts(light.Light))
    {
      light.NoShadow = "it is chosen so";
    }
    if (light.NoShadow.empty() && maps + room > mostMaps)
    {
      light.NoShadow = "the lights before it take all maps that a shader has room for";
      light.Broken = true;
    }
    if (light.NoShadow.empty())
    {
      maps += room;
      this->Casting.push_back(light);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowLights::Move(const vtkRelievoLightSizes& sizes, int sample, int samples)
{
  this->Unmoved = this->Casting;
  for (vtkRelievoShadowLight& light : this->Casting)
  {
    if (sizes.IsSized(light.Light))
    {
      sizes.Move(light, sample, samples);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowLights::Divide(
  const vtkRelievoLightSizes& sizes, int parts, int maps, int most)
{
  std::vector<vtkRelievoShadowLight*> suns;
  for (vtkRelievoShadowLight& light : this->Casting)
  {
    if (sizes.IsSized(light.Light) && !light.Positional)
    {
      suns.push_back(&light);
    }
    else
    {
      most -= light.Positional && !light.IsSpot() && !light.AtEye ? 6 : 1;
    }
  }
  for (vtkRelievoShadowLight* sun : suns)
  {
    for (int i = 0; i < parts; ++i)
    {
      vtkRelievoShadowLight part = *sun;
      sizes.Move(part, i, parts);
      sun->Parts.push_back({ part.Direction });
    }
    FindCenters(*sun, std::min({ maps, parts, std::max(1, most / static_cast<int>(suns.size())) }));
  }
  return !suns.empty();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowLights::CountSized(
  vtkRenderer* renderer, const vtkRelievoLightSizes& sizes, bool positional) const
{
  int count = 0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    count += light->GetSwitch() && !light->LightTypeIsHeadlight() && this->Casts(light) &&
        sizes.IsSized(light) && (light->GetPositional() != 0) == positional
      ? 1
      : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
std::vector<int> vtkRelievoShadowLights::GetNumbers() const
{
  std::vector<int> numbers;
  for (const vtkRelievoShadowLight& light : this->Casting)
  {
    numbers.push_back(light.Number);
  }
  return numbers;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowLights::KeepOnly(const std::vector<int>& numbers)
{
  this->Casting.clear();
  for (vtkRelievoShadowLight& light : this->All)
  {
    if (!light.NoShadow.empty())
    {
      continue;
    }
    if (std::find(numbers.begin(), numbers.end(), light.Number) != numbers.end())
    {
      this->Casting.push_back(light);
    }
    else
    {
      light.NoShadow = "it casts none on another process; use the same settings on all processes";
      light.Broken = true;
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowLights::GetReport() const
{
  // Lists each reason once, with its lights: presets have several fills of one name.
  std::map<std::string, std::map<std::string, int>> reasons;
  for (const vtkRelievoShadowLight& light : this->All)
  {
    if (!light.NoShadow.empty())
    {
      ++reasons[light.NoShadow][this->GetName(light)];
    }
  }
  std::string report;
  for (const auto& [reason, names] : reasons)
  {
    std::string lights;
    for (const auto& [name, count] : names)
    {
      lights += (lights.empty() ? "" : ", ") + name +
        (count > 1 ? " (" + std::to_string(count) + " lights)" : "");
    }
    const bool one = names.size() == 1 && names.begin()->second == 1;
    report += "; " + lights + (one ? " casts none: " : " cast none: ") + reason;
  }
  return report;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowLights::GetCastingReport() const
{
  std::string words = std::to_string(this->Casting.size());
  words += this->Casting.size() == 1 ? " light casts" : " lights cast";
  for (const vtkRelievoShadowLight& light : this->Casting)
  {
    words += (&light == this->Casting.data() ? " (" : ", ") + this->GetName(light);
  }
  return words + ")";
}
