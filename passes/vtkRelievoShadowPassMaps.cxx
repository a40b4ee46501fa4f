// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of a frame, and what the forward method makes of them.
#include "vtkRelievoShadowInternals.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// From the NDC of the tile that is drawn to those of the whole picture, so that maps are the same
// in all tiles. Identity without tiles.
glm::dmat4 GetTileToPicture(vtkRenderer* renderer)
{
  glm::dmat4 m(1.0);
  const double* all = renderer->GetViewport();
  double tile[4];
  renderer->GetRenderWindow()->GetTileViewport(tile);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = std::max(all[axis], tile[axis]);
    const double high = std::min(all[axis + 2], tile[axis + 2]);
    const double whole = all[axis + 2] - all[axis];
    if (high > low && whole > 0.0)
    {
      m[axis][axis] = (high - low) / whole;
      m[3][axis] = (high + low - all[axis] - all[axis + 2]) / whole;
    }
  }
  return m;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::FitMaps(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  vtkRelievoShadowScene scene;
  vtkRelievoShadowFit::Request& request = scene.Request;
  request.Size = this->MapSize;
  const int largest = vtkRelievoShadowMaps::GetLargestSize();
  if (request.Size > largest)
  {
    request.Size = largest;
    if (in.Said.insert("size" + std::to_string(this->MapSize)).second)
    {
      vtkWarningMacro("Shadow maps of " << this->MapSize << " x " << this->MapSize
                                        << " texels were asked for, this OpenGL makes at most "
                                        << largest << " x " << largest << ": these are used.");
    }
  }
  in.Radius = std::min(this->FilterRadius, request.Size / 4);
  request.Border = in.Radius + 1;
  request.Warp = this->Method == METHOD_WARPED;
  const glm::dmat4 viewToWorld = glm::inverse(in.View.WorldToView);
  request.Eye = glm::dvec3(viewToWorld[3]);
  request.Gaze = glm::normalize(-glm::dvec3(viewToWorld[2]));
  request.ViewUp = glm::dvec3(viewToWorld[1]);
  request.ParallelEye = in.View.Parallel;
  scene.WorldToNDC = GetTileToPicture(s->GetRenderer()) * in.View.ViewToNDC * in.View.WorldToView;
  scene.Casters = in.Props.GetCasterBoxes();
  scene.Receivers = in.Props.GetReceiverBoxes();
  scene.SameCasters = in.Cache.HasCasters(in.Props);
  in.Cache.SetCasters(in.Props);
  const bool together = in.Exchange.IsOn();
  if (together)
  {
    in.Exchange.Gather(scene);
  }
  if (!together || in.Exchange.IsRoot())
  {
    in.Cache.Update(in.Casting, scene);
  }
  if (together)
  {
    in.Exchange.Share(in.Cache, in.Casting, request.Size);
  }
  if (in.Maps.Allocate(window, request.Size, in.Cache.GetNumberOfMaps()))
  {
    in.Cache.Invalidate();
  }
  if (together)
  {
    in.Exchange.Agree(in.Cache);
  }
  vtkRelievoShadowSplice::Structure structure;
  structure.Numbers = static_cast<int>(in.Lights.size());
  structure.Unlit = this->LayersAsked;
  structure.WideFilter = in.Radius > 1;
  structure.Warped = this->Method == METHOD_WARPED;
  structure.Forward = this->Method == METHOD_FORWARD;
  for (const auto& entry : in.Cache.GetEntries())
  {
    structure.Lights.push_back({ entry.Light.ShaderIndex, !entry.Light.Positional, entry.Cube });
  }
  if (!(structure == in.Structure))
  {
    in.Structure = structure;
    in.StructureTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::DrawMaps(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  in.Told.clear();
  for (auto& entry : in.Cache.GetEntries())
  {
    for (auto& map : entry.Maps)
    {
      if (map.Drawn)
      {
        continue;
      }
      if (!in.DrawingMaps)
      {
        in.DrawingMaps = true;
        in.Maps.Bind(false);
        in.Maps.Begin();
      }
      in.Maps.Draw(map.Layer, map.View, renderer, [&](const vtkRelievoShadowView& view) {
        this->DrawCalls += in.Props.RenderCasters(renderer, view, in.PlainDraw);
      });
      if (in.Exchange.IsOn())
      {
        in.Exchange.Merge(in.Maps, map.Layer);
      }
      map.Drawn = true;
      ++this->NumberOfMapsDrawn;
    }
  }
  if (in.DrawingMaps)
  {
    in.Maps.End();
    in.DrawingMaps = false;
    // What VTK takes for these programs' lights are in a light's eye space.
    for (vtkShaderProgram* program : in.LitForMaps)
    {
      program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    }
    in.LitForMaps.clear();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::DrawMasks(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const glm::dmat4 worldToNDC = in.View.ViewToNDC * in.View.WorldToView;
  const bool lost = in.Masks.Allocate(window, in.View.Viewport[2], in.View.Viewport[3],
    static_cast<int>(in.Cache.GetEntries().size()));
  if (!in.Masks.Bind())
  {
    in.MaskState = {};
    return;
  }
  in.Maps.Bind(true); // making the masks may have taken their place
  std::vector<vtkLight*> lights;
  for (const auto& entry : in.Cache.GetEntries())
  {
    lights.push_back(entry.Light.Light);
  }
  // What only receives is not in the casters' state: redrawn whenever there is any.
  if (!lost && this->NumberOfMapsDrawn == 0 && in.MaskState.WorldToNDC == worldToNDC &&
    in.MaskState.Surfaces == in.Props.GetState() && in.MaskState.Culling == in.Props.GetCulling() &&
    in.MaskState.Lights == lights && in.MaskState.Bias == this->Bias &&
    !in.Props.HasMereReceivers())
  {
    return;
  }
  in.MaskState.WorldToNDC = worldToNDC;
  in.MaskState.Surfaces = in.Props.GetState();
  in.MaskState.Culling = in.Props.GetCulling();
  in.MaskState.Lights = lights;
  in.MaskState.Bias = this->Bias;
  in.DrawingDepth = true;
  in.Masks.DrawDepth(
    [&]() { this->DrawCalls += in.Props.RenderSurfaces(renderer, worldToNDC, in.PlainDraw); });
  in.DrawingDepth = false;
  int light = 0;
  for (const auto& entry : in.Cache.GetEntries())
  {
    if (in.Masks.BeginLight(light++, in.View, in.Maps.GetTextureUnit(), in.Maps.GetSize()))
    {
      for (const auto& map : entry.Maps)
      {
        in.Masks.DrawMap(map.View, map.Layer, this->Bias);
        ++this->DrawCalls;
      }
    }
    in.Masks.EndLight();
  }
}
