// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The resource `shading`: properties of surfaces in place of their lit colour. Shaders include
// gbuffer/read.glsl (relievoFetchSurface, relievoFetchDepth, relievoFetchNormal, and
// relievoFetchVisibility if NumberOfLights is not 0).
#ifndef vtkRelievoShading_h
#define vtkRelievoShading_h

#include "vtkRelievoResource.h"

#include <map>
#include <string>

class VTKRELIEVOFRAME_EXPORT vtkRelievoShading : public vtkRelievoResource
{
public:
  // The reason why VTK has lit all surfaces; empty if it has not.
  std::string WhyNot;

  // Number of draw calls that VTK has lit, for each reason.
  std::map<std::string, int> Left;

  // Number of draw calls without VTK's light.
  int Deferred = 0;

  // Lights of the renderer, switched-off lights included: one visibility is stored for each.
  int NumberOfLights = 0;
};

#endif
