// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a frame's shadows are made of: what the parts of the stage and its methods work on.
#ifndef vtkRelievoShadowWork_h
#define vtkRelievoShadowWork_h

#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoShadowCache.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowProps.h"
#include "vtkRelievoShadowSplice.h"
#include "vtkRelievoView.h"

struct vtkRelievoShadowWork
{
  vtkRelievoView View; // the camera's
  vtkRelievoShadowProps Props;
  vtkRelievoShadowCache Cache;
  vtkRelievoShadowMaps Maps;
  vtkRelievoCasterDraw PlainDraw;
  vtkRelievoShadowSplice::Structure Structure;
  int Radius = 1;    // of the filter in texels, as the maps' size allows
  double Bias = 0.0; // in texels
  int MapsDrawn = 0; // anew, in this frame
  bool DrawingMaps = false;
  bool DrawingDepth = false; // that the camera sees, for a method
};

#endif
