// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColorBuffers.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRelievoTextureRoom.h"
#include "vtkRenderbuffer.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
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
}

//------------------------------------------------------------------------------
vtkRelievoColorBuffers::~vtkRelievoColorBuffers()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoColorBuffers::HasBoundDepth() const
{
  return vtkRelievoBoundFramebuffer::GetDepth() == this->DepthOf;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> vtkRelievoColorBuffers::MakeTexture(
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

//------------------------------------------------------------------------------
std::string vtkRelievoColorBuffers::Allocate(
  vtkOpenGLRenderWindow* window, const int viewport[4], int samples)
{
  const int size[4] = { viewport[0] + viewport[2], viewport[1] + viewport[3], viewport[2],
    viewport[3] };
  if (this->Window == window && this->Framebuffer && samples == this->NumberOfSamples &&
    this->HasBoundDepth() && std::equal(size, size + 4, this->Size))
  {
    return {};
  }
  // VTK's passes copy depths between framebuffers, which requires equal formats.
  const vtkRelievoBoundFramebuffer::DepthFormat depth = vtkRelievoBoundFramebuffer::GetDepth();
  this->Release(this->Window);
  this->Window = window;
  this->NumberOfSamples = samples;
  this->DepthOf = depth;
  std::copy_n(size, 4, this->Size);
  // Processors blend floats faster than half floats, which they have to convert.
  this->Floats = vtkRelievoIsSoftwareOpenGL();
  const unsigned int format = this->GetFormat();
  const std::string fault = vtkRelievoFindTextureFault(format, GL_RGBA, GL_FLOAT, size[0], size[1]);
  if (!fault.empty())
  {
    this->Release(window);
    return fault;
  }
  this->Color = MakeTexture(this->Window, format, size[0], size[1]);
  this->Linear[0] = MakeTexture(this->Window, format, size[2], size[3]);
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
    const unsigned int formats[2] = { format, depth.GetFormat() };
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
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoColorBuffers::MakeSecond()
{
  if (!this->Linear[1])
  {
    this->Linear[1] = MakeTexture(this->Window, this->GetFormat(), this->Size[2], this->Size[3]);
  }
}

//------------------------------------------------------------------------------
unsigned int vtkRelievoColorBuffers::GetFormat() const
{
  return this->Floats ? GL_RGBA32F : GL_RGBA16F;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoColorBuffers::GetBytes() const
{
  if (!this->Framebuffer)
  {
    return 0;
  }
  const vtkIdType all = static_cast<vtkIdType>(this->Size[0]) * this->Size[1];
  const vtkIdType seen = static_cast<vtkIdType>(this->Size[2]) * this->Size[3];
  // Four components, and one word of depth.
  const vtkIdType color = this->Floats ? 16 : 8;
  return (color + 4) * all * (1 + this->NumberOfSamples) + (this->Linear[1] ? 2 : 1) * color * seen;
}

//------------------------------------------------------------------------------
void vtkRelievoColorBuffers::Release(vtkWindow* window)
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
  this->DepthCopied = false;
  this->Window = nullptr;
}
