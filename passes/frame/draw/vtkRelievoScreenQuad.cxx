// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoScreenQuad.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoResource.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkRelievoScreenQuad::vtkRelievoScreenQuad() = default;

//------------------------------------------------------------------------------
vtkRelievoScreenQuad::~vtkRelievoScreenQuad() = default;

//------------------------------------------------------------------------------
vtkShaderProgram* vtkRelievoScreenQuad::Ready(vtkRelievoFrameContext& context,
  const std::string& source, const std::vector<vtkRelievoResourceName>& reads,
  const std::string& defines)
{
  this->Error.clear();
  this->Resources.clear();
  std::string all;
  for (const vtkRelievoResourceName& name : reads)
  {
    vtkRelievoResource* resource = context.Find(name);
    if (!resource)
    {
      this->Error = "the frame has no resource '" + name.Get() + "'";
      return nullptr;
    }
    auto& known = this->Resources;
    if (std::find(known.begin(), known.end(), resource) == known.end())
    {
      known.push_back(resource);
      all += resource->GetDefines();
    }
  }
  all += defines;
  const std::string key = source + "\n" + all;
  if (this->Key != key)
  {
    this->Key = key;
    this->Quad.reset();
    const std::string quad = vtkRelievoShaderLibrary::Get("screen/quadVS.glsl");
    std::string text = vtkRelievoShaderLibrary::Get(source);
    vtkShaderProgram::Substitute(text, "//RELIEVO::Defines", all, false);
    // VTK's helper assumes that its shaders compile.
    if (context.Window->GetShaderCache()->ReadyShaderProgram(quad.c_str(), text.c_str(), ""))
    {
      this->Quad.reset(new vtkOpenGLQuadHelper(context.Window, quad.c_str(), text.c_str(), ""));
    }
  }
  if (!this->Quad)
  {
    this->Error = "its shader " + source + " does not compile; see the errors before";
    return nullptr;
  }
  context.Window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  return this->Quad->Program;
}

//------------------------------------------------------------------------------
void vtkRelievoScreenQuad::Draw(
  vtkRelievoFrameContext& context, const int* viewport, DepthUse depth, const int* part)
{
  vtkShaderProgram* program = this->Quad->Program;
  // Another quad may have made its program current.
  context.Window->GetShaderCache()->ReadyShaderProgram(program);
  const vtkRelievoFrameCamera& view = context.View;
  const int* area = viewport ? viewport : view.Viewport;
  const float size[2] = { static_cast<float>(view.Viewport[2]),
    static_cast<float>(view.Viewport[3]) };
  glm::mat4 projection = view.GetProjection();
  glm::mat4 viewToWorld = view.GetViewToWorld();
  program->SetUniform2f("relievoSize", size);
  program->SetUniformf("relievoNear", static_cast<float>(view.Near));
  program->SetUniformf("relievoFar", static_cast<float>(view.Far));
  program->SetUniformi("relievoParallel", view.Parallel);
  program->SetUniformMatrix4x4("relievoProjection", &projection[0][0]);
  program->SetUniformMatrix4x4("relievoViewToWorld", &viewToWorld[0][0]);
  for (vtkRelievoResource* resource : this->Resources)
  {
    resource->Activate(program);
  }
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->vtkglViewport(area[0], area[1], area[2], area[3]);
  const int* drawn = part ? part : area;
  state->vtkglScissor(drawn[0], drawn[1], drawn[2], drawn[3]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  // OpenGL writes depth only with the depth test enabled.
  state->SetEnumState(GL_DEPTH_TEST, depth != NO_DEPTH);
  state->vtkglDepthFunc(depth == WRITES_DEPTH ? GL_ALWAYS
      : depth == WHERE_DRAWN                  ? GL_GREATER
                                              : GL_LEQUAL);
  state->vtkglDepthMask(depth == WRITES_DEPTH ? GL_TRUE : GL_FALSE);
  this->Quad->Render();
  for (vtkRelievoResource* resource : this->Resources)
  {
    resource->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoScreenQuad::Release(vtkWindow* window)
{
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Key.clear();
  this->Resources.clear();
}
