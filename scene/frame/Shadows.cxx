// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shadows.h"

#include "Display.h"
#include "Options.h"
#include "Values.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"

namespace scene
{
//------------------------------------------------------------------------------
int CountLights(vtkRenderer* renderer)
{
  const int lights = renderer->GetLights()->GetNumberOfItems();
  return lights == 0 && renderer->GetAutomaticLightCreation() ? 1 : lights;
}

//------------------------------------------------------------------------------
void SetCastingLights(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options)
{
  for (std::size_t i = 0; i < options.Lights.size(); ++i)
  {
    // --light has replaced the file's lights.
    vtkObject* object = renderer->GetLights()->GetItemAsObject(static_cast<int>(i));
    vtkLight* light = vtkLight::SafeDownCast(object);
    const LightChoice& choice = options.Lights[i];
    pass->GetShadowStage()->SetLightCasts(light, choice.Casts && !choice.IsNight());
    pass->GetShadowStage()->SetLightName(light, choice.Name);
    if (choice.Size)
    {
      pass->GetShadowStage()->SetLightSize(light, *choice.Size);
    }
  }
}

//------------------------------------------------------------------------------
void SetCastingVolumes(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options)
{
  const std::string kind = options.GetWord("--volume-shadows");
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    vtkProp* volume = vtkProp::SafeDownCast(volumes->GetItemAsObject(i));
    pass->GetShadowStage()->SetPropCasts(volume,
      kind == "receives" || kind == "none" ? vtkRelievoShadowStage::CASTS_NEVER
                                           : vtkRelievoShadowStage::CASTS_IF_OPAQUE);
    pass->GetShadowStage()->SetPropReceives(volume, kind != "casts" && kind != "none");
  }
}

//------------------------------------------------------------------------------
void SetShadows(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options)
{
  SetCastingLights(pass, renderer, options);
  SetCastingVolumes(pass, renderer, options);
  // The viewer uses --stage instead, because OpenGL must not be queried between a widget's frames.
  const std::string option = "--shadow-size";
  if (const std::string* size = FindStageChoice(options.Stages, "shadows", "map_size", option))
  {
    vtkOpenGLRenderWindow* gl = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    const int limit = gl ? GetSizeLimit(gl) : 0;
    if (gl && std::stoi(*size) > limit)
    {
      RefuseValue(option, *size,
        "at most " + std::to_string(limit) + ", the largest map that OpenGL makes here");
    }
  }
  pass->WaitForSamplesOn();
}
}
