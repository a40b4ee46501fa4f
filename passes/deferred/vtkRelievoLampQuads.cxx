// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLampQuads.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoLampList.h"
#include "vtkRelievoLampShadows.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
std::string vtkRelievoLampQuads::DrawSurfaces(
  vtkRelievoFrameContext& context, vtkRelievoScreenTarget& target)
{
  vtkOpenGLState* state = context.Window->GetState();
  if (!this->Surfaces.Ready(context, "deferred/lampDepthFS.glsl", { "depth" }))
  {
    return this->Surfaces.GetWrong();
  }
  // Depth only: the colour is the sum's.
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->Surfaces.Draw(context, target.GetArea(), true);
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
  vtkRelievoResource* layers = context.Find("depth");
  vtkRelievoResource* normals = context.Find("normal");
  const std::string casting = shadows ? shadows->GetDefines() : std::string();
  std::string vertices = vtkRelievoShaderLibrary::Get("deferred/lampQuadVS.glsl");
  vtkShaderProgram::Substitute(vertices, "//RELIEVO::Defines", casting, false);
  std::string fragments = vtkRelievoShaderLibrary::Get("deferred/lampsFS.glsl");
  vtkShaderProgram::Substitute(fragments, "//RELIEVO::Defines",
    layers->GetDefines() + (normals == layers ? "" : normals->GetDefines()) + defines + casting +
      "#define RELIEVO_LAMP_IN_QUAD\n",
    false);
  vtkShaderProgram* program =
    context.Window->GetShaderCache()->ReadyShaderProgram(vertices.c_str(), fragments.c_str(), "");
  if (!program)
  {
    return "its shader deferred/lampsFS.glsl does not compile; see the errors before";
  }
  const vtkRelievoFrameCamera& view = context.View;
  const float size[2] = { static_cast<float>(view.Viewport[2]),
    static_cast<float>(view.Viewport[3]) };
  glm::mat4 projection = view.GetProjection();
  program->SetUniform2f("relievoSize", size);
  program->SetUniformMatrix4x4("relievoProjection", &projection[0][0]);
  program->SetUniformf("relievoNear", static_cast<float>(view.Near));
  program->SetUniformf("relievoFar", static_cast<float>(view.Far));
  program->SetUniformi("relievoParallel", view.Parallel);
  layers->Activate(program);
  if (normals != layers)
  {
    normals->Activate(program);
  }
  bind(program);
  this->Rectangles.Activate(program, "relievoRectangles");
  if (!this->Nothing)
  {
    this->Nothing = vtkSmartPointer<vtkOpenGLVertexArrayObject>::New();
  }
  this->Nothing->Bind();
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
      glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    shadows->Deactivate();
    draws += lamps;
  }
  else
  {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, lamps);
    ++draws;
  }
  this->Nothing->Release();
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
  if (this->Nothing)
  {
    const vtkRelievoScopedContext context(window);
    this->Nothing->ReleaseGraphicsResources();
    this->Nothing = nullptr;
  }
}
