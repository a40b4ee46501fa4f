// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Decides which maps a frame needs and which of them must be redrawn: fits them to the casting
// lights, and draws the new ones, together with other processes if there are any.
#ifndef vtkRelievoShadowSchedule_h
#define vtkRelievoShadowSchedule_h

#include "vtkRelievoShadowExchange.h"
#include "vtkRelievoShadowLight.h"

#include <set>
#include <string>
#include <vector>

class vtkRelievoShadowFitter;
class vtkRenderer;
class vtkShaderProgram;
struct vtkRelievoShadowContext;

class vtkRelievoShadowSchedule
{
public:
  vtkRelievoShadowExchange Exchange;

  // Prepares maps of size x size texels, or less if another process has a lower limit, with a
  // filter of at most this radius, and a texture unit. Returns the error, or "".
  std::string Fit(vtkRelievoShadowContext& work, const std::vector<vtkRelievoShadowLight>& casting,
    const vtkRelievoShadowFitter& fitter, int size, int radius, vtkRenderer* renderer);

  // Draws the maps. Returns the draw calls except those of mappers that draw by themselves.
  int Draw(vtkRelievoShadowContext& work, vtkRenderer* renderer);

  // Call when a mapper's own program draws into a map: VTK gives it lights in a light's eye space.
  void AddProgram(vtkShaderProgram* program) { this->LitForMaps.insert(program); }

private:
  std::set<vtkShaderProgram*> LitForMaps;
};

#endif
