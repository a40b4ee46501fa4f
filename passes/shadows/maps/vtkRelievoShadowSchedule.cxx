// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowSchedule.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowFitter.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRelievoTiles.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <sstream>

//------------------------------------------------------------------------------
std::string vtkRelievoShadowSchedule::Fit(vtkRelievoShadowContext& work,
  const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowFitter& fitter, int size,
  int radius, vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRelievoShadowScene scene;
  vtkRelievoShadowFit::Request& request = scene.Request;
  request.Size = size;
  work.Radius = std::min(radius, size / 4);
  request.Border = work.Radius + 1;
  const glm::dmat4 viewToWorld = glm::inverse(work.SteadyView.WorldToView);
  request.Eye = glm::dvec3(viewToWorld[3]);
  request.Gaze = glm::normalize(-glm::dvec3(viewToWorld[2]));
  request.ViewUp = glm::dvec3(viewToWorld[1]);
  request.ParallelEye = work.SteadyView.Parallel;
  scene.WorldToNDC =
    vtkRelievoGetTileToPicture(renderer) * work.SteadyView.ViewToNDC * work.SteadyView.WorldToView;
  scene.Casters = work.Props.GetCasterBoxes(work.WithoutFollowed);
  scene.Receivers = work.OnEverything ? work.Props.GetAllBoxes() : work.Props.GetReceiverBoxes();
  scene.SameCasters = work.Cache.HasCasters(work.Props, work.WithoutFollowed);
  work.Cache.SetCasters(work.Props, work.WithoutFollowed);
  const bool together = this->Exchange.IsOn();
  if (together)
  {
    this->Exchange.Gather(scene);
  }
  if (!together || this->Exchange.IsRoot())
  {
    work.Cache.Update(casting, scene, fitter);
  }
  if (together)
  {
    this->Exchange.Share(work.Cache, casting, request.Size);
  }
  if (work.Maps.Allocate(window, request.Size, work.Cache.GetNumberOfMaps()))
  {
    work.Cache.Invalidate();
  }
  std::string fault;
  if (!work.Maps.IsThere())
  {
    std::ostringstream out;
    const int maps = work.Cache.GetNumberOfMaps();
    out << "this OpenGL has no memory for " << maps << (maps == 1 ? " map of " : " maps of ")
        << request.Size << " x " << request.Size << " texels; choose a smaller MapSize";
    fault = out.str();
  }
  else if (!work.Maps.Bind(false))
  {
    fault = "all texture units of this OpenGL are taken; use fewer textures";
  }
  if (together)
  {
    this->Exchange.Agree(work.Cache);
    if (!this->Exchange.IsEverywhere(fault.empty()) && fault.empty())
    {
      fault = "another process has no room for the maps";
      work.Maps.Unbind();
    }
  }
  return fault;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowSchedule::Draw(vtkRelievoShadowContext& work, vtkRenderer* renderer)
{
  int draws = 0;
  work.MapsDrawn = 0;
  // Software OpenGL is not faster for any number of triangles. Processor seconds of first pictures
  // by OpenGL and by the processor, medians of five: a cube 0.95 and 0.95, a sphere of 1056
  // triangles 1.20 and 1.24, one of 10 080 triangles 1.27 and 1.26.
  const bool software = vtkRelievoIsSoftwareOpenGL();
  int inMap = 0;
  auto inMemory = [&](const vtkRelievoShadowView& view, const int region[4],
                    vtkRelievoDepthRaster& raster) {
    inMap += work.Props.RasterizeCasters(
      renderer, view, region, work.PlainDraw, work.WithoutFollowed, raster);
    return work.Props.HasRastered();
  };
  for (auto& entry : work.Cache.GetEntries())
  {
    for (auto& map : entry.Maps)
    {
      if (map.Drawn)
      {
        continue;
      }
      if (!work.DrawingMaps)
      {
        work.DrawingMaps = work.DrawingAnyMaps = true;
        work.Maps.Bind(false);
        work.Maps.Begin();
      }
      inMap = 0;
      work.Props.BeginRaster();
      const bool isRastered = work.Maps.Draw(map.Layer, map.View, renderer,
        software ? inMemory : vtkRelievoShadowMaps::CastersInMemory(),
        [&](const vtkRelievoShadowView& view, bool others) {
          return work.Props.RenderCasters(
            renderer, view, work.PlainDraw, work.WithoutFollowed, others, draws);
        });
      draws += isRastered ? inMap : 0;
      if (this->Exchange.IsOn())
      {
        this->Exchange.Merge(work.Maps, map.Layer);
      }
      map.Drawn = true;
      ++work.MapsDrawn;
    }
  }
  if (work.DrawingMaps)
  {
    work.Maps.End();
    work.DrawingMaps = work.DrawingAnyMaps = false;
    // VTK updates these programs' lights with a light's eye space.
    for (vtkShaderProgram* program : this->LitForMaps)
    {
      program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    }
    this->LitForMaps.clear();
  }
  return draws;
}
