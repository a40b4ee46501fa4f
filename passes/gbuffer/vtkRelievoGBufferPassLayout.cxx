// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which words a frame's pixels have, from what is asked of the stage.
#include "vtkRelievoGBufferInternals.h"

#include "vtkLightCollection.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerReader.h"
#include "vtkRelievoSurfaces.h"

#include <numeric>

//------------------------------------------------------------------------------
void vtkRelievoGBufferPass::Internals::Arrange(
  vtkRelievoGBufferPass& self, const vtkRelievoFrameContext& context)
{
  this->RefinesDepth = self.RefineDepth;
  vtkRelievoGBufferLayout layout;
  layout.Lights = context.Lights;
  layout.NormalFormat = self.GetNormalFormatUsed();
  layout.DepthFormat = self.GetDepthFormatUsed();
  const bool separate = self.NormalTolerance > 0.0 || self.DepthTolerance > 0.0;
  layout.NormalDepth = separate ? static_cast<int>(NORMAL_DEPTH_SEPARATE) : self.NormalDepthFormat;
  for (const std::string& layer : context.GetAsked(&self))
  {
    if (layer == "surface" || layer == "shading")
    {
      layout.Surface = true;
    }
    else
    {
      vtkRelievoLayerReader::AddChannels(layer, layout);
    }
  }
  // A depth that shares its texel with the normal is as it was written.
  const bool together =
    layout.NormalDepth != NORMAL_DEPTH_SEPARATE && layout.Normal && layout.Depth;
  const bool refines = self.RefineDepth && layout.DepthFormat == DEPTH_32F && !together;
  for (const std::string& layer : context.ReadBack)
  {
    layout.Ids = layout.Ids ||
      (refines && vtkRelievoLayerCatalogue::Find(layer).Source == vtkRelievoLayer::FROM_DEPTH);
  }
  if (layout.Surface)
  {
    const vtkRelievoSurfaces surfaces = vtkRelievoSurfaces::Find(context.Scene);
    layout.SurfaceDetail = surfaces.Detail;
    layout.SurfaceSpecular = surfaces.Specular;
    layout.SurfacePbr = surfaces.Pbr;
  }
  std::vector<int> asked; // lights whose visibility is a layer
  this->Textures.WhyNot.clear();
  this->Textures.Left.clear();
  this->Textures.Deferred = this->Textures.NumberOfLights = 0;
  this->ShadingAsked = context.IsAsked(&self, "shading");
  if (this->ShadingAsked)
  {
    this->Textures.WhyNot = this->Stray
      ? "something has been drawn by a shader that takes no splice, or not in one go"
      : context.ColorsLight ? "translucent surfaces colour the light that passes them"
                            : vtkRelievoSurfaces::WhyAllLit(context.Scene, context.Window);
  }
  this->Shading = this->ShadingAsked && this->Textures.WhyNot.empty();
  if (this->Shading)
  {
    layout.Depth = layout.Normal = true;
    asked = layout.Shadows;
    if (context.IsPlanned("shadow maps"))
    {
      layout.Shadows.resize(context.Renderer->GetLights()->GetNumberOfItems());
      std::iota(layout.Shadows.begin(), layout.Shadows.end(), 0);
      this->Textures.NumberOfLights = static_cast<int>(layout.Shadows.size());
    }
  }
  layout.Arrange();
  if (this->Shading && layout.GetNumberOfAttachments() > vtkRelievoGBufferLayout::MostAttachments)
  {
    this->Textures.WhyNot = "the visibility of " + std::to_string(layout.Shadows.size()) +
      " lights takes more than " + std::to_string(vtkRelievoGBufferLayout::MostAttachments) +
      " attachments";
    this->Shading = false;
    layout.Shadows = asked;
    layout.Arrange();
  }
  const bool changed = layout != this->Layout;
  this->Layout = layout;
  if (changed)
  {
    this->StructureTime.Modified();
  }
}
