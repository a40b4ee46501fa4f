// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeTarget.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoTextureRoom.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
vtkRelievoVolumeTarget::vtkRelievoVolumeTarget() = default;

//------------------------------------------------------------------------------
vtkRelievoVolumeTarget::~vtkRelievoVolumeTarget()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoVolumeTarget::Prepare(vtkRelievoFrameContext& context, int volumes)
{
  const int width = context.View.Viewport[2];
  const int height = context.View.Viewport[3];
  if (this->Window != context.Window || this->Area[2] != width || this->Area[3] != height ||
    static_cast<int>(this->Volumes.size()) > volumes)
  {
    this->Release(this->Window);
  }
  const auto columns = static_cast<unsigned int>(width);
  const auto rows = static_cast<unsigned int>(height);
  const vtkRelievoScopedState kept(context.Window->GetState());
  if (!this->Framebuffer)
  {
    const std::string fault =
      vtkRelievoFindTextureFault(GL_RGBA32F, GL_RGBA, GL_FLOAT, width, height);
    if (!fault.empty())
    {
      return fault;
    }
    this->Window = context.Window;
    this->Area[2] = width;
    this->Area[3] = height;
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(context.Window);
    context.Window->GetStencilCapable()
      ? this->Depth->AllocateDepthStencil(columns, rows)
      : this->Depth->AllocateDepth(columns, rows, vtkTextureObject::Fixed32);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(context.Window);
    this->Framebuffer->Bind();
    this->Framebuffer->AddDepthAttachment(this->Depth);
  }
  while (static_cast<int>(this->Volumes.size()) < volumes)
  {
    this->Volumes.emplace_back();
    for (auto& texture : this->Volumes.back())
    {
      texture = vtkSmartPointer<vtkTextureObject>::New();
      texture->SetContext(context.Window);
      texture->SetInternalFormat(GL_RGBA32F);
      texture->SetFormat(GL_RGBA);
      texture->SetDataType(GL_FLOAT);
      texture->Allocate2D(columns, rows, 4, VTK_FLOAT);
    }
  }
  this->Framebuffer->Bind();
  for (int i = 0; i < volumes; ++i)
  {
    this->Attach(i);
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      const std::string bytes = std::to_string(this->GetBytes());
      this->Release(context.Window);
      return "OpenGL cannot draw to the " + bytes + " bytes of float textures of " +
        std::to_string(volumes) + " volumes; take a smaller picture or fewer volumes";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeTarget::Attach(int volume)
{
  for (unsigned int i = 0; i < Textures; ++i)
  {
    this->Framebuffer->AddColorAttachment(i, this->Volumes[volume][i]);
  }
  this->Framebuffer->ActivateDrawBuffers(Textures);
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeTarget::Begin(vtkRelievoFrameContext& context)
{
  vtkOpenGLState* state = context.Window->GetState();
  this->SavedState.reset(new vtkRelievoScopedState(state));
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, this->Area[2], this->Area[3]);
  state->vtkglScissor(0, 0, this->Area[2], this->Area[3]);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeTarget::Select(int volume)
{
  this->Framebuffer->Bind();
  this->Attach(volume);
  const float none[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (int i = 0; i < Textures; ++i)
  {
    glClearBufferfv(GL_COLOR, i, none);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeTarget::End()
{
  this->SavedState.reset();
}

//------------------------------------------------------------------------------
std::array<std::vector<float>, vtkRelievoVolumeTarget::Textures> vtkRelievoVolumeTarget::Read(
  int volume)
{
  std::array<std::vector<float>, Textures> texels;
  this->Window->MakeCurrent();
  vtkOpenGLState* state = this->Window->GetState();
  const vtkRelievoScopedState kept(state);
  this->Framebuffer->Bind();
  this->Attach(volume);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glFinish();
  for (unsigned int i = 0; i < Textures; ++i)
  {
    texels[i].resize(static_cast<std::size_t>(4) * this->Area[2] * this->Area[3]);
    this->Framebuffer->ActivateReadBuffer(i);
    glReadPixels(0, 0, this->Area[2], this->Area[3], GL_RGBA, GL_FLOAT, texels[i].data());
  }
  return texels;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVolumeTarget::GetBytes() const
{
  const vtkIdType perPixel =
    this->Framebuffer ? 4 + 16 * Textures * static_cast<vtkIdType>(this->Volumes.size()) : 0;
  return perPixel * this->Area[2] * this->Area[3];
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeTarget::Release(vtkWindow* window)
{
  if (window && this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Depth->ReleaseGraphicsResources(window);
    for (auto& volume : this->Volumes)
    {
      for (auto& texture : volume)
      {
        texture->ReleaseGraphicsResources(window);
      }
    }
  }
  this->Volumes.clear();
  this->Depth = nullptr;
  this->Framebuffer = nullptr;
  this->Window = nullptr;
}
