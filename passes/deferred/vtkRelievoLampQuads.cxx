// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampQuads.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoLampList.h"
#include "vtkRelievoLampShadows.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
std::string vtkRelievoLampQuads::DrawSurfaces(
  vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target)
{
  vtkOpenGLState* state = context.Window->GetState();
  if (!this->Surfaces.Ready(context, "deferred/lampDepthFS.glsl", { vtkRelievoResources::Depth }))
  {
    return this->Surfaces.GetError();
  }
  // Depth only: the colour holds the sum.
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->Surfaces.Draw(context, target.GetArea(), vtkRelievoScreenQuad::WRITES_DEPTH);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoLampQuads::Draw(vtkRelievoFrameContext& context,
  const vtkRelievoLampList& list, const std::string& defines,
  const std::function<void(vtkShaderProgram*)>& bind, vtkRelievoLampShadows* shadows, int& draws)
{
  std::vector<float> rectangles;
  rectangles.reserve(4 * list.GetLamps().size());
  for (const vtkRelievoLampList::Lamp& lamp : list.GetLamps())
  {
    rectangles.insert(rectangles.end(), lamp.Rectangle, lamp.Rectangle + 4);
  }
  const std::string tooMany = this->Rectangles.Upload(context.Window, rectangles, 4);
  if (!tooMany.empty())
  {
    return tooMany;
  }
  vtkRelievoResource* layers = context.Find(vtkRelievoResources::Depth);
  vtkRelievoResource* normals = context.Find(vtkRelievoResources::Normal);
  vtkShaderProgram* program =
    this->Lamps.Ready(context, "deferred/lampQuadVS.glsl", "deferred/lampsFS.glsl",
      layers->GetDefines() + (normals == layers ? "" : normals->GetDefines()) + defines +
        (shadows ? shadows->GetDefines() : std::string()) + "#define RELIEVO_LAMP_IN_QUAD\n");
  if (!program)
  {
    return this->Lamps.GetError();
  }
  layers->Activate(program);
  if (normals != layers)
  {
    normals->Activate(program);
  }
  bind(program);
  this->Rectangles.Activate(program, "relievoRectangles");
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  const auto lamps = static_cast<int>(list.GetLamps().size());
  if (shadows)
  {
    shadows->Activate(program);
    for (int lamp = 0; lamp < lamps; ++lamp)
    {
      program->SetUniformi("relievoCastingLamp", lamp);
      shadows->SetLamp(program, lamp);
      this->Lamps.Draw(1);
    }
    shadows->Deactivate();
    draws += lamps;
  }
  else
  {
    this->Lamps.Draw(lamps);
    ++draws;
  }
  this->Rectangles.Deactivate();
  if (normals != layers)
  {
    normals->Deactivate();
  }
  layers->Deactivate();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoLampQuads::Release(vtkWindow* window)
{
  this->Surfaces.Release(window);
  this->Rectangles.Release(window);
  this->Lamps.Release(window);
}
