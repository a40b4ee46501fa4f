// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFogStage.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRelievoFogBuffer.h"
#include "vtkRelievoFogSpheres.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoSphereRays.h"
#include "vtkRelievoTranslucentDepth.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoFogStage);

class vtkRelievoFogStage::Internals
{
public:
  vtkRelievoFogBuffer Buffer;
  vtkRelievoTranslucentDepth Translucent;
  vtkRelievoScreenQuad Quad;
  vtkRelievoScreenQuad Finish; // adds the fog to the picture
};

namespace
{
const vtkRelievoResourceName FogVolumeDepth = vtkRelievoResourceName::Of("volume_depth");

bool Sees(const vtkRelievoSphereRays& rays, vtkRelievoFogSpheres* fog)
{
  const int count = fog->GetNumberOfPoints();
  const double* row = fog->GetRows().data();
  vtkRelievoSphereRays::Sphere sphere;
  for (int i = 0; i < count; ++i, row += fog->GetRowWidth())
  {
    if (rays.Find({ row[0], row[1], row[2] }, row[vtkRelievoFogSpheres::RADIUS], sphere))
    {
      return true;
    }
  }
  return false;
}

vtkRelievoFogBuffer::Options GetOptions(vtkRelievoFogStage* stage)
{
  vtkRelievoFogBuffer::Options options;
  options.Chord = stage->GetMode() == vtkRelievoFogStage::CHORD;
  options.Dominant = stage->GetOverlap() == vtkRelievoFogStage::DOMINANT;
  return options;
}
}

//------------------------------------------------------------------------------
vtkRelievoFogStage::vtkRelievoFogStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoFogStage::~vtkRelievoFogStage() = default;

//------------------------------------------------------------------------------
bool vtkRelievoFogStage::Prepare(vtkRelievoFrameContext& context)
{
  if (context.IsAsked(this, vtkRelievoResources::Color))
  {
    context.WantTranslucentDepth(&this->Internal->Translucent);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkRelievoFogStage::NewPoints()
{
  return vtkRelievoFogSpheres::New();
}

//------------------------------------------------------------------------------
void vtkRelievoFogStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "fog";
  description.Help = "Fog in spheres, which come from data.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = -5; // over markers, before the translucent surfaces of the stage `blend`
  description.Writes = { vtkRelievoResources::Color };
  description.Layers = { "fog" };
  description.OnByDefault = true;
  description.TakesData = true;
  description
    .AddChoice(
      "mode", this->Mode, [this](int mode) { this->SetMode(mode); }, { "beer", "chord" },
      "Transmittance: beer, e^(-density length); chord, 1 - density length / diameter.")
    .ChoiceLabels = { "exponential", "linear" };
  description
    .AddChoice(
      "overlap", this->Overlap, [this](int overlap) { this->SetOverlap(overlap); },
      { "sum", "dominant" },
      "Overlapping spheres: sum of optical depths, or the dominant sphere alone.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
void vtkRelievoFogStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  const vtkRelievoSphereRays rays(context.View);
  const auto fogs = this->GetSets<vtkRelievoFogSpheres>();
  if (rays.IsUsual() && !this->IsTogether() &&
    std::none_of(fogs.begin(), fogs.end(), [&rays](auto* fog) { return Sees(rays, fog); }))
  {
    // Without fog in view the layer is constant: all light passes.
    declaration.Writes.clear();
    declaration.ReasonCode = "idle";
    declaration.Reason = "no fog is in view";
  }
  else if (context.Renderer->GetVolumes()->GetNumberOfItems() > 0)
  {
    declaration.OptionalReads = { FogVolumeDepth };
  }
}

//------------------------------------------------------------------------------
// The delegate's own depth buffer is precise enough for the picture if its error changes white fog
// over black, the most sensitive case, by less than a quarter of an 8-bit step.
void vtkRelievoFogStage::Synchronize(vtkRelievoFrameContext& context)
{
  this->Superclass::Synchronize(context);
  using Fog = vtkRelievoFogSpheres;
  constexpr double seen = 1.0 / (4.0 * 255.0 * 12.92);
  int left = 1000; // with more spheres, the layer's cost no longer matters
  this->DrawnDepthSuffices = false;
  const vtkRelievoSphereRays rays(context.View);
  // Sum over all spheres: optical depth per unit length, times brightness.
  double densities = 0.0;
  double farthest = context.View.Near;
  for (vtkRelievoFogSpheres* fog : this->GetSets<vtkRelievoFogSpheres>())
  {
    left -= fog->GetNumberOfPoints();
    const double* row = fog->GetRows().data();
    vtkRelievoSphereRays::Sphere sphere;
    for (int i = 0; left >= 0 && i < fog->GetNumberOfPoints(); ++i, row += fog->GetRowWidth())
    {
      const double radius = row[Fog::RADIUS];
      if (rays.Find({ row[0], row[1], row[2] }, radius, sphere))
      {
        const double length = this->Mode == CHORD ? 2.0 * radius : 1.0;
        densities += row[Fog::DENSITY] / length *
          std::max({ 1.0, row[Fog::RED], row[Fog::GREEN], row[Fog::BLUE] });
        farthest = std::max(farthest, rays.GetBegin() + sphere.MiddleDepth + radius);
      }
    }
  }
  if (left >= 0 && !this->IsTogether())
  {
    farthest = std::min(farthest, context.View.Far);
    this->DrawnDepthSuffices = context.GetDrawnDepthError(farthest) * densities <= seen;
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoResourceName> vtkRelievoFogStage::GetReadsFor(
  const vtkRelievoFrameContext&, const std::vector<std::string>& asked) const
{
  const bool layer = std::find(asked.begin(), asked.end(), "fog") != asked.end();
  return layer || !this->DrawnDepthSuffices
    ? std::vector<vtkRelievoResourceName>{ vtkRelievoResources::Depth }
    : std::vector<vtkRelievoResourceName>();
}

//------------------------------------------------------------------------------
void vtkRelievoFogStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  this->NumberDrawn = 0;
  const vtkRelievoSphereRays rays(context.View);
  in.Buffer.BeforeDrawn = this->DrawnDepthSuffices && !context.IsLayerAsked(this, "fog");
  std::string error;
  int spheres = 0;
  if (!rays.IsUsual())
  {
    error = "the camera's projection has depths that change across the picture";
  }
  else
  {
    in.Buffer.Clear();
    for (vtkRelievoFogSpheres* fog : this->GetSets<vtkRelievoFogSpheres>())
    {
      in.Buffer.Add(rays, fog, this->Mode == CHORD);
      spheres += static_cast<int>(fog->GetSharedRows().size()) / fog->GetRowWidth();
    }
    this->NumberDrawn = in.Buffer.GetNumberOfSpheres();
    error = this->DrawBeforeTranslucent(context, rays);
    if (error.empty())
    {
      vtkRelievoFogBuffer::Options options = GetOptions(this);
      options.Everywhere = context.IsLayerAsked(this, "fog");
      error = in.Buffer.Draw(context, rays, options);
    }
  }
  if (error.empty())
  {
    context.ProvideLayer("fog", &in.Buffer.Target);
    this->DrawCalls += this->NumberDrawn > 0 ? 1 : 0;
    this->Explain("ran",
      "draws " + std::to_string(this->NumberDrawn) + " of " + std::to_string(spheres) + " spheres");
  }
  if (error.empty() && this->NumberDrawn > 0 && context.IsAsked(this, vtkRelievoResources::Color))
  {
    const bool finishes = context.FinishesColor();
    if (finishes &&
      in.Finish.Ready(context, "fog/colorFS.glsl",
        { vtkRelievoResourceName::Of("fog"), vtkRelievoResources::Color,
          vtkRelievoResources::Drawn },
        "#define RELIEVO_TO_DISPLAY\n"))
    {
      this->DrawCalls += context.PresentPart(in.Finish, in.Buffer.GetPart()) ? 1 : 0;
    }
    else if (!finishes &&
      in.Quad.Ready(context, "fog/colorFS.glsl", { vtkRelievoResourceName::Of("fog") }))
    {
      vtkOpenGLState* state = context.Window->GetState();
      const vtkRelievoScopedState kept(state);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      this->DrawCalls += context.DrawColor(in.Quad, false, in.Buffer.GetPart()) ? 1 : 0;
    }
    else
    {
      error = finishes ? in.Finish.GetError() : in.Quad.GetError();
    }
  }
  this->ReportFault(error);
}

//------------------------------------------------------------------------------
// Fog in front of translucent surfaces and volumes covers them as much as the surfaces behind.
std::string vtkRelievoFogStage::DrawBeforeTranslucent(
  vtkRelievoFrameContext& context, const vtkRelievoSphereRays& rays)
{
  Internals& in = *this->Internal;
  auto* layer =
    dynamic_cast<vtkRelievoScreenTarget*>(context.Find(vtkRelievoResources::Translucent));
  vtkRelievoResource* depth = context.Find(vtkRelievoResources::TranslucentDepth);
  if (!depth)
  {
    in.Translucent.Release(context.Window);
  }
  if (this->NumberDrawn == 0 || !layer || !depth ||
    !context.IsAsked(this, vtkRelievoResources::Color))
  {
    return {};
  }
  std::vector<vtkRelievoResource*> nearer = { depth };
  if (vtkRelievoResource* volumes = context.Find(FogVolumeDepth))
  {
    nearer.push_back(volumes);
  }
  const std::string error = in.Buffer.Draw(context, rays, GetOptions(this), nearer);
  if (!error.empty())
  {
    return error;
  }
  context.ProvideLayer("fog", &in.Buffer.Target);
  if (in.Quad.Ready(context, "fog/colorFS.glsl", { vtkRelievoResourceName::Of("fog") }))
  {
    layer->GoOn(context);
    vtkOpenGLState* state = context.Window->GetState();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    in.Quad.Draw(context, layer->GetArea(), vtkRelievoScreenQuad::NO_DEPTH, in.Buffer.GetPart());
    layer->End();
    this->DrawCalls += 2;
  }
  return in.Quad.GetError();
}

//------------------------------------------------------------------------------
std::string vtkRelievoFogStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    vtkNew<vtkImageData> drawn;
    drawn->SetDimensions(image->GetDimensions());
    const std::string error = this->Internal->Buffer.Target.Read(name, 4, drawn);
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
    }
    image->SetDimensions(drawn->GetDimensions());
    auto* depths = vtkFloatArray::SafeDownCast(drawn->GetPointData()->GetArray(name.c_str()));
    vtkNew<vtkFloatArray> passes;
    passes->SetName(name.c_str());
    passes->SetNumberOfTuples(depths->GetNumberOfTuples());
    for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
    {
      passes->SetValue(i, std::exp(-depths->GetTypedComponent(i, 3)));
    }
    image->GetPointData()->AddArray(passes);
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoFogStage::GetBytesHeld()
{
  return this->Internal->Buffer.GetBytes() + this->Internal->Translucent.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoFogStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Buffer.Release(window);
  this->Internal->Quad.Release(window);
  this->Internal->Finish.Release(window);
  this->Internal->Translucent.Release(window);
  this->DrawCalls = 0;
  this->NumberDrawn = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
