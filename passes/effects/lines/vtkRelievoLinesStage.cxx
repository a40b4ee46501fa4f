// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLinesStage.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoHiddenLines.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoTellVolumes.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeCollection.h"

#include <cmath>

vtkStandardNewMacro(vtkRelievoLinesStage);

namespace
{
const vtkRelievoResourceName LinesVolumeDepth = vtkRelievoResourceName::Of("volume_depth");

const vtkRelievoResourceName SidesName = vtkRelievoResourceName::Of("lines sides");
}

class vtkRelievoLinesStage::Internals
{
public:
  vtkRelievoScreenTarget Sides{ "linesSides" };
  vtkRelievoScreenQuad Find[2]; // lines of surfaces, of volumes
  vtkRelievoScreenQuad Draw;
  vtkRelievoHiddenLines Hidden;
  vtkRelievoReportOnce Reported;
};

//------------------------------------------------------------------------------
vtkRelievoLinesStage::vtkRelievoLinesStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoLinesStage::~vtkRelievoLinesStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoLinesStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "lines";
  description.Help = "Outlines, creases and folds as lines, as in a technical illustration.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = -5; // on surfaces: after markers, before fog
  description.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::GeometricNormal,
    vtkRelievoResources::Actor, vtkRelievoResources::Color };
  description.Writes = { vtkRelievoResources::Color };
  description.AddNumber(
    "width", this->Width, [this](double width) { this->SetWidth(width); }, 0.0, 16.0, "pixels",
    "Width of the lines.");
  description.AddColor(
    "color", this->Color,
    [this](const double* color) { this->SetColor(color[0], color[1], color[2]); },
    "Colour of the lines.");
  description.AddFlag(
    "outlines", this->Outlines, [this](bool on) { this->SetOutlines(on); },
    "Lines around parts: actors, blocks and glyphs.");
  description.AddFlag(
    "creases", this->Creases, [this](bool on) { this->SetCreases(on); },
    "Lines where a part's triangles meet at an angle.");
  description
    .AddNumber(
      "crease_angle", this->CreaseAngle, [this](double angle) { this->SetCreaseAngle(angle); }, 1.0,
      180.0, "degrees", "The smallest angle that counts as a crease.")
    .OnlyIf = "creases=on";
  description.AddFlag(
    "folds", this->Folds, [this](bool on) { this->SetFolds(on); },
    "Lines where a part overlaps itself.");
  description.AddFlag(
    "volumes", this->Volumes, [this](bool on) { this->SetVolumes(on); },
    "Outlines and folds of volumes, at their depth by the rule of the stage volumes.");
  description.AddChoice(
    "hidden", this->Hidden, [this](int hidden) { this->SetHidden(hidden); }, { "off", "dashed" },
    "Whether lines behind opaque surfaces are drawn, dashed.");
  description
    .AddNumber(
      "dash", this->Dash, [this](double dash) { this->SetDash(dash); }, 1.0, 100.0, "pixels",
      "Length of a dash; a gap is half as long.")
    .OnlyIf = "hidden=dashed";
}

//------------------------------------------------------------------------------
bool vtkRelievoLinesStage::HasVolumes(const vtkRelievoFrameContext& context) const
{
  return this->Volumes && (this->Outlines || this->Folds) &&
    context.Renderer->GetVolumes()->GetNumberOfItems() > 0;
}

//------------------------------------------------------------------------------
void vtkRelievoLinesStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  declaration.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::Actor,
    vtkRelievoResources::Color };
  if (this->Creases)
  {
    declaration.Reads.push_back(vtkRelievoResources::GeometricNormal);
  }
  if (this->HasVolumes(context))
  {
    declaration.Reads.push_back(LinesVolumeDepth);
  }
  if (this->Width == 0.0 || !(this->Outlines || this->Creases || this->Folds))
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason = this->Width == 0.0 ? "the width is 0" : "all kinds of lines are off";
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoLinesStage::Draw(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoScreenTarget::Format format;
  format.Channels = this->Hidden == DASHED ? 4 : 2;
  std::string error = in.Sides.Prepare(context, format);
  error = error.empty() ? this->FindSides(context, false) : error;
  error = error.empty() ? this->DrawHidden(context) : error;
  error = error.empty() ? this->DrawSides(context, false) : error;
  if (error.empty() && this->HasVolumes(context))
  {
    error = this->FindSides(context, true);
    error = error.empty() ? this->DrawSides(context, true) : error;
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLinesStage::FindSides(vtkRelievoFrameContext& context, bool ofVolumes)
{
  Internals& in = *this->Internal;
  std::vector<vtkRelievoResourceName> reads;
  std::string defines;
  if (ofVolumes)
  {
    reads = { LinesVolumeDepth };
    defines = "#define LINES_VOLUMES\n";
  }
  else
  {
    reads = { vtkRelievoResources::Depth, vtkRelievoResources::Actor };
    if (this->Creases)
    {
      reads.push_back(vtkRelievoResources::GeometricNormal);
      defines = "#define LINES_CREASES\n";
    }
  }
  vtkRelievoScreenQuad& quad = in.Find[ofVolumes ? 1 : 0];
  vtkShaderProgram* program = quad.Ready(context, "lines/sidesFS.glsl", reads, defines);
  if (!program)
  {
    return quad.GetError();
  }
  program->SetUniformi("linesOutlines", this->Outlines);
  program->SetUniformi("linesFolds", this->Folds);
  program->SetUniformf("linesCreaseCosine",
    static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(this->CreaseAngle))));
  in.Sides.Begin(context);
  quad.Draw(context, in.Sides.GetArea());
  in.Sides.End();
  ++this->DrawCalls;
  return {};
}

//------------------------------------------------------------------------------
// Lines of volumes belong to the translucent layer, if that is kept apart: it covers the colour.
std::string vtkRelievoLinesStage::DrawSides(vtkRelievoFrameContext& context, bool ofVolumes)
{
  Internals& in = *this->Internal;
  context.Provide(SidesName, &in.Sides);
  vtkShaderProgram* program = in.Draw.Ready(context, "lines/linesFS.glsl", { SidesName },
    this->Hidden == DASHED ? "#define LINES_HIDDEN\n" : "");
  if (!program)
  {
    return in.Draw.GetError();
  }
  const float color[3] = { static_cast<float>(this->Color[0]), static_cast<float>(this->Color[1]),
    static_cast<float>(this->Color[2]) };
  program->SetUniform3f("linesColor", color);
  program->SetUniformf("linesHalfWidth", static_cast<float>(0.5 * this->Width));
  auto* layer = ofVolumes
    ? dynamic_cast<vtkRelievoScreenTarget*>(context.Find(vtkRelievoResources::Translucent))
    : nullptr;
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  const auto blend = [state]() {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  };
  if (layer)
  {
    layer->GoOn(context);
    blend();
    in.Draw.Draw(context, layer->GetArea());
    layer->End();
    ++this->DrawCalls;
    return {};
  }
  blend();
  this->DrawCalls += context.DrawColor(in.Draw, false) ? 1 : 0;
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoLinesStage::DrawHidden(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (this->Hidden == OFF)
  {
    in.Hidden.Release(context.Window);
    return {};
  }
  vtkRelievoHiddenLines::Settings settings;
  settings.Silhouettes = this->Outlines || this->Folds;
  settings.Creases = this->Creases;
  settings.CreaseCosine = std::cos(vtkMath::RadiansFromDegrees(this->CreaseAngle));
  settings.HalfWidth = 0.5 * this->Width;
  settings.Dash = this->Dash;
  const std::string error = in.Hidden.Draw(context, in.Sides, settings);
  if (error.empty())
  {
    ++this->DrawCalls;
    const int leftOut = in.Hidden.GetNumberOfPropsLeftOut();
    if (leftOut > 0)
    {
      this->Explain("ran",
        std::to_string(leftOut) +
          (leftOut == 1 ? " prop without readable triangles has no hidden lines"
                        : " props without readable triangles have no hidden lines"));
    }
  }
  return error;
}

//------------------------------------------------------------------------------
void vtkRelievoLinesStage::Execute(vtkRelievoFrameContext& context)
{
  this->DrawCalls = 0;
  const std::string error = this->Draw(context);
  if (!this->HasVolumes(context))
  {
    this->Explain("ran", this->GetReason() + vtkRelievoTellVolumes(context, "without lines"));
  }
  if (!error.empty())
  {
    this->Explain("failed", error);
  }
  if (this->Internal->Reported.IsChange(error))
  {
    vtkErrorMacro("Lines are not drawn: " << error << ".");
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLinesStage::GetBytesHeld()
{
  return this->Internal->Sides.GetBytes() + this->Internal->Hidden.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLinesStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Sides.Release(window);
  for (vtkRelievoScreenQuad& quad : this->Internal->Find)
  {
    quad.Release(window);
  }
  this->Internal->Draw.Release(window);
  this->Internal->Hidden.Release(window);
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
