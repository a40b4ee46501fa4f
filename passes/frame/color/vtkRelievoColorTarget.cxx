// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColorTarget.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <utility>

//------------------------------------------------------------------------------
class vtkRelievoColorTarget::Input : public vtkRelievoResource
{
public:
  vtkRelievoColorTarget* Target = nullptr;
  int Offset[2] = { 0, 0 };

  void Activate(vtkShaderProgram* program) override
  {
    this->Target->Buffers.Color->Activate();
    this->Target->Buffers.Depth->Activate();
    program->SetUniformi("relievoDrawn", this->Target->Buffers.Color->GetTextureUnit());
    program->SetUniformi("relievoDrawnZ", this->Target->Buffers.Depth->GetTextureUnit());
    program->SetUniform2i("relievoDrawnOffset", this->Offset);
  }
  void Deactivate() override
  {
    this->Target->Buffers.Color->Deactivate();
    this->Target->Buffers.Depth->Deactivate();
  }
};

//------------------------------------------------------------------------------
vtkRelievoColorTarget::vtkRelievoColorTarget()
  : Drawn(new Input)
{
  this->Drawn->Target = this;
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::~vtkRelievoColorTarget()
{
  this->Release(this->Buffers.Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::Prepare(vtkRelievoFrameContext& context)
{
  this->Valid = false;
  vtkRenderer* renderer = context.Renderer;
  if (context.Picture && (renderer->GetPreserveDepthBuffer() || !renderer->GetErase()))
  {
    return renderer->GetErase()
      ? "the renderer keeps another renderer's depth (PreserveDepthBuffer)"
      : "the renderer keeps what was drawn before (EraseOff)";
  }
  this->Buffers.Allocate(context.Window, context.View.Viewport);
  vtkOpenGLState* state = context.Window->GetState();
  state->PushFramebufferBindings();
  this->Buffers.Framebuffer->Bind();
  const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  state->PopFramebufferBindings();
  if (!complete)
  {
    const int samples = this->Buffers.NumberOfSamples;
    this->Release(context.Window);
    return "this OpenGL cannot draw to half floats with " + std::to_string(samples) + " samples";
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Begin(vtkRelievoFrameContext& context)
{
  vtkRenderer* renderer = context.Renderer;
  vtkOpenGLState* state = context.Window->GetState();
  this->Separated = false;
  const int before = vtkRelievoColorBuffers::GetBoundFramebuffer();
  state->PushFramebufferBindings();
  this->Buffers.Framebuffer->Bind();
  const bool keeps =
    renderer->GetLayer() > 0 || !renderer->GetErase() || renderer->GetPreserveColorBuffer();
  if (context.Picture && (keeps || context.Nested))
  {
    this->CopyWhatIsThere(context, before);
  }
  else if (keeps || renderer->GetPreserveDepthBuffer())
  {
    // VTK clears not all of it, and what is there is another frame's.
    const vtkRelievoScopedState kept(state);
    const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    const float far = 1.0f;
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far);
  }
  if (context.Nested)
  {
    // The pass around has cleared its own framebuffer, and set its own viewport.
    const int* v = context.View.Viewport;
    state->vtkglViewport(v[0], v[1], v[2], v[3]);
    state->vtkglScissor(v[0], v[1], v[2], v[3]);
    if (!context.Picture && !keeps)
    {
      renderer->Clear();
    }
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClearDepth(1.0);
    state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::CopyWhatIsThere(vtkRelievoFrameContext& context, int framebuffer)
{
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  // Samples are resolved into what they have been made of, on every OpenGL.
  vtkSmartPointer<vtkTextureObject> there = vtkRelievoColorBuffers::MakeTexture(
    context.Window, this->Buffers.NumberOfSamples > 0 ? GL_RGBA8 : GL_RGBA16F, v[2], v[3]);
  this->Buffers.Pen->Bind(GL_DRAW_FRAMEBUFFER);
  this->Buffers.Pen->AddColorAttachment(0, there);
  this->Buffers.Pen->ActivateDrawBuffer(0);
  {
    // Read from where it is drawn, which need not be where that framebuffer was read from.
    const auto name = static_cast<unsigned int>(framebuffer);
    GLint drawn = GL_NONE;
    GLint read = GL_NONE;
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    glGetIntegerv(GL_DRAW_BUFFER, &drawn);
    this->Buffers.Pen->Bind(GL_DRAW_FRAMEBUFFER);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, name);
    glGetIntegerv(GL_READ_BUFFER, &read);
    state->vtkglReadBuffer(static_cast<unsigned int>(drawn));
    state->vtkglScissor(0, 0, v[2], v[3]);
    state->vtkglBlitFramebuffer(
      v[0], v[1], v[0] + v[2], v[1] + v[3], 0, 0, v[2], v[3], GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state->vtkglReadBuffer(static_cast<unsigned int>(read));
  }
  this->Buffers.Framebuffer->Bind();
  if (vtkShaderProgram* program = this->Copy.Ready(context, "frame/copyFS.glsl", {}))
  {
    there->Activate();
    program->SetUniformi("relievoSource", there->GetTextureUnit());
    state->vtkglDisable(GL_BLEND);
    this->Copy.Draw(context);
    there->Deactivate();
  }
  there->ReleaseGraphicsResources(context.Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::IsBound(bool reading) const
{
  return this->Buffers.Framebuffer &&
    vtkRelievoColorBuffers::GetBoundFramebuffer(reading) ==
    static_cast<int>(this->Buffers.Framebuffer->GetFBOIndex());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Resolve(vtkRelievoFrameContext& context)
{
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  if (this->Buffers.Resolved)
  {
    const vtkRelievoScopedState kept(state);
    this->Buffers.Framebuffer->Bind(GL_READ_FRAMEBUFFER);
    this->Buffers.Framebuffer->ActivateReadBuffer(0);
    this->Buffers.Resolved->Bind(GL_DRAW_FRAMEBUFFER);
    state->vtkglScissor(0, 0, this->Buffers.Size[0], this->Buffers.Size[1]);
    for (const unsigned int buffer : { GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT })
    {
      state->vtkglBlitFramebuffer(v[0], v[1], v[0] + v[2], v[1] + v[3], v[0], v[1], v[0] + v[2],
        v[1] + v[3], buffer, GL_NEAREST);
    }
  }
  this->Drawn->Offset[0] = v[0];
  this->Drawn->Offset[1] = v[1];
  context.Provide("drawn", this->Drawn.get());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::MakeLinear(vtkRelievoFrameContext& context)
{
  this->Valid = this->ToLinear.Ready(context, "frame/toLinearFS.glsl", { "drawn" }) &&
    this->Draw(context, this->ToLinear, true);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Separate(vtkRelievoFrameContext& context)
{
  this->Resolve(context);
  this->MakeLinear(context);
  this->Separated = true;
  context.Provide("color", this);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Clear(vtkRelievoFrameContext& context, float alpha)
{
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  this->Buffers.Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, alpha };
  glClearBufferfv(GL_COLOR, 0, nothing);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::End(vtkRelievoFrameContext& context)
{
  this->Resolve(context);
  context.Window->GetState()->PopFramebufferBindings();
  if (!this->Separated)
  {
    this->MakeLinear(context);
  }
  this->Presented = false;
  if (this->Valid)
  {
    context.Provide("color", this);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::BeginAside(vtkRelievoFrameContext& context)
{
  context.Window->GetState()->PushFramebufferBindings();
  this->Buffers.Framebuffer->Bind();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::EndAside(vtkRelievoFrameContext& context)
{
  context.Window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::Draw(
  vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces, const int* part)
{
  if (!this->Buffers.Pen || (!this->Valid && &quad != &this->ToLinear))
  {
    return false;
  }
  const int area[4] = { 0, 0, this->Buffers.Size[2], this->Buffers.Size[3] };
  vtkOpenGLState* state = context.Window->GetState();
  {
    const vtkRelievoScopedState kept(state);
    this->Buffers.Pen->Bind();
    this->Buffers.Pen->AddColorAttachment(0, this->Buffers.Linear[replaces ? 1 : 0]);
    this->Buffers.Pen->ActivateDrawBuffer(0);
    if (replaces)
    {
      state->vtkglDisable(GL_BLEND);
    }
    quad.Draw(context, area, false, replaces ? nullptr : part);
  }
  if (replaces)
  {
    std::swap(this->Buffers.Linear[0], this->Buffers.Linear[1]);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::Present(vtkRelievoFrameContext& context, vtkRelievoScreenQuad* quad)
{
  const auto readyCurve = [&]() {
    return this->ToDisplay.Ready(context, "frame/toDisplayFS.glsl", { "color", "drawn" });
  };
  if (!this->Valid || this->Presented || (!quad && !readyCurve()))
  {
    return false;
  }
  const vtkRelievoScopedState kept(context.Window->GetState());
  context.Window->GetState()->vtkglDisable(GL_BLEND);
  (quad ? *quad : this->ToDisplay).Draw(context, nullptr, true);
  this->Presented = true;
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::Read(vtkImageData* image)
{
  if (!this->Valid || !this->Buffers.Window)
  {
    return "the last frame made no linear colour; ask for it (RequestLayer) and render before";
  }
  const int width = this->Buffers.Size[2];
  const int height = this->Buffers.Size[3];
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(width, height, 1);
  }
  if (image->GetNumberOfPoints() != static_cast<vtkIdType>(width) * height)
  {
    return "the image has " + std::to_string(image->GetNumberOfPoints()) + " points, the colour " +
      std::to_string(width) + " x " + std::to_string(height) + " pixels";
  }
  vtkNew<vtkFloatArray> color;
  color->SetName("color");
  color->SetNumberOfComponents(4);
  color->SetNumberOfTuples(image->GetNumberOfPoints());
  this->Buffers.Window->MakeCurrent();
  vtkOpenGLState* state = this->Buffers.Window->GetState();
  state->PushFramebufferBindings();
  this->Buffers.Pen->Bind();
  this->Buffers.Pen->AddColorAttachment(0, this->Buffers.Linear[0]);
  this->Buffers.Pen->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glFinish();
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, color->GetPointer(0));
  state->PopFramebufferBindings();
  image->GetPointData()->AddArray(color);
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Activate(vtkShaderProgram* program)
{
  this->Buffers.Linear[0]->Activate();
  program->SetUniformi("relievoColor", this->Buffers.Linear[0]->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Deactivate()
{
  this->Buffers.Linear[0]->Deactivate();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Release(vtkWindow* window)
{
  this->Buffers.Release(window);
  for (vtkRelievoScreenQuad* quad : { &this->ToLinear, &this->ToDisplay, &this->Copy })
  {
    quad->Release(window);
  }
  this->Valid = false;
}
