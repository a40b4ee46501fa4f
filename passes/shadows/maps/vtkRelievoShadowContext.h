// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The data of a frame's shadows, shared by the parts of the stage and its methods.
#ifndef vtkRelievoShadowContext_h
#define vtkRelievoShadowContext_h

#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoMeshExchange.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowProps.h"
#include "vtkRelievoShadowStructure.h"
#include "vtkRelievoVolumeShade.h"

// The casters drawn into all maps of a frame, and settings for drawing.
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
  vtkRelievoFrameCamera SteadyView; // without the sample's offset: maps are fitted to it
  vtkRelievoShadowProps& Props;
  vtkRelievoCasterDraw& PlainDraw;
  bool& DrawingAnyMaps;          // these or others of the same casters
  vtkRelievoMeshExchange Others; // of processes that draw together with this one
  vtkRelievoShadowCache Cache;
  vtkRelievoShadowMaps Maps;
  vtkRelievoShadowStructure Structure;
  vtkRelievoVolumeShade Shade; // of volumes
  int Radius = 1;              // of the filter in texels, limited by the maps' size
  double Bias = 0.0;           // in texels
  // For soft lights' parts, in frames that draw all samples at once: the step between their numbers
  // (vtkRelievoSampleLattice::GetNumberStep); 0, 0 in other frames.
  glm::vec2 PartStep{ 0.f };
  // By which share of the bottom's colour the background's gradient changes up to its top.
  glm::vec3 BackgroundRise{ 0.f };
  glm::dmat4 TileToPicture{ 1.0 }; // a gradient runs through the whole picture
  int MapsDrawn = 0;               // in this frame
  bool DrawingMaps = false;
  bool DrawingDepth = false; // a method is drawing the camera's depth
  bool ColoredShadows = false;
  bool WithoutVolumes = false;  // volumes dim nothing: for certificates
  bool WithoutFollowed = false; // in these maps: the method traces rays at the other casters
  bool OwnSteps = true;         // as in vtkRelievoFrameContext
  bool OnEverything = false;    // shadows fall also on props chosen not to receive any

  // Texels from a map's centre up to which the filter fits.
  float GetInner() const { return 0.5f * (this->Maps.GetSize() - 1) - this->Radius; }
};

#endif
