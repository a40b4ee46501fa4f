// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The renderer's lights as the stage uses them: the user's choices, names and visibility layers,
// and which of them cast in a frame.
#ifndef vtkRelievoShadowLights_h
#define vtkRelievoShadowLights_h

#include "vtkLight.h"
#include "vtkRelievoShadowLight.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkRelievoLightSizes;
class vtkRenderer;

class vtkRelievoShadowLights
{
public:
  void SetCasts(vtkLight* light, bool casts);
  bool Casts(vtkLight* light) const;

  void SetName(vtkLight* light, const std::string& name);
  std::string GetName(const vtkRelievoShadowLight& light) const;
  std::string GetName(vtkRenderer* renderer, vtkLight* light) const;

  // The layer of a light's visibility (vtkRelievoShadowStage::GetLightLayer), the layers of all
  // lights that cast by the user's choice (see Collect), and the indices of the lights with a layer
  // among `layers`.
  std::string GetLayer(vtkRenderer* renderer, vtkLight* light) const;
  std::vector<std::string> GetLayers(
    vtkRenderer* renderer, const vtkRelievoLightSizes* sizes = nullptr) const;
  std::map<std::string, int> Find(
    const std::vector<std::string>& layers, vtkRenderer* renderer) const;

  // Selects the casting lights of this frame, limited by the number of maps. Suns at the eye cast
  // where they have one of these sizes, if any are given. With `separates`, where the picture tells
  // casting lights from others, other lights at the eye count as casting lights, without maps: a
  // light that moves to the eye must not become one of those.
  void Collect(vtkRenderer* renderer, int mostMaps, const vtkRelievoLightSizes* sizes = nullptr,
    bool separates = false);
  std::vector<int> GetNumbers() const; // of the casting lights
  void KeepOnly(const std::vector<int>& numbers);
  // Moves the casting lights to the positions of a sample.
  void Move(const vtkRelievoLightSizes& sizes, int sample, int samples);

  // Splits casting suns with a size into parts, which share up to this number of maps each, or
  // fewer if all lights together would need more than `most`. Returns whether there are any.
  bool Divide(const vtkRelievoLightSizes& sizes, int parts, int maps, int most);

  // Lights that may cast and have a size: positional ones, or suns.
  int CountSized(vtkRenderer* renderer, const vtkRelievoLightSizes& sizes, bool positional) const;

  const std::vector<vtkRelievoShadowLight>& GetAll() const { return this->All; }
  const std::vector<vtkRelievoShadowLight>& GetCasting() const { return this->Casting; }
  // The casting lights at their own positions, for any sample.
  const std::vector<vtkRelievoShadowLight>& GetUnmoved() const
  {
    return this->Unmoved.empty() ? this->Casting : this->Unmoved;
  }
  void Clear()
  {
    this->Casting.clear();
    this->Unmoved.clear();
  }

  // In words: the number and the names of the casting lights.
  std::string GetCastingReport() const;

  // The other lights, as a part of a sentence: "; NAME casts none: WHY".
  std::string GetReport() const;

private:
  std::vector<vtkWeakPointer<vtkLight>> NotCasting; // chosen not to cast
  std::vector<std::pair<vtkWeakPointer<vtkLight>, std::string>> Names;
  std::vector<vtkRelievoShadowLight> All;
  std::vector<vtkRelievoShadowLight> Casting; // lights with an index in the shaders
  std::vector<vtkRelievoShadowLight> Unmoved; // before Move; empty without it
};

#endif
