// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shadows.h"

#include "Options.h"
#include "Values.h"

#include "vtkLightCollection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowPass.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cctype>

namespace cli
{
//------------------------------------------------------------------------------
int GetLightOfLayer(const std::string& layer)
{
  const std::string prefix = "shadow_";
  if (layer.rfind(prefix, 0) != 0)
  {
    return -1;
  }
  const std::string number = layer.substr(prefix.size());
  const bool whole = !number.empty() && number.size() < 4 &&
    std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c); });
  return whole ? std::stoi(number) : -1;
}

//------------------------------------------------------------------------------
void CheckShadowLayers(const RenderOptions& options, int lights, const std::string& whose)
{
  for (const std::string& name : options.Layers)
  {
    if (GetLightOfLayer(name) >= lights)
    {
      const std::string last = "shadow_" + std::to_string(lights - 1);
      RefuseValue("--layers", name,
        (lights == 1 ? "no shadow layer but shadow_0" : "none beyond " + last) + ": there " +
          (lights == 1 ? "is 1 " : "are " + std::to_string(lights) + " ") + whose +
          ", counted from 0");
    }
  }
}

//------------------------------------------------------------------------------
int CountLights(vtkRenderer* renderer)
{
  const int lights = renderer->GetLights()->GetNumberOfItems();
  return lights == 0 && renderer->GetAutomaticLightCreation() ? 1 : lights;
}

//------------------------------------------------------------------------------
void SetShadows(vtkRelievoPass* pass, vtkRenderWindow* window, const RenderOptions& options)
{
  pass->SetShadows(options.ShadowMethod != Shadows::Off);
  if (options.ShadowSize)
  {
    vtkOpenGLRenderWindow* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
    const int limit = gl ? vtkTextureObject::GetMaximumTextureSize(gl) : *options.ShadowSize;
    if (*options.ShadowSize > limit)
    {
      RefuseValue("--shadow-size", std::to_string(*options.ShadowSize),
        "a whole number from " + std::to_string(SmallestShadowSize) + " to " +
          std::to_string(limit) + ", the largest map that OpenGL makes here");
    }
    pass->GetShadowPass()->SetMapSize(*options.ShadowSize);
  }
  constexpr int methods[] = { vtkRelievoShadowPass::METHOD_MAP, vtkRelievoShadowPass::METHOD_MAP,
    vtkRelievoShadowPass::METHOD_FORWARD, vtkRelievoShadowPass::METHOD_WARPED };
  pass->GetShadowPass()->SetMethod(methods[static_cast<int>(options.ShadowMethod)]);
}
}
