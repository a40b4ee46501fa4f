// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which maps a frame needs, and which of them must be drawn: fits them to the lights that cast, and
// draws those that no frame before drew, together with other processes if there are any.
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

  // Maps of size x size texels, or less if another process makes no larger ones, with a filter of
  // this radius at most. They get a texture unit. Returns why there are none, in words.
  std::string Fit(vtkRelievoShadowContext& work, const std::vector<vtkRelievoShadowLight>& casting,
    const vtkRelievoShadowFitter& fitter, int size, int radius, vtkRenderer* renderer);

  // Returns the draw calls but for those of mappers that draw by themselves.
  int Draw(vtkRelievoShadowContext& work, vtkRenderer* renderer);

  // A mapper's own program draws into a map: VTK gives it lights in a light's eye space.
  void AddProgram(vtkShaderProgram* program) { this->LitForMaps.insert(program); }

private:
  std::set<vtkShaderProgram*> LitForMaps;
};

#endif
