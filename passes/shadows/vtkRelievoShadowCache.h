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

// What maps are fitted to.
struct vtkRelievoShadowScene
{
  std::vector<vtkRelievoBox> Casters;
  std::vector<vtkRelievoBox> Receivers;
  bool SameCasters = false; // as when the maps were drawn
  glm::dmat4 WorldToNDC{ 0.0 };
  vtkRelievoShadowFit::Request Request;
};

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
  void Update(
    const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowScene& scene);

  std::vector<Entry>& GetEntries() { return this->Entries; }

  // Maps that another process fitted, in their layers.
  void SetEntries(std::vector<Entry> entries, int layers);
  int GetNumberOfMaps() const;

  // The middle of what the maps are fitted to, in world coordinates.
  glm::dvec3 GetCenter() const;

  // Layers that the maps take: as many as there are maps, or as were needed since lights changed.
  int GetNumberOfLayers() const { return this->Layers; }

  // What casts as the maps are drawn, or what it looks like now without having changed.
  void SetCasters(const vtkRelievoShadowProps& props);
  bool HasCasters(const vtkRelievoShadowProps& props) const;

  // What the layers held is lost.
  void Invalidate();
  void Clear();

private:
  static void Refit(Entry& entry, const vtkRelievoShadowScene& scene,
    const std::vector<vtkRelievoShadowRegion::Polygon>& region, bool keep);
  void AssignLayers(bool otherLights);

  std::vector<Entry> Entries;
  std::vector<std::uint64_t> Casters;
  vtkRelievoShadowScene Scene; // that the maps were fitted to
  int Layers = 0;
};

#endif
