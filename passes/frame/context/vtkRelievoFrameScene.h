// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The content of a frame: its props with the actors that draw by a mapper, and the renderer's
// lights in the numbering of VTK's shaders.
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
  int Number = -1; // index in vtkRenderer::GetViewProps(); -1 in a frame's scene
  std::vector<vtkRelievoPropParts::Part> Parts;
};

struct vtkRelievoFrameLight
{
  vtkLight* Light;
  int Number;      // index in vtkRenderer::GetLights()
  int ShaderIndex; // number in VTK's lightColor0; -1 if it is off
};

struct VTKRELIEVOFRAME_EXPORT vtkRelievoFrameScene
{
  std::vector<vtkRelievoFrameProp> Props; // in drawing order

  void Take(const vtkRenderState* s);

  // Keeps only the props that VTK draws for the renderer's present camera, in VTK's order, as
  // vtkRenderer::Render does before a frame.
  void Cull(vtkRenderer* renderer);

  // All visible props of the renderer, in its order, those outside the view included, since their
  // shadows may be visible. Actors are those of the present moment: drawing may choose another
  // level of detail.
  static std::vector<vtkRelievoFrameProp> FindVisible(vtkRenderer* renderer);

  // The renderer's present lights: VTK adds one while it draws a renderer without lights.
  static std::vector<vtkRelievoFrameLight> FindLights(vtkRenderer* renderer);
};

#endif
