// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The resource `shading`: what surfaces are made of, in the place of their lit colour. Shaders
// include gbuffer/read.glsl (relievoFetchSurface, relievoFetchDepth, relievoFetchNormal, and
// relievoFetchVisibility if NumberOfLights is not 0).
#ifndef vtkRelievoShading_h
#define vtkRelievoShading_h

#include "vtkRelievoResource.h"

#include <map>
#include <string>

class VTKRELIEVOFRAME_EXPORT vtkRelievoShading : public vtkRelievoResource
{
public:
  // Why VTK has lit everything after all, in words; empty if it has not.
  std::string WhyNot;

  // Draw calls that VTK has lit by itself, by the reason.
  std::map<std::string, int> Left;

  // Draw calls whose light was left out.
  int Deferred = 0;

  // Of the renderer, those that are off included: as many visibilities are stored.
  int NumberOfLights = 0;
};

#endif
