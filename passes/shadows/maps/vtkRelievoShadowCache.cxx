// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCache.h"

#include "vtkRelievoShadowFitter.h"
#include "vtkRelievoShadowProps.h"

#include <glm/vector_relational.hpp>

#include <algorithm>

namespace
{
using Entry = vtkRelievoShadowCache::Entry;
using Map = vtkRelievoShadowCache::Map;

bool IsSame(const vtkRelievoShadowLight& a, const vtkRelievoShadowLight& b)
{
  return a.Light == b.Light && a.AtEye == b.AtEye && a.Positional == b.Positional &&
    a.IsSpot() == b.IsSpot() && (!a.IsSpot() || a.ConeAngle == b.ConeAngle) &&
    (!a.Positional || a.Position == b.Position) && a.Reach == b.Reach && a.Spread == b.Spread &&
    a.Centers.size() == b.Centers.size() && a.Parts.size() == b.Parts.size() &&
    ((a.Positional && !a.IsSpot()) || a.Direction == b.Direction);
}

bool IsSame(const std::vector<vtkRelievoBox>& a, const std::vector<vtkRelievoBox>& b)
{
  return std::equal(
    a.begin(), a.end(), b.begin(), b.end(), [](const vtkRelievoBox& x, const vtkRelievoBox& y) {
      return x.Min == y.Min && x.Max == y.Max && x.Loose == y.Loose;
    });
}

bool IsSame(const vtkRelievoShadowFit::Request& a, const vtkRelievoShadowFit::Request& b)
{
  return a.Size == b.Size && a.Border == b.Border && a.Eye == b.Eye && a.Gaze == b.Gaze &&
    a.ViewUp == b.ViewUp && a.ParallelEye == b.ParallelEye;
}

// The parts of boxes within a cube around the light's sphere.
std::vector<vtkRelievoBox> GetReached(
  const std::vector<vtkRelievoBox>& boxes, const vtkRelievoShadowLight& light)
{
  std::vector<vtkRelievoBox> reached;
  for (vtkRelievoBox box : boxes)
  {
    box.Min = glm::max(box.Min, light.Position - light.Reach);
    box.Max = glm::min(box.Max, light.Position + light.Reach);
    if (glm::all(glm::lessThanEqual(box.Min, box.Max)))
    {
      reached.push_back(box);
    }
  }
  return reached;
}

int Count(const std::vector<Entry>& entries)
{
  int count = 0;
  for (const Entry& entry : entries)
  {
    count += static_cast<int>(entry.Maps.size());
  }
  return count;
}

// Finds a map of an equal view, of any light.
const Map* Find(const std::vector<Entry>& entries, const vtkRelievoShadowView& view)
{
  for (const Entry& entry : entries)
  {
    for (const Map& map : entry.Maps)
    {
      if (map.Drawn && map.View.IsSame(view))
      {
        return &map;
      }
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::Update(const std::vector<vtkRelievoShadowLight>& casting,
  const vtkRelievoShadowScene& scene, const vtkRelievoShadowFitter& fitter)
{
  if (!scene.SameCasters)
  {
    this->Invalidate();
  }
  const bool sameFit = this->Fitted && scene.WorldToNDC == this->Scene.WorldToNDC &&
    IsSame(scene.Request, this->Scene.Request) && IsSame(scene.Casters, this->Scene.Casters) &&
    IsSame(scene.Receivers, this->Scene.Receivers) &&
    std::equal(casting.begin(), casting.end(), this->Entries.begin(), this->Entries.end(),
      [](const vtkRelievoShadowLight& light, const Entry& entry) {
        return IsSame(light, entry.Light);
      });
  if (sameFit)
  {
    for (std::size_t i = 0; i < casting.size(); ++i)
    {
      this->Entries[i].Light = casting[i];
    }
    return;
  }
  this->Fit(casting, scene, fitter);
  this->Scene = scene;
  this->Fitted = true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::Fit(const std::vector<vtkRelievoShadowLight>& casting,
  const vtkRelievoShadowScene& scene, const vtkRelievoShadowFitter& fitter)
{
  const auto visible = vtkRelievoShadowRegion::Cut(scene.Receivers, scene.WorldToNDC);
  const auto all = vtkRelievoShadowRegion::GetFaces(scene.Receivers);
  this->Center = vtkRelievoShadowRegion::GetMiddle(visible);
  std::vector<Entry> before = std::move(this->Entries);
  this->Entries.clear();
  for (const vtkRelievoShadowLight& light : casting)
  {
    Entry entry;
    entry.Light = light;
    if (light.AtEye)
    {
      this->Entries.push_back(entry);
      continue;
    }
    const bool local = light.Reach > 0.0;
    const auto receivers = local ? GetReached(scene.Receivers, light) : scene.Receivers;
    const auto casters = local ? GetReached(scene.Casters, light) : scene.Casters;
    const auto planes = vtkRelievoShadowFit::GetShadowPlanes(light, casters, receivers);
    const auto shaded = vtkRelievoShadowRegion::Clip(
      local ? vtkRelievoShadowRegion::GetFaces(receivers) : all, planes);
    const auto seen = vtkRelievoShadowRegion::Clip(
      local ? vtkRelievoShadowRegion::Cut(receivers, scene.WorldToNDC) : visible, planes);
    entry.Cube = !local && vtkRelievoShadowFit::IsCube(light, shaded);
    const std::vector<vtkRelievoShadowView> views =
      fitter.Fit(light, seen, shaded, casters, scene.Request);
    for (const vtkRelievoShadowView& view : views)
    {
      Map map;
      map.View = view;
      const Map* drawn = Find(before, view);
      entry.Maps.push_back(drawn ? *drawn : map);
    }
    this->Entries.push_back(entry);
  }
  this->AssignLayers(before);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::AssignLayers(const std::vector<Entry>& before)
{
  const int layers = Count(this->Entries);
  const bool lost = layers != Count(before);
  // Two lights with equal views have a map each, of which only one was drawn.
  std::vector<bool> used(layers, false);
  std::vector<Map*> open;
  for (Entry& entry : this->Entries)
  {
    for (Map& map : entry.Maps)
    {
      if (lost || map.Layer < 0 || used[map.Layer])
      {
        map.Drawn = false;
        open.push_back(&map);
        continue;
      }
      used[map.Layer] = true;
    }
  }
  for (Map* map : open)
  {
    map->Layer = static_cast<int>(std::find(used.begin(), used.end(), false) - used.begin());
    used[map->Layer] = true;
  }
}

//------------------------------------------------------------------------------
int vtkRelievoShadowCache::GetNumberOfMaps() const
{
  return Count(this->Entries);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::SetEntries(std::vector<Entry> entries, const glm::dvec3& center)
{
  this->Entries = std::move(entries);
  this->Center = center;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::SetCasters(const vtkRelievoShadowProps& props, bool withoutFollowed)
{
  this->Casters = props.GetState(withoutFollowed);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowCache::HasCasters(
  const vtkRelievoShadowProps& props, bool withoutFollowed) const
{
  return this->Casters == props.GetState(withoutFollowed);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::Invalidate()
{
  for (Entry& entry : this->Entries)
  {
    for (Map& map : entry.Maps)
    {
      map.Drawn = false;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::Clear()
{
  *this = vtkRelievoShadowCache();
}
