// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a frame draws: its props with what each draws with a mapper, and the renderer's lights as
// VTK's shaders count them.
#ifndef vtkRelievoFrameScene_h
#define vtkRelievoFrameScene_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoPropParts.h"

#include <vector>

class vtkLight;
class vtkProp;
class vtkRenderState;
class vtkRenderer;

struct vtkRelievoFrameProp
{
  vtkProp* Prop;
  std::vector<vtkRelievoPropParts::Part> Parts;
};

struct vtkRelievoFrameLight
{
  vtkLight* Light;
  int Number;      // place in vtkRenderer::GetLights()
  int ShaderIndex; // as in VTK's lightColor0; -1 if it is off
};

struct VTKRELIEVOFRAME_EXPORT vtkRelievoFrameScene
{
  std::vector<vtkRelievoFrameProp> Props; // in the order in which they are drawn

  void Take(const vtkRenderState* s);

  // As they are now: VTK makes one while it draws a renderer that has none.
  static std::vector<vtkRelievoFrameLight> FindLights(vtkRenderer* renderer);
};

#endif
