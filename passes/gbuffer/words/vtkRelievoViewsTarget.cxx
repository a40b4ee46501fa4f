// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoViewsTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoTexels.h"

#include <algorithm>

namespace
{
constexpr double MostBytes = 1 << 22; // fit a processor's cache, and are allocated once
}

//------------------------------------------------------------------------------
vtkRelievoViewsTarget::vtkRelievoViewsTarget(vtkOpenGLRenderWindow* window,
  const vtkRelievoGBufferLayout& layout, int width, int height, int views)
  : Window(window)
  , Layout(layout)
  , Width(width)
  , Height(height)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &limit);
  double bytes = 0.0;
  for (int i = 0; i < layout.GetNumberOfAttachments(); ++i)
  {
    bytes += 4.0 * layout.GetNumberOfChannels(i) * width * height;
  }
  const int fit = std::max(1, static_cast<int>(MostBytes / std::max(1.0, bytes)));
  this->Views = std::min({ views, static_cast<int>(limit), fit });
}

//------------------------------------------------------------------------------
vtkRelievoViewsTarget::~vtkRelievoViewsTarget()
{
  glDeleteTextures(static_cast<GLsizei>(this->Textures.size()), this->Textures.data());
  glDeleteRenderbuffers(1, &this->Depth);
  glDeleteFramebuffers(1, &this->Framebuffer);
}

//------------------------------------------------------------------------------
bool vtkRelievoViewsTarget::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  const int attachments = this->Layout.GetNumberOfAttachments();
  if (this->Framebuffer == 0)
  {
    glGenFramebuffers(1, &this->Framebuffer);
    glGenRenderbuffers(1, &this->Depth);
    this->Textures.resize(static_cast<std::size_t>(attachments));
    this->Words.resize(this->Textures.size());
    glGenTextures(attachments, this->Textures.data());
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &bound);
    for (int i = 0; i < attachments; ++i)
    {
      const relievo::TexelFormat format =
        relievo::TexelFormat::Get(this->Layout.GetNumberOfChannels(i));
      glBindTexture(GL_TEXTURE_2D_ARRAY, this->Textures[static_cast<std::size_t>(i)]);
      glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
      glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format.Internal), this->Width,
        this->Height, this->Views, 0, format.External, GL_UNSIGNED_INT, nullptr);
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(bound));
    glBindRenderbuffer(GL_RENDERBUFFER, this->Depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, this->Width, this->Height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  std::vector<unsigned int> buffers(1, GL_NONE); // location 0 belongs to the colour
  for (int i = 0; i < attachments; ++i)
  {
    const unsigned int attachment = GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(i);
    buffers.push_back(attachment);
    glFramebufferTextureLayer(
      GL_DRAW_FRAMEBUFFER, attachment, this->Textures[static_cast<std::size_t>(i)], 0, 0);
  }
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->Depth);
  state->vtkglDrawBuffers(static_cast<unsigned int>(buffers.size()), buffers.data());
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    state->PopFramebufferBindings();
    return false;
  }
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglScissor(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoViewsTarget::Draw(int view)
{
  for (std::size_t i = 0; i < this->Textures.size(); ++i)
  {
    glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER,
      GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(i), this->Textures[i], 0, view);
  }
  this->Window->GetState()->vtkglDepthMask(GL_TRUE); // props may have changed it
  relievo::ClearToBackground(this->Layout);
  const GLfloat farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

//------------------------------------------------------------------------------
void vtkRelievoViewsTarget::End()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glFinish(); // see vtkRelievoGBufferTarget::Read
  const std::size_t pixels = static_cast<std::size_t>(this->Width) * this->Height;
  for (std::size_t i = 0; i < this->Textures.size(); ++i)
  {
    const int channels = this->Layout.GetNumberOfChannels(static_cast<int>(i));
    this->Words[i].resize(pixels * static_cast<std::size_t>(channels * this->Views));
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &bound);
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Textures[i]);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, relievo::TexelFormat::Get(channels).External,
      GL_UNSIGNED_INT, this->Words[i].data());
    glBindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(bound));
  }
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
bool vtkRelievoViewsTarget::Read(
  int attachment, const int[4], const std::vector<std::uint32_t*>& planes)
{
  const auto number = static_cast<std::size_t>(attachment);
  const int channels = this->Layout.GetNumberOfChannels(attachment);
  const std::ptrdiff_t pixels = static_cast<std::ptrdiff_t>(this->Width) * this->Height;
  const std::uint32_t* first = this->Words[number].data() + this->Selected * pixels * channels;
  for (std::size_t k = 0; k < planes.size(); ++k)
  {
    relievo::Gather(first + k, channels, planes[k], pixels);
  }
  return true;
}
