// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColorTarget.h"

#include "vtkFloatArray.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkImageData.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoKeptState.h"
#include "vtkRenderState.h"
#include "vtkRenderbuffer.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <utility>

namespace
{
vtkSmartPointer<vtkTextureObject> MakeTexture(
  vtkOpenGLRenderWindow* window, unsigned int format, int width, int height)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetInternalFormat(format);
  texture->SetFormat(GL_RGBA);
  texture->SetDataType(format == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->Allocate2D(width, height, 4, format == GL_RGBA8 ? VTK_UNSIGNED_CHAR : VTK_FLOAT);
  return texture;
}

vtkSmartPointer<vtkOpenGLFramebufferObject> MakeFramebuffer(vtkOpenGLRenderWindow* window)
{
  auto framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  framebuffer->SetContext(window);
  return framebuffer;
}

template <typename T>
void ReleaseAndForget(vtkSmartPointer<T>& object, vtkWindow* window)
{
  if (object && window)
  {
    object->ReleaseGraphicsResources(window);
  }
  object = nullptr;
}

int GetBoundFramebuffer()
{
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return bound;
}

// The depth of what is bound for drawing: VTK's passes copy depths between framebuffers, which must
// be of one format.
vtkRelievoColorTarget::DepthFormat GetBoundDepth()
{
  vtkRelievoColorTarget::DepthFormat format;
  GLint type = GL_UNSIGNED_NORMALIZED;
  const GLenum place = GetBoundFramebuffer() == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  if (type == GL_NONE)
  {
    return format;
  }
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &format.Bits);
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, place, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  format.Float = type == GL_FLOAT;
  const GLenum stencil = GetBoundFramebuffer() == 0 ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  format.Stencil = type != GL_NONE;
  return format;
}

unsigned int GetInternalFormat(const vtkRelievoColorTarget::DepthFormat& depth)
{
  return depth.Stencil ? GL_DEPTH24_STENCIL8
    : depth.Float      ? GL_DEPTH_COMPONENT32F
    : depth.Bits == 32 ? GL_DEPTH_COMPONENT32
    : depth.Bits == 16 ? GL_DEPTH_COMPONENT16
                       : GL_DEPTH_COMPONENT24;
}
}

//------------------------------------------------------------------------------
class vtkRelievoColorTarget::Input : public vtkRelievoResource
{
public:
  vtkRelievoColorTarget* Target = nullptr;
  int Offset[2] = { 0, 0 };

  void Activate(vtkShaderProgram* program) override
  {
    this->Target->Color->Activate();
    this->Target->Depth->Activate();
    program->SetUniformi("relievoDrawn", this->Target->Color->GetTextureUnit());
    program->SetUniformi("relievoDrawnZ", this->Target->Depth->GetTextureUnit());
    program->SetUniform2i("relievoDrawnOffset", this->Offset);
  }
  void Deactivate() override
  {
    this->Target->Color->Deactivate();
    this->Target->Depth->Deactivate();
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
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Allocate(
  vtkRelievoFrameContext& context, int samples, const DepthFormat& depth)
{
  const int* viewport = context.View.Viewport;
  const int size[4] = { viewport[0] + viewport[2], viewport[1] + viewport[3], viewport[2],
    viewport[3] };
  if (this->Window == context.Window && this->Framebuffer && samples == this->NumberOfSamples &&
    depth.Bits == this->DepthOf.Bits && depth.Float == this->DepthOf.Float &&
    depth.Stencil == this->DepthOf.Stencil && std::equal(size, size + 4, this->Size))
  {
    return;
  }
  this->Release(this->Window);
  this->Window = context.Window;
  this->NumberOfSamples = samples;
  this->DepthOf = depth;
  std::copy_n(size, 4, this->Size);
  this->Color = MakeTexture(this->Window, GL_RGBA16F, size[0], size[1]);
  this->Linear[0] = MakeTexture(this->Window, GL_RGBA16F, size[2], size[3]);
  this->Linear[1] = MakeTexture(this->Window, GL_RGBA16F, size[2], size[3]);
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(this->Window);
  if (depth.Stencil)
  {
    this->Depth->AllocateDepthStencil(size[0], size[1]);
  }
  else
  {
    this->Depth->AllocateDepth(size[0], size[1],
      depth.Float          ? vtkTextureObject::Float32
        : depth.Bits == 32 ? vtkTextureObject::Fixed32
        : depth.Bits == 16 ? vtkTextureObject::Fixed16
                           : vtkTextureObject::Fixed24);
  }
  this->Pen = MakeFramebuffer(this->Window);
  this->Framebuffer = MakeFramebuffer(this->Window);
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  if (samples > 0)
  {
    const unsigned int formats[2] = { GL_RGBA16F, GetInternalFormat(depth) };
    for (int i = 0; i < 2; ++i)
    {
      this->Samples[i] = vtkSmartPointer<vtkRenderbuffer>::New();
      this->Samples[i]->SetContext(this->Window);
      this->Samples[i]->Create(formats[i], static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), static_cast<unsigned int>(samples));
    }
    this->Resolved = MakeFramebuffer(this->Window);
    this->Resolved->Bind();
    this->Resolved->AddColorAttachment(0, this->Color);
    this->Resolved->AddDepthAttachment(this->Depth);
    this->Resolved->ActivateDrawBuffer(0);
    this->Framebuffer->Bind();
    this->Framebuffer->AddColorAttachment(0, this->Samples[0]);
    this->Framebuffer->AddDepthAttachment(this->Samples[1]);
  }
  else
  {
    this->Framebuffer->Bind();
    this->Framebuffer->AddColorAttachment(0, this->Color);
    this->Framebuffer->AddDepthAttachment(this->Depth);
  }
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->ActivateReadBuffer(0);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::Begin(vtkRelievoFrameContext& context)
{
  this->Valid = false;
  if (context.Renderer->GetPreserveDepthBuffer())
  {
    return "the renderer keeps another renderer's depth (PreserveDepthBuffer)";
  }
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  this->Allocate(context, samples, GetBoundDepth());
  vtkOpenGLState* state = context.Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    state->PopFramebufferBindings();
    this->Release(context.Window);
    return "this OpenGL cannot draw to half floats with " + std::to_string(samples) + " samples";
  }
  const bool keeps = context.Renderer->GetLayer() > 0 || !context.Renderer->GetErase() ||
    context.Renderer->GetPreserveColorBuffer();
  if (keeps && context.Picture)
  {
    this->CopyWhatIsThere(context);
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::CopyWhatIsThere(vtkRelievoFrameContext& context)
{
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  // Samples are resolved into what they have been made of, on every OpenGL.
  vtkSmartPointer<vtkTextureObject> there =
    MakeTexture(context.Window, this->NumberOfSamples > 0 ? GL_RGBA8 : GL_RGBA16F, v[2], v[3]);
  state->PopFramebufferBindings(); // what is there is bound again
  state->PushFramebufferBindings();
  this->Pen->Bind(GL_DRAW_FRAMEBUFFER);
  this->Pen->AddColorAttachment(0, there);
  this->Pen->ActivateDrawBuffer(0);
  state->vtkglScissor(0, 0, v[2], v[3]);
  state->vtkglBlitFramebuffer(
    v[0], v[1], v[0] + v[2], v[1] + v[3], 0, 0, v[2], v[3], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  this->Framebuffer->Bind();
  if (vtkShaderProgram* program = this->Copy.Ready(context, "frame/copyFS.glsl", {}))
  {
    there->Activate();
    program->SetUniformi("relievoSource", there->GetTextureUnit());
    const vtkRelievoKeptState kept(state);
    state->vtkglDisable(GL_BLEND);
    this->Copy.Draw(context);
    there->Deactivate();
  }
  there->ReleaseGraphicsResources(context.Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::IsBound() const
{
  return this->Framebuffer &&
    GetBoundFramebuffer() == static_cast<int>(this->Framebuffer->GetFBOIndex());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::End(vtkRelievoFrameContext& context)
{
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  if (this->Resolved)
  {
    state->PushFramebufferBindings();
    this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
    this->Framebuffer->ActivateReadBuffer(0);
    this->Resolved->Bind(GL_DRAW_FRAMEBUFFER);
    state->vtkglScissor(0, 0, this->Size[0], this->Size[1]);
    for (const unsigned int buffer : { GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT })
    {
      state->vtkglBlitFramebuffer(v[0], v[1], v[0] + v[2], v[1] + v[3], v[0], v[1], v[0] + v[2],
        v[1] + v[3], buffer, GL_NEAREST);
    }
    state->PopFramebufferBindings();
  }
  state->PopFramebufferBindings();
  this->Drawn->Offset[0] = v[0];
  this->Drawn->Offset[1] = v[1];
  context.Provide("drawn", this->Drawn.get());
  this->Valid = this->ToLinear.Ready(context, "frame/toLinearFS.glsl", { "drawn" }) &&
    this->Draw(context, this->ToLinear, true);
  if (this->Valid)
  {
    context.Provide("color", this);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::Draw(
  vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces)
{
  if (!this->Pen || (!this->Valid && &quad != &this->ToLinear))
  {
    return false;
  }
  const int area[4] = { 0, 0, this->Size[2], this->Size[3] };
  vtkOpenGLState* state = context.Window->GetState();
  {
    const vtkRelievoKeptState kept(state);
    this->Pen->Bind();
    this->Pen->AddColorAttachment(0, this->Linear[replaces ? 1 : 0]);
    this->Pen->ActivateDrawBuffer(0);
    if (replaces)
    {
      state->vtkglDisable(GL_BLEND);
    }
    quad.Draw(context, area);
  }
  if (replaces)
  {
    std::swap(this->Linear[0], this->Linear[1]);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Present(vtkRelievoFrameContext& context)
{
  if (!this->Valid ||
    !this->ToDisplay.Ready(context, "frame/toDisplayFS.glsl", { "color", "drawn" }))
  {
    return;
  }
  const vtkRelievoKeptState kept(context.Window->GetState());
  context.Window->GetState()->vtkglDisable(GL_BLEND);
  this->ToDisplay.Draw(context, nullptr, true);
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::Read(vtkImageData* image)
{
  if (!this->Valid || !this->Window)
  {
    return "the last frame made no linear colour; ask for it (RequestLayer) and render before";
  }
  const int width = this->Size[2];
  const int height = this->Size[3];
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
  this->Window->MakeCurrent();
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Pen->Bind();
  this->Pen->AddColorAttachment(0, this->Linear[0]);
  this->Pen->ActivateReadBuffer(0);
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
  this->Linear[0]->Activate();
  program->SetUniformi("relievoColor", this->Linear[0]->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Deactivate()
{
  this->Linear[0]->Deactivate();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoColorTarget::GetBytes() const
{
  if (!this->Framebuffer)
  {
    return 0;
  }
  const vtkIdType all = static_cast<vtkIdType>(this->Size[0]) * this->Size[1];
  const vtkIdType seen = static_cast<vtkIdType>(this->Size[2]) * this->Size[3];
  // Half floats of four components, and a depth in a word.
  return (8 + 4) * all * (1 + this->NumberOfSamples) + 2 * 8 * seen;
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Release(vtkWindow* window)
{
  ReleaseAndForget(this->Framebuffer, window);
  ReleaseAndForget(this->Resolved, window);
  ReleaseAndForget(this->Pen, window);
  ReleaseAndForget(this->Color, window);
  ReleaseAndForget(this->Depth, window);
  for (int i = 0; i < 2; ++i)
  {
    ReleaseAndForget(this->Linear[i], window);
    ReleaseAndForget(this->Samples[i], window);
  }
  for (vtkRelievoScreenQuad* quad : { &this->ToLinear, &this->ToDisplay, &this->Copy })
  {
    quad->Release(window);
  }
  this->Valid = false;
  this->Window = nullptr;
}
