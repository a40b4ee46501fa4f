// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDisplayStage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoLayerColors.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoView.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkRelievoDisplayStage);

namespace
{
// The layers that the shader decodes, by its RELIEVO_SHOW; 0 for all others.
int GetShown(const std::string& layer)
{
  static const char* const names[] = { "", "depth", "range", "normal", "geometric_normal",
    "albedo" };
  for (int i = 1; i < 6; ++i)
  {
    if (layer == names[i])
    {
      return i;
    }
  }
  return 0;
}
}

//------------------------------------------------------------------------------
vtkRelievoDisplayStage::vtkRelievoDisplayStage() = default;

//------------------------------------------------------------------------------
vtkRelievoDisplayStage::~vtkRelievoDisplayStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::SetFrame(const std::string& layer, const double range[2], bool grey)
{
  this->Layer = layer;
  this->Range[0] = range[0];
  this->Range[1] = range[1];
  this->Grey = grey;
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::IsNeeded(const vtkRenderState*, std::string& reason)
{
  reason = this->Layer.empty() ? "no layer is shown as the picture"
                               : "shows the layer " + this->Layer + " as the picture";
  return !this->Layer.empty();
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoDisplayStage::GetNeededLayers()
{
  return { this->Layer };
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::UploadColors(vtkRelievoPass* frame, vtkOpenGLRenderWindow* window)
{
  vtkNew<vtkImageData> image;
  if (!frame->ReadLayer(this->Layer, image))
  {
    return false;
  }
  int size[3];
  image->GetDimensions(size);
  std::vector<unsigned char> colors =
    vtkRelievoLayerColors::Make(image, this->Layer, this->Range, this->Grey);
  if (!this->Colors)
  {
    this->Colors = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Colors->SetContext(window);
  this->Colors->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Colors->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Colors->Create2DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), 4, VTK_UNSIGNED_CHAR, colors.data());
  this->ColorBytes = static_cast<vtkIdType>(colors.size());
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::PrepareQuad(vtkOpenGLRenderWindow* window, const std::string& defines)
{
  if (this->Quad && this->Defines == defines)
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  else
  {
    this->Defines = defines;
    std::string source = vtkRelievoShaderLibrary::Get("display/layerFS.glsl");
    vtkShaderProgram::Substitute(source, "//RELIEVO::Defines", defines, false);
    this->Quad.reset(new vtkOpenGLQuadHelper(window, nullptr, source.c_str(), ""));
  }
  return this->Quad->Program && this->Quad->Program->GetCompiled();
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::RenderAfter(vtkRelievoPass* frame, const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRelievoGBufferPass* gbuffer = frame->GetGBuffer();
  const vtkRelievoGBufferLayout& layout = gbuffer->GetLayout();
  const int shown = GetShown(this->Layer);
  if (shown == 0 ? !this->UploadColors(frame, window) : !gbuffer->GetTexture(0))
  {
    return;
  }

  std::string defines = layout.GetDefines();
  defines += "#define RELIEVO_SHOW " + std::to_string(shown) + "\n";
  if (!this->PrepareQuad(window, defines))
  {
    vtkErrorMacro(
      "The shader display/layerFS.glsl does not compile for the layer '" << this->Layer << "'.");
    return;
  }
  vtkRelievoView view;
  view.Take(renderer, s);
  vtkOpenGLState* state = window->GetState();
  state->Push();
  state->vtkglViewport(view.Viewport[0], view.Viewport[1], view.Viewport[2], view.Viewport[3]);
  state->vtkglScissor(view.Viewport[0], view.Viewport[1], view.Viewport[2], view.Viewport[3]);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);

  vtkShaderProgram* program = this->Quad->Program;
  static const char* const samplers[] = { "relievoWords1", "relievoWords2", "relievoWords3" };
  vtkTextureObject* textures[3] = { nullptr, nullptr, nullptr };
  if (shown == 0)
  {
    this->Colors->Activate();
    program->SetUniformi("relievoColors", this->Colors->GetTextureUnit());
  }
  else
  {
    for (int i = 0; i < layout.GetNumberOfAttachments() && i < 3; ++i)
    {
      textures[i] = gbuffer->GetTexture(i);
      textures[i]->Activate();
      program->SetUniformi(samplers[i], textures[i]->GetTextureUnit());
    }
  }
  int offset[2];
  gbuffer->GetOffset(offset);
  const float range[2] = { static_cast<float>(
                             this->Range[0] < this->Range[1] ? this->Range[0] : view.Near),
    static_cast<float>(this->Range[0] < this->Range[1] ? this->Range[1] : view.Far) };
  float background[3];
  for (int i = 0; i < 3; ++i)
  {
    background[i] = static_cast<float>(renderer->GetBackground()[i]);
  }
  const float size[2] = { static_cast<float>(view.Viewport[2]),
    static_cast<float>(view.Viewport[3]) };
  float projection[16];
  float viewToWorld[16];
  const glm::dmat4 world = glm::inverse(view.WorldToView);
  for (int i = 0; i < 16; ++i)
  {
    projection[i] = static_cast<float>(view.ViewToNDC[i / 4][i % 4]);
    viewToWorld[i] = static_cast<float>(world[i / 4][i % 4]);
  }
  program->SetUniform2i("relievoOffset", offset);
  program->SetUniform2f("relievoSize", size);
  program->SetUniform2f("relievoShown", range);
  program->SetUniform3f("relievoBackground", background);
  program->SetUniformf("relievoNear", static_cast<float>(view.Near));
  program->SetUniformf("relievoFar", static_cast<float>(view.Far));
  program->SetUniformi("relievoParallel", view.Parallel);
  program->SetUniformi("relievoGrey", this->Grey);
  program->SetUniformi(
    "relievoWorldNormals", gbuffer->GetNormalSpace() == vtkRelievoGBufferPass::WORLD);
  program->SetUniformMatrix4x4("relievoProjection", projection);
  program->SetUniformMatrix4x4("relievoViewToWorld", viewToWorld);
  this->Quad->Render();
  this->DrawCalls = 1;

  if (shown == 0)
  {
    this->Colors->Deactivate();
  }
  for (vtkTextureObject* texture : textures)
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
  state->Pop();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoDisplayStage::GetBytesHeld()
{
  return this->ColorBytes;
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  if (this->Colors)
  {
    this->Colors->ReleaseGraphicsResources(window);
    this->Colors = nullptr;
  }
  this->ColorBytes = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
