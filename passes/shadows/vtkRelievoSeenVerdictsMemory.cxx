// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the verdicts take of OpenGL.
#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoColorBuffers.h"
#include "vtkRelievoPushedContext.h"
#include "vtkRelievoSeenVerdicts.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <string>

//------------------------------------------------------------------------------
bool vtkRelievoSeenVerdicts::Allocate()
{
  const int* size = this->View.Viewport + 2;
  const unsigned int depths = vtkRelievoColorBuffers::GetBoundDepthFormat();
  if (this->Textures[0] && this->Width == size[0] && this->Height == size[1] &&
    this->DepthFormat == depths && this->RoomIsFor == this->Colored)
  {
    return this->Room;
  }
  this->DepthFormat = depths;
  this->RoomIsFor = this->Colored;
  this->Width = size[0];
  this->Height = size[1];
  this->SurfacesDrawn.clear();
  this->VerdictsDrawn.clear();
  this->Checked = false;
  if (!this->Arrays)
  {
    glGenVertexArrays(1, &this->Arrays);
    glGenTextures(Count, this->Textures);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(this->Window);
  }
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // Others' errors: what follows is to be known.
  }
  // What lies within one step of the picture's depths hides what it hides there.
  const bool stencil = depths == GL_DEPTH24_STENCIL8;
  const GLint formats[Count] = { GL_RG32F, this->Colored ? GL_RGBA32F : GL_R32F,
    static_cast<GLint>(depths), GL_R32F };
  const GLenum channels[Count] = { GL_RG, static_cast<GLenum>(this->Colored ? GL_RGBA : GL_RED),
    static_cast<GLenum>(stencil ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT), GL_RED };
  this->Window->GetState()->vtkglActiveTexture(
    GL_TEXTURE0 + static_cast<unsigned int>(this->Units[0]));
  for (int i = 0; i < Count; ++i)
  {
    const int width = i == Tiles ? CountTiles(this->Width) : this->Width;
    const int height = i == Tiles ? CountTiles(this->Height) : this->Height;
    glBindTexture(GL_TEXTURE_2D, this->Textures[i]);
    glTexImage2D(GL_TEXTURE_2D, 0, formats[i], width, height, 0, channels[i],
      i == Depth && stencil ? GL_UNSIGNED_INT_24_8 : GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0);
  this->Room = glGetError() == GL_NO_ERROR; // else rays for each fragment
  return this->Room;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSeenVerdicts::GetSource(const std::string& name) const
{
  std::string source = vtkRelievoShaderLibrary::Get(name);
  if (this->Colored)
  {
    vtkShaderProgram::Substitute(
      source, "//VTK::System::Dec", "//VTK::System::Dec\n#define RELIEVO_SHADOW_COLORED", false);
  }
  return source;
}

//------------------------------------------------------------------------------
// Before shaders are built that look verdicts up.
bool vtkRelievoSeenVerdicts::IsReady()
{
  if (this->Checked)
  {
    return !this->Broken;
  }
  this->Checked = true;
  std::string fault;
  for (const std::string name : { "shadow/seen", "shadow/tiles", "shadow/verdicts" })
  {
    const bool compiles = this->Window->GetShaderCache()->ReadyShaderProgram(
      this->GetSource(name + "VS.glsl").c_str(), this->GetSource(name + "FS.glsl").c_str(), "");
    fault = compiles ? fault : "the shader " + name + " does not compile";
  }
  for (const int target : { Surfaces, Verdicts, Tiles })
  {
    this->BeginDrawing(this->Textures[target], 1, 1);
    const bool deep = target == Surfaces;
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, deep ? this->Textures[Depth] : 0, 0);
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    this->EndDrawing();
    fault = status == GL_FRAMEBUFFER_COMPLETE ? fault : "its framebuffer is incomplete";
  }
  this->Broken = !fault.empty();
  if (this->Broken)
  {
    vtkGenericWarningMacro("Exact shadows are found by each fragment, slowly: " << fault << ".");
  }
  return !this->Broken;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoSeenVerdicts::GetBytes() const
{
  const vtkIdType colors = this->Colored ? BytesOfColors * this->Width * this->Height : 0;
  return this->Room ? GetBytes(this->Width, this->Height) + colors : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoSeenVerdicts::GetBytes(int width, int height)
{
  const vtkIdType tiles = static_cast<vtkIdType>(CountTiles(width)) * CountTiles(height);
  return BytesPerPixel * width * height + 4 * tiles;
}

//------------------------------------------------------------------------------
void vtkRelievoSeenVerdicts::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // what is held is another window's
  }
  const vtkRelievoPushedContext context(window);
  if (window)
  {
    this->Unbind(); // also units without textures
  }
  if (window && window == this->Owner && this->Textures[0])
  {
    glDeleteTextures(Count, this->Textures);
    glDeleteVertexArrays(1, &this->Arrays);
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  std::fill_n(this->Textures, Count, 0);
  std::fill_n(this->Units, 2, -1);
  this->Arrays = 0;
  this->Framebuffer = nullptr;
  this->Room = this->Fits = this->Broken = this->Checked = false;
  this->Width = this->Height = this->Lights = 0;
  this->SurfacesDrawn.clear();
  this->VerdictsDrawn.clear();
}
