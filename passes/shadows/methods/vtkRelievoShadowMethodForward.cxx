// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethodForward.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Fitted like vtkRelievoShadowMapLaw, but only to maps of 512 and 1024 texels; larger ones were not
// measured.
constexpr vtkRelievoShadowErrorLaw ForwardLaw = { 2.09e-4, 1.00 };
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowMethodForward::State::operator==(const State& other) const
{
  return this->WorldToNDC == other.WorldToNDC && this->Surfaces == other.Surfaces &&
    this->Culling == other.Culling && this->Lights == other.Lights && this->Bias == other.Bias;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowMethodForward::Draw(vtkRelievoShadowContext& work, vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const auto& entries = work.Cache.GetEntries();
  const bool lost = this->Masks.Allocate(
    window, work.View.Viewport[2], work.View.Viewport[3], static_cast<int>(entries.size()));
  this->Fault.clear();
  const bool bound = this->Masks.Bind();
  work.Maps.Bind(true); // making the masks may have replaced their binding
  if (!bound)
  {
    this->Drawn = {};
    this->Fault = this->Masks.IsThere() ? "all texture units of this OpenGL are taken"
                                        : "this OpenGL has no memory for the masks in the view";
    return 0;
  }
  State state;
  state.WorldToNDC = work.View.ViewToNDC * work.View.WorldToView;
  state.Surfaces = work.Props.GetState();
  state.Culling = work.Props.GetCulling();
  state.Bias = work.Bias;
  for (const auto& entry : entries)
  {
    state.Lights.push_back(entry.Light.Light);
  }
  // Mere receivers are not in the casters' state: redraws whenever there is any.
  if (!lost && work.MapsDrawn == 0 && state == this->Drawn && !work.Props.HasMereReceivers())
  {
    return 0;
  }
  this->Drawn = state;
  int draws = 0;
  work.DrawingDepth = true;
  this->Masks.DrawDepth(
    [&]() { draws += work.Props.RenderSurfaces(renderer, state.WorldToNDC, work.PlainDraw); });
  work.DrawingDepth = false;
  int light = 0;
  for (const auto& entry : entries)
  {
    if (this->Masks.BeginLight(light++, work.View, work.Maps.GetTextureUnit(), work.Maps.GetSize()))
    {
      for (const auto& map : entry.Maps)
      {
        this->Masks.DrawMap(map.View, map.Layer, work.Bias);
        ++draws;
      }
    }
    this->Masks.EndLight();
  }
  return draws;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodForward::Settle(const vtkRelievoShadowContext& work)
{
  if (!this->Drawn.Lights.empty())
  {
    this->Drawn.Surfaces = work.Props.GetState();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodForward::SetFrameUniforms(
  vtkShaderProgram* program, const vtkRelievoShadowContext& work) const
{
  const int faces = work.Structure.GetFaces();
  std::vector<int> masks(faces, 0);
  int first = 0;
  int light = 0;
  for (const auto& entry : work.Cache.GetEntries())
  {
    std::fill_n(masks.begin() + first, entry.Maps.size(), light);
    first += work.Structure.Lights[light++].GetRoom();
  }
  // While maps are drawn there are no masks yet, but the sampler needs a unit.
  program->SetUniformi("relievoShadowMasks",
    this->Masks.GetTextureUnit() >= 0 ? this->Masks.GetTextureUnit() : work.Maps.GetTextureUnit());
  program->SetUniform1iv("relievoShadowMask", faces, masks.data());
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMethodForward::SetActorUniforms(
  vtkShaderProgram* program, const vtkRelievoShadowContext& work, vtkActor* actor) const
{
  int region[4];
  vtkRelievoForwardMasks::GetViewport(region);
  // A mask covers the visible opaque surfaces, at the size of the viewport.
  const bool holds = !work.DrawingAnyMaps && !work.DrawingDepth && this->Fault.empty() &&
    this->Masks.GetTextureUnit() >= 0 && actor->HasOpaqueGeometry() &&
    region[2] == work.View.Viewport[2] && region[3] == work.View.Viewport[3];
  program->SetUniformi("relievoShadowMasked", holds ? 1 : 0);
  program->SetUniform2i("relievoShadowOrigin", region);
}

//------------------------------------------------------------------------------
vtkRelievoShadowEstimate vtkRelievoShadowMethodForward::Estimate(
  const vtkRelievoShadowDemand& demand) const
{
  vtkRelievoShadowEstimate estimate;
  estimate.Bytes = vtkRelievoShadowMaps::GetBytes(demand.MapSize, demand.Maps) +
    vtkRelievoForwardMasks::GetBytes(demand.Width, demand.Height, demand.Lights);
  // The maps, the camera's depth, the maps' samples.
  estimate.DrawCalls = demand.Maps * demand.Props + demand.Props + demand.Maps;
  estimate.WrongShare = ForwardLaw.GetShare(demand.MapSize);
  return estimate;
}
