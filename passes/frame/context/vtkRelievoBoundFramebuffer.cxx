// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBoundFramebuffer.h"

#include "vtkOpenGLError.h" // for OpenGL

//------------------------------------------------------------------------------
int vtkRelievoBoundFramebuffer::GetNumber(bool reading)
{
  GLint bound = 0;
  glGetIntegerv(reading ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return bound;
}

//------------------------------------------------------------------------------
int vtkRelievoBoundFramebuffer::GetSamples()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return samples;
}

//------------------------------------------------------------------------------
vtkRelievoBoundFramebuffer::DepthFormat vtkRelievoBoundFramebuffer::GetDepth()
{
  DepthFormat format;
  GLint type = GL_UNSIGNED_NORMALIZED;
  const bool own = GetNumber() == 0; // the window's
  const GLenum place = own ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
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
  const GLenum stencil = own ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  format.Stencil = type != GL_NONE;
  return format;
}

//------------------------------------------------------------------------------
unsigned int vtkRelievoBoundFramebuffer::DepthFormat::GetFormat() const
{
  return this->Stencil ? GL_DEPTH24_STENCIL8
    : this->Float      ? GL_DEPTH_COMPONENT32F
    : this->Bits == 32 ? GL_DEPTH_COMPONENT32
    : this->Bits == 16 ? GL_DEPTH_COMPONENT16
                       : GL_DEPTH_COMPONENT24;
}
