// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGBufferTarget.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRelievoTexels.h"
#include "vtkRelievoTextureRoom.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <sstream>

namespace
{
using relievo::ClearToBackground;
using relievo::Gather;
using relievo::TexelFormat;

// The first unused color attachment from the top.
unsigned int FindFreeAttachment(unsigned int from)
{
  for (unsigned int attachment = from; attachment > GL_COLOR_ATTACHMENT0; --attachment)
  {
    GLint type = GL_NONE;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_NONE)
    {
      return attachment;
    }
  }
  return GL_NONE;
}

constexpr int BandBytes = 1 << 18;

}

//------------------------------------------------------------------------------
vtkRelievoGBufferTarget::~vtkRelievoGBufferTarget()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferTarget::Allocate(
  vtkOpenGLRenderWindow* window, const vtkRelievoGBufferLayout& layout, int width, int height)
{
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
  }
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width > limit || height > limit)
  {
    this->Release(window);
    std::ostringstream out;
    out << "the layers need " << width << " x " << height
        << " pixels, but this OpenGL supports at most " << limit << " x " << limit
        << ": make the window smaller, or capture it in tiles";
    return out.str();
  }
  // Draw buffer 0 belongs to the colour.
  GLint buffers = 0;
  GLint attachments = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &buffers);
  glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
  const int most = std::min({ vtkRelievoGBufferLayout::MostAttachments, buffers - 1, attachments });
  if (layout.GetNumberOfAttachments() > most)
  {
    this->Release(window);
    std::ostringstream out;
    out << "the requested layers take " << layout.GetNumberOfWords()
        << " words of 32 bits per pixel, but at most " << 4 * most
        << " can be written at once: request fewer layers, or choose a smaller format for normals";
    return out.str();
  }
  std::vector<int> channels;
  for (int i = 0; i < layout.GetNumberOfAttachments(); ++i)
  {
    channels.push_back(layout.GetNumberOfChannels(i));
  }
  if (channels == this->Channels && width == this->Width && height == this->Height)
  {
    return std::string();
  }
  this->Release(window);
  for (int count : channels)
  {
    const TexelFormat format = TexelFormat::Get(count);
    const std::string fault =
      vtkRelievoFindTextureFault(format.Internal, format.External, GL_UNSIGNED_INT, width, height);
    if (!fault.empty())
    {
      this->Release(window);
      return fault;
    }
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetInternalFormat(format.Internal);
    texture->SetFormat(format.External);
    texture->SetDataType(GL_UNSIGNED_INT);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Allocate2D(width, height, count, VTK_UNSIGNED_INT);
    this->Textures.push_back(texture);
  }
  this->Channels = channels;
  this->Width = width;
  this->Height = height;
  return std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferTarget::AttachShared(
  const vtkRelievoGBufferLayout& layout, const int region[4])
{
  // A capture does not keep its own depth.
  if (this->Depth)
  {
    this->Depth->ReleaseGraphicsResources(this->Window);
    this->Framebuffer->ReleaseGraphicsResources(this->Window);
    this->Depth = nullptr;
    this->Framebuffer = nullptr;
  }
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  if (framebuffer == 0)
  {
    return "the delegate draws to the window itself";
  }
  // With a pass that draws larger and scales down, for example, the textures would clip the
  // picture.
  GLint viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (!std::equal(viewport, viewport + 4, region))
  {
    return "the delegate draws to another place or size than the renderer's viewport";
  }
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples > 0)
  {
    return "the delegate's framebuffer is multisampled";
  }
  GLint first = GL_NONE;
  GLint second = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER0, &first);
  glGetIntegerv(GL_DRAW_BUFFER1, &second);
  if (first == GL_NONE || second != GL_NONE)
  {
    return "the delegate draws to several buffers, or to none, at once";
  }
  GLint attachments = 0;
  glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
  this->SharedFramebuffer = static_cast<unsigned int>(framebuffer);
  this->SharedColorBuffer = static_cast<unsigned int>(first);
  this->DrawBuffers.assign(1, this->SharedColorBuffer);
  unsigned int from = GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(attachments) - 1;
  for (std::size_t i = 0; i < this->Textures.size(); ++i)
  {
    from = FindFreeAttachment(from);
    if (from == GL_NONE)
    {
      this->DrawBuffers.clear();
      return "the delegate's framebuffer has no attachments left";
    }
    this->DrawBuffers.push_back(from--);
  }
  for (std::size_t i = 0; i < this->Textures.size(); ++i)
  {
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, this->DrawBuffers[i + 1], GL_TEXTURE_2D,
      this->Textures[i]->GetHandle(), 0);
  }
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->DetachShared();
    return "the driver refuses the layers beside the delegate's attachments";
  }
  this->Writing = false;
  this->WriteLayers(true);
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor box(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(region[0], region[1], region[2], region[3]);
  ClearToBackground(layout);
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTarget::DetachShared()
{
  if (this->DrawBuffers.empty())
  {
    return;
  }
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->SharedFramebuffer);
  this->WriteLayers(false);
  for (std::size_t i = 1; i < this->DrawBuffers.size(); ++i)
  {
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, this->DrawBuffers[i], GL_TEXTURE_2D, 0, 0);
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  this->DrawBuffers.clear();
}

//------------------------------------------------------------------------------
std::string vtkRelievoGBufferTarget::BeginOwn(const vtkRelievoGBufferLayout& layout)
{
  vtkOpenGLState* state = this->Window->GetState();
  if (!this->Framebuffer)
  {
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(this->Window);
  }
  if (!this->Depth)
  {
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth->SetContext(this->Window);
    this->Depth->AllocateDepth(this->Width, this->Height, vtkTextureObject::Float32);
  }
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->DrawBuffers.assign(1, GL_NONE);
  for (std::size_t i = 0; i < this->Textures.size(); ++i)
  {
    this->Framebuffer->AddColorAttachment(static_cast<unsigned int>(i), this->Textures[i]);
    this->DrawBuffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(i));
  }
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->SharedColorBuffer = GL_NONE;
  state->vtkglDrawBuffers(
    static_cast<unsigned int>(this->DrawBuffers.size()), this->DrawBuffers.data());
  this->Writing = true;
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->EndOwn();
    return "this OpenGL cannot draw to unsigned integer textures";
  }
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglScissor(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  ClearToBackground(layout);
  const GLfloat farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTarget::EndOwn()
{
  this->DrawBuffers.clear();
  this->Window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTarget::WriteLayers(bool on)
{
  if (on == this->Writing || this->DrawBuffers.empty())
  {
    return;
  }
  // Bypasses vtkOpenGLState on purpose: VTK's cached state of this framebuffer is valid again once
  // the layers are off.
  if (on)
  {
    glDrawBuffers(static_cast<GLsizei>(this->DrawBuffers.size()), this->DrawBuffers.data());
  }
  else
  {
    glDrawBuffers(1, &this->SharedColorBuffer);
  }
  this->Writing = on;
}

//------------------------------------------------------------------------------
bool vtkRelievoGBufferTarget::Read(
  int attachment, const int region[4], const std::vector<std::uint32_t*>& planes)
{
  if (attachment < 0 || attachment >= static_cast<int>(this->Textures.size()) || !this->Window)
  {
    return false;
  }
  this->Window->MakeCurrent();
  vtkOpenGLState* state = this->Window->GetState();
  const int channels = this->Channels[attachment];
  state->PushFramebufferBindings();
  GLuint reader = 0;
  glGenFramebuffers(1, &reader);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, reader);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
    this->Textures[attachment]->GetHandle(), 0);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  // Reading waits for the drawing anyway. Mesa's software OpenGL does not wait for the drawing of a
  // framebuffer that is no longer bound, and returns old content for some tiles.
  glFinish();
  const int width = region[2];
  const GLenum format = TexelFormat::Get(channels).External;
  const auto gather = [&](const std::uint32_t* band, int y, int rows) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * width;
    for (std::size_t k = 0; k < planes.size(); ++k)
    {
      Gather(band + k, channels, planes[k] + first, static_cast<std::ptrdiff_t>(rows) * width);
    }
  };
  // A GPU waits for each call, and copies fastest into memory owned by OpenGL.
  const auto bytes = static_cast<GLsizeiptr>(sizeof(std::uint32_t)) * channels * width * region[3];
  const void* read = nullptr;
  if (!vtkRelievoIsSoftwareOpenGL())
  {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    glReadPixels(region[0], region[1], width, region[3], format, GL_UNSIGNED_INT, nullptr);
    read = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (read)
    {
      gather(static_cast<const std::uint32_t*>(read), 0, region[3]);
      glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glDeleteBuffers(1, &buffer);
  }
  if (!read)
  {
    // In bands that fit the processor's cache, so that each word is fetched from memory only once.
    const int most = std::max(1, BandBytes / std::max(1, 4 * channels * width));
    std::vector<std::uint32_t> band(static_cast<std::size_t>(most) * channels * width);
    for (int y = 0; y < region[3]; y += most)
    {
      const int rows = std::min(most, region[3] - y);
      glReadPixels(region[0], region[1] + y, width, rows, format, GL_UNSIGNED_INT, band.data());
      gather(band.data(), y, rows);
    }
  }
  state->PopFramebufferBindings();
  glDeleteFramebuffers(1, &reader);
  return true;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkRelievoGBufferTarget::GetTexture(int attachment)
{
  return attachment >= 0 && attachment < static_cast<int>(this->Textures.size())
    ? this->Textures[attachment].GetPointer()
    : nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoGBufferTarget::GetBytes() const
{
  vtkIdType channels = this->Depth ? 1 : 0;
  for (int count : this->Channels)
  {
    channels += count;
  }
  return 4 * channels * static_cast<vtkIdType>(this->Width) * this->Height;
}

//------------------------------------------------------------------------------
void vtkRelievoGBufferTarget::Release(vtkWindow* window)
{
  if (window)
  {
    for (auto& texture : this->Textures)
    {
      texture->ReleaseGraphicsResources(window);
    }
    if (this->Depth)
    {
      this->Depth->ReleaseGraphicsResources(window);
    }
    if (this->Framebuffer)
    {
      this->Framebuffer->ReleaseGraphicsResources(window);
    }
  }
  this->Textures.clear();
  this->Channels.clear();
  this->Depth = nullptr;
  this->Framebuffer = nullptr;
  this->Width = 0;
  this->Height = 0;
}
