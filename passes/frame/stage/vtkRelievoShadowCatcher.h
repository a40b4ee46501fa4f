// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadow catchers: translucent props that have their ambient colour wherever all light reaches
// them, whatever the lights are, and show shadows of occluders: the stages `shadows` and `ambient`
// darken them, and `lamps` lights them in any case. Over a gradient, the colour changes with the
// background's: one in the colour of its bottom is invisible where it is lit.
#ifndef vtkRelievoShadowCatcher_h
#define vtkRelievoShadowCatcher_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <glm/vec3.hpp>

#include <vector>

class vtkPolyDataMapper;
class vtkProp;
class vtkRelievoFrameContext;
class vtkRenderer;

struct VTKRELIEVOFRAME_EXPORT vtkRelievoShadowCatcher
{
  // Marks a prop as a shadow catcher, before it is drawn for the first time.
  static void Make(vtkProp* prop);
  static bool Is(vtkProp* prop);

  // The name of an array of points, four floats each: the displayed colour where all light reaches
  // them, 0 to 1, and the share of the sky that is hidden from them. With shadows a catcher has
  // these colours, darker by the hidden sky's light, in place of VTK's; its mapper passes them to
  // the shaders.
  static const char* GetColorsName();
  static void MapColors(vtkPolyDataMapper* mapper);
  static bool HasColors(vtkPolyDataMapper* mapper);

  // By which share of its bottom's colour a renderer's background changes up to its top.
  static glm::vec3 GetRise(vtkRenderer* renderer);

  // The shadow catchers of the frame.
  static std::vector<vtkProp*> Find(const vtkRelievoFrameContext& context);
};

#endif
