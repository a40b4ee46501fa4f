// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFramePass.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoColorTarget.h"
#include "vtkRelievoDelegate.h"
#include "vtkRelievoDepthSplice.h"
#include "vtkRelievoEdgeFilter.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFrameReader.h"
#include "vtkRelievoFrameReport.h"
#include "vtkRelievoFrameRun.h"
#include "vtkRelievoGpuTimer.h"
#include "vtkRelievoLeakedTextureUnits.h"
#include "vtkRelievoPointGroups.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoSampleAccumulator.h"
#include "vtkRelievoSampleOffset.h"
#include "vtkRelievoSampleRaster.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageRegistry.h"
#include "vtkRelievoTranslucentLayers.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

class vtkRelievoFramePass::Internals
{
public:
  vtkSmartPointer<vtkRenderPass> Delegate;
  std::vector<vtkSmartPointer<vtkRelievoStage>> Registered;
  std::vector<vtkSmartPointer<vtkRelievoStage>> Added;
  std::set<std::string> Requested;
  std::vector<std::string> Optional;
  vtkRelievoReportOnce Reported;
  bool Drawing = false;
  vtkRelievoGpuTimer Timer;
  vtkRelievoFrameReport Report;
  vtkRelievoDelegate Picture;
  vtkRelievoColorTarget Color;
  vtkRelievoTranslucentLayers Translucent;
  vtkNew<vtkRelievoDepthSplice> Depth;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkRelievoSampleAccumulator Samples;
  vtkRelievoSampleRaster Raster; // all samples at once
  vtkRelievoPointGroups PointGroups;
  vtkRelievoFrameReader Reader{ Color, Samples };
  vtkRelievoEdgeFilter Filter;                  // for pictures with one of several samples
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the last frame

  // While something moves, pictures show only the first of the samples that smooth edges: the
  // filter applies to the shown picture, not to the gathered samples.
  void SmoothFirst(const vtkRelievoFrameContext& context)
  {
    if (context.OffsetsSamples && context.Sample == 0 && context.Picture && context.Last)
    {
      this->Filter.Execute(context);
    }
  }

  std::vector<vtkRelievoStage*> GetStages()
  {
    std::vector<vtkRelievoStage*> stages;
    for (auto& stage : this->Registered)
    {
      const std::string name = stage->GetStageName();
      const bool replaced = std::any_of(this->Added.begin(), this->Added.end(),
        [&name](const auto& added) { return added->GetStageName() == name; });
      if (!replaced)
      {
        stages.push_back(stage);
      }
    }
    for (auto& stage : this->Added)
    {
      stages.push_back(stage);
    }
    return stages;
  }

  // Groups of points that nothing in the renderer needs any more, inside or outside the view.
  void DropPointGroups(vtkRenderer* renderer)
  {
    if (this->PointGroups.IsEmpty())
    {
      return;
    }
    std::vector<vtkProp*> visible;
    vtkCollectionSimpleIterator it;
    renderer->GetViewProps()->InitTraversal(it);
    while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
    {
      if (prop->GetVisibility())
      {
        visible.push_back(prop);
      }
    }
    this->PointGroups.KeepOnly(visible);
  }

  // For a stage that leaves the frame: releases its resources, and drops its layers.
  void Forget(vtkRelievoStage* stage)
  {
    if (this->Window)
    {
      stage->ReleaseGraphicsResources(this->Window);
    }
    this->Reader.Forget(stage);
  }
};

vtkStandardNewMacro(vtkRelievoFramePass);

//------------------------------------------------------------------------------
vtkRelievoFramePass::vtkRelievoFramePass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoFramePass::~vtkRelievoFramePass() = default;

//------------------------------------------------------------------------------
void vtkRelievoFramePass::AddRegisteredStages()
{
  for (const auto& stage : vtkRelievoStageRegistry::MakeAll())
  {
    stage->SetEnabled(stage->GetDescription().OnByDefault);
    this->Internal->Registered.push_back(stage);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Internal->Delegate != pass)
  {
    this->Internal->Delegate = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkRelievoFramePass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::AddStage(vtkRelievoStage* stage)
{
  auto& added = this->Internal->Added;
  const auto stages = this->Internal->GetStages();
  if (!stage || std::find(stages.begin(), stages.end(), stage) != stages.end())
  {
    vtkErrorMacro(
      "AddStage was given " << (stage ? "a stage that was added before." : "no stage."));
    return;
  }
  const std::string name = stage->GetStageName();
  for (const auto& other : added)
  {
    if (other->GetStageName() == name)
    {
      vtkErrorMacro("AddStage was given a second stage '" << name << "'; give it another name, or "
                                                          << "remove the first one (RemoveStage).");
      return;
    }
  }
  if (vtkRelievoStage* replaced = this->GetStage(name))
  {
    this->Internal->Forget(replaced);
  }
  added.push_back(stage);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::RemoveStage(vtkRelievoStage* stage)
{
  auto& added = this->Internal->Added;
  const auto found = std::find(added.begin(), added.end(), stage);
  if (found == added.end())
  {
    return;
  }
  this->Internal->Forget(stage);
  added.erase(found);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoFramePass::GetNumberOfStages()
{
  return static_cast<int>(this->Internal->GetStages().size());
}

//------------------------------------------------------------------------------
vtkRelievoStage* vtkRelievoFramePass::GetStage(int i)
{
  const auto stages = this->Internal->GetStages();
  return i >= 0 && i < static_cast<int>(stages.size()) ? stages[i] : nullptr;
}

//------------------------------------------------------------------------------
vtkRelievoStage* vtkRelievoFramePass::GetStage(RELIEVO_TEXT name)
{
  for (vtkRelievoStage* stage : this->Internal->GetStages())
  {
    if (stage->GetStageName() == name)
    {
      return stage;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::RequestLayer(RELIEVO_TEXT name)
{
  if (name.empty())
  {
    vtkErrorMacro("RequestLayer was given an empty name; give it a layer's or an array's name.");
    return;
  }
  if (this->Internal->Requested.insert(name).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::ReleaseLayer(RELIEVO_TEXT name)
{
  if (this->Internal->Requested.erase(name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::ReleaseLayers()
{
  this->Internal->Requested.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoFramePass::IsLayerRequested(RELIEVO_TEXT name)
{
  return this->Internal->Requested.count(name) != 0;
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::SetOptionalLayers(const std::vector<std::string>& names)
{
  if (this->Internal->Optional != names)
  {
    this->Internal->Optional = names;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const std::vector<std::string>& vtkRelievoFramePass::GetOptionalLayers() const
{
  return this->Internal->Optional;
}

//------------------------------------------------------------------------------
bool vtkRelievoFramePass::ReadLayer(RELIEVO_TEXT name, vtkImageData* image)
{
  return this->ReadLayers({ name }, image);
}

//------------------------------------------------------------------------------
bool vtkRelievoFramePass::ReadLayers(const std::vector<std::string>& names, vtkImageData* image)
{
  const std::string error = this->TryReadLayers(names, image);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  return error.empty();
}

//------------------------------------------------------------------------------
std::string vtkRelievoFramePass::TryReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  if (!image)
  {
    return "Reading layers needs an image to fill, and was given none; give it a vtkImageData.";
  }
  const std::string error = this->Internal->Reader.Read(names, image);
  return error.empty() && this->Amends ? this->Internal->Reader.Amend(names, image) : error;
}

//------------------------------------------------------------------------------
std::string vtkRelievoFramePass::CheckLights(vtkRenderer* renderer)
{
  int on = 0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    on += light->GetSwitch() ? 1 : 0;
  }
  return on <= MOST_LIGHTS ? std::string()
                           : std::to_string(on) +
      " lights are on, and VTK's shaders, which have code for each, take at most " +
      std::to_string(MOST_LIGHTS) + ".";
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  auto* window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window)
  {
    vtkErrorMacro("Relievo draws with VTK's OpenGL renderer and window only.");
    return;
  }
  if (in.Drawing)
  {
    if (in.Reported.IsNew("within itself"))
    {
      vtkErrorMacro("The frame is inside its own delegate pass: set another delegate pass.");
    }
    return;
  }
  this->NumberOfRenderedProps = 0;
  const std::string tooMany = CheckLights(renderer);
  if (!tooMany.empty())
  {
    vtkErrorMacro("Nothing is drawn: " << tooMany << " Make them lamps (vtkRelievoLamps).");
    return;
  }
  if (in.Window && in.Window != window)
  {
    // For one pass in two windows: resources are released in their own context first.
    this->ReleaseStages(in.Window);
    in.Picture.ReleaseGraphicsResources(in.Window);
  }
  in.Window = window;
  window->MakeCurrent();
  vtkRelievoAccess::Camera::SetStereo(renderer->GetActiveCamera(), window->GetStereoRender());
  if (renderer->GetSelector())
  {
    // A selection draws its own picture of ids, by its own rules.
    this->NumberOfRenderedProps = in.Picture.Render(in.Delegate, s, {});
    return;
  }

  vtkRelievoLeakedTextureUnits::Release(window);
  in.Samples.BeginFrame();
  in.Timer.BeginFrame(window);
  in.Drawing = true;
  while (!this->DrawSample(s))
  {
    // Nothing is shown yet: the frame has more samples.
  }
  in.Drawing = false;
  in.Timer.EndFrame();
}

//------------------------------------------------------------------------------
// Returns whether the sample is the frame's last.
bool vtkRelievoFramePass::DrawSample(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  auto* renderer = static_cast<vtkOpenGLRenderer*>(s->GetRenderer());
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRelievoFrameContext context;
  context.Renderer = renderer;
  context.Window = window;
  context.State = s;
  context.View.Take(renderer, s);
  context.SteadyView = context.View;
  context.Picture = !this->LayersOnly;
  context.Waits = this->WaitForSamples;
  context.OneByOne = this->SamplesOneByOne && !this->WaitForSamples;
  context.Delegate = in.Delegate;
  context.Controller = in.Controller && in.Controller->GetNumberOfProcesses() > 1
    ? in.Controller.GetPointer()
    : nullptr;
  context.OwnSteps = (!in.Delegate || this->DelegateDrawsOwnSteps) && !s->GetFrameBuffer();
  context.Frame = this;
  context.Nested = renderer->GetPass() != this;
  context.ReadBack.assign(in.Requested.begin(), in.Requested.end());
  context.OptionalLayers = in.Optional;
  context.Amends = this->Amends;
  context.ReadLayers = [&in](const std::vector<std::string>& names, vtkImageData* image) {
    return in.Reader.Read(names, image);
  };
  const std::vector<vtkRelievoStage*> stages = in.GetStages();
  vtkRelievoFrameRun run(
    context, stages, in.Color, in.Translucent, in.Samples, in.Raster, in.PointGroups, in.Timer);
  run.Synchronize();
  run.Declare();
  for (const std::string& error : run.Plan())
  {
    if (in.Reported.IsNew(error))
    {
      vtkErrorMacro(<< error << ".");
    }
  }
  for (vtkRelievoStage* stage : stages)
  {
    if (!run.IsNeeded(stage))
    {
      stage->ReleaseGraphicsResources(window);
    }
  }
  if (!run.NeedsColor())
  {
    in.Color.Release(window);
    in.Translucent.Release(window);
  }
  in.DropPointGroups(renderer);
  in.Reader.SetFrame(run.GetWriters(), run.GetAmenders(), run.GetMissing());

  const vtkRelievoSampleOffset offset(context);
  in.Timer.Begin("frame");
  run.Prepare();
  in.Depth->Begin(context.Scene, window);
  run.DrawLightMaps();
  this->NumberOfRenderedProps = run.DrawDelegate(in.Picture, in.Delegate);
  run.DrawStages();
  run.Present();
  in.SmoothFirst(context);
  in.Depth->End();
  run.Finish();
  in.Timer.End("frame");

  in.Samples.End(context, stages);
  if (!in.Samples.GetFault().empty() && in.Reported.IsNew(in.Samples.GetFault()))
  {
    vtkErrorMacro("Samples are not gathered: " << in.Samples.GetFault() << ".");
  }
  if (!in.Raster.GetFault().empty() && in.Reported.IsNew(in.Raster.GetFault()))
  {
    vtkWarningMacro("Samples are drawn one by one: " << in.Raster.GetFault() << ".");
  }
  run.Report(in.Report, in.Delegate);
  return context.Last;
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::SetController(vtkMultiProcessController* controller)
{
  this->Internal->Controller = controller;
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoFramePass::GetController()
{
  return this->Internal->Controller;
}

//------------------------------------------------------------------------------
int vtkRelievoFramePass::GetSamplesLeft()
{
  return this->Internal->Samples.GetLeft();
}

//------------------------------------------------------------------------------
std::string vtkRelievoFramePass::GetFrameReport()
{
  this->Internal->Timer.Want();
  return this->Internal->Report.GetJSON(this->Internal->Timer);
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoFramePass::GetBytesHeld()
{
  vtkIdType bytes = this->Internal->Color.GetBytes() + this->Internal->Samples.GetBytes() +
    this->Internal->PointGroups.GetBytes();
  for (vtkRelievoStage* stage : this->Internal->GetStages())
  {
    bytes += stage->GetBytesHeld();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::ReleaseStages(vtkWindow* window)
{
  for (auto* list : { &this->Internal->Registered, &this->Internal->Added })
  {
    for (auto& stage : *list)
    {
      stage->ReleaseGraphicsResources(window);
    }
  }
  this->Internal->Color.Release(window);
  this->Internal->Translucent.Release(window);
  this->Internal->Samples.Release(window);
  this->Internal->Raster.Release(window);
  this->Internal->Filter.Release(window);
  this->Internal->Timer.Release();
  this->Internal->PointGroups.Clear();
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    vtkErrorMacro(
      "ReleaseGraphicsResources was given no window; give it the window that was drawn to.");
    return;
  }
  this->ReleaseStages(window);
  this->Internal->Picture.ReleaseGraphicsResources(window);
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoFramePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: "
     << (this->Internal->Delegate ? this->Internal->Delegate->GetClassName()
                                  : "(renderer's own steps)")
     << "\n";
  os << indent << "DelegateDrawsOwnSteps: " << this->DelegateDrawsOwnSteps << "\n";
  os << indent << "Stages:";
  for (vtkRelievoStage* stage : this->Internal->GetStages())
  {
    os << " " << stage->GetStageName() << (stage->GetEnabled() ? "" : " (off)");
  }
  os << "\n";
  os << indent << "Requested layers:";
  for (const std::string& name : this->Internal->Requested)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "Optional layers:";
  for (const std::string& name : this->Internal->Optional)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "LayersOnly: " << this->LayersOnly << "\n";
  os << indent << "Controller: " << this->Internal->Controller.GetPointer() << "\n";
  os << indent << "WaitForSamples: " << this->WaitForSamples << "\n";
  os << indent << "SamplesOneByOne: " << this->SamplesOneByOne << "\n";
}
