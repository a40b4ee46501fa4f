// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLuminanceMeter.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace
{
constexpr int Side = 8; // of the squares, as in measureFS.glsl

int GetWidth(vtkTextureObject* texture)
{
  return static_cast<int>(texture->GetWidth());
}

int GetHeight(vtkTextureObject* texture)
{
  return static_cast<int>(texture->GetHeight());
}
}

//------------------------------------------------------------------------------
void vtkRelievoLuminanceMeter::Allocate(vtkRelievoFrameContext& context)
{
  const int* size = context.View.Viewport + 2;
  if (!this->Sums.empty() && this->Size[0] == size[0] && this->Size[1] == size[1] &&
    this->Sums.front()->GetContext() == context.Window)
  {
    return;
  }
  this->Release(context.Window);
  this->Pen = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Pen->SetContext(context.Window);
  int width = this->Size[0] = size[0];
  int height = this->Size[1] = size[1];
  do
  {
    width = (width + Side - 1) / Side;
    height = (height + Side - 1) / Side;
    auto sums = vtkSmartPointer<vtkTextureObject>::New();
    sums->SetContext(context.Window);
    sums->SetInternalFormat(GL_RGBA32F);
    sums->SetFormat(GL_RGBA);
    sums->SetDataType(GL_FLOAT);
    sums->SetMinificationFilter(vtkTextureObject::Nearest);
    sums->SetMagnificationFilter(vtkTextureObject::Nearest);
    sums->Allocate2D(
      static_cast<unsigned int>(width), static_cast<unsigned int>(height), 4, VTK_FLOAT);
    this->Sums.push_back(sums);
  } while (width > 1 || height > 1);
}

//------------------------------------------------------------------------------
std::string vtkRelievoLuminanceMeter::Measure(vtkRelievoFrameContext& context)
{
  this->Allocate(context);
  const vtkRelievoScopedState kept(context.Window->GetState());
  context.Window->GetState()->vtkglDisable(GL_BLEND);
  this->Pen->Bind();
  const vtkSmartPointer<vtkTextureObject>* summed = nullptr;
  for (const auto& sums : this->Sums)
  {
    vtkRelievoScreenQuad& quad = summed ? this->Rest : this->First;
    vtkShaderProgram* program = summed
      ? quad.Ready(context, "tone/measureFS.glsl", {})
      : quad.Ready(context, "tone/measureFS.glsl",
          { vtkRelievoResources::Color, vtkRelievoResources::Drawn }, "#define RELIEVO_FIRST\n");
    if (!program)
    {
      return quad.GetError();
    }
    const int size[2] = { summed ? GetWidth(*summed) : this->Size[0],
      summed ? GetHeight(*summed) : this->Size[1] };
    const int area[4] = { 0, 0, GetWidth(sums), GetHeight(sums) };
    const float target[2] = { static_cast<float>(area[2]), static_cast<float>(area[3]) };
    program->SetUniform2i("toneSize", size);
    program->SetUniform2f("toneTarget", target);
    if (summed)
    {
      (*summed)->Activate();
      program->SetUniformi("toneSums", (*summed)->GetTextureUnit());
    }
    else
    {
      // A gradient or a texture behind everything is opaque.
      vtkRenderer* renderer = context.Renderer;
      const bool plain = !renderer->GetGradientBackground() && !renderer->GetTexturedBackground();
      program->SetUniformf(
        "toneBackgroundAlpha", plain ? static_cast<float>(renderer->GetBackgroundAlpha()) : 1.0F);
    }
    this->Pen->AddColorAttachment(0, sums);
    this->Pen->ActivateDrawBuffer(0);
    quad.Draw(context, area);
    if (summed)
    {
      (*summed)->Deactivate();
    }
    summed = &sums;
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoLuminanceMeter::Activate(vtkShaderProgram* program)
{
  this->Sums.back()->Activate();
  program->SetUniformi("toneSums", this->Sums.back()->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkRelievoLuminanceMeter::Deactivate()
{
  this->Sums.back()->Deactivate();
}

//------------------------------------------------------------------------------
bool vtkRelievoLuminanceMeter::Read(float sums[4])
{
  auto* window = this->Sums.empty()
    ? nullptr
    : vtkOpenGLRenderWindow::SafeDownCast(this->Sums.back()->GetContext());
  if (!window)
  {
    return false;
  }
  window->MakeCurrent();
  const vtkRelievoScopedState kept(window->GetState());
  this->Pen->Bind();
  this->Pen->AddColorAttachment(0, this->Sums.back());
  this->Pen->ActivateReadBuffer(0);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, sums);
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLuminanceMeter::GetBytes() const
{
  vtkIdType bytes = 0;
  for (const auto& sums : this->Sums)
  {
    bytes += vtkIdType(16) * sums->GetWidth() * sums->GetHeight();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoLuminanceMeter::Release(vtkWindow* window)
{
  this->First.Release(window);
  this->Rest.Release(window);
  for (const auto& sums : this->Sums)
  {
    sums->ReleaseGraphicsResources(window);
  }
  this->Sums.clear();
  if (this->Pen)
  {
    this->Pen->ReleaseGraphicsResources(window);
    this->Pen = nullptr;
  }
}
