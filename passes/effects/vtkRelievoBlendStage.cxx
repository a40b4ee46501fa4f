// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlendStage.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkRelievoBlendStage);

namespace
{
const char* const Blend = "blend";
}

class vtkRelievoBlendStage::Internals
{
public:
  vtkRelievoScreenTarget Layer{ "blendLayer" };
  vtkRelievoScreenQuad Quad;
  vtkRelievoReportOnce Reported;
};

//------------------------------------------------------------------------------
vtkRelievoBlendStage::vtkRelievoBlendStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoBlendStage::~vtkRelievoBlendStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoBlendStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "blend";
  description.Help = "Keeps translucent surfaces apart until opaque ones are lit.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = -1; // before stages that change the colour of every pixel
  description.Reads = { vtkRelievoResources::Translucent };
  description.Writes = { vtkRelievoResources::Color };
  description.Layers = { Blend };
  description.OnByDefault = true;
}

//------------------------------------------------------------------------------
void vtkRelievoBlendStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  declaration.OnlyIfColorChanges = true;
  declaration.OnlyIfTranslucent = true;
  if (context.Renderer->GetUseFXAA())
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason =
      "FXAA (UseFXAA) smooths translucent surfaces together with those behind them";
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoBlendStage::Prepare(vtkRelievoFrameContext& context)
{
  context.KeepTranslucentApart(
    &this->Internal->Layer, !context.IsAsked(this, vtkRelievoResources::Color));
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoBlendStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const bool any = context.Find(vtkRelievoResources::Translucent) != nullptr;
  std::string error;
  this->DrawCalls = 0;
  if (context.IsLayerAsked(this, Blend))
  {
    error = any ? "" : in.Layer.Prepare(context, {});
    if (!any && error.empty())
    {
      in.Layer.Begin(context);
      in.Layer.End();
    }
    if (error.empty())
    {
      context.ProvideLayer(Blend, &in.Layer);
    }
  }
  else if (!any)
  {
    this->ReleaseGraphicsResources(context.Window);
  }
  if (any && context.IsAsked(this, vtkRelievoResources::Color))
  {
    if (in.Quad.Ready(context, "blend/colorFS.glsl",
          { vtkRelievoResources::Color, vtkRelievoResources::Translucent }))
    {
      this->DrawCalls += context.DrawColor(in.Quad) ? 1 : 0;
    }
    error = in.Quad.GetError();
  }
  this->Explain(error.empty() ? "ran" : "failed",
    !error.empty() ? error
      : any        ? "keeps translucent surfaces apart"
                   : "nothing translucent was drawn into the colour");
  if (in.Reported.IsChange(error))
  {
    vtkErrorMacro("Translucent surfaces are missing: " << error << ".");
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoBlendStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    const std::string error = this->Internal->Layer.Read(name, 4, image);
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoBlendStage::GetBytesHeld()
{
  return this->Internal->Layer.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoBlendStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Layer.Release(window);
  this->Internal->Quad.Release(window);
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
