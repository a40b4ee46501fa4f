// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMaps.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRenderer.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace
{
// Uniforms of a fragment shader beside those of VTK's own shader.
int CountFreeNumbers()
{
  constexpr int ForOthers = 512;
  GLint numbers = 0;
  glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &numbers);
  return numbers - ForOthers;
}
}

//------------------------------------------------------------------------------
vtkRelievoShadowMaps::vtkRelievoShadowMaps() = default;

//------------------------------------------------------------------------------
vtkRelievoShadowMaps::~vtkRelievoShadowMaps()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
int vtkRelievoShadowMaps::GetLargestSize()
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  return limit;
}

//------------------------------------------------------------------------------
unsigned int vtkRelievoShadowMaps::MakeArray(unsigned int format, int width, int height, int layers)
{
  const bool depth = format == GL_DEPTH_COMPONENT32F;
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // Clears earlier errors, to detect errors of the calls below.
  }
  GLint others = 0; // such as the maps of lights, when those of lamps are made
  glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &others);
  unsigned int texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format), width, height, layers, 0,
    depth ? GL_DEPTH_COMPONENT : GL_RED, depth ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
  const bool there = glGetError() == GL_NO_ERROR;
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  glBindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(others));
  if (!there)
  {
    glDeleteTextures(1, &texture);
    texture = 0;
  }
  return texture;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowMaps::Allocate(vtkOpenGLRenderWindow* window, int size, int layers)
{
  if (this->Window == window && this->Size == size && this->Layers == layers)
  {
    return false;
  }
  this->Release(this->Window);
  this->Window = window;
  this->Size = size;
  this->Layers = layers;
  this->Nearest.Begin(size, layers);
  const int side = layers > 0 ? size : 1;
  this->Texture = MakeArray(GL_DEPTH_COMPONENT32F, side, side, std::max(1, layers));
  if (!this->Texture)
  {
    return true; // not tried again before another request
  }
  this->Empty = MakeArray(GL_DEPTH_COMPONENT32F, 1, 1, 1);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  return true;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowMaps::GetMostFaces()
{
  // Numbers per map side in shaders/shadow/receive.glsl and the methods' files.
  constexpr int PerFace = 48;
  constexpr int Enough = 96;
  return std::min(Enough, std::max(6, CountFreeNumbers() / PerFace));
}

//------------------------------------------------------------------------------
int vtkRelievoShadowMaps::GetMostRays()
{
  constexpr int PerRay = 4; // alignment of arrays
  return std::max(1, CountFreeNumbers() / 2 / PerRay);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoShadowMaps::GetNDCToMap(int size)
{
  const double half = 0.5 * size;
  glm::dmat4 m(0.5);
  m[0].x = m[1].y = half;
  m[3] = glm::dvec4(half - 0.5, half - 0.5, 0.5, 1.0);
  return m;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkRelievoShadowMaps::GetRay(
  const vtkRelievoShadowView& view, const glm::dvec3& direction) const
{
  const glm::dvec3 ray =
    glm::dmat3(GetNDCToMap(this->Size) * view.ViewToNDC * view.WorldToView) * direction;
  return -glm::dvec2(ray) / ray.z;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  this->SavedState.reset(new vtkRelievoScopedState(state));
  this->Framebuffer->Bind();
  // VTK caches the buffers of the previously bound framebuffer and may skip changes.
  unsigned int none = GL_NONE;
  state->vtkglDrawBuffers(1, &none);
  glDrawBuffers(1, &none);
  state->vtkglViewport(0, 0, this->Size, this->Size);
  state->vtkglScissor(0, 0, this->Size, this->Size);
  state->vtkglReadBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowMaps::Draw(int layer, vtkRelievoShadowView& view, vtkRenderer* renderer,
  const CastersInMemory& inMemory, const Casters& casters)
{
  if (!this->Camera)
  {
    this->Camera = vtkSmartPointer<vtkCamera>::New();
    this->Camera->UseExplicitProjectionTransformMatrixOn();
  }
  // Clamping fragments is slower in software OpenGL.
  view.Clamps() ? glEnable(GL_DEPTH_CLAMP) : glDisable(GL_DEPTH_CLAMP);

  // Far enough for the direction to keep its digits.
  const double reach =
    std::max({ std::abs(view.Far), view.Width, view.Height, 1e-6 * glm::length(view.Position) });
  const glm::dvec3 focus = view.Position + view.Forward * reach;
  this->Camera->SetParallelProjection(view.Parallel);
  this->Camera->SetPosition(view.Position.x, view.Position.y, view.Position.z);
  this->Camera->SetFocalPoint(focus.x, focus.y, focus.z);
  this->Camera->SetViewUp(view.Up.x, view.Up.y, view.Up.z);
  view.WorldToView = vtkRelievoToGlm(this->Camera->GetModelViewTransformMatrix());
  auto forPieces = [&](auto&& work) {
    for (int u = 0; u < view.U.Pieces; ++u)
    {
      for (int v = 0; v < view.V.Pieces; ++v)
      {
        int region[4];
        const vtkRelievoShadowView piece = view.GetPiece(u, v, this->Size, region);
        work(piece, region);
      }
    }
  };
  glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, this->Texture, 0, layer);
  bool drawn = false;
  bool failed = false;
  if (inMemory)
  {
    this->Raster.Clear(this->Size);
    forPieces([&](const vtkRelievoShadowView& piece, const int region[4]) {
      this->DrawPiece(piece, region, renderer, false, [&](const vtkRelievoShadowView&, bool) {
        try
        {
          drawn = !failed && inMemory(piece, region, this->Raster);
        }
        catch (const std::exception&) // out of memory, or of threads
        {
          failed = true;
          this->Raster = vtkRelievoDepthRaster();
        }
        return false;
      });
    });
    drawn = drawn && !failed && !this->Raster.GetDepths().empty();
  }
  if (drawn)
  {
    this->Write(layer, this->Raster.GetDepths());
  }
  else
  {
    this->Window->GetState()->vtkglScissor(0, 0, this->Size, this->Size);
    const GLfloat farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
  }
  bool others = false;
  forPieces([&](const vtkRelievoShadowView& piece, const int region[4]) {
    others = this->DrawPiece(piece, region, renderer, drawn, casters) || others;
  });
  if (!drawn || others)
  {
    this->Nearest.Forget(layer);
  }
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowMaps::DrawPiece(const vtkRelievoShadowView& view, const int region[4],
  vtkRenderer* renderer, bool others, const Casters& casters)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglViewport(region[0], region[1], region[2], region[3]);
  state->vtkglScissor(region[0], region[1], region[2], region[3]);
  vtkNew<vtkMatrix4x4> projection;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      projection->SetElement(row, column, view.ViewToNDC[column][row]);
    }
  }
  this->Camera->SetExplicitProjectionTransformMatrix(projection);
  this->Camera->Modified();
  vtkCamera*& active = vtkRelievoAccess::Renderer::CameraInUse(renderer);
  vtkCamera* const own = active;
  active = this->Camera;
  const bool any = casters(view, others);
  active = own;
  return any;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::Read(std::vector<float>& depths)
{
  depths.resize(static_cast<std::size_t>(this->Size) * this->Size);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, this->Size, this->Size, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::Write(int layer, const std::vector<float>& depths)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  this->BindTexture(this->Texture);
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, this->Size, this->Size, 1,
    GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  this->BindTexture(this->Empty);
  this->Nearest.Set(layer, depths);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::End()
{
  glDisable(GL_DEPTH_CLAMP);
  glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, 0, 0, 0);
  this->Raster = vtkRelievoDepthRaster();
  this->SavedState.reset();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::DrawBothSides(vtkOpenGLRenderWindow* window)
{
  window->GetState()->vtkglDisable(GL_CULL_FACE);
  window->GetState()->vtkglDepthMask(GL_TRUE); // also for translucent geometry
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::BindTexture(unsigned int texture)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  state->vtkglActiveTexture(GL_TEXTURE0);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowMaps::Bind(bool maps)
{
  if (this->Unit < 0)
  {
    this->Unit = this->Window->GetState()->GetTextureUnitManager()->Allocate();
  }
  if (this->Unit >= 0)
  {
    this->BindTexture(maps ? this->Texture : this->Empty);
  }
  return this->Unit >= 0;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::Unbind()
{
  if (this->Unit >= 0 && this->Window)
  {
    this->BindTexture(0);
    this->Window->GetState()->GetTextureUnitManager()->Free(this->Unit);
  }
  this->Unit = -1;
  this->Nearest.Unbind();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowMaps::GetBytes(int size, int maps)
{
  return 4 * static_cast<vtkIdType>(size) * size * maps;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowMaps::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // the resources belong to another window
  }
  this->Nearest.Release(window);
  if (window && this->Texture)
  {
    // Not by the weak pointer, which is null in the window's own destructor.
    const vtkRelievoScopedContext context(window);
    this->Unbind();
    glDeleteTextures(1, &this->Texture);
    glDeleteTextures(1, &this->Empty);
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  this->Texture = 0;
  this->Empty = 0;
  this->Framebuffer = nullptr;
  this->Unit = -1;
  this->Size = 0;
  this->Layers = 0;
}
