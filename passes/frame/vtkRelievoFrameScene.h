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
  vtkProp* Prop = nullptr;
  int Number = -1; // place in vtkRenderer::GetViewProps(); -1 in what a frame draws
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

  // What the renderer's visible props draw, in its order: those outside the view, too, whose
  // shadows may be seen. What they draw is as of now: drawing may choose another level of detail.
  static std::vector<vtkRelievoFrameProp> FindVisible(vtkRenderer* renderer);

  // The renderer's lights now: VTK makes one while it draws a renderer that has none.
  static std::vector<vtkRelievoFrameLight> FindLights(vtkRenderer* renderer);
};

#endif
