// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDisplayStage.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerColors.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkRelievoDisplayStage);

namespace
{
// What is read to show it. What a light reaches is 1 where nothing is, too: depth tells.
std::vector<std::string> GetNeeded(const std::string& layer)
{
  return vtkRelievoLayerCatalogue::GetIsOfLight(layer) ? std::vector<std::string>{ layer, "depth" }
                                                       : std::vector<std::string>{ layer };
}
}

class vtkRelievoDisplayStage::Internals
{
public:
  vtkRelievoScreenQuad Quad;
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkIdType ColorBytes = 0;
  std::string Reported; // what was wrong with the layer in the last frame: said once
  std::string Failed;   // what was wrong with the shader
};

//------------------------------------------------------------------------------
vtkRelievoDisplayStage::vtkRelievoDisplayStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoDisplayStage::~vtkRelievoDisplayStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::SetLayer(RELIEVO_TEXT name)
{
  if (this->Layer != name)
  {
    this->Layer = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "display";
  description.Label = "Layer Shown";
  description.Help = "Shows a layer as the picture.";
  description.Slot = vtkRelievoStageDescription::DISPLAY;
  description.Writes = { "picture" };
  description.OnByDefault = true;
  description.AddText(
    "layer", [this]() { return this->Layer; },
    [this](const std::string& name) { this->SetLayer(name); },
    "The layer to show; empty for the picture itself.");
  description.AddFlag(
    "grey", this->Grey, [this](bool on) { this->SetGrey(on); },
    "Shows scalar layers in grey instead of colours.");
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  if (this->Layer.empty())
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason = "no layer is shown as the picture";
    return;
  }
  declaration.ReadsLayers = GetNeeded(this->Layer);
  // Nobody knows yet whether anything drawn has an array; if not, the picture itself is shown.
  declaration.HidesColor =
    vtkRelievoLayerCatalogue::Find(this->Layer).Kind != vtkRelievoLayer::ARRAY;
  declaration.Reason = "shows the layer " + this->Layer + " as the picture";
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::UploadColors(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkNew<vtkImageData> image;
  const std::string wrong = context.ReadLayers(GetNeeded(this->Layer), image);
  if (!wrong.empty() && wrong != in.Reported)
  {
    vtkErrorMacro(<< wrong);
  }
  in.Reported = wrong;
  if (!wrong.empty())
  {
    this->Explain("failed", wrong);
    return false;
  }
  int size[3];
  image->GetDimensions(size);
  std::vector<unsigned char> colors = vtkRelievoLayerColors::Make(image, this->Layer,
    context.Lights.count(this->Layer) > 0, this->Range, this->Grey, this->ShownRange, this->Same);
  if (!in.Colors)
  {
    in.Colors = vtkSmartPointer<vtkTextureObject>::New();
  }
  in.Colors->SetContext(context.Window);
  in.Colors->SetMinificationFilter(vtkTextureObject::Nearest);
  in.Colors->SetMagnificationFilter(vtkTextureObject::Nearest);
  in.Colors->Create2DFromRaw(static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]),
    4, VTK_UNSIGNED_CHAR, colors.data());
  in.ColorBytes = static_cast<vtkIdType>(colors.size());
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const std::string& shader = vtkRelievoLayerCatalogue::Find(this->Layer).Shader;
  const bool colors = shader.empty();
  this->DrawCalls = 0;
  if (!context.FindLayer(this->Layer))
  {
    this->Explain("failed", "the frame has made no '" + this->Layer + "'");
    return;
  }
  if (colors && !this->UploadColors(context))
  {
    return;
  }
  std::vector<std::string> reads;
  if (!colors)
  {
    reads.push_back(this->Layer);
  }
  vtkShaderProgram* program = in.Quad.Ready(context, "display/layerFS.glsl", reads,
    "#define RELIEVO_SHOW_" + (colors ? "COLORS" : shader) + "\n");
  if (!program)
  {
    const std::string wrong = in.Quad.GetWrong();
    this->Explain("failed", wrong);
    if (in.Failed != wrong)
    {
      vtkErrorMacro("The layer '" << this->Layer << "' is not shown: " << wrong << ".");
    }
    in.Failed = wrong;
    return;
  }
  const vtkRelievoFrameCamera& view = context.View;
  vtkRenderer* renderer = context.Renderer;
  const float range[2] = { static_cast<float>(
                             this->Range[0] < this->Range[1] ? this->Range[0] : view.Near),
    static_cast<float>(this->Range[0] < this->Range[1] ? this->Range[1] : view.Far) };
  float background[4];
  for (int i = 0; i < 3; ++i)
  {
    background[i] = static_cast<float>(renderer->GetBackground()[i]);
  }
  background[3] = static_cast<float>(renderer->GetBackgroundAlpha());
  if (!colors)
  {
    this->Same = false;
    this->ShownRange[0] = range[0];
    this->ShownRange[1] = range[1];
  }
  program->SetUniform2f("relievoShown", range);
  program->SetUniform4f("relievoBackground", background);
  program->SetUniformi("relievoGrey", this->Grey);
  if (colors)
  {
    in.Colors->Activate();
    program->SetUniformi("relievoColors", in.Colors->GetTextureUnit());
  }
  {
    const vtkRelievoScopedState kept(context.Window->GetState());
    context.Window->GetState()->vtkglDisable(GL_BLEND);
    in.Quad.Draw(context);
  }
  this->DrawCalls = 1;
  if (colors)
  {
    in.Colors->Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoDisplayStage::GetBytesHeld()
{
  return this->Internal->ColorBytes;
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Quad.Release(window);
  if (in.Colors)
  {
    in.Colors->ReleaseGraphicsResources(window);
    in.Colors = nullptr;
  }
  in.ColorBytes = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
