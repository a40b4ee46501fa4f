// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLCheck.h"

#include "Check.h"

#include <vtkOpenGLError.h>
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <cstring>
#include <sstream>

// Declarations of functions that the driver calls, under the names of both GL loaders.
#ifndef GLAPIENTRY
#define GLAPIENTRY GLAD_API_PTR
#endif

namespace relievoTest
{
namespace
{
// Mesa gives its shader compiler's warnings high severity, and only when it compiles, not when it
// uses its disk cache. These are for VTK's vtkEDLShadeFS.glsl and its volumes' shaders.
bool IsKnownWarning(GLenum source, const std::string& text)
{
  if (source != GL_DEBUG_SOURCE_SHADER_COMPILER)
  {
    return false;
  }
  for (const char* known : { "warning: `S' used uninitialized", "warning: `t' used uninitialized",
         "warning: `Z' used uninitialized", "warning: `g_eyePosObj' used uninitialized" })
  {
    if (text.find(known) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

void GLAPIENTRY TakeMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
  const GLchar* message, const void* count)
{
  const std::string words(message, length < 0 ? std::strlen(message) : static_cast<size_t>(length));
  if ((type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) ||
    IsKnownWarning(source, words))
  {
    return;
  }
  ++*static_cast<int*>(const_cast<void*>(count));
  std::ostringstream text;
  text << "(" << id << ") " << words;
  Fail("OpenGL", 0, text.str());
}

const char* NameOfError(GLenum error)
{
  switch (error)
  {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "an unknown error";
  }
}

// Makes the window current, creating its context if necessary; null if that fails.
vtkOpenGLRenderWindow* MakeCurrent(vtkRenderWindow* window)
{
  vtkOpenGLRenderWindow* gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (gl)
  {
    gl->Initialize();
    gl->MakeCurrent();
  }
  return gl && gl->IsCurrent() ? gl : nullptr;
}

// Makes the window current if it has a context; a closed window gets no new one.
bool HasContext(vtkOpenGLRenderWindow* window)
{
  if (window)
  {
    window->MakeCurrent();
  }
  return window && window->IsCurrent();
}

// Bytes of all levels of one texture.
long long TextureBytes(GLuint texture)
{
  GLint shown = 0;
  glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &shown);
  if (shown != 0)
  {
    return 0; // counted as the buffer that it shows; other queries are errors
  }
  GLint target = 0;
  glGetTextureParameteriv(texture, GL_TEXTURE_TARGET, &target);
  const long long faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
  long long bytes = 0;
  for (GLint level = 0; level < 16; ++level)
  {
    const auto get = [&](GLenum name) {
      GLint value = 0;
      glGetTextureLevelParameteriv(texture, level, name, &value);
      return static_cast<long long>(value);
    };
    const long long texels = get(GL_TEXTURE_WIDTH) * get(GL_TEXTURE_HEIGHT) * get(GL_TEXTURE_DEPTH);
    if (texels == 0)
    {
      break;
    }
    long long bits = 0;
    for (const GLenum name : { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
           GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE })
    {
      bits += get(name);
    }
    bytes += texels * faces * std::max(get(GL_TEXTURE_SAMPLES), 1LL) * bits / 8;
    if (target == GL_TEXTURE_RECTANGLE || target == GL_TEXTURE_2D_MULTISAMPLE ||
      target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY)
    {
      break; // these have one level; querying another is an error
    }
  }
  return bytes;
}

long long RenderbufferBytes(GLuint buffer)
{
  const auto get = [&](GLenum name) {
    GLint value = 0;
    glGetNamedRenderbufferParameteriv(buffer, name, &value);
    return static_cast<long long>(value);
  };
  long long bits = 0;
  for (const GLenum name :
    { GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE,
      GL_RENDERBUFFER_ALPHA_SIZE, GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE })
  {
    bits += get(name);
  }
  return get(GL_RENDERBUFFER_WIDTH) * get(GL_RENDERBUFFER_HEIGHT) *
    std::max(get(GL_RENDERBUFFER_SAMPLES), 1LL) * bits / 8;
}
}

//------------------------------------------------------------------------------
GLCheck::GLCheck(vtkRenderWindow* window)
  : Window(MakeCurrent(window))
  , Count(new int(0))
{
  if (!this->Window)
  {
    Fail(__FILE__, __LINE__, "the window has no OpenGL context that can be made current");
    return;
  }
  this->Poll("before watching");
  if (!glDebugMessageCallback)
  {
    Fail(__FILE__, __LINE__, "this OpenGL has no debug output (KHR_debug, or 4.3)");
    return;
  }
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(TakeMessage, this->Count.get());
}

//------------------------------------------------------------------------------
GLCheck::~GLCheck()
{
  if (HasContext(this->Window))
  {
    this->Poll("at the end");
    if (glDebugMessageCallback)
    {
      glDebugMessageCallback(nullptr, nullptr);
      glDisable(GL_DEBUG_OUTPUT);
    }
  }
}

//------------------------------------------------------------------------------
void GLCheck::Poll(const std::string& where)
{
  if (!HasContext(this->Window))
  {
    return;
  }
  // A lost context reports errors for ever: stops after a few.
  for (int i = 0; i < 8; ++i)
  {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR)
    {
      break;
    }
    ++*this->Count;
    Fail("OpenGL", 0, std::string("glGetError says ") + NameOfError(error) + " " + where);
  }
}

//------------------------------------------------------------------------------
int GLCheck::Errors() const
{
  return *this->Count;
}

//------------------------------------------------------------------------------
int GLObjects::Total() const
{
  return this->Textures + this->Buffers + this->Renderbuffers + this->Framebuffers +
    this->Programs + this->Shaders + this->Queries + this->VertexArrays;
}

//------------------------------------------------------------------------------
std::string GLObjects::ToString() const
{
  std::ostringstream text;
  text << this->Bytes << " bytes, " << this->Textures << " textures, " << this->Buffers
       << " buffers, " << this->Renderbuffers << " renderbuffers, " << this->Framebuffers
       << " framebuffers, " << this->Programs << " programs, " << this->Shaders << " shaders, "
       << this->Queries << " queries, " << this->VertexArrays << " vertex arrays";
  return text.str();
}

//------------------------------------------------------------------------------
GLObjects CountGLObjects(vtkRenderWindow* window)
{
  GLObjects count;
  if (!MakeCurrent(window) || !glGetTextureLevelParameteriv)
  {
    Fail(__FILE__, __LINE__, "OpenGL objects can be counted only in a context of OpenGL 4.5");
    return count;
  }
  for (GLuint name = 1; name < 65536; ++name)
  {
    if (glIsTexture(name))
    {
      ++count.Textures;
      count.Bytes += TextureBytes(name);
    }
    if (glIsBuffer(name))
    {
      ++count.Buffers;
      GLint64 size = 0;
      glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &size);
      count.Bytes += size;
    }
    if (glIsRenderbuffer(name))
    {
      ++count.Renderbuffers;
      count.Bytes += RenderbufferBytes(name);
    }
    count.Framebuffers += glIsFramebuffer(name) ? 1 : 0;
    count.Programs += glIsProgram(name) ? 1 : 0;
    count.Shaders += glIsShader(name) ? 1 : 0;
    count.Queries += glIsQuery(name) ? 1 : 0;
    count.VertexArrays += glIsVertexArray(name) ? 1 : 0;
  }
  return count;
}
}
