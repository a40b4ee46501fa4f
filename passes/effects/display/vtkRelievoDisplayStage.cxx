// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDisplayStage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRelievoColormaps.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerColors.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoShownValues.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoDisplayStage);

namespace
{
constexpr int MapColors = 256;

// The layers to read. The visibility of a light is 1 in the background too, which only depth tells.
std::vector<std::string> GetNeeded(const std::string& layer)
{
  return vtkRelievoLayerCatalogue::GetIsOfLight(layer) ? std::vector<std::string>{ layer, "depth" }
                                                       : std::vector<std::string>{ layer };
}

vtkRelievoLayer::Kinds GetKind(const std::string& layer)
{
  return vtkRelievoLayerCatalogue::GetIsOfLight(layer) // a light layer may have any name
    ? vtkRelievoLayerCatalogue::GetOfLight().Kind
    : vtkRelievoLayerCatalogue::Find(layer).Kind;
}
}

class vtkRelievoDisplayStage::Internals
{
public:
  vtkRelievoScreenQuad Quad;
  vtkRelievoShownValues Values;
  vtkSmartPointer<vtkTextureObject> Colors;
  vtkIdType ColorBytes = 0;
  vtkSmartPointer<vtkTextureObject> Map;
  std::vector<std::array<float, 3>> Row; // the map's texture
  vtkRelievoReportOnce Refused;          // errors of the layer
  vtkRelievoReportOnce Failed;           // errors of the shader
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
  description.Writes = { vtkRelievoResources::Picture };
  description.OnByDefault = true;
  description.AddText(
    "layer", [this]() { return this->Layer; },
    [this](const std::string& name) { this->SetLayer(name); },
    "The layer to show; empty for the picture itself.");
  description.AddPair(
    "range", this->Range, [this](const double* range) { this->SetRange(range[0], range[1]); },
    "Values shown in the first and the last colour of a scalar layer. 0 and 0 show the range of "
    "all visible values, for depth and range without those of a ground far wider than the rest; "
    "several ranks show depth and range from the near to the far plane.");
  vtkRelievoParameter& colormap = description.AddChoice(
    "colormap", this->Colormap, [this](int map) { this->SetColormap(map); },
    vtkRelievoColormaps::GetNames(), "Colour map of scalar layers.");
  colormap.Label = "Colour Map";
  colormap.OnlyIf = "grey=off";
  description
    .AddFlag(
      "reversed", this->Reversed, [this](bool on) { this->SetReversed(on); },
      "Shows the greatest value in the first colour.")
    .OnlyIf = "grey=off";
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
  // No earlier step knows whether any drawn mesh has the array; if none has, the picture is shown.
  declaration.HidesColor =
    vtkRelievoLayerCatalogue::Find(this->Layer).Kind != vtkRelievoLayer::ARRAY;
  declaration.Reason = "shows the layer " + this->Layer + " as the picture";
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::IsGood(const std::string& error)
{
  if (this->Internal->Refused.IsChange(error))
  {
    vtkErrorMacro(<< error);
  }
  if (!error.empty())
  {
    this->Explain("failed", error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
std::vector<std::array<float, 3>> vtkRelievoDisplayStage::GetColors() const
{
  const auto map = static_cast<std::size_t>(this->Grey ? GREY : this->Colormap);
  return vtkRelievoColormaps::Sample(
    vtkRelievoColormaps::GetNames()[map], this->Reversed && !this->Grey, MapColors);
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::UploadMap(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  std::vector<std::array<float, 3>> colors = this->GetColors();
  if (in.Map && in.Map->GetContext() == context.Window && in.Row == colors)
  {
    return;
  }
  if (!in.Map)
  {
    in.Map = vtkSmartPointer<vtkTextureObject>::New();
  }
  in.Map->SetContext(context.Window);
  in.Map->SetMinificationFilter(vtkTextureObject::Linear);
  in.Map->SetMagnificationFilter(vtkTextureObject::Linear);
  in.Map->SetWrapS(vtkTextureObject::ClampToEdge);
  in.Map->SetWrapT(vtkTextureObject::ClampToEdge);
  in.Map->Create2DFromRaw(MapColors, 1, 3, VTK_FLOAT, colors.data());
  in.Row.swap(colors);
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::UploadColors(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkNew<vtkImageData> image;
  if (!this->IsGood(context.ReadLayers(GetNeeded(this->Layer), image)))
  {
    return false;
  }
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* values = image->GetPointData()->GetArray(this->Layer.c_str());
  this->ShownComponents = values ? values->GetNumberOfComponents() : 0;
  std::vector<unsigned char> colors =
    vtkRelievoLayerColors::Make(image, this->Layer, context.Lights.count(this->Layer) > 0,
      this->Range, this->GetColors(), this->ShownRange, this->Same);
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
  std::vector<vtkRelievoResourceName> reads;
  const bool values = shader == "DEPTH" || shader == "RANGE" || shader == "VOLUME_DEPTH";
  if (!colors)
  {
    reads.push_back(vtkRelievoResourceName::Of(this->Layer));
    this->ShownComponents = vtkRelievoLayerCatalogue::Find(this->Layer).Components;
    this->Same = false;
    std::copy(this->Range, this->Range + 2, this->ShownRange);
  }
  if (values && this->Range[0] >= this->Range[1] &&
    !this->IsGood(in.Values.Find(context, this->Layer, this->ShownRange)))
  {
    return;
  }
  if (values)
  {
    this->UploadMap(context);
  }
  vtkShaderProgram* program = in.Quad.Ready(context, "display/layerFS.glsl", reads,
    "#define RELIEVO_SHOW_" + (colors ? "COLORS" : shader) + "\n");
  if (!program)
  {
    const std::string error = in.Quad.GetError();
    this->Explain("failed", error);
    if (in.Failed.IsChange(error))
    {
      vtkErrorMacro("The layer '" << this->Layer << "' is not shown: " << error << ".");
    }
    return;
  }
  vtkRenderer* renderer = context.Renderer;
  float background[4];
  for (int i = 0; i < 3; ++i)
  {
    background[i] = static_cast<float>(renderer->GetBackground()[i]);
  }
  background[3] = static_cast<float>(renderer->GetBackgroundAlpha());
  if (values)
  {
    const bool any = std::isfinite(this->ShownRange[0]);
    const float range[2] = { any ? static_cast<float>(this->ShownRange[0]) : 0.0F,
      any ? static_cast<float>(this->ShownRange[1]) : 1.0F };
    program->SetUniform2f("relievoShown", range);
    in.Map->Activate();
    program->SetUniformi("relievoMap", in.Map->GetTextureUnit());
  }
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
  if (values)
  {
    in.Map->Deactivate();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::HasScale()
{
  switch (GetKind(this->Layer))
  {
    case vtkRelievoLayer::ID:
    case vtkRelievoLayer::VECTOR:
    case vtkRelievoLayer::POSITION:
    case vtkRelievoLayer::COLOR:
      return false;
    default:
      return this->ShownComponents <= 2;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoDisplayStage::GetShownColormap()
{
  const bool grey = this->Grey || GetKind(this->Layer) == vtkRelievoLayer::SHARE;
  return vtkRelievoColormaps::GetNames()[static_cast<std::size_t>(grey ? GREY : this->Colormap)];
}

//------------------------------------------------------------------------------
bool vtkRelievoDisplayStage::GetShownReversed()
{
  return this->Reversed && !this->Grey && GetKind(this->Layer) != vtkRelievoLayer::SHARE;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoDisplayStage::GetBytesHeld()
{
  const Internals& in = *this->Internal;
  return in.ColorBytes + in.Values.GetBytes() +
    static_cast<vtkIdType>(in.Row.size() * sizeof(in.Row[0]));
}

//------------------------------------------------------------------------------
void vtkRelievoDisplayStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Quad.Release(window);
  in.Values.Release(window);
  if (in.Map)
  {
    in.Map->ReleaseGraphicsResources(window);
    in.Map = nullptr;
  }
  in.Row.clear();
  if (in.Colors)
  {
    in.Colors->ReleaseGraphicsResources(window);
    in.Colors = nullptr;
  }
  in.ColorBytes = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
