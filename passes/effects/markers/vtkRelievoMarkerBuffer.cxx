// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkerBuffer.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoMarkerList.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkRelievoMarkerBuffer::vtkRelievoMarkerBuffer()
  : Target("markersOver")
{
}

//------------------------------------------------------------------------------
vtkRelievoMarkerBuffer::~vtkRelievoMarkerBuffer() = default;

//------------------------------------------------------------------------------
std::string vtkRelievoMarkerBuffer::Compile(
  vtkRelievoFrameContext& context, const std::string& defines)
{
  vtkOpenGLShaderCache* cache = context.Window->GetShaderCache();
  if (this->Key != defines)
  {
    std::string text = vtkRelievoShaderLibrary::Get("marker/markerFS.glsl");
    vtkShaderProgram::Substitute(text, "//RELIEVO::Defines", defines, false);
    this->Key = defines;
    this->Program = cache->ReadyShaderProgram(
      vtkRelievoShaderLibrary::Get("marker/markerVS.glsl").c_str(), text.c_str(), "");
  }
  else if (this->Program)
  {
    this->Program = cache->ReadyShaderProgram(this->Program);
  }
  return this->Program ? std::string()
                       : "its shader marker/markerFS.glsl does not compile; see the errors before";
}

//------------------------------------------------------------------------------
std::string vtkRelievoMarkerBuffer::Draw(
  vtkRelievoFrameContext& context, const vtkRelievoMarkerList& list)
{
  vtkRelievoScreenTarget::Format format;
  format.Halves = false;
  std::string wrong = this->Target.Prepare(context, format);
  const int count = list.GetNumberDrawn();
  vtkRelievoResource* depth = context.Find("depth");
  vtkRelievoResource* normal = list.GetShadows() ? context.Find("normal") : depth;
  if (wrong.empty() && count > 0 && (!depth || !normal))
  {
    wrong = std::string("the frame has made no '") + (depth ? "normal" : "depth") + "'";
  }
  if (wrong.empty() && count > 0)
  {
    wrong = this->Markers.Upload(context.Window, list.GetTexels(), 4);
  }
  if (wrong.empty() && count > 0)
  {
    wrong = this->Compile(context,
      depth->GetDefines() + (normal == depth ? "" : normal->GetDefines()) +
        (list.GetShadows() ? "#define RELIEVO_MARKER_SHADOWS\n" : ""));
  }
  if (!wrong.empty())
  {
    return wrong;
  }
  this->Target.Begin(context);
  if (count > 0)
  {
    depth->Activate(this->Program);
    if (normal != depth)
    {
      normal->Activate(this->Program);
    }
    this->DrawAll(context, count);
    if (normal != depth)
    {
      normal->Deactivate();
    }
    depth->Deactivate();
  }
  this->Target.End();
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoMarkerBuffer::DrawAll(vtkRelievoFrameContext& context, int count)
{
  const vtkRelievoFrameCamera& view = context.View;
  const vtkRelievoSphereRays rays(view);
  const float size[2] = { static_cast<float>(view.Viewport[2]),
    static_cast<float>(view.Viewport[3]) };
  const glm::vec2 direction(rays.GetDirection(glm::dvec2(0.0)));
  const glm::mat2 directions(rays.GetDirections());
  const float first[2] = { direction.x, direction.y };
  const float step[4] = { directions[0].x, directions[0].y, directions[1].x, directions[1].y };
  this->Program->SetUniform2f("relievoSize", size);
  this->Program->SetUniformf("relievoNear", static_cast<float>(view.Near));
  this->Program->SetUniformf("relievoFar", static_cast<float>(view.Far));
  this->Program->SetUniformi("relievoParallel", view.Parallel);
  this->Program->SetUniform2f("markerDirection", first);
  this->Program->SetUniform4f("markerDirectionStep", step);
  this->Markers.Activate(this->Program, "markers");
  if (!this->Arrays)
  {
    glGenVertexArrays(1, &this->Arrays);
  }
  glBindVertexArray(this->Arrays);
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
  glBindVertexArray(0);
  this->Markers.Deactivate();
}

//------------------------------------------------------------------------------
void vtkRelievoMarkerBuffer::Release(vtkWindow* window)
{
  if (this->Arrays && window)
  {
    const vtkRelievoScopedContext context(window);
    glDeleteVertexArrays(1, &this->Arrays);
  }
  this->Arrays = 0;
  this->Program = nullptr;
  this->Key.clear();
  this->Target.Release(window);
  this->Markers.Release(window);
}
