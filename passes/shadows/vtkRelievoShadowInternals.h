// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the parts of vtkRelievoShadowPass share: its methods are in several files.
#ifndef vtkRelievoShadowInternals_h
#define vtkRelievoShadowInternals_h

#include "vtkLight.h"
#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoForwardMasks.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowExchange.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowPass.h"
#include "vtkRelievoShadowProps.h"
#include "vtkRelievoShadowSplice.h"
#include "vtkRelievoView.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

class vtkShaderProgram;

class vtkRelievoShadowPass::Internals
{
public:
  std::vector<vtkRelievoShadowLight> Lights;        // all of the renderer, in this frame
  std::vector<vtkRelievoShadowLight> Casting;       // those with a place in the shaders
  std::vector<vtkWeakPointer<vtkLight>> NotCasting; // chosen so
  std::vector<std::pair<vtkWeakPointer<vtkLight>, std::string>> Names; // for reports
  vtkRelievoShadowProps Props;
  vtkRelievoShadowCache Cache;
  vtkRelievoShadowExchange Exchange;
  vtkRelievoShadowMaps Maps;
  vtkRelievoForwardMasks Masks;
  vtkRelievoCasterDraw PlainDraw;
  vtkRelievoShadowSplice::Structure Structure;
  vtkTimeStamp StructureTime;
  vtkRelievoView View;
  int Radius = 1;                               // of the filter, as the maps' size allows
  std::string WithoutShadow;                    // lights that cast none, and why
  bool LayersAsked = false;                     // visibility is asked for as a layer
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the frame
  bool DrawingMaps = false;
  bool DrawingDepth = false;        // that the camera sees, for the masks
  std::set<vtkShaderProgram*> Told; // programs that have this frame's parameters
  std::set<vtkShaderProgram*>
    LitForMaps; // programs that VTK gave its lights in a light's eye space
  std::set<std::string> Said;
  bool Spliced = false;
  bool Strayed = false; // shaders without shadows were built with this pass in their keys

  struct MaskState // what the masks were drawn for
  {
    glm::dmat4 WorldToNDC{ 0.0 };
    std::vector<std::uint64_t> Surfaces;
    std::vector<bool> Culling;
    std::vector<vtkLight*> Lights; // for comparison only
    double Bias = -1.0;
  } MaskState;

  bool IsChosen(vtkLight* light) const
  {
    return std::find(this->NotCasting.begin(), this->NotCasting.end(), light) ==
      this->NotCasting.end();
  }
  std::string GetName(const vtkRelievoShadowLight& light) const
  {
    for (const auto& named : this->Names)
    {
      if (named.first == light.Light)
      {
        return named.second;
      }
    }
    return "light " + std::to_string(light.Number);
  }
};

#endif
