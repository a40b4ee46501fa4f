// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTextureBuffer.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
vtkRelievoTextureBuffer::vtkRelievoTextureBuffer() = default;

//------------------------------------------------------------------------------
vtkRelievoTextureBuffer::~vtkRelievoTextureBuffer()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoTextureBuffer::Upload(
  vtkOpenGLRenderWindow* window, const std::vector<float>& values, int channels)
{
  const std::size_t texels = values.size() / channels;
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (texels > static_cast<std::size_t>(limit))
  {
    return "a list of " + std::to_string(texels) +
      " entries is needed, this OpenGL reads at most " + std::to_string(limit);
  }
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
  }
  if (!this->Buffer)
  {
    this->Buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
    this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer);
  }
  // An empty list is a texel that nobody reads: OpenGL makes no textures of nothing.
  const std::vector<float> nothing(static_cast<std::size_t>(channels), 0.0f);
  const std::vector<float>& all = values.empty() ? nothing : values;
  this->Buffer->Upload(all.data(), all.size(), vtkOpenGLBufferObject::TextureBuffer);
  this->Buffer->Release();
  const std::size_t count = all.size() / channels;
  if (!this->Texture || this->Texels != count || this->Channels != channels)
  {
    if (this->Texture)
    {
      this->Texture->ReleaseGraphicsResources(window);
    }
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(count), channels, VTK_FLOAT, this->Buffer);
    this->Texels = count;
    this->Channels = channels;
  }
  this->Bytes = static_cast<vtkIdType>(all.size() * sizeof(float));
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Activate(vtkShaderProgram* program, const char* sampler)
{
  this->Texture->Activate();
  program->SetUniformi(sampler, this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTextureBuffer::Release(vtkWindow* window)
{
  if (this->Texture && window)
  {
    this->Texture->ReleaseGraphicsResources(window);
  }
  if (this->Buffer && window)
  {
    this->Buffer->ReleaseGraphicsResources();
  }
  this->Texture = nullptr;
  this->Buffer = nullptr;
  this->Window = nullptr;
  this->Bytes = 0;
}
