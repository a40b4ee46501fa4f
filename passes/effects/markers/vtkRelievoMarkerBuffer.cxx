// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkerBuffer.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoMarkerList.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkRelievoMarkerBuffer::vtkRelievoMarkerBuffer()
  : Target("markersOver")
{
}

//------------------------------------------------------------------------------
vtkRelievoMarkerBuffer::~vtkRelievoMarkerBuffer() = default;

//------------------------------------------------------------------------------
std::string vtkRelievoMarkerBuffer::Draw(
  vtkRelievoFrameContext& context, const vtkRelievoMarkerList& list)
{
  vtkRelievoScreenTarget::Format format;
  format.Halves = false;
  std::string error = this->Target.Prepare(context, format);
  const int count = list.GetNumberDrawn();
  vtkRelievoResource* depth = context.Find(vtkRelievoResources::Depth);
  vtkRelievoResource* normal =
    list.GetShadows() ? context.Find(vtkRelievoResources::Normal) : depth;
  if (error.empty() && count > 0 && (!depth || !normal))
  {
    error = std::string("the frame has no layer '") + (depth ? "normal" : "depth") + "'";
  }
  if (error.empty() && count > 0)
  {
    error = this->Markers.Upload(context.Window, list.GetTexels(), 4);
  }
  vtkShaderProgram* program = nullptr;
  if (error.empty() && count > 0)
  {
    program = this->Quads.Ready(context, "marker/markerVS.glsl", "marker/markerFS.glsl",
      depth->GetDefines() + (normal == depth ? "" : normal->GetDefines()) +
        (list.GetShadows() ? "#define RELIEVO_MARKER_SHADOWS\n" : ""));
    error = this->Quads.GetError();
  }
  if (!error.empty())
  {
    return error;
  }
  this->Target.Begin(context);
  if (count > 0)
  {
    depth->Activate(program);
    if (normal != depth)
    {
      normal->Activate(program);
    }
    this->DrawAll(context, program, count);
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
void vtkRelievoMarkerBuffer::DrawAll(
  vtkRelievoFrameContext& context, vtkShaderProgram* program, int count)
{
  const vtkRelievoSphereRays rays(context.View);
  const glm::vec2 direction(rays.GetDirection(glm::dvec2(0.0)));
  const glm::mat2 directions(rays.GetDirections());
  const float first[2] = { direction.x, direction.y };
  const float step[4] = { directions[0].x, directions[0].y, directions[1].x, directions[1].y };
  program->SetUniform2f("markerDirection", first);
  program->SetUniform4f("markerDirectionStep", step);
  this->Markers.Activate(program, "markers");
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->Quads.Draw(count);
  this->Markers.Deactivate();
}

//------------------------------------------------------------------------------
void vtkRelievoMarkerBuffer::Release(vtkWindow* window)
{
  this->Quads.Release(window);
  this->Target.Release(window);
  this->Markers.Release(window);
}
