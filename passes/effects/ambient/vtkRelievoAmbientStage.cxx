// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAmbientStage.h"

#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoAmbientCatch.h"
#include "vtkRelievoAmbientScene.h"
#include "vtkRelievoBlueNoise.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoShadowCatcher.h"
#include "vtkRelievoSkySamples.h"
#include "vtkRelievoTellVolumes.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <sstream>

vtkStandardNewMacro(vtkRelievoAmbientStage);

namespace
{
constexpr const char* Layer = "ambient";
constexpr int MostSamples = 4096;
constexpr int MostPerFrame = 64; // array size in shaders/ambient/sees.glsl
constexpr double LargestRadius = 1e9;
static_assert(vtkRelievoBlueNoise::Size == 64, "shaders/ambient/sees.glsl expects this size");
}

class vtkRelievoAmbientStage::Internals
{
public:
  vtkRelievoAmbientScene Scene;
  vtkRelievoTextureBuffer Noise;
  vtkRelievoScreenTarget Share{ "ambientShare" };
  vtkRelievoScreenQuad Find;
  vtkRelievoScreenQuad Darken;
  std::vector<vtkRelievoSkySamples::Point> Points; // of all frames
  vtkNew<vtkRelievoAmbientCatch> Catchers;
  bool Begun = false; // rays can be traced in this frame
  vtkRelievoReportOnce Reported;
  bool ToldOfTriangles = false;

  Internals() { this->Share.SetDefines("#define RELIEVO_GATHERED ambientShare\n"); }
};

//------------------------------------------------------------------------------
vtkRelievoAmbientStage::vtkRelievoAmbientStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoAmbientStage::~vtkRelievoAmbientStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoAmbientStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "ambient";
  description.Label = "Ambient Occlusion";
  description.Help = "Ambient occlusion by rays: surfaces are darker where they see less of the "
                     "sky, except in the light of lights that cast shadows.";
  description.Slot = vtkRelievoStageDescription::SHADE;
  description.Order = -10; // before the lamps, whose direct light is not darkened
  description.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::GeometricNormal };
  description.Writes = { vtkRelievoResources::Color };
  description.Layers = { Layer };
  description.ServesWhenOff = true;
  description
    .AddFlag(
      "only_catchers", this->OnlyCatchers, [this](bool on) { this->SetOnlyCatchers(on); },
      "Darkens only surfaces that catch shadows, such as the ground of a preset.")
    .Advanced = true;
  description
    .AddNumber(
      "strength", this->Strength, [this](double strength) { this->SetStrength(strength); }, 0.0,
      1.0, "", "Share of the light removed where no sky is visible.")
    .OnlyIf = "enabled=on";
  description.AddNumber(
    "radius", this->Radius, [this](double radius) { this->SetRadius(radius); }, 0.0, LargestRadius,
    "world units", "Greatest distance at which surfaces hide the sky; 0: no limit.");
  description
    .AddChoice(
      "weighting", this->Weighting, [this](int weighting) { this->SetWeighting(weighting); },
      { "cosine", "uniform" },
      "Weight of each part of the sky: cosine, by its angle to the normal; uniform, by solid "
      "angle.")
    .Advanced = true;
  description.AddWhole(
    "samples", this->Samples, [this](int samples) { this->SetSamples(samples); }, 1, MostSamples,
    "rays", "Total rays per pixel, rounded up to whole frames.");
  description
    .AddWhole(
      "samples_per_frame", this->SamplesPerFrame,
      [this](int samples) { this->SetSamplesPerFrame(samples); }, 1, MostPerFrame, "rays",
      "Rays per pixel traced in each frame.")
    .Advanced = true;
  description
    .AddFlag(
      "at_once", this->AtOnce, [this](bool on) { this->SetAtOnce(on); },
      "Whether each frame traces all rays; otherwise some in each frame.")
    .Advanced = true;
  description.Parameters.back().Label = "All Samples At Once";
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientStage::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  declaration.Gathered = { vtkRelievoResources::Color, vtkRelievoResourceName::Of(Layer) };
  declaration.Samples = (this->Samples + this->SamplesPerFrame - 1) / this->SamplesPerFrame;
  declaration.AtOnce = this->AtOnce;
  if (this->OnlyCatchers)
  {
    declaration.Reads.clear(); // required only by the layer
  }
  else if (this->Strength > 0.0)
  {
    declaration.OptionalReads = { vtkRelievoResources::DirectLight };
  }
  if (this->Strength == 0.0)
  {
    declaration.Writes.clear();
    declaration.ReasonCode = "idle";
    declaration.Reason = "the strength is 0";
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoResourceName> vtkRelievoAmbientStage::GetReadsFor(
  const vtkRelievoFrameContext&, const std::vector<std::string>& asked) const
{
  return std::find(asked.begin(), asked.end(), Layer) != asked.end()
    ? std::vector<vtkRelievoResourceName>{ vtkRelievoResources::Depth,
        vtkRelievoResources::GeometricNormal }
    : std::vector<vtkRelievoResourceName>();
}

//------------------------------------------------------------------------------
bool vtkRelievoAmbientStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Begun = false;
  const std::vector<vtkProp*> catchers = context.IsAsked(this, vtkRelievoResources::Color)
    ? vtkRelievoShadowCatcher::Find(context)
    : std::vector<vtkProp*>();
  if (!catchers.empty() && this->BeginRays(context).empty())
  {
    in.Catchers->Begin(context.Window, catchers, [this, &context](vtkShaderProgram* program) {
      this->TellRays(program, context);
      this->Internal->Scene.SetUniforms(program, context, "ambient");
      program->SetUniformf("ambientStrength", static_cast<float>(this->Strength));
    });
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientStage::Finish(vtkRelievoFrameContext&)
{
  this->Internal->Catchers->End();
  this->Internal->Noise.Deactivate();
  this->Internal->Scene.End();
}

//------------------------------------------------------------------------------
std::string vtkRelievoAmbientStage::BeginRays(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Begun)
  {
    return {};
  }
  std::string error;
  if (!in.Noise.IsIn(context.Window))
  {
    error = in.Noise.Upload(context.Window, vtkRelievoBlueNoise::GetThresholds(), 1);
  }
  error = in.Scene.Begin(context, error);
  in.Begun = error.empty();
  if (!in.Begun)
  {
    in.Scene.End(); // another process may have failed
  }
  return error;
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientStage::TellRays(
  vtkShaderProgram* program, const vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const int rays = std::min(this->Samples, this->SamplesPerFrame);
  const auto all = static_cast<std::size_t>(rays) * static_cast<std::size_t>(context.Samples);
  if (in.Points.size() != all)
  {
    in.Points = vtkRelievoSkySamples::Get(static_cast<int>(all), true);
  }
  float points[MostPerFrame][2];
  for (int i = 0; i < rays; ++i)
  {
    const auto& point = in.Points[static_cast<std::size_t>(context.Sample * rays + i)];
    points[i][0] = static_cast<float>(point.X);
    points[i][1] = static_cast<float>(point.Y);
  }
  program->SetUniform2fv("ambientPoints", rays, points);
  program->SetUniformi("ambientRays", rays);
  program->SetUniformf("ambientStep", 1.0f / static_cast<float>(all));
  program->SetUniformf("ambientRadius", static_cast<float>(this->Radius));
  program->SetUniformi("ambientByCosine", this->Weighting == COSINE);
  in.Noise.Activate(program, "ambientNoise");
}

//------------------------------------------------------------------------------
std::string vtkRelievoAmbientStage::DrawShare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoScreenTarget::Format format;
  format.Channels = 1;
  format.Halves = false;
  std::string error = in.Share.Prepare(context, format);
  if (!error.empty())
  {
    return error;
  }
  vtkShaderProgram* program = in.Find.Ready(context, "ambient/shareFS.glsl",
    { vtkRelievoResources::Depth, vtkRelievoResources::GeometricNormal });
  if (program)
  {
    this->TellRays(program, context);
    in.Scene.SetUniforms(program, context);
    in.Share.Begin(context);
    in.Find.Draw(context, in.Share.GetArea());
    in.Share.End();
    this->DrawCalls = 1;
    context.ProvideLayer(Layer, &in.Share);
  }
  return in.Find.GetError();
}

//------------------------------------------------------------------------------
std::string vtkRelievoAmbientStage::DrawColor(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkShaderProgram* program = in.Darken.Ready(context, "ambient/colorFS.glsl",
    { vtkRelievoResourceName::Of(Layer), vtkRelievoResources::DirectLight });
  if (program)
  {
    program->SetUniformf("ambientStrength", static_cast<float>(this->Strength));
    vtkOpenGLState* state = context.Window->GetState();
    const vtkRelievoScopedState kept(state);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    this->DrawCalls += context.DrawColor(in.Darken, false) ? 1 : 0;
  }
  return in.Darken.GetError();
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  std::string error = this->BeginRays(context);
  const bool darkens = !this->OnlyCatchers && context.IsAsked(this, vtkRelievoResources::Color);
  if (error.empty() && (darkens || context.IsLayerAsked(this, Layer)))
  {
    error = this->DrawShare(context);
  }
  if (error.empty() && darkens)
  {
    error = this->DrawColor(context);
  }
  const bool isChange = in.Reported.IsChange(error);
  if (error.empty())
  {
    const int rays = std::min(this->Samples, this->SamplesPerFrame);
    std::ostringstream words;
    words << rays * (context.Sample + 1) << " of " << rays * context.Samples
          << " rays per pixel through " << in.Scene.GetNumberOfTriangles() << " triangles"
          << in.Scene.GetReport();
    if (in.Scene.GetNumberOfPropsLeftOut() > 0)
    {
      words << "; " << in.Scene.GetNumberOfPropsLeftOut()
            << (in.Scene.GetNumberOfPropsLeftOut() == 1 ? " prop" : " props")
            << " that rays cannot intersect hide nothing";
    }
    this->Explain(
      "ran", words.str() + vtkRelievoTellVolumes(context, "neither hiding nor darkened"));
    const vtkIdType triangles = in.Scene.GetTooManyTriangles();
    if (triangles > 0 && !in.ToldOfTriangles)
    {
      vtkWarningMacro("A mesh of "
        << triangles << " triangles hides no sky: ray tracing takes at most "
        << vtkRelievoMeshTexels::GetMostTriangles() << " per mesh. Split the mesh.");
    }
    in.ToldOfTriangles = triangles > 0;
  }
  else
  {
    this->Explain("failed", error);
    // Only one process reports the error.
    vtkMultiProcessController* all = context.Controller;
    if (isChange && (!all || all->GetLocalProcessId() == 0))
    {
      vtkErrorMacro("There is no ambient occlusion: " << error << ".");
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoAmbientStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    const std::string error = this->Internal->Share.Read(name, 1, image);
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoAmbientStage::GetBytesHeld()
{
  const Internals& in = *this->Internal;
  return in.Scene.GetBytes() + in.Noise.GetBytes() + in.Share.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoAmbientStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Scene.Release(window);
  in.Noise.Release(window);
  in.Share.Release(window);
  in.Find.Release(window);
  in.Darken.Release(window);
  in.Catchers->ReleaseGraphicsResources(window);
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
