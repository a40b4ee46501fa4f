// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkersStage.h"

#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
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
#include "vtkSmartPointer.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoMarkersStage);

class vtkRelievoMarkersStage::Internals
{
public:
  std::vector<vtkSmartPointer<vtkRelievoMarkers>> Sets;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkRelievoMarkerList List;
  vtkRelievoMarkerBuffer Buffer;
  vtkRelievoScreenQuad Quad;
  std::string Reported; // what was wrong in the last frame: said once

  std::vector<vtkRelievoMarkers*> GetSets() const
  {
    return { this->Sets.begin(), this->Sets.end() };
  }
};

//------------------------------------------------------------------------------
vtkRelievoMarkersStage::vtkRelievoMarkersStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoMarkersStage::~vtkRelievoMarkersStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::AddMarkers(vtkRelievoMarkers* markers)
{
  auto& sets = this->Internal->Sets;
  if (markers && std::find(sets.begin(), sets.end(), markers) == sets.end())
  {
    sets.emplace_back(markers);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::RemoveMarkers(vtkRelievoMarkers* markers)
{
  auto& sets = this->Internal->Sets;
  const auto found = std::find(sets.begin(), sets.end(), markers);
  if (found != sets.end())
  {
    sets.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::RemoveAllMarkers()
{
  if (!this->Internal->Sets.empty())
  {
    this->Internal->Sets.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoMarkersStage::GetNumberOfMarkerSets()
{
  return static_cast<int>(this->Internal->Sets.size());
}

//------------------------------------------------------------------------------
vtkRelievoMarkers* vtkRelievoMarkersStage::GetMarkers(int i)
{
  return i >= 0 && i < this->GetNumberOfMarkerSets() ? this->Internal->Sets[i].Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::SetController(vtkMultiProcessController* controller)
{
  this->Internal->Controller = controller;
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoMarkersStage::GetController()
{
  return this->Internal->Controller;
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "markers";
  description.Help = "Rings, glows, discs and blob shadows on surfaces, around points and actors.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = -10; // on surfaces: what is before them comes after
  description.Reads = { "depth", "normal" };
  description.Writes = { "color" };
  description.Layers = { "marker" };
  description.OnByDefault = true;
  description.TakesData = true;
}

//------------------------------------------------------------------------------
void vtkRelievoMarkersStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  const Internals& in = *this->Internal;
  // Another process may have markers where this one has none, and must not wait for it.
  const bool together = in.Controller && !in.Sets.empty();
  vtkRelievoMarkerList list;
  list.Take(context.View, in.GetSets(), false);
  const bool shadows = list.GetShadows() ||
    (together && std::any_of(in.Sets.begin(), in.Sets.end(), [](const auto& markers) {
      return markers->GetShape() == vtkRelievoMarkers::SHADOW;
    }));
  if (!shadows)
  {
    declaration.Reads = { "depth" };
  }
  if (!together && list.GetNumberDrawn() == 0 && vtkRelievoSphereRays(context.View).IsUsual())
  {
    // Without markers in view the layer is still what it says: nothing is covered.
    declaration.Writes.clear();
    declaration.Reason = "no markers are in view";
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoMarkersStage::Prepare(vtkRelievoFrameContext&)
{
  for (const auto& markers : this->Internal->Sets)
  {
    markers->Share(this->Internal->Controller);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRelievoMarkersStage::Draw(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (!vtkRelievoSphereRays(context.View).IsUsual())
  {
    return "the camera's projection has depths that change across the picture";
  }
  in.List.Take(context.View, in.GetSets(), true);
  const std::string wrong = in.Buffer.Draw(context, in.List);
  if (!wrong.empty())
  {
    return wrong;
  }
  this->NumberDrawn = in.List.GetNumberDrawn();
  context.ProvideLayer("marker", &in.Buffer.Target);
  this->DrawCalls = this->NumberDrawn > 0 ? 1 : 0;
  this->Explain("ran",
    "draws " + std::to_string(this->NumberDrawn) + " of " +
      std::to_string(in.List.GetNumberGiven()) + " markers");
  if (this->NumberDrawn == 0 || !context.IsAsked(this, "color"))
  {
    return {};
  }
  if (!in.Quad.Ready(context, "marker/colorFS.glsl", { "marker" }))
  {
    return in.Quad.GetWrong();
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
  const std::string wrong = this->Draw(context);
  if (!wrong.empty())
  {
    this->Explain("failed", wrong);
    if (this->Internal->Reported != wrong)
    {
      vtkErrorMacro("There are no markers: " << wrong << ".");
    }
  }
  this->Internal->Reported = wrong;
}

//------------------------------------------------------------------------------
std::string vtkRelievoMarkersStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    const std::string wrong = this->Internal->Buffer.Target.Read(name, 1, image, 3);
    if (!wrong.empty())
    {
      return "The layer '" + name + "' cannot be read: " + wrong + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoMarkersStage::GetDataTime()
{
  vtkMTimeType time = 0;
  for (const auto& each : this->Internal->Sets)
  {
    time = std::max(time, each->GetUpdatedTime());
  }
  return time;
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
