// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleAccumulator.h"

#include "vtkCommunicator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoSampleRaster.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoStageDescription.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Tiles of a picture are drawn once each, and several views alternate: the next frame never
// continues the present one.
bool IsOneOfSeveral(const vtkRelievoFrameContext& context)
{
  vtkRenderWindow* window = context.Window;
  if (window->GetTileScale()[0] > 1 || window->GetTileScale()[1] > 1 || window->GetStereoRender())
  {
    return true;
  }
  vtkRendererCollection* renderers = window->GetRenderers();
  vtkCollectionSimpleIterator it;
  renderers->InitTraversal(it);
  while (vtkRenderer* other = renderers->GetNextRenderer(it))
  {
    if (other != context.Renderer && other->GetDraw() && other->GetPass() &&
      other->GetPass() == context.Renderer->GetPass())
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Display stages process the mean, however it was made.
bool IsOfAnyRaster(const vtkRelievoFramePlan::Node& node)
{
  return !node.Needed || node.Delegate || node.Declaration.AnyRaster ||
    node.Slot == vtkRelievoStageDescription::DISPLAY;
}
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::Sum::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->Quad.Release(window);
}

//------------------------------------------------------------------------------
vtkRelievoSampleAccumulator::Demand vtkRelievoSampleAccumulator::GetDemand(
  const vtkRelievoFrameContext& context, const std::vector<vtkRelievoFramePlan::Node>& nodes,
  bool hasColor)
{
  Demand demand;
  for (const vtkRelievoFramePlan::Node& node : nodes)
  {
    const vtkRelievoDeclaration& declaration = node.Declaration;
    if (!node.Needed || declaration.Samples <= 1)
    {
      continue;
    }
    const auto isAmong = [](const std::vector<vtkRelievoResourceName>& names,
                           const std::string& name) {
      return std::any_of(names.begin(), names.end(),
        [&name](const vtkRelievoResourceName& other) { return other.Get() == name; });
    };
    const std::string& colorName = vtkRelievoResources::Color.Get();
    // A picture that is not made from the linear colour cannot be a mean; layers can, if samples
    // affect nothing else.
    const bool layersAlone =
      std::all_of(node.Asked.begin(), node.Asked.end(), [&](const std::string& asked) {
        return asked != colorName && isAmong(declaration.Gathered, asked);
      });
    if (context.Picture && !hasColor && !layersAlone)
    {
      demand = Demand();
      break;
    }
    demand.Samples = std::max(demand.Samples, declaration.Samples);
    demand.AtOnce = demand.AtOnce || declaration.AtOnce || context.Waits;
    demand.Offsets = demand.Offsets || declaration.OffsetsSamples;
    for (const std::string& asked : node.Asked)
    {
      const bool gathered = isAmong(declaration.Gathered, asked);
      const bool color = asked == colorName && gathered;
      demand.Color =
        demand.Color || (hasColor && (color || isAmong(declaration.OptionalWrites, asked)));
      if (gathered && !color)
      {
        demand.Layers.push_back(asked);
      }
    }
  }
  for (const auto& light : context.Lights)
  {
    demand.Layers.push_back(light.first);
  }
  demand.AnyRaster = !context.OneByOne && demand.Offsets && demand.Color && demand.Layers.empty() &&
    std::all_of(nodes.begin(), nodes.end(), IsOfAnyRaster);
  return demand;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::Begin(vtkRelievoFrameContext& context,
  const std::vector<vtkRelievoFramePlan::Node>& nodes, bool hasColor,
  const std::vector<vtkRelievoStage*>& stages)
{
  context.Samples = 1;
  context.Sample = 0;
  context.Last = true;
  ++this->Turns;
  this->Asked = GetDemand(context, nodes, hasColor);
  if (!this->Asked.Color && this->Asked.Layers.empty())
  {
    this->Asked.Samples = 1;
  }
  // Compared only once per frame: a scene that changes with every drawing would never be gathered.
  bool begins = this->Asked.Samples > 1 && this->Turns == 1 &&
    (this->Asked.Samples != this->Before || this->Asked.Offsets != this->OffsetsBefore ||
      !this->State.IsOf(context, stages));
  // Restarts a mean that had to be drawn sample by sample, and now can be drawn at once.
  begins = begins ||
    (this->Turns == 1 && this->OneByOneBefore && this->Asked.AnyRaster && this->Color &&
      this->Color->Weight > 1 && vtkRelievoSampleRaster::FindObstacle(context).empty());
  if (context.Controller)
  {
    this->AgreeOnSamples(context.Controller, begins);
  }
  if (this->Asked.Samples == 1)
  {
    if (context.Picture) // a capture of layers without samples keeps the window's sums
    {
      this->Before = 1;
      this->Release(context.Window);
    }
    return;
  }
  this->Before = this->Asked.Samples;
  this->OffsetsBefore = this->Asked.Offsets;
  this->OneByOneBefore = context.OneByOne;
  if (begins)
  {
    this->Release(context.Window);
  }
  if (!this->Fault.empty())
  {
    this->Asked.Samples = 1; // until a change
    return;
  }
  this->Choose(context);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::AgreeOnSamples(
  vtkMultiProcessController* controller, bool& begins)
{
  const bool able = begins || this->Fault.empty();
  const int own[2] = { able ? this->Asked.Samples : 1, begins ? 0 : 1 };
  int all[2] = { 1, 1 };
  controller->AllReduce(own, all, 2, vtkCommunicator::MIN_OP);
  this->Asked.Samples = all[0];
  begins = all[1] == 0;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::AgreeOnLast(vtkRelievoFrameContext& context)
{
  const int own = context.Last ? 1 : 0;
  int all = 0;
  context.Controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  context.Last = all != 0;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::Choose(vtkRelievoFrameContext& context)
{
  const Demand& demand = this->Asked;
  for (auto it = this->Layers.begin(); it != this->Layers.end();)
  {
    const bool kept =
      std::find(demand.Layers.begin(), demand.Layers.end(), it->first) != demand.Layers.end();
    if (!kept)
    {
      it->second->Release(context.Window);
    }
    it = kept ? std::next(it) : this->Layers.erase(it);
  }
  int next = demand.Samples;
  for (const std::string& layer : demand.Layers)
  {
    auto& sum = this->Layers[layer];
    if (!sum)
    {
      sum.reset(new Sum);
    }
    next = std::min(next, sum->Count);
  }
  if (demand.Color)
  {
    if (this->Color && this->ColorOfPicture != context.Picture)
    {
      this->Color->Release(context.Window);
      this->Color.reset();
    }
    if (!this->Color)
    {
      this->Color.reset(new Sum);
      this->ColorOfPicture = context.Picture;
    }
    next = std::min(next, this->Color->Count);
  }
  // Once all samples are gathered the last one remains, so that data depending on it is not
  // rebuilt.
  context.Samples = demand.Samples;
  context.OffsetsSamples = demand.Offsets;
  context.Sample = std::min(next, demand.Samples - 1);
  const bool atOnce = demand.AtOnce || IsOneOfSeveral(context);
  // While something moves, one sample is drawn; then all others at once.
  const bool many = demand.AnyRaster && (atOnce || next > 0);
  if (many && !this->Obstacle) // the search takes as long as a frame if there are many actors
  {
    this->Obstacle = vtkRelievoSampleRaster::FindObstacle(context);
  }
  context.Obstacle = many ? *this->Obstacle : std::string();
  if (many && this->Obstacle->empty() && next < demand.Samples)
  {
    const int samples = vtkRelievoSampleLattice::GetNumberInPlaceOf(demand.Samples);
    if (!this->Lattice || this->Lattice->GetNumberOfSamples() != samples)
    {
      this->Lattice.reset(new vtkRelievoSampleLattice(samples));
    }
    context.Lattice = this->Lattice.get();
    context.Sample = demand.Samples - 1;
  }
  // For a complete mean, stages continue with the data made for it.
  context.MeanLattice = context.Lattice;
  if (demand.AnyRaster && next >= demand.Samples && this->Color->IsDrawnAtOnce())
  {
    context.MeanLattice = this->Lattice.get();
    context.MeanWords = this->Words;
  }
  context.Last = !atOnce || next + 1 >= demand.Samples || this->Turns >= demand.Samples ||
    context.Lattice != nullptr;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleAccumulator::Add(vtkRelievoFrameContext& context, Sum& sum,
  const vtkRelievoResourceName& resource, const std::string& defines, int channels)
{
  const bool wanted =
    context.Lattice ? sum.Count < this->Asked.Samples : sum.Count == context.Sample;
  if (!wanted || context.Window->GetAbortRender())
  {
    return {}; // the sample was added before, or the drawing is incomplete
  }
  vtkRelievoScreenTarget::Format format;
  format.Channels = channels;
  format.Halves = false;
  std::string error = sum.Target.Prepare(context, format);
  if (error.empty() && !sum.Quad.Ready(context, "frame/gatherFS.glsl", { resource }, defines))
  {
    error = sum.Quad.GetError();
  }
  if (!error.empty())
  {
    return error;
  }
  if (context.Lattice)
  {
    sum.Count = sum.Weight = 0;
  }
  sum.Count == 0 ? sum.Target.Begin(context) : sum.Target.GoOn(context);
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  sum.Quad.Draw(context, sum.Target.GetArea());
  sum.Target.End();
  sum.Count = context.Lattice ? this->Asked.Samples : sum.Count + 1;
  ++sum.Weight;
  return {};
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleAccumulator::ShowMean(vtkRelievoFrameContext& context)
{
  const bool own =
    (context.Lattice || this->Color->Count == 1) && !context.Window->GetAbortRender();
  if (this->Color->Count == 0 || own)
  {
    return {}; // one sample is its own mean
  }
  context.Provide(vtkRelievoResources::Gathered, &this->Color->Target);
  vtkShaderProgram* program =
    this->Mean.Ready(context, "frame/meanFS.glsl", { vtkRelievoResources::Gathered });
  if (!program)
  {
    return this->Mean.GetError();
  }
  program->SetUniformf("relievoCount", static_cast<float>(this->Color->Weight));
  context.DrawColor(this->Mean);
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::Accumulate(vtkRelievoFrameContext& context)
{
  if (context.Samples <= 1)
  {
    return;
  }
  for (const std::string& layer : this->Asked.Layers)
  {
    Sum& sum = *this->Layers[layer];
    sum.There = context.FindLayer(layer) != nullptr;
    if (!sum.There)
    {
      sum.Count = this->Asked.Samples; // complete: no reader needs the sum
    }
    else if (this->Fault.empty())
    {
      const auto light = context.Lights.find(layer);
      this->Fault = this->Add(context, sum, vtkRelievoResourceName::Of(layer),
        light == context.Lights.end() ? "#define RELIEVO_GATHERED_TEXTURE\n"
                                      : "#define RELIEVO_GATHERED_PLACE RELIEVO_SHADOW_PLACE_" +
            std::to_string(light->second) + "\n",
        1);
    }
  }
  if (this->Fault.empty() && this->Asked.Color)
  {
    this->Fault = context.Find(vtkRelievoResources::Color)
      ? this->Add(context, *this->Color, vtkRelievoResources::Color, "", 4)
      : "the frame has made no linear colour";
  }
  if (!context.Last && this->Fault.empty() &&
    (context.Window->GetAbortRender() || context.Window->CheckAbortStatus()))
  {
    context.Last = true; // shows the mean so far
  }
  if (!this->Fault.empty())
  {
    this->GiveUp(context);
  }
  if (context.Lattice)
  {
    this->Words = context.MeanWords;
  }
  if (context.Controller)
  {
    AgreeOnLast(context);
  }
  if (context.Last && this->Fault.empty() && this->Asked.Color)
  {
    this->Fault = this->ShowMean(context);
    if (!this->Fault.empty())
    {
      this->GiveUp(context);
      context.Last = context.Last || context.Controller; // all processes have agreed
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::GiveUp(vtkRelievoFrameContext& context)
{
  this->ReleaseSums(context.Window);
  context.Last = context.Sample == 0; // or one more turn, with the first sample
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::End(
  const vtkRelievoFrameContext& context, const std::vector<vtkRelievoStage*>& stages)
{
  if (context.Last && (context.Samples > 1 || !this->Fault.empty()))
  {
    this->State.Take(context, stages);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoSampleAccumulator::Has(const std::string& layer) const
{
  const auto found = this->Layers.find(layer);
  return this->Asked.Samples > 1 && this->Fault.empty() && found != this->Layers.end() &&
    found->second->There && found->second->Count > 0;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleAccumulator::Read(const std::string& layer, vtkImageData* image)
{
  Sum& sum = *this->Layers.at(layer);
  const std::string error = sum.Target.Read(layer, 1, image);
  if (!error.empty())
  {
    return "The layer '" + layer + "' cannot be read: " + error + ".";
  }
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(layer.c_str()));
  float* value = values->GetPointer(0);
  const auto count = static_cast<float>(sum.Weight);
  std::for_each(
    value, value + values->GetNumberOfValues(), [count](float& each) { each /= count; });
  return {};
}

//------------------------------------------------------------------------------
int vtkRelievoSampleAccumulator::GetLeft() const
{
  if (!this->Fault.empty())
  {
    return 0;
  }
  int least = this->Before;
  for (const auto& layer : this->Layers)
  {
    least = std::min(least, layer.second->Count);
  }
  // The window's picture also waits during a capture.
  if (this->Color && (this->Asked.Color || this->ColorOfPicture))
  {
    least = std::min(least, this->Color->Count);
  }
  return this->Before - least;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoSampleAccumulator::GetBytes() const
{
  vtkIdType bytes = this->Color ? this->Color->Target.GetBytes() : 0;
  for (const auto& layer : this->Layers)
  {
    bytes += layer.second->Target.GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::ReleaseSums(vtkWindow* window)
{
  for (auto& layer : this->Layers)
  {
    layer.second->Release(window);
  }
  this->Layers.clear();
  if (this->Color)
  {
    this->Color->Release(window);
    this->Color.reset();
  }
  this->Mean.Release(window);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleAccumulator::Release(vtkWindow* window)
{
  this->ReleaseSums(window);
  this->State.Clear();
  this->Obstacle.reset();
  this->Fault.clear();
}
