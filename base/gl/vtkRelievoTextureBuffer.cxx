// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTextureBuffer.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoScopedContext.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

namespace
{
int MostTexels = 0;

GLenum GetFormat(int channels)
{
  return channels == 1 ? GL_R32F : channels == 2 ? GL_RG32F : GL_RGBA32F;
}
}

//------------------------------------------------------------------------------
vtkRelievoTextureBuffer::vtkRelievoTextureBuffer() = default;

//------------------------------------------------------------------------------
vtkRelievoTextureBuffer::~vtkRelievoTextureBuffer()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::SetMostTexels(int texels)
{
  MostTexels = texels;
}

//------------------------------------------------------------------------------
bool vtkRelievoTextureBuffer::IsIn(vtkOpenGLRenderWindow* window) const
{
  return this->Texture != 0 && this->Window == window;
}

//------------------------------------------------------------------------------
std::string vtkRelievoTextureBuffer::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<float>& values, int channels)
{
  const std::string fault = this->Allocate(window, values.size() / channels, channels);
  if (fault.empty())
  {
    this->Write(0, values.data(), values.size());
  }
  return fault;
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoTextureBuffer::GetMostTexels()
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  return static_cast<std::size_t>(MostTexels > 0 ? std::min(limit, MostTexels) : limit);
}

//------------------------------------------------------------------------------
std::string vtkRelievoTextureBuffer::Allocate(
  vtkOpenGLRenderWindow* window, std::size_t texels, int channels)
{
  const std::size_t most = GetMostTexels();
  if (texels > most)
  {
    return "a list of " + std::to_string(texels) +
      " entries is needed, but this OpenGL reads at most " + std::to_string(most);
  }
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
    this->Owner = window;
  }
  if (!this->Texture)
  {
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Texture);
  }
  // An empty list still gets one texel: OpenGL makes no empty textures.
  this->Bytes = static_cast<vtkIdType>(std::max<std::size_t>(1, texels) * channels * sizeof(float));
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glBufferData(GL_TEXTURE_BUFFER, this->Bytes, nullptr, GL_STATIC_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0);
  GLint others = 0; // the buffer bound to this unit by a user in the middle of a frame
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &others);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  glTexBuffer(GL_TEXTURE_BUFFER, GetFormat(channels), this->Buffer);
  glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(others));
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Write(std::size_t firstFloat, const float* values, std::size_t count)
{
  if (count > 0)
  {
    glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(firstFloat * sizeof(float)),
      static_cast<GLsizeiptr>(count * sizeof(float)), values);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Activate()
{
  if (!this->Window || !this->Texture)
  {
    return;
  }
  vtkOpenGLState* state = this->Window->GetState();
  if (this->Unit < 0)
  {
    this->Unit = state->GetTextureUnitManager()->Allocate();
  }
  if (this->Unit >= 0)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
    state->vtkglActiveTexture(GL_TEXTURE0);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::SetUniform(vtkShaderProgram* program, const char* sampler)
{
  program->SetUniformi(sampler, this->Unit);
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Activate(vtkShaderProgram* program, const char* sampler)
{
  this->Activate();
  this->SetUniform(program, sampler);
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Deactivate()
{
  if (this->Unit >= 0 && this->Window)
  {
    vtkOpenGLState* state = this->Window->GetState();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    state->vtkglActiveTexture(GL_TEXTURE0);
    state->GetTextureUnitManager()->Free(this->Unit);
  }
  this->Unit = -1;
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // the texture belongs to another window
  }
  if (window && window == this->Owner && this->Texture)
  {
    const vtkRelievoScopedContext context(window);
    this->Deactivate();
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->Texture = 0;
  this->Buffer = 0;
  this->Unit = -1;
  this->Window = nullptr;
  this->Owner = nullptr;
  this->Bytes = 0;
}
