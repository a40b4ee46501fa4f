// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoForwardMasks.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

namespace
{
// Neighbouring samples form one surface while their depths differ by less than this number of texel
// widths: a surface at 3.6 degrees to the light.
constexpr double Steepest = 16.0;
}

//------------------------------------------------------------------------------
vtkRelievoForwardMasks::vtkRelievoForwardMasks() = default;

//------------------------------------------------------------------------------
vtkRelievoForwardMasks::~vtkRelievoForwardMasks()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::GetViewport(int region[4])
{
  glGetIntegerv(GL_VIEWPORT, region);
}

//------------------------------------------------------------------------------
bool vtkRelievoForwardMasks::Allocate(
  vtkOpenGLRenderWindow* window, int width, int height, int lights)
{
  if (this->Window == window && this->Width == width && this->Height == height &&
    this->Lights == lights)
  {
    return false;
  }
  this->Release(this->Window);
  this->Window = window;
  this->Width = width;
  this->Height = height;
  this->Lights = lights;
  this->Masks = vtkRelievoShadowMaps::MakeArray(GL_R8, width, height, lights);
  if (!this->Masks)
  {
    return true; // not tried again before another request
  }
  glGenVertexArrays(1, &this->Arrays);
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(window);
  this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  this->SavedState.reset(new vtkRelievoScopedState(state));
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglScissor(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::DrawTo(unsigned int buffer)
{
  // VTK caches the buffers of the previously bound framebuffer and may skip changes.
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDrawBuffers(1, &buffer);
  glDrawBuffers(1, &buffer);
  state->vtkglReadBuffer(buffer);
  glReadBuffer(buffer);
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::End()
{
  this->SavedState.reset();
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::DrawDepth(const std::function<void()>& surfaces)
{
  this->Begin();
  vtkOpenGLState* state = this->Window->GetState();
  this->DrawTo(GL_NONE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Depth->GetHandle(), 0);
  const GLfloat farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  surfaces();
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  this->End();
}

//------------------------------------------------------------------------------
bool vtkRelievoForwardMasks::BeginLight(
  int light, const vtkRelievoFrameCamera& camera, int mapUnit, int mapSize)
{
  this->Begin();
  vtkOpenGLState* state = this->Window->GetState();
  glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Masks, 0, light);
  this->DrawTo(GL_COLOR_ATTACHMENT0);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const GLfloat dark[4] = { 0.f, 0.f, 0.f, 0.f };
  glClearBufferfv(GL_COLOR, 0, dark);
  this->Program = this->Window->GetShaderCache()->ReadyShaderProgram(
    vtkRelievoShaderLibrary::Get("shadow/forwardVS.glsl").c_str(),
    vtkRelievoShaderLibrary::Get("shadow/forwardFS.glsl").c_str(), "");
  if (!this->Program)
  {
    return false;
  }
  this->WorldToView = camera.WorldToView;
  this->ViewToNDC = camera.ViewToNDC;
  this->MapSize = mapSize;
  // NDC z is (p22 z + p32) / (p23 z + p33) of eye-space z: solved for -z.
  const glm::dmat4& p = camera.ViewToNDC;
  const float depthFromZ[4] = { static_cast<float>(p[3][2]), static_cast<float>(-p[3][3]),
    static_cast<float>(p[2][2]), static_cast<float>(-p[2][3]) };
  this->Depth->Activate();
  this->Program->SetUniform4f("relievoDepthFromZ", depthFromZ);
  this->Program->SetUniformi("relievoCameraDepth", this->Depth->GetTextureUnit());
  this->Program->SetUniformi("relievoShadowMaps", mapUnit);
  this->Program->SetUniformi("relievoSize", mapSize);
  glBindVertexArray(this->Arrays);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::DrawMap(const vtkRelievoShadowView& view, int layer, double tolerance)
{
  const glm::dmat4 worldToMap =
    vtkRelievoShadowMaps::GetNDCToMap(this->MapSize) * view.ViewToNDC * view.WorldToView;
  const glm::dmat4 mapToView = this->WorldToView * glm::inverse(worldToMap);
  const glm::mat4 toView(mapToView);
  const glm::mat4 toClip(this->ViewToNDC * mapToView);
  const double range = view.Far - view.Near;
  const float w[2] = { static_cast<float>(view.Parallel ? 1.0 : 1.0 / view.Near),
    static_cast<float>(view.Parallel ? 0.0 : -range / (view.Far * view.Near)) };
  const double texel = std::max(view.Width, view.Height) / this->MapSize;
  this->Program->SetUniformi("relievoLayer", layer);
  this->Program->SetUniformMatrix4x4("relievoMapToView", const_cast<float*>(&toView[0][0]));
  this->Program->SetUniformMatrix4x4("relievoMapToClip", const_cast<float*>(&toClip[0][0]));
  this->Program->SetUniformf("relievoJump", static_cast<float>(Steepest * view.Texel));
  this->Program->SetUniformf("relievoTexel", static_cast<float>(texel));
  this->Program->SetUniform2f("relievoW", w);
  this->Program->SetUniformf("relievoTolerance", static_cast<float>(tolerance));
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * this->MapSize, this->MapSize);
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::EndLight()
{
  glBindVertexArray(0);
  this->Depth->Deactivate();
  glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 0, 0, 0);
  this->End();
}

//------------------------------------------------------------------------------
bool vtkRelievoForwardMasks::Bind()
{
  vtkOpenGLState* state = this->Window->GetState();
  if (!this->Masks)
  {
    return false;
  }
  if (this->Unit < 0)
  {
    this->Unit = state->GetTextureUnitManager()->Allocate();
  }
  if (this->Unit < 0)
  {
    return false;
  }
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Masks);
  state->vtkglActiveTexture(GL_TEXTURE0);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::Unbind()
{
  if (this->Unit >= 0 && this->Window)
  {
    vtkOpenGLState* state = this->Window->GetState();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    state->vtkglActiveTexture(GL_TEXTURE0);
    state->GetTextureUnitManager()->Free(this->Unit);
  }
  this->Unit = -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoForwardMasks::GetBytes(int width, int height, int lights)
{
  return static_cast<vtkIdType>(width) * height * (4 + lights);
}

//------------------------------------------------------------------------------
void vtkRelievoForwardMasks::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // the resources belong to another window
  }
  if (window && this->Masks)
  {
    const vtkRelievoScopedContext context(window);
    this->Unbind();
    glDeleteTextures(1, &this->Masks);
    glDeleteVertexArrays(1, &this->Arrays);
    this->Depth->ReleaseGraphicsResources(window);
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  this->Masks = 0;
  this->Arrays = 0;
  this->Depth = nullptr;
  this->Framebuffer = nullptr;
  this->Program = nullptr;
  this->Unit = -1;
  this->Width = this->Height = this->Lights = 0;
}
