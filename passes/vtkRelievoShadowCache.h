// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps that a frame's lights have, and which of them must be drawn anew: only those whose
// light, casters or size changed, or that the camera's view has left.
#ifndef vtkRelievoShadowCache_h
#define vtkRelievoShadowCache_h

#include "vtkRelievoShadowFit.h"
#include "vtkRelievoShadowLight.h"

#include <cstdint>
#include <vector>

class vtkRelievoShadowProps;

class vtkRelievoShadowCache
{
public:
  struct Map
  {
    vtkRelievoShadowView View;
    int Layer = -1;     // of the texture array
    bool Drawn = false; // what the layer holds is this view's
  };
  struct Entry
  {
    vtkRelievoShadowLight Light;
    std::vector<Map> Maps;
    bool Cube = false;  // it has had several maps: shaders keep room for six
    bool Exact = false; // the maps fit the view, with nothing to spare
  };

  // Fits maps to the casting lights, keeping what is still right.
  void Update(const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowProps& props,
    const glm::dmat4& worldToNDC, const vtkRelievoShadowFit::Request& request);

  std::vector<Entry>& GetEntries() { return this->Entries; }
  int GetNumberOfMaps() const;

  // The middle of what the maps are fitted to, in world coordinates.
  glm::dvec3 GetCenter() const;

  // Layers that the maps take: as many as there are maps, or as were needed since lights changed.
  int GetNumberOfLayers() const { return this->Layers; }

  // What cast when the maps were drawn, if it looks otherwise now without having changed.
  void SetCasters(const vtkRelievoShadowProps& props);

  // What the layers held is lost.
  void Invalidate();
  void Clear();

private:
  void Refit(Entry& entry, const vtkRelievoShadowProps& props,
    const std::vector<vtkRelievoShadowRegion::Polygon>& region,
    const vtkRelievoShadowFit::Request& request, bool keep);
  void AssignLayers(bool otherLights);

  std::vector<Entry> Entries;
  std::vector<std::uint64_t> Casters;
  std::vector<vtkRelievoBox> Receivers;
  glm::dmat4 WorldToNDC{ 0.0 };
  vtkRelievoShadowFit::Request Request;
  int Layers = 0;
};

#endif
