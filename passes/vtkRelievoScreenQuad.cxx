// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoScreenQuad.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoKeptState.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

//------------------------------------------------------------------------------
vtkRelievoScreenQuad::vtkRelievoScreenQuad() = default;

//------------------------------------------------------------------------------
vtkRelievoScreenQuad::~vtkRelievoScreenQuad() = default;

//------------------------------------------------------------------------------
vtkShaderProgram* vtkRelievoScreenQuad::Ready(vtkOpenGLRenderWindow* window,
  vtkRelievoGBufferPass* gbuffer, const std::string& source, const std::string& defines)
{
  if (!gbuffer->GetTexture(0))
  {
    return nullptr;
  }
  const std::string all = gbuffer->GetLayout().GetDefines() + defines;
  const std::string key = source + "\n" + all;
  if (this->Key == key)
  {
    return this->Quad ? window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program) : nullptr;
  }
  this->Key = key;
  this->Quad.reset();
  const std::string quad = vtkRelievoShaderLibrary::Get("screen/quadVS.glsl");
  std::string text = vtkRelievoShaderLibrary::Get(source);
  vtkShaderProgram::Substitute(text, "//RELIEVO::Defines", all, false);
  // VTK's helper takes it for granted that its shaders compile.
  if (!window->GetShaderCache()->ReadyShaderProgram(quad.c_str(), text.c_str(), ""))
  {
    return nullptr;
  }
  this->Quad.reset(new vtkOpenGLQuadHelper(window, quad.c_str(), text.c_str(), ""));
  return this->Quad->Program;
}

//------------------------------------------------------------------------------
void vtkRelievoScreenQuad::Draw(
  vtkOpenGLRenderWindow* window, vtkRelievoGBufferPass* gbuffer, const vtkRelievoView& view)
{
  vtkShaderProgram* program = this->Quad->Program;
  static const char* const samplers[] = { "relievoWords1", "relievoWords2", "relievoWords3",
    "relievoWords4", "relievoWords5" };
  std::vector<vtkTextureObject*> textures;
  for (int i = 0; i < gbuffer->GetLayout().GetNumberOfAttachments(); ++i)
  {
    textures.push_back(gbuffer->GetTexture(i));
    textures.back()->Activate();
    program->SetUniformi(samplers[i], textures.back()->GetTextureUnit());
  }
  const float size[2] = { static_cast<float>(view.Viewport[2]),
    static_cast<float>(view.Viewport[3]) };
  int offset[2];
  gbuffer->GetOffset(offset);
  double range[2];
  gbuffer->GetClippingRange(range);
  program->SetUniform2f("relievoSize", size);
  program->SetUniform2i("relievoOffset", offset);
  program->SetUniformf("relievoNear", static_cast<float>(range[0]));
  program->SetUniformf("relievoFar", static_cast<float>(range[1]));
  program->SetUniformi("relievoParallel", view.Parallel);

  vtkOpenGLState* state = window->GetState();
  const vtkRelievoKeptState kept(state);
  state->vtkglViewport(view.Viewport[0], view.Viewport[1], view.Viewport[2], view.Viewport[3]);
  state->vtkglScissor(view.Viewport[0], view.Viewport[1], view.Viewport[2], view.Viewport[3]);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  this->Quad->Render();
  for (vtkTextureObject* texture : textures)
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoScreenQuad::Release(vtkWindow* window)
{
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Key.clear();
}
