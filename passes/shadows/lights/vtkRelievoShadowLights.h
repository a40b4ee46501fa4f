// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lights of a renderer as the stage sees them: what was chosen for each, what it is called,
// which layer has its visibility, and which of them cast in a frame.
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
  // lights that cast by what was chosen, and the indices of the lights whose layers are among
  // `layers`.
  std::string GetLayer(vtkRenderer* renderer, vtkLight* light) const;
  std::vector<std::string> GetLayers(vtkRenderer* renderer) const;
  std::map<std::string, int> Find(
    const std::vector<std::string>& layers, vtkRenderer* renderer) const;

  // Decides which lights cast in this frame, with so many maps at most.
  void Collect(vtkRenderer* renderer, int mostMaps);
  std::vector<int> GetNumbers() const; // of those that cast
  void KeepOnly(const std::vector<int>& numbers);
  // Those that cast, to where a sample of so many casts its shadow from.
  void Move(const vtkRelievoLightSizes& sizes, int sample, int samples);

  // Suns that cast and have a size, into so many parts, which are looked up in so many maps each,
  // or fewer, if all lights would have more than `most`. Returns whether there are any.
  bool Divide(const vtkRelievoLightSizes& sizes, int parts, int maps, int most);

  // Lights that may cast and are more than points: those with a position, or suns.
  int CountSized(vtkRenderer* renderer, const vtkRelievoLightSizes& sizes, bool positional) const;

  const std::vector<vtkRelievoShadowLight>& GetAll() const { return this->All; }
  const std::vector<vtkRelievoShadowLight>& GetCasting() const { return this->Casting; }
  // These, where they are by themselves, whatever sample of them is drawn.
  const std::vector<vtkRelievoShadowLight>& GetUnmoved() const
  {
    return this->Unmoved.empty() ? this->Casting : this->Unmoved;
  }
  void Clear()
  {
    this->Casting.clear();
    this->Unmoved.clear();
  }

  // In words: how many lights cast, and their names.
  std::string GetCastingReport() const;

  // Of the others, as a part of a sentence: "; NAME casts none: WHY".
  std::string GetReport() const;

private:
  std::vector<vtkWeakPointer<vtkLight>> NotCasting; // chosen so
  std::vector<std::pair<vtkWeakPointer<vtkLight>, std::string>> Names;
  std::vector<vtkRelievoShadowLight> All;
  std::vector<vtkRelievoShadowLight> Casting; // those with a place in the shaders
  std::vector<vtkRelievoShadowLight> Unmoved; // before Move; empty if there was none
};

#endif
