// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a frame's shadows are made of: what the parts of the stage and its methods work on.
#ifndef vtkRelievoShadowContext_h
#define vtkRelievoShadowContext_h

#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoMeshExchange.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowProps.h"
#include "vtkRelievoShadowStructure.h"

// What is drawn into all maps of a frame, and how.
struct vtkRelievoShadowCasters
{
  vtkRelievoShadowProps Props;
  vtkRelievoCasterDraw PlainDraw;
  bool DrawingMaps = false;
};

struct vtkRelievoShadowContext
{
  explicit vtkRelievoShadowContext(vtkRelievoShadowCasters& casters)
    : Props(casters.Props)
    , PlainDraw(casters.PlainDraw)
    , DrawingAnyMaps(casters.DrawingMaps)
  {
  }

  vtkRelievoFrameCamera View;       // the camera's
  vtkRelievoFrameCamera SteadyView; // without the sample's offset: what maps are fitted to
  vtkRelievoShadowProps& Props;
  vtkRelievoCasterDraw& PlainDraw;
  bool& DrawingAnyMaps;          // these or others of the same casters
  vtkRelievoMeshExchange Others; // that draw together with this process
  vtkRelievoShadowCache Cache;
  vtkRelievoShadowMaps Maps;
  vtkRelievoShadowStructure Structure;
  int Radius = 1;    // of the filter in texels, as the maps' size allows
  double Bias = 0.0; // in texels
  // Of soft lights' parts, in frames that draw all samples at once: the step of their numbers
  // (vtkRelievoSampleLattice::GetNumberStep); 0, 0 in others.
  glm::vec2 PartStep{ 0.f };
  int MapsDrawn = 0; // anew, in this frame
  bool DrawingMaps = false;
  bool DrawingDepth = false; // that the camera sees, for a method
  bool ColoredShadows = false;
  bool WithoutFollowed = false; // in these maps: the method sends rays past what can be followed
  bool OwnSteps = true;         // the renderer draws the picture without a pass of its own
  bool OnEverything = false;    // shadows fall also on what was chosen not to receive any

  // Texels from a map's middle to where the filter no longer has room.
  float GetInner() const { return 0.5f * (this->Maps.GetSize() - 1) - this->Radius; }
};

#endif
