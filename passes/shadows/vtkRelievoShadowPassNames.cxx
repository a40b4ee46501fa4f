// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkRelievoShadowPass calls lights, and the layers of their visibility.
#include "vtkRelievoShadowInternals.h"

#include "vtkLightCollection.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoShadowLight.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
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
  return isNumber ? "light_" + out : out; // shadow_3 is the light in place 3
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetLightName(vtkLight* light, const std::string& name)
{
  auto& names = this->Internal->Names;
  names.erase(std::remove_if(names.begin(), names.end(),
                [light](const auto& named) { return !named.first || named.first == light; }),
    names.end());
  if (light && !name.empty())
  {
    names.emplace_back(light, name);
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::GetLightName(vtkRenderer* renderer, vtkLight* light)
{
  vtkRelievoShadowLight named;
  named.Light = light;
  named.Number = light ? renderer->GetLights()->IsItemPresent(light) - 1 : -1;
  return named.Number < 0 ? std::string() : this->Internal->GetName(named);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::GetLightLayer(vtkRenderer* renderer, vtkLight* light)
{
  std::vector<std::string> before;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* each = renderer->GetLights()->GetNextLight(it))
  {
    const std::string first =
      vtkRelievoLayerCatalogue::GetOfLight().Name + Identify(this->GetLightName(renderer, each));
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
std::vector<std::string> vtkRelievoShadowPass::GetShadowLayers(vtkRenderer* renderer)
{
  std::vector<std::string> layers;
  for (const vtkRelievoShadowLight& light : vtkRelievoShadowLight::Collect(renderer))
  {
    if (light.NoShadow.empty() && this->Internal->IsChosen(light.Light) &&
      light.Light->GetShadowAttenuation() > 0.0f)
    {
      layers.push_back(this->GetLightLayer(renderer, light.Light));
    }
  }
  return layers;
}

//------------------------------------------------------------------------------
std::map<std::string, int> vtkRelievoShadowPass::FindLights(
  const std::vector<std::string>& layers, vtkRenderer* renderer)
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
        if (this->GetLightLayer(renderer, each) == layer)
        {
          lights[layer] = place;
        }
        ++place;
      }
    }
  }
  return lights;
}
