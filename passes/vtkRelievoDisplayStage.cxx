// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDisplayStage.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoKeptState.h"
#include "vtkRelievoLayerColors.h"
#include "vtkRelievoPass.h"
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
  const std::string wrong = frame->GetGBuffer()->ReadLayers({ this->Layer }, image);
  if (!wrong.empty() && wrong != this->Told)
  {
    vtkErrorMacro(<< wrong);
  }
  this->Told = wrong;
  if (!wrong.empty())
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
void vtkRelievoDisplayStage::RenderAfter(vtkRelievoPass* frame, const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRelievoGBufferPass* gbuffer = frame->GetGBuffer();
  const int shown = GetShown(this->Layer);
  if (!gbuffer->GetTexture(0) || (shown == 0 && !this->UploadColors(frame, window)))
  {
    return;
  }
  vtkShaderProgram* program = this->Quad.Ready(window, gbuffer, "display/layerFS.glsl",
    "#define RELIEVO_SHOW " + std::to_string(shown) + "\n");
  if (!program)
  {
    vtkErrorMacro(
      "The shader display/layerFS.glsl does not compile for the layer '" << this->Layer << "'.");
    return;
  }
  vtkRelievoView view;
  view.Take(renderer, s);
  const float range[2] = { static_cast<float>(
                             this->Range[0] < this->Range[1] ? this->Range[0] : view.Near),
    static_cast<float>(this->Range[0] < this->Range[1] ? this->Range[1] : view.Far) };
  float background[4];
  for (int i = 0; i < 3; ++i)
  {
    background[i] = static_cast<float>(renderer->GetBackground()[i]);
  }
  background[3] = static_cast<float>(renderer->GetBackgroundAlpha());
  float projection[16];
  float viewToWorld[16];
  const glm::dmat4 world = glm::inverse(view.WorldToView);
  for (int i = 0; i < 16; ++i)
  {
    projection[i] = static_cast<float>(view.ViewToNDC[i / 4][i % 4]);
    viewToWorld[i] = static_cast<float>(world[i / 4][i % 4]);
  }
  program->SetUniform2f("relievoShown", range);
  program->SetUniform4f("relievoBackground", background);
  program->SetUniformi("relievoGrey", this->Grey);
  program->SetUniformi(
    "relievoWorldNormals", gbuffer->GetNormalSpace() == vtkRelievoGBufferPass::WORLD);
  program->SetUniformMatrix4x4("relievoProjection", projection);
  program->SetUniformMatrix4x4("relievoViewToWorld", viewToWorld);
  if (shown == 0)
  {
    this->Colors->Activate();
    program->SetUniformi("relievoColors", this->Colors->GetTextureUnit());
  }
  {
    const vtkRelievoKeptState kept(window->GetState());
    window->GetState()->vtkglDisable(GL_BLEND);
    this->Quad.Draw(window, gbuffer, view);
  }
  this->DrawCalls = 1;
  if (shown == 0)
  {
    this->Colors->Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoDisplayStage::GetBytesHeld()
{
  return this->ColorBytes;
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.Release(window);
  if (this->Colors)
  {
    this->Colors->ReleaseGraphicsResources(window);
    this->Colors = nullptr;
  }
  this->ColorBytes = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
