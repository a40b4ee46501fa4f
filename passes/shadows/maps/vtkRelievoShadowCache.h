// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps that a frame's lights have, and which of them must be drawn anew: only those that no
// frame before drew from the same view, with the same casters. What maps there are is a function of
// the frame alone.
#ifndef vtkRelievoShadowCache_h
#define vtkRelievoShadowCache_h

#include "vtkRelievoShadowFit.h"
#include "vtkRelievoShadowLight.h"

#include <cstdint>
#include <vector>

class vtkRelievoShadowFitter;
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
    bool Cube = false; // another camera may need several maps: shaders keep room for six
  };

  // Fits maps to the casting lights, keeping what is still right.
  void Update(const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowScene& scene,
    const vtkRelievoShadowFitter& fitter);

  // Another fitter may fit otherwise: maps that it has as well are kept.
  void Refit() { this->Fitted = false; }

  std::vector<Entry>& GetEntries() { return this->Entries; }
  const std::vector<Entry>& GetEntries() const { return this->Entries; }
  int GetNumberOfMaps() const;

  // The middle of what is visible of the receivers, in world coordinates.
  const glm::dvec3& GetCenter() const { return this->Center; }

  // Maps that another process fitted, in their layers.
  void SetEntries(std::vector<Entry> entries, const glm::dvec3& center);

  // What casts as the maps are drawn, or what it looks like now without having changed.
  void SetCasters(const vtkRelievoShadowProps& props, bool withoutFollowed);
  bool HasCasters(const vtkRelievoShadowProps& props, bool withoutFollowed) const;

  // What the layers held is lost.
  void Invalidate();
  void Clear();

private:
  void Fit(const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowScene& scene,
    const vtkRelievoShadowFitter& fitter);
  void AssignLayers(const std::vector<Entry>& before);

  std::vector<Entry> Entries;
  std::vector<std::uint64_t> Casters;
  vtkRelievoShadowScene Scene; // that the maps were fitted to
  bool Fitted = false;
  glm::dvec3 Center{ 0.0 };
};

#endif
