// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEdgeFilter.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoBoundFramebuffer.h"
#include "vtkRelievoColorBuffers.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"

//------------------------------------------------------------------------------
void vtkRelievoEdgeFilter::Execute(const vtkRelievoFrameContext& context)
{
  const vtkRelievoScopedState kept(context.Window->GetState());
  if (vtkRelievoBoundFramebuffer::GetSamples() > 0)
  {
    this->Resolve(context);
  }
  this->Filter->Execute(static_cast<vtkOpenGLRenderer*>(context.Renderer));
}

//------------------------------------------------------------------------------
// Keeps the framebuffer bound for drawing, and binds its resolved content for reading.
void vtkRelievoEdgeFilter::Resolve(const vtkRelievoFrameContext& context)
{
  const int* v = context.View.Viewport;
  const auto width = static_cast<unsigned int>(v[0] + v[2]);
  const auto height = static_cast<unsigned int>(v[1] + v[3]);
  vtkOpenGLState* state = context.Window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  const auto drawn = static_cast<unsigned int>(vtkRelievoBoundFramebuffer::GetNumber());
  GLint place = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER, &place);
  this->Framebuffer->SetContext(context.Window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  if (!this->Resolved || this->Resolved->GetWidth() != width ||
    this->Resolved->GetHeight() != height)
  {
    if (this->Resolved)
    {
      this->Resolved->ReleaseGraphicsResources(context.Window);
    }
    // Every OpenGL can resolve samples into a texture of their own format.
    this->Resolved = vtkRelievoColorBuffers::MakeTexture(
      context.Window, GL_RGBA8, static_cast<int>(width), static_cast<int>(height));
    this->Framebuffer->AddColorAttachment(0, this->Resolved);
  }
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  GLint read = GL_NONE;
  glGetIntegerv(GL_READ_BUFFER, &read);
  state->vtkglReadBuffer(static_cast<unsigned int>(place));
  state->vtkglDisable(GL_SCISSOR_TEST);
  const int right = v[0] + v[2];
  const int top = v[1] + v[3];
  state->vtkglBlitFramebuffer(
    v[0], v[1], right, top, v[0], v[1], right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state->vtkglReadBuffer(static_cast<unsigned int>(read));
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawn);
  this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  this->Framebuffer->ActivateReadBuffer(0);
}

//------------------------------------------------------------------------------
void vtkRelievoEdgeFilter::Release(vtkWindow* window)
{
  this->Filter->ReleaseGraphicsResources();
  if (this->Resolved)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Resolved->ReleaseGraphicsResources(window);
    this->Resolved = nullptr;
  }
}
