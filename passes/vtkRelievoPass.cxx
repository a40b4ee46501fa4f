// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRelievoDelegate.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoFrameReport.h"
#include "vtkRelievoGBufferLayout.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoGpuTimer.h"
#include "vtkRelievoShadowPass.h"
#include "vtkRelievoStage.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkRelievoPass);

class vtkRelievoPass::Internals
{
public:
  vtkSmartPointer<vtkRenderPass> Delegate;
  vtkNew<vtkRelievoGBufferPass> GBuffer;
  vtkNew<vtkRelievoShadowPass> Shadows;
  vtkNew<vtkRelievoDisplayStage> Display;
  std::vector<vtkSmartPointer<vtkRelievoStage>> Added;
  std::set<std::string> Requested;
  vtkRelievoGpuTimer Timer;
  vtkRelievoFrameReport Report;
  vtkRelievoDelegate Picture;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the last frame

  // In the order in which the frame runs them.
  std::vector<vtkRelievoStage*> GetStages()
  {
    std::vector<vtkRelievoStage*> stages;
    stages.push_back(this->GBuffer);
    stages.push_back(this->Shadows);
    for (auto& stage : this->Added)
    {
      stages.push_back(stage);
    }
    stages.push_back(this->Display);
    return stages;
  }
};

//------------------------------------------------------------------------------
vtkRelievoPass::vtkRelievoPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoPass::~vtkRelievoPass()
{
  this->SetDisplayLayer(nullptr);
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Internal->Delegate != pass)
  {
    this->Internal->Delegate = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkRelievoPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

//------------------------------------------------------------------------------
vtkRelievoGBufferPass* vtkRelievoPass::GetGBuffer()
{
  return this->Internal->GBuffer;
}

//------------------------------------------------------------------------------
vtkRelievoShadowPass* vtkRelievoPass::GetShadowPass()
{
  return this->Internal->Shadows;
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetShadows(bool on)
{
  this->Internal->Shadows->SetVisible(on);
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::GetShadows()
{
  return this->Internal->Shadows->GetVisible();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::AddStage(vtkRelievoStage* stage)
{
  auto& added = this->Internal->Added;
  if (!stage || std::find(added.begin(), added.end(), stage) != added.end())
  {
    vtkErrorMacro(
      "AddStage was given " << (stage ? "a stage that is there already." : "no stage."));
    return;
  }
  added.push_back(stage);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::RemoveStage(vtkRelievoStage* stage)
{
  auto& added = this->Internal->Added;
  added.erase(std::remove(added.begin(), added.end(), stage), added.end());
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoPass::GetNumberOfStages()
{
  return static_cast<int>(this->Internal->GetStages().size());
}

//------------------------------------------------------------------------------
vtkRelievoStage* vtkRelievoPass::GetStage(int i)
{
  const auto stages = this->Internal->GetStages();
  return i >= 0 && i < static_cast<int>(stages.size()) ? stages[i] : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoPass::RequestLayer(const std::string& name)
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
void vtkRelievoPass::ReleaseLayer(const std::string& name)
{
  if (this->Internal->Requested.erase(name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPass::ReleaseLayers()
{
  this->Internal->Requested.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::IsLayerRequested(const std::string& name)
{
  return this->Internal->Requested.count(name) != 0;
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::ReadLayer(const std::string& name, vtkImageData* image)
{
  return this->ReadLayers({ name }, image);
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::ReadLayers(const std::vector<std::string>& names, vtkImageData* image)
{
  const std::string wrong = image
    ? this->Internal->GBuffer->ReadLayers(names, image)
    : "Reading layers needs an image to fill, and was given none; give it a vtkImageData.";
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
  }
  return wrong.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::Render(const vtkRenderState* s)
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
  this->NumberOfRenderedProps = 0;
  if (in.Window && in.Window != window)
  {
    // One pass in two windows: what a context holds is released in it, before the other is current.
    this->ReleaseStages(in.Window);
    in.Picture.ReleaseGraphicsResources(in.Window);
  }
  in.Window = window;
  window->MakeCurrent();

  in.Display->SetFrame(
    this->DisplayLayer ? this->DisplayLayer : "", this->DisplayRange, this->DisplayGrey);
  // A selection draws its own picture of ids, to its own rules.
  const bool selecting = renderer->GetSelector() != nullptr;
  std::vector<vtkRelievoStage*> needed;
  std::vector<std::string> layers(in.Requested.begin(), in.Requested.end());
  std::vector<vtkRelievoStage*> stages = in.GetStages();
  std::string reason;
  // What a stage reads is made before it: the G-buffer asks last what it is asked for.
  for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage)
  {
    if (*stage == in.GBuffer.GetPointer())
    {
      std::sort(layers.begin(), layers.end());
      layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
      in.GBuffer->SetLayers(
        layers, std::vector<std::string>(in.Requested.begin(), in.Requested.end()));
    }
    if (*stage == in.Shadows.GetPointer())
    {
      in.Shadows->SetLayersAsked(std::any_of(layers.begin(), layers.end(),
        [](const std::string& layer) { return vtkRelievoGBufferLayout::GetLight(layer) >= 0; }));
    }
    const bool runs = !selecting && (*stage)->GetEnabled() && (*stage)->IsNeeded(s, reason);
    if (runs)
    {
      needed.insert(needed.begin(), *stage);
      const std::vector<std::string> more = (*stage)->GetNeededLayers();
      layers.insert(layers.end(), more.begin(), more.end());
    }
    else if (!selecting)
    {
      (*stage)->ReleaseGraphicsResources(window);
    }
  }

  in.Timer.BeginFrame(window);
  in.Timer.Begin("frame");
  auto each = [&](void (vtkRelievoStage::*step)(vtkRelievoPass*, const vtkRenderState*)) {
    for (vtkRelievoStage* stage : needed)
    {
      in.Timer.Begin(stage->GetStageName());
      (stage->*step)(this, s);
      in.Timer.End(stage->GetStageName());
    }
  };
  each(&vtkRelievoStage::RenderBefore);
  if (!this->LayersOnly || selecting)
  {
    this->RenderDelegate(s, needed);
  }
  else
  {
    // The delegate would have done it: VTK's shaders are built for the lights that it counts.
    renderer->UpdateLights();
  }
  each(&vtkRelievoStage::RenderAfter);
  in.Timer.End("frame");
  in.Timer.EndFrame();
  if (!selecting)
  {
    this->Report(s, needed);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPass::RenderDelegate(
  const vtkRenderState* s, const std::vector<vtkRelievoStage*>& needed)
{
  Internals& in = *this->Internal;
  std::function<void()> begin;
  std::function<void()> end;
  if (!needed.empty())
  {
    begin = [&]() {
      for (vtkRelievoStage* stage : needed)
      {
        in.Timer.Begin(stage->GetStageName());
        stage->BeginOpaque(this, s);
      }
    };
    end = [&]() {
      for (vtkRelievoStage* stage : needed)
      {
        stage->EndOpaque(this, s);
        in.Timer.End(stage->GetStageName());
      }
    };
  }
  in.Timer.Begin("delegate");
  this->NumberOfRenderedProps += in.Picture.Render(in.Delegate, s, begin, end);
  in.Timer.End("delegate");
}

//------------------------------------------------------------------------------
void vtkRelievoPass::Report(const vtkRenderState* s, const std::vector<vtkRelievoStage*>& needed)
{
  Internals& in = *this->Internal;
  in.Report.Lines.clear();
  vtkRelievoFrameReport::Line delegate;
  delegate.Name = "delegate";
  delegate.Ran = !this->LayersOnly;
  delegate.Reason = this->LayersOnly ? "only the layers are asked for"
    : in.Delegate ? std::string("draws the picture: ") + in.Delegate->GetClassName()
                  : "draws the picture: the renderer's own steps";
  in.Report.Lines.push_back(delegate);
  for (vtkRelievoStage* stage : in.GetStages())
  {
    vtkRelievoFrameReport::Line line;
    line.Name = stage->GetStageName();
    line.Ran = std::find(needed.begin(), needed.end(), stage) != needed.end();
    line.Reason = "switched off (EnabledOff)";
    if (stage->GetEnabled())
    {
      stage->IsNeeded(s, line.Reason); // again: how a stage ran is known only now
    }
    line.Bytes = stage->GetBytesHeld();
    line.DrawCalls = line.Ran ? stage->GetDrawCalls() : 0;
    in.Report.Lines.push_back(line);
  }
  in.Report.PrimitiveIds = in.GBuffer->GetPrimitiveIds();
  s->GetRenderer()->GetTiledSize(&in.Report.Size[0], &in.Report.Size[1]);
}

//------------------------------------------------------------------------------
std::string vtkRelievoPass::GetFrameReport()
{
  return this->Internal->Report.GetJSON(this->Internal->Timer);
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoPass::GetBytesHeld()
{
  vtkIdType bytes = 0;
  for (vtkRelievoStage* stage : this->Internal->GetStages())
  {
    bytes += stage->GetBytesHeld();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoPass::ReleaseStages(vtkWindow* window)
{
  for (vtkRelievoStage* stage : this->Internal->GetStages())
  {
    stage->ReleaseGraphicsResources(window);
  }
  this->Internal->Timer.Release();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ReleaseStages(window);
  this->Internal->Picture.ReleaseGraphicsResources(window);
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: "
     << (this->Internal->Delegate ? this->Internal->Delegate->GetClassName()
                                  : "(renderer's own steps)")
     << "\n";
  os << indent << "Requested layers:";
  for (const std::string& name : this->Internal->Requested)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "DisplayLayer: " << (this->DisplayLayer ? this->DisplayLayer : "(none)") << "\n";
  os << indent << "DisplayRange: " << this->DisplayRange[0] << " " << this->DisplayRange[1] << "\n";
  os << indent << "DisplayGrey: " << this->DisplayGrey << "\n";
  os << indent << "LayersOnly: " << this->LayersOnly << "\n";
}
