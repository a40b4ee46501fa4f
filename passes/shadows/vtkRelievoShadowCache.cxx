// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCache.h"

#include "vtkRelievoShadowProps.h"

#include <algorithm>
#include <cmath>

namespace
{
// A map is kept while it is at most this many times as large as one that fits the view; texels are
// up to the root of it wider then.
constexpr double LargestSlack = 1.5;
// A moving view gets a map with this share of its size to spare on each side, so that the next
// views are in it as well.
constexpr double MovingMargin = 0.1;

bool IsSame(const vtkRelievoShadowLight& a, const vtkRelievoShadowLight& b)
{
  return a.Light == b.Light && a.Positional == b.Positional && a.IsSpot() == b.IsSpot() &&
    (!a.IsSpot() || a.ConeAngle == b.ConeAngle) && (!a.Positional || a.Position == b.Position) &&
    ((a.Positional && !a.IsSpot()) || a.Direction == b.Direction);
}

// Whether the texels are spent about as the view asks.
bool IsNear(const vtkRelievoMapAxis& a, const vtkRelievoMapAxis& b)
{
  return a.Pieces == b.Pieces && std::abs(a.Focus - b.Focus) <= 0.1 &&
    a.Ratio <= LargestSlack * b.Ratio && b.Ratio <= LargestSlack * a.Ratio;
}

bool IsSame(const std::vector<vtkRelievoBox>& a, const std::vector<vtkRelievoBox>& b)
{
  return std::equal(
    a.begin(), a.end(), b.begin(), b.end(), [](const vtkRelievoBox& x, const vtkRelievoBox& y) {
      return x.Min == y.Min && x.Max == y.Max;
    });
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::Update(
  const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowScene& scene)
{
  const vtkRelievoShadowFit::Request& request = scene.Request;
  const vtkRelievoShadowFit::Request& before = this->Scene.Request;
  const bool sameRequest =
    request.Size == before.Size && request.Border == before.Border && request.Warp == before.Warp;
  const bool sameView =
    scene.WorldToNDC == this->Scene.WorldToNDC && IsSame(scene.Receivers, this->Scene.Receivers);
  std::vector<Entry> entries;
  std::vector<vtkRelievoShadowRegion::Polygon> region;
  bool cut = false;
  bool otherLights = casting.size() != this->Entries.size();
  for (const vtkRelievoShadowLight& light : casting)
  {
    auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
      [&light](const Entry& entry) { return entry.Light.Light == light.Light; });
    Entry entry;
    bool sameLight = false;
    if (found != this->Entries.end())
    {
      sameLight = IsSame(found->Light, light);
      entry = std::move(*found);
      this->Entries.erase(found);
    }
    else
    {
      otherLights = true;
    }
    entry.Light = light;
    const bool sameMap = sameLight && scene.SameCasters && sameRequest;
    // A view that stands still gets maps that fit it.
    if (!sameMap || !sameView || !entry.Exact)
    {
      if (!cut)
      {
        region = vtkRelievoShadowRegion::Cut(scene.Receivers, scene.WorldToNDC);
        cut = true;
      }
      Refit(entry, scene, region, sameMap && !sameView);
      entry.Cube = entry.Cube || entry.Maps.size() > 1;
    }
    entries.push_back(std::move(entry));
  }
  this->Entries = std::move(entries);
  this->Scene = scene;
  this->AssignLayers(otherLights);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::Refit(Entry& entry, const vtkRelievoShadowScene& scene,
  const std::vector<vtkRelievoShadowRegion::Polygon>& region, bool keep)
{
  const vtkRelievoShadowFit::Request& request = scene.Request;
  std::vector<vtkRelievoShadowView> views =
    vtkRelievoShadowFit::Fit(entry.Light, region, scene.Casters, request);
  entry.Exact = !keep;
  if (keep)
  {
    const bool kept = views.size() == entry.Maps.size() &&
      std::equal(views.begin(), views.end(), entry.Maps.begin(),
        [&request](const vtkRelievoShadowView& view, const Map& map) {
          return view.Side == map.View.Side && IsNear(view.U, map.View.U) &&
            map.View.Width * map.View.Height <= LargestSlack * view.Width * view.Height &&
            map.View.Contains(view.Points, request.Size, request.Border);
        });
    if (kept)
    {
      return;
    }
    vtkRelievoShadowFit::Request wider = request;
    wider.Margin = MovingMargin;
    views = vtkRelievoShadowFit::Fit(entry.Light, region, scene.Casters, wider);
  }
  // Layers stay with the light: they are drawn over.
  std::vector<Map> maps(views.size());
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    maps[i].View = std::move(views[i]);
    maps[i].Layer = i < entry.Maps.size() ? entry.Maps[i].Layer : -1;
  }
  entry.Maps = std::move(maps);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::AssignLayers(bool otherLights)
{
  const int needed = this->GetNumberOfMaps();
  const int layers = otherLights ? needed : std::max(needed, this->Layers);
  if (layers != this->Layers)
  {
    this->Layers = layers;
    this->Invalidate();
    int next = 0;
    for (Entry& entry : this->Entries)
    {
      for (Map& map : entry.Maps)
      {
        map.Layer = next++;
      }
    }
    return;
  }
  std::vector<bool> used(layers, false);
  for (Entry& entry : this->Entries)
  {
    for (Map& map : entry.Maps)
    {
      if (map.Layer >= 0)
      {
        used[map.Layer] = true;
      }
    }
  }
  for (Entry& entry : this->Entries)
  {
    for (Map& map : entry.Maps)
    {
      if (map.Layer < 0)
      {
        map.Layer = static_cast<int>(std::find(used.begin(), used.end(), false) - used.begin());
        used[map.Layer] = true;
      }
    }
  }
}

//------------------------------------------------------------------------------
int vtkRelievoShadowCache::GetNumberOfMaps() const
{
  int count = 0;
  for (const Entry& entry : this->Entries)
  {
    count += static_cast<int>(entry.Maps.size());
  }
  return count;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoShadowCache::GetCenter() const
{
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const Entry& entry : this->Entries)
  {
    for (const Map& map : entry.Maps)
    {
      for (const glm::dvec3& point : map.View.Points)
      {
        low = glm::min(low, point);
        high = glm::max(high, point);
      }
    }
  }
  return low.x <= high.x ? 0.5 * (low + high) : glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::SetEntries(std::vector<Entry> entries, int layers)
{
  this->Entries = std::move(entries);
  this->Layers = layers;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCache::SetCasters(const vtkRelievoShadowProps& props)
{
  this->Casters = props.GetState();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowCache::HasCasters(const vtkRelievoShadowProps& props) const
{
  return this->Casters == props.GetState();
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
