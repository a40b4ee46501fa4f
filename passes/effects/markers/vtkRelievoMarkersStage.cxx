// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkersStage.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoMarkerBuffer.h"
#include "vtkRelievoMarkerList.h"
#include "vtkRelievoMarkers.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkShaderProgram.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoMarkersStage);

class vtkRelievoMarkersStage::Internals
{
public:
  vtkRelievoMarkerList List;
  vtkRelievoMarkerBuffer Buffer;
  vtkRelievoScreenQuad Quad;
};

//------------------------------------------------------------------------------
vtkRelievoMarkersStage::vtkRelievoMarkersStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoMarkersStage::~vtkRelievoMarkersStage() = default;

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkRelievoMarkersStage::NewPoints()
{
  return vtkRelievoMarkers::New();
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "markers";
  description.Help = "Rings, glows, discs and blob shadows on surfaces, around points and actors.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = -10; // on surfaces, before everything in front of them
  description.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::Normal };
  description.Writes = { vtkRelievoResources::Color };
  description.Layers = { "marker" };
  description.OnByDefault = true;
  description.TakesData = true;
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  const auto sets = this->GetSets<vtkRelievoMarkers>();
  vtkRelievoMarkerList list;
  list.Take(context.View, sets, false);
  const bool shadows = list.GetShadows() ||
    (this->IsTogether() && std::any_of(sets.begin(), sets.end(), [](auto* markers) {
      return markers->GetShape() == vtkRelievoMarkers::SHADOW;
    }));
  if (!shadows)
  {
    declaration.Reads = { vtkRelievoResources::Depth };
  }
  if (!this->IsTogether() && list.GetNumberDrawn() == 0 &&
    vtkRelievoSphereRays(context.View).IsUsual())
  {
    // Without markers in view the layer is constant: nothing is covered.
    declaration.Writes.clear();
    declaration.ReasonCode = "idle";
    declaration.Reason = "no markers are in view";
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoMarkersStage::Draw(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (!vtkRelievoSphereRays(context.View).IsUsual())
  {
    return "the camera's projection has depths that change across the picture";
  }
  in.List.Take(context.View, this->GetSets<vtkRelievoMarkers>(), true);
  const std::string error = in.Buffer.Draw(context, in.List);
  if (!error.empty())
  {
    return error;
  }
  this->NumberDrawn = in.List.GetNumberDrawn();
  context.ProvideLayer("marker", &in.Buffer.Target);
  this->DrawCalls = this->NumberDrawn > 0 ? 1 : 0;
  this->Explain("ran",
    "draws " + std::to_string(this->NumberDrawn) + " of " +
      std::to_string(in.List.GetNumberGiven()) + " markers");
  if (this->NumberDrawn == 0 || !context.IsAsked(this, vtkRelievoResources::Color))
  {
    return {};
  }
  if (!in.Quad.Ready(context, "marker/colorFS.glsl", { vtkRelievoResourceName::Of("marker") }))
  {
    return in.Quad.GetError();
  }
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->DrawCalls += context.DrawColor(in.Quad, false, in.List.GetPart()) ? 1 : 0;
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::Execute(vtkRelievoFrameContext& context)
{
  this->DrawCalls = 0;
  this->NumberDrawn = 0;
  this->ReportFault(this->Draw(context));
}

//------------------------------------------------------------------------------
std::string vtkRelievoMarkersStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    const std::string error = this->Internal->Buffer.Target.Read(name, 1, image, 3);
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMarkersStage::GetBytesHeld()
{
  return this->Internal->Buffer.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Buffer.Release(window);
  this->Internal->Quad.Release(window);
  this->Internal->List.Clear();
  this->DrawCalls = 0;
  this->NumberDrawn = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
