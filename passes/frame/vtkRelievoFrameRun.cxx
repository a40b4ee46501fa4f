// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameRun.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoBoundFramebuffer.h"
#include "vtkRelievoColorTarget.h"
#include "vtkRelievoDelegate.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFrameReport.h"
#include "vtkRelievoGpuTimer.h"
#include "vtkRelievoHiddenPoints.h"
#include "vtkRelievoLeakedTextureUnits.h"
#include "vtkRelievoPointGroups.h"
#include "vtkRelievoSampleAccumulator.h"
#include "vtkRelievoSampleRaster.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoTranslucentLayers.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <cstddef>

//------------------------------------------------------------------------------
vtkRelievoFrameRun::vtkRelievoFrameRun(vtkRelievoFrameContext& context,
  const std::vector<vtkRelievoStage*>& stages, vtkRelievoColorTarget& color,
  vtkRelievoTranslucentLayers& translucent, vtkRelievoSampleAccumulator& samples,
  vtkRelievoSampleRaster& raster, vtkRelievoPointGroups& pointGroups, vtkRelievoGpuTimer& timer)
  : Context(context)
  , Stages(stages)
  , Color(color)
  , Translucent(translucent)
  , Samples(samples)
  , Raster(raster)
  , PointGroups(pointGroups)
  , Timer(timer)
  , Nodes(stages.size() + 1)
  , Dropped(stages.size() + 1, false)
{
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Synchronize()
{
  for (vtkRelievoStage* stage : this->Stages)
  {
    if (stage->GetEnabled() || stage->GetDescription().ServesWhenOff)
    {
      stage->Synchronize(this->Context);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Declare()
{
  using Description = vtkRelievoStageDescription;
  this->Nodes.assign(this->Stages.size() + 1, {});
  vtkRelievoFramePlan::Node& delegate = this->Nodes[0];
  delegate.Name = "delegate";
  delegate.Slot = Description::SURFACES;
  delegate.Order = -1;
  delegate.Delegate = true;
  delegate.Declaration.Writes = { vtkRelievoResources::Picture, vtkRelievoResources::Color,
    vtkRelievoResources::Translucent };
  for (std::size_t i = 0; i < this->Stages.size(); ++i)
  {
    vtkRelievoStage* stage = this->Stages[i];
    const Description& description = stage->GetDescription();
    vtkRelievoFramePlan::Node& node = this->Nodes[i + 1];
    node.Name = description.Name;
    node.Slot = description.Slot;
    node.Order = description.Order;
    node.Declaration.Reads = description.Reads;
    node.Declaration.Writes = description.Writes;
    node.Declaration.OptionalWrites = description.Writes;
    node.Declaration.Layers = description.Layers;
    node.Declaration.WritesArrays = description.WritesArrays;
    node.Declaration.Reason = description.Help;
    node.ReadsFor = [this, stage](const std::vector<std::string>& asked) {
      return stage->GetReadsFor(this->Context, asked);
    };
    if (stage->GetEnabled() || description.ServesWhenOff)
    {
      stage->Declare(this->Context, node.Declaration);
    }
    if (!stage->GetEnabled() && node.Declaration.Runs)
    {
      std::vector<vtkRelievoResourceName>& writes = node.Declaration.Writes;
      writes.erase(
        std::remove(writes.begin(), writes.end(), vtkRelievoResources::Color), writes.end());
      node.Declaration.OptionalWrites.clear();
      node.Declaration.Runs = description.ServesWhenOff;
      node.Declaration.ReasonCode = "off";
      node.Declaration.Reason = "switched off (EnabledOff)";
    }
    if (description.Slot == Description::LIGHT_MAPS || node.Declaration.DrawsWithDelegate)
    {
      // The picture's lighting uses data made for lights.
      std::vector<vtkRelievoResourceName>& uses = delegate.Declaration.OptionalReads;
      uses.insert(uses.end(), description.Writes.begin(), description.Writes.end());
    }
  }
  std::vector<std::string>& layers = this->Context.ReadBack;
  for (const vtkRelievoFramePlan::Node& node : this->Nodes)
  {
    const std::vector<std::string>& amends = node.Declaration.Amends;
    const auto isAsked = [&layers](const std::string& name) {
      return std::find(layers.begin(), layers.end(), name) != layers.end();
    };
    if (this->Context.Amends && node.Declaration.Runs &&
      std::any_of(amends.begin(), amends.end(), isAsked) && !isAsked(node.Declaration.AmendsBy))
    {
      layers.push_back(node.Declaration.AmendsBy);
    }
  }
  this->FindLights();
}

//------------------------------------------------------------------------------
// Finds the requested layers that are lights' visibility.
void vtkRelievoFrameRun::FindLights()
{
  std::vector<std::string> layers = this->Context.ReadBack;
  for (const vtkRelievoFramePlan::Node& node : this->Nodes)
  {
    for (const vtkRelievoResourceName& read : node.Declaration.Reads)
    {
      layers.push_back(read.Get());
    }
    const std::vector<std::string>& more = node.Declaration.ReadsLayers;
    layers.insert(layers.end(), more.begin(), more.end());
  }
  for (vtkRelievoStage* stage : this->Stages)
  {
    this->Context.Lights.merge(stage->FindLights(layers, this->Context.Renderer));
  }
  for (vtkRelievoFramePlan::Node& node : this->Nodes)
  {
    for (const auto& light : this->Context.Lights)
    {
      if (node.Declaration.WritesArrays)
      {
        node.Declaration.Layers.push_back(light.first);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoFrameRun::Plan()
{
  const std::vector<vtkRelievoFramePlan::Node> declared = this->Nodes;
  this->Planned.SetOptionalLayers(this->Context.OptionalLayers);
  std::vector<std::string> error =
    this->Planned.Make(this->Nodes, this->Context.ReadBack, this->Context.Picture);
  if (this->Planned.NeedsColor())
  {
    // Samples with their own positions replace OpenGL's, which averages encoded colours.
    const bool single = std::any_of(this->Nodes.begin(), this->Nodes.end(), [](const auto& node) {
      return node.Needed && node.Declaration.OffsetsSamples && node.Declaration.Samples > 1;
    });
    const std::string noColor = this->Color.Prepare(this->Context, single);
    if (!noColor.empty())
    {
      this->Planned.SetNoColor(noColor);
      this->Nodes = declared;
      error = this->Planned.Make(this->Nodes, this->Context.ReadBack, this->Context.Picture);
    }
  }
  const auto worksOnColor = [](const vtkRelievoFramePlan::Node& node) {
    const auto reads = vtkRelievoFramePlan::GetReads(node);
    return node.Declaration.Presents || node.ChangesColor() ||
      std::any_of(reads.begin(), reads.end(), [](const vtkRelievoFramePlan::Name& read) {
        return read.Resource == vtkRelievoResources::Color.Get();
      });
  };
  const auto hasColor = [](const std::vector<std::string>& layers) {
    return std::find(layers.begin(), layers.end(), vtkRelievoResources::Color.Get()) !=
      layers.end();
  };
  this->Context.ReadsColor = hasColor(this->Context.ReadBack) ||
    std::any_of(this->Nodes.begin(), this->Nodes.end(), [&hasColor](const auto& node) {
      return node.Needed && hasColor(node.Declaration.ReadsLayers);
    });
  this->WorkOnColor.resize(this->Nodes.size());
  std::transform(this->Nodes.begin(), this->Nodes.end(), this->WorkOnColor.begin(), worksOnColor);
  this->Context.OneByOne = this->Context.OneByOne || !this->Raster.GetFault().empty();
  this->Samples.Begin(this->Context, this->Nodes, this->Planned.NeedsColor(), this->Stages);
  for (std::size_t i = 0; i < this->Stages.size(); ++i)
  {
    const vtkRelievoFramePlan::Node& node = this->Nodes[i + 1];
    if (node.Needed)
    {
      this->Context.Asked[this->Stages[i]] = node.Asked;
      this->Stages[i]->Explain("ran", node.Declaration.Reason);
    }
    else
    {
      this->Stages[i]->Explain(node.ReasonCode, node.Reason);
    }
  }
  return error;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameRun::IsNeeded(const vtkRelievoStage* stage) const
{
  for (std::size_t i = 0; i < this->Stages.size(); ++i)
  {
    if (this->Stages[i] == stage)
    {
      return this->Nodes[i + 1].Needed && !this->Dropped[i + 1];
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::map<std::string, vtkRelievoStage*> vtkRelievoFrameRun::GetWriters() const
{
  std::map<std::string, vtkRelievoStage*> writers;
  for (std::size_t i = 0; i < this->Stages.size(); ++i)
  {
    const vtkRelievoFramePlan::Node& node = this->Nodes[i + 1];
    const std::vector<std::string>& layers = node.Declaration.Layers;
    if (node.Needed && node.Declaration.WritesArrays)
    {
      writers[std::string()] = this->Stages[i];
    }
    for (const std::string& resource : node.Asked)
    {
      if (std::find(layers.begin(), layers.end(), resource) != layers.end())
      {
        writers[resource] = this->Stages[i];
      }
    }
  }
  return writers;
}

//------------------------------------------------------------------------------
// nullptr: the layers cannot be amended, as none of them was requested.
std::map<std::string, vtkRelievoStage*> vtkRelievoFrameRun::GetAmenders() const
{
  const std::vector<std::string>& asked = this->Context.ReadBack;
  std::map<std::string, vtkRelievoStage*> amenders;
  for (std::size_t i = 0; i < this->Stages.size(); ++i)
  {
    const vtkRelievoFramePlan::Node& node = this->Nodes[i + 1];
    const std::vector<std::string>& amends = node.Declaration.Amends;
    const bool any = std::any_of(amends.begin(), amends.end(), [&asked](const std::string& layer) {
      return std::find(asked.begin(), asked.end(), layer) != asked.end();
    });
    for (const std::string& layer : amends)
    {
      if (any ? node.Needed : node.Declaration.Runs)
      {
        amenders[layer] = any ? this->Stages[i] : nullptr;
      }
    }
  }
  return amenders;
}

//------------------------------------------------------------------------------
// The stages that run, in order.
std::vector<vtkRelievoStage*> vtkRelievoFrameRun::GetRunning() const
{
  std::vector<vtkRelievoStage*> running;
  for (const int place : this->Planned.GetOrder())
  {
    if (place > 0 && !this->Dropped[place])
    {
      running.push_back(this->Stages[place - 1]);
    }
  }
  return running;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Prepare()
{
  const std::vector<int>& order = this->Planned.GetOrder();
  if (std::any_of(order.begin(), order.end(), [](int place) { return place > 0; }))
  {
    this->Context.Scene.Take(this->Context.State);
  }
  for (const int place : order)
  {
    if (place > 0 && !this->Stages[place - 1]->Prepare(this->Context))
    {
      this->Dropped[place] = true;
      this->Stages[place - 1]->ReleaseGraphicsResources(this->Context.Window);
    }
  }
}

//------------------------------------------------------------------------------
// Runs the next stages of the order, up to a slot.
void vtkRelievoFrameRun::RunStages(int lastSlot)
{
  const std::vector<int>& order = this->Planned.GetOrder();
  for (; this->Next < order.size() && this->Nodes[order[this->Next]].Slot <= lastSlot; ++this->Next)
  {
    this->Run(order[this->Next]);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Run(int place)
{
  if (place > 0 && !this->Dropped[place])
  {
    vtkRelievoStage* stage = this->Stages[place - 1];
    this->Timer.Begin(stage->GetStageName());
    this->Context.Finishes = this->Nodes[place].ChangesColor() && this->FinishesColor() &&
      this->Color.PresentDepth(this->Context);
    stage->Execute(this->Context);
    vtkRelievoLeakedTextureUnits::Release(this->Context.Window);
    this->Timer.End(stage->GetStageName());
  }
}

//------------------------------------------------------------------------------
// Whether the next stage is the last to process the colour, and the picture is only encoded by the
// sRGB curve.
bool vtkRelievoFrameRun::FinishesColor() const
{
  const vtkRelievoFrameContext& context = this->Context;
  const std::vector<int>& order = this->Planned.GetOrder();
  return context.Color && context.Picture && context.Last && context.Samples == 1 &&
    !context.ReadsColor &&
    std::none_of(order.begin() + static_cast<std::ptrdiff_t>(this->Next) + 1, order.end(),
      [this, &context](int later) {
        return this->WorkOnColor[later] &&
          (!this->Nodes[later].Declaration.OnlyIfTranslucent ||
            context.Find(vtkRelievoResources::Translucent));
      });
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::DrawLightMaps()
{
  this->RunStages(vtkRelievoStageDescription::LIGHT_MAPS);
}

//------------------------------------------------------------------------------
int vtkRelievoFrameRun::DrawDelegate(vtkRelievoDelegate& delegate, vtkRenderPass* pass)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(this->Context.Renderer);
  if (!this->Nodes[0].Needed)
  {
    // Done here in place of the delegate: VTK's shaders are built for the lights counted by it, and
    // readers of layers need the lights' positions.
    vtkRelievoAccess::Renderer::FollowCamera(renderer);
    renderer->UpdateLights();
    return 0;
  }
  // Excludes interruptions from the delegate's time.
  const auto interrupt = [this](const auto& work) {
    this->Timer.End("delegate");
    work();
    this->Timer.Begin("delegate");
  };
  const std::vector<vtkRelievoStage*> running = this->GetRunning();
  const auto forEach = [&](void (vtkRelievoStage::*work)(vtkRelievoFrameContext&)) {
    for (vtkRelievoStage* stage : running)
    {
      this->Timer.Begin(stage->GetStageName());
      (stage->*work)(this->Context);
      this->Timer.End(stage->GetStageName());
    }
  };
  vtkRelievoDelegate::DelegateEvents events;
  HiddenPoints hidden;
  // Opaque geometry: stages write next to the colour while VTK draws it.
  if (!running.empty())
  {
    events.OpaqueBegins = [&]() {
      interrupt([&]() { forEach(&vtkRelievoStage::BeginOpaque); });
      if (this->Context.Lattice)
      {
        this->Raster.Begin(this->Context, this->Color);
        this->CheckRaster();
      }
      this->FindHidden(hidden);
    };
    events.OpaqueEnds = [&]() {
      hidden.clear();
      vtkRelievoLeakedTextureUnits::Release(this->Context.Window);
      if (this->Context.Lattice)
      {
        this->Raster.End(this->Context, this->Color);
        this->CheckRaster();
        if (this->Context.Lattice && !this->Context.Translucent)
        {
          delegate.LeaveTranslucentOut(renderer);
        }
      }
      interrupt([&]() { forEach(&vtkRelievoStage::EndOpaque); });
    };
  }
  bool aside = false;
  if (this->Planned.NeedsColor())
  {
    this->Color.Begin(this->Context);
    this->ColorOpen = true;
    this->Context.Color = &this->Color;
    // Translucent geometry and volumes: each into its own layer, if a stage keeps them apart.
    if (this->Context.Translucent || vtkRelievoTranslucentLayers::RightsAlpha(this->Context))
    {
      this->Translucent.Begin(this->Context, this->Color);
      events.TranslucentAsked = [&]() { interrupt([&]() { this->Translucent.Ask(); }); };
      events.TranslucentBegins = [&](vtkProp* sentinel) {
        interrupt([&]() { this->Translucent.BeginSurfaces(sentinel); });
      };
      events.VolumesBegin = [&]() { interrupt([&]() { this->Translucent.BeginVolumes(); }); };
    }
    // Overlay: texts and bars are drawn over the finished picture, not into the colour that stages
    // change; without a picture they are discarded.
    events.OverlayBegins = [&]() {
      if (this->ColorOpen && this->Color.IsBound())
      {
        interrupt([&]() {
          this->DrawStages();
          this->Present();
        });
        aside = !this->Context.Picture || !this->Context.Last;
        if (aside)
        {
          this->Color.BeginAside(this->Context);
        }
      }
    };
  }
  // Linear colours are floats, but the next picture may be drawn without them, or without a frame.
  const bool linear = this->ColorOpen;
  if (linear)
  {
    vtkRelievoAccess::Renderer::ForgetColorFormat(renderer);
  }
  this->Timer.Begin("delegate");
  const int drawn = delegate.Render(pass, this->Context.State, events);
  this->Timer.End("delegate");
  if (linear)
  {
    vtkRelievoAccess::Renderer::ForgetColorFormat(renderer);
  }
  if (aside)
  {
    this->Color.EndAside(this->Context);
  }
  return drawn;
}

//------------------------------------------------------------------------------
// Finds hidden points, if the renderer's own steps draw everything with one camera, in one go, and
// no layer numbers primitives. A mapper shared by several actors would need different points for
// each.
void vtkRelievoFrameRun::FindHidden(HiddenPoints& hidden) const
{
  const vtkRelievoFrameContext& context = this->Context;
  vtkProp** const props = context.State->GetPropArray();
  vtkProp** const end = props + context.State->GetPropArrayCount();
  const std::vector<vtkRelievoStage*> running = this->GetRunning();
  const auto counts = [](vtkRelievoStage* stage) {
    return std::string(stage->GetStageName()) == "gbuffer";
  };
  if (!context.OwnSteps || context.Nested || context.Lattice ||
    std::none_of(props, end, vtkRelievoHiddenPoints::IsPossible) ||
    vtkRelievoBoundFramebuffer::GetSamples() > 0 ||
    std::any_of(running.begin(), running.end(), counts))
  {
    return;
  }
  const auto isPlain = [](vtkProp* prop) {
    return vtkActor::SafeDownCast(prop) || vtkActor2D::SafeDownCast(prop);
  };
  if (!std::all_of(props, end, isPlain))
  {
    return; // other props may contain an actor that shares a mapper
  }
  for (vtkProp** prop = props; prop != end; ++prop)
  {
    const auto shares = [prop](vtkProp* other) {
      auto* actor = vtkActor::SafeDownCast(other);
      return actor && other != *prop &&
        actor->GetMapper() == static_cast<vtkActor*>(*prop)->GetMapper();
    };
    if (vtkRelievoHiddenPoints::IsPossible(*prop) && std::none_of(props, end, shares))
    {
      hidden.emplace_back(new vtkRelievoHiddenPoints(*prop, context.Renderer, this->PointGroups));
    }
  }
}

//------------------------------------------------------------------------------
// If samples could not be drawn at once, nothing is shown yet: the next turn starts with the first
// sample.
void vtkRelievoFrameRun::CheckRaster()
{
  if (!this->Raster.GetFault().empty())
  {
    this->Context.Lattice = this->Context.MeanLattice = nullptr;
    this->Context.Last = false;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::DrawStages()
{
  if (this->StagesDrawn)
  {
    return;
  }
  this->StagesDrawn = true;
  vtkRelievoLeakedTextureUnits::Release(this->Context.Window);
  if (this->ColorOpen)
  {
    this->Translucent.End();
    this->Color.End(this->Context);
    this->ColorOpen = false;
  }
  this->RunStages(vtkRelievoStageDescription::COMPOSITE);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Present()
{
  if (this->Presented)
  {
    return;
  }
  this->Presented = true;
  this->Samples.Accumulate(this->Context);
  if (this->Context.Picture && this->Context.Last && this->Context.Color)
  {
    this->Color.PresentDepth(this->Context);
  }
  const std::vector<int>& order = this->Planned.GetOrder();
  for (; this->Next < order.size() && this->Context.Last; ++this->Next)
  {
    // A stage that makes the picture from the colour presents it itself; a stage that replaces the
    // picture draws over it.
    if (!this->Nodes[order[this->Next]].Declaration.Presents)
    {
      this->PresentColor();
    }
    this->Run(order[this->Next]);
  }
  this->PresentColor();
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::PresentColor()
{
  if (this->Context.Picture && this->Context.Last && this->Context.Color)
  {
    this->Color.Present(this->Context);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Finish()
{
  std::vector<vtkRelievoStage*> running = this->GetRunning();
  for (auto stage = running.rbegin(); stage != running.rend(); ++stage)
  {
    (*stage)->Finish(this->Context);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameRun::Report(vtkRelievoFrameReport& report, vtkRenderPass* pass) const
{
  const bool draws = this->Nodes[0].Needed;
  report.Begin(this->Context.Renderer,
    this->Color.GetBytes() + this->Samples.GetBytes() + this->PointGroups.GetBytes());
  report.Add("delegate", draws, draws ? "ran" : "not_asked",
    !draws   ? "only the layers are asked for"
      : pass ? std::string("draws the picture: ") + pass->GetClassName()
             : "draws the picture: the renderer's own steps");
  for (vtkRelievoStage* stage : this->Stages)
  {
    report.Add(stage, this->IsNeeded(stage));
  }
}
