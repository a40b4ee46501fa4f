// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of a frame's lights, and which of them must be redrawn: only those that no earlier frame
// drew from the same view, with the same casters. The set of maps depends only on the frame.
#ifndef vtkRelievoShadowCache_h
#define vtkRelievoShadowCache_h

#include "vtkRelievoShadowFit.h"
#include "vtkRelievoShadowLight.h"

#include <cstdint>
#include <vector>

class vtkRelievoShadowFitter;
class vtkRelievoShadowProps;

// The scene that maps are fitted to.
struct vtkRelievoShadowScene
{
  std::vector<vtkRelievoBox> Casters;
  std::vector<vtkRelievoBox> Receivers;
  bool SameCasters = false; // as in the drawn maps
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
    bool Drawn = false; // the layer contains this view
  };
  struct Entry
  {
    vtkRelievoShadowLight Light;
    std::vector<Map> Maps;
    bool Cube = false; // another camera may need several maps: shaders reserve six
  };

  // Fits maps to the casting lights, and keeps maps that are still valid.
  void Update(const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowScene& scene,
    const vtkRelievoShadowFitter& fitter);

  // Call after a change of fitter, which may fit differently: equal maps are kept.
  void Refit() { this->Fitted = false; }

  std::vector<Entry>& GetEntries() { return this->Entries; }
  const std::vector<Entry>& GetEntries() const { return this->Entries; }
  int GetNumberOfMaps() const;

  // The centre of the visible parts of the receivers, in world coordinates.
  const glm::dvec3& GetCenter() const { return this->Center; }

  // Sets maps fitted by another process, with their layers.
  void SetEntries(std::vector<Entry> entries, const glm::dvec3& center);

  // State of the casters while the maps are drawn, or the present one if only drawing changed it.
  void SetCasters(const vtkRelievoShadowProps& props, bool withoutFollowed);
  bool HasCasters(const vtkRelievoShadowProps& props, bool withoutFollowed) const;

  // The contents of the layers are lost.
  void Invalidate();
  void Clear();

private:
  void Fit(const std::vector<vtkRelievoShadowLight>& casting, const vtkRelievoShadowScene& scene,
    const vtkRelievoShadowFitter& fitter);
  void AssignLayers(const std::vector<Entry>& before);

  std::vector<Entry> Entries;
  std::vector<std::uint64_t> Casters;
  vtkRelievoShadowScene Scene; // scene to which the maps were fitted
  bool Fitted = false;
  glm::dvec3 Center{ 0.0 };
};

#endif
