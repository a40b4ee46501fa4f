// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoScreenTarget.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoTextureRoom.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <vector>

namespace
{
struct TexelFormat
{
  unsigned int Internal;
  unsigned int External;
};

TexelFormat GetTexelFormat(const vtkRelievoScreenTarget::Format& format)
{
  switch (format.Channels)
  {
    case 1:
      return { static_cast<unsigned int>(format.Halves ? GL_R16F : GL_R32F), GL_RED };
    case 2:
      return { static_cast<unsigned int>(format.Halves ? GL_RG16F : GL_RG32F), GL_RG };
    default:
      return { static_cast<unsigned int>(format.Halves ? GL_RGBA16F : GL_RGBA32F), GL_RGBA };
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoScreenTarget::vtkRelievoScreenTarget(const std::string& sampler)
  : Sampler(sampler)
{
}

//------------------------------------------------------------------------------
vtkRelievoScreenTarget::~vtkRelievoScreenTarget()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoScreenTarget::Prepare(vtkRelievoFrameContext& context, const Format& format)
{
  const int width = context.View.Viewport[2];
  const int height = context.View.Viewport[3];
  if (this->Window == context.Window && this->Texture && this->Area[2] == width &&
    this->Area[3] == height && this->Shape.Channels == format.Channels &&
    this->Shape.Halves == format.Halves && this->Shape.Depth == format.Depth)
  {
    return {};
  }
  this->Release(this->Window);
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width <= 0 || height <= 0 || width > limit || height > limit)
  {
    return "the viewport has " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels, but this OpenGL supports 1 to " + std::to_string(limit);
  }
  const TexelFormat texel = GetTexelFormat(format);
  const std::string fault =
    vtkRelievoFindTextureFault(texel.Internal, texel.External, GL_FLOAT, width, height);
  if (!fault.empty())
  {
    return fault;
  }
  this->Window = context.Window;
  this->Shape = format;
  this->Area[2] = width;
  this->Area[3] = height;
  this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  this->Texture->SetContext(context.Window);
  this->Texture->SetInternalFormat(texel.Internal);
  this->Texture->SetFormat(texel.External);
  this->Texture->SetDataType(GL_FLOAT);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->Allocate2D(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
    format.Channels, VTK_FLOAT);
  const vtkRelievoScopedState kept(context.Window->GetState());
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(context.Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Texture);
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->ActivateReadBuffer(0);
  if (format.Depth)
  {
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(context.Window);
    this->Depth->AllocateDepth(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
      vtkTextureObject::Float32);
    this->Framebuffer->AddDepthAttachment(this->Depth);
  }
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->Release(context.Window);
    return "this OpenGL cannot draw to " + std::to_string(format.Channels) + " " +
      (format.Halves ? "half floats" : "floats") + " a pixel";
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoScreenTarget::Begin(vtkRelievoFrameContext& context, float value, const int* part)
{
  this->GoOn(context);
  const float values[4] = { value, value, value, value };
  vtkOpenGLState* state = context.Window->GetState();
  if (part)
  {
    state->vtkglScissor(part[0], part[1], part[2], part[3]);
  }
  glClearBufferfv(GL_COLOR, 0, values);
  state->vtkglScissor(0, 0, this->Area[2], this->Area[3]);
}

//------------------------------------------------------------------------------
void vtkRelievoScreenTarget::GoOn(vtkRelievoFrameContext& context)
{
  vtkOpenGLState* state = context.Window->GetState();
  this->SavedState.reset(new vtkRelievoScopedState(state));
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, this->Area[2], this->Area[3]);
  state->vtkglScissor(0, 0, this->Area[2], this->Area[3]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
}

//------------------------------------------------------------------------------
void vtkRelievoScreenTarget::End()
{
  this->SavedState.reset();
}

//------------------------------------------------------------------------------
std::string vtkRelievoScreenTarget::Read(
  const std::string& name, int components, vtkImageData* image, int firstChannel)
{
  if (!this->Texture || !this->Window)
  {
    return "the last frame did not make it; ask for it (RequestLayer) and render before";
  }
  const int width = this->Area[2];
  const int height = this->Area[3];
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(width, height, 1);
  }
  const vtkIdType count = static_cast<vtkIdType>(width) * height;
  if (image->GetNumberOfPoints() != count)
  {
    return "the image has " + std::to_string(image->GetNumberOfPoints()) +
      " points, but the layer has " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels";
  }
  const int channels = this->Shape.Channels;
  std::vector<float> texels(static_cast<std::size_t>(count) * channels);
  this->Window->MakeCurrent();
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glFinish();
  glReadPixels(0, 0, width, height, GetTexelFormat(this->Shape).External, GL_FLOAT, texels.data());
  state->PopFramebufferBindings();
  vtkNew<vtkFloatArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  float* out = array->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      out[i * components + c] = texels[i * channels + (channels == 1 ? 0 : firstChannel + c)];
    }
  }
  image->GetPointData()->AddArray(array);
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoScreenTarget::GetBytes() const
{
  if (!this->Texture)
  {
    return 0;
  }
  const vtkIdType pixels = static_cast<vtkIdType>(this->Area[2]) * this->Area[3];
  return pixels * (this->Shape.Channels * (this->Shape.Halves ? 2 : 4) + (this->Depth ? 4 : 0));
}

//------------------------------------------------------------------------------
void vtkRelievoScreenTarget::Release(vtkWindow* window)
{
  this->SavedState.reset();
  for (auto* texture : { &this->Texture, &this->Depth })
  {
    if (*texture && window)
    {
      (*texture)->ReleaseGraphicsResources(window);
    }
    *texture = nullptr;
  }
  if (this->Framebuffer && window)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  this->Framebuffer = nullptr;
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoScreenTarget::Activate(vtkShaderProgram* program)
{
  this->Texture->Activate();
  program->SetUniformi(this->Sampler.c_str(), this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkRelievoScreenTarget::Deactivate()
{
  this->Texture->Deactivate();
}
