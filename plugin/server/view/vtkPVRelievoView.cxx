// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoView.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVDefaultPass.h"
#include "vtkPVRelievoAccess.h"
#include "vtkPVRelievoClamped.h"
#include "vtkPVRelievoEnvironment.h"
#include "vtkPVRelievoLegend.h"
#include "vtkPVRelievoPoints.h"
#include "vtkPVRelievoSelection.h"
#include "vtkPVRelievoSun.h"
#include "vtkPVView.h"
#include "vtkPropCollection.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayersStage.h"
#include "vtkRelievoMarkersStage.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSynchronizedRenderers.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPVRelievoView);

namespace
{
std::vector<vtkPVRelievoView*>& GetAllViews()
{
  // Never destroyed: ParaView may delete its proxies' objects after this library's statics.
  static auto* all = new std::vector<vtkPVRelievoView*>;
  return *all;
}

vtkRelievoDisplayStage* GetDisplay(vtkPVRelievoView* view)
{
  return vtkRelievoDisplayStage::SafeDownCast(view->GetFrame()->GetStage("display"));
}

// While cells are being selected, VTK's state stores the bound buffers (SaveGLState), and restores
// them whenever a state is popped, even after their deletion.
void ForgetBuffers(vtkRenderWindow* window)
{
  if (auto* opened = vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    opened->GetState()->Reset();
  }
}

// Sets a parameter by `set`, which returns an error or "".
template <typename Set>
void SetParameter(vtkPVRelievoView* view, const std::string& word, Set set)
{
  const std::size_t colon = word.find(':');
  vtkRelievoStage* stage = view->GetFrame()->GetStage(word.substr(0, colon));
  const vtkRelievoParameter* parameter = stage && colon != std::string::npos
    ? stage->GetDescription().Find(word.substr(colon + 1))
    : nullptr;
  const std::string error = parameter ? set(*parameter) : "there is no such parameter here";
  if (!error.empty() && vtkPVRelievoReports())
  {
    vtkWarningWithObjectMacro(view, << word << ": " << error << ".");
  }
}
}

class vtkPVRelievoView::Internals
{
public:
  vtkWeakPointer<vtkPVRenderView> View;
  vtkNew<vtkRelievoPass> Frame;
  vtkNew<vtkPVDefaultPass> Delegate;
  vtkPVRelievoSun Sun;
  vtkPVRelievoEnvironment Environment;
  vtkPVRelievoSelection Selection;
  vtkPVRelievoLegend Legend;
  unsigned long EarlyTag = 0;
  unsigned long StartTag = 0;
  unsigned long EndTag = 0;
  unsigned long AnnotatedTag = 0;
  std::map<std::string, int> Asked; // layers, with the number of their users
  std::string Report;
  std::string ShadowLayers;
};

//------------------------------------------------------------------------------
vtkPVRelievoView::vtkPVRelievoView()
  : Internal(new Internals)
{
  this->Internal->Frame->SetDelegatePass(this->Internal->Delegate);
  this->Internal->Frame->DelegateDrawsOwnStepsOn();
  // The actor of ParaView's surfaces; its subclass adds only a coarse mapper for interaction.
  vtkRelievoShadowStage::AddPlainActorClass("vtkPVLODActor");
  this->Internal->Environment.Environment->GammaCorrectOn();
  this->Internal->Environment.Environment->SetUpAxis(2);
  GetAllViews().push_back(this);
}

//------------------------------------------------------------------------------
vtkPVRelievoView::~vtkPVRelievoView()
{
  GetAllViews().erase(
    std::remove(GetAllViews().begin(), GetAllViews().end(), this), GetAllViews().end());
  if (this->Internal->View)
  {
    vtkRenderer* renderer = this->Internal->View->GetRenderer();
    renderer->RemoveObserver(this->Internal->EarlyTag);
    renderer->RemoveObserver(this->Internal->StartTag);
    renderer->RemoveObserver(this->Internal->EndTag);
    this->Internal->View->GetNonCompositedRenderer()->RemoveObserver(this->Internal->AnnotatedTag);
    this->Internal->Legend.Leave(this->Internal->View);
    this->Internal->Environment.Leave(this->Internal->View);
    this->Internal->Sun.On = false;
    this->Internal->Sun.Place(renderer, vtkPVRelievoAccess::View::Kit(this->Internal->View));
    auto* passes = vtkPVRelievoAccess::View::Passes(this->Internal->View);
    if (passes->GetRenderPass() == this->Internal->Frame)
    {
      passes->SetRenderPass(nullptr);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetView(vtkPVView* view)
{
  Internals& in = *this->Internal;
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView || in.View)
  {
    vtkErrorMacro("SetView was given " << (renderView ? "a second view" : "no render view")
                                       << "; give it one vtkPVRenderView, once.");
    return;
  }
  in.View = renderView;
  vtkLightKit* kit = vtkPVRelievoAccess::View::Kit(renderView);
  vtkRelievoShadowStage* shadows = in.Frame->GetShadowStage();
  shadows->SetLightName(in.Sun.Light, "sun");
  for (vtkLight* fill : in.Sun.Fills)
  {
    shadows->SetLightName(fill, "sun's fill");
    shadows->SetLightCasts(fill, false);
  }
  shadows->SetLightName(vtkPVRelievoAccess::LightKit::Key(kit), "key light");
  for (const auto& other : vtkPVRelievoAccess::LightKit::Others(kit))
  {
    shadows->SetLightName(other.first, other.second);
  }
  vtkRenderer* renderer = renderView->GetRenderer();
  in.EarlyTag =
    renderer->AddObserver(vtkCommand::StartEvent, this, &vtkPVRelievoView::KeepLayersSharp, 10.0F);
  // After the observers that bring the client's camera to this process.
  in.StartTag =
    renderer->AddObserver(vtkCommand::StartEvent, this, &vtkPVRelievoView::Prepare, -10.0F);
  // Before those that send it away.
  in.EndTag = renderer->AddObserver(vtkCommand::EndEvent, this, &vtkPVRelievoView::Finish, 10.0F);
  // Drawn after the renderer.
  in.AnnotatedTag = renderView->GetNonCompositedRenderer()->AddObserver(
    vtkCommand::EndEvent, this, &vtkPVRelievoView::EndAnnotations);
}

//------------------------------------------------------------------------------
vtkPVRelievoView* vtkPVRelievoView::Find(vtkPVView* view)
{
  for (vtkPVRelievoView* each : GetAllViews())
  {
    if (view && each->Internal->View == view)
    {
      return each;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::IsAnythingOn()
{
  return this->Internal->Frame->GetDisplayLayer() || !this->Internal->Asked.empty() ||
    this->IsAnyStageOn() || this->Internal->Selection.On ||
    vtkPVRelievoPoints::IsAny(this->Internal->View);
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::IsInPlace()
{
  return this->Internal->View &&
    vtkPVRelievoAccess::View::Passes(this->Internal->View)->GetRenderPass() ==
    this->Internal->Frame;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::RequestLayer(const std::string& name)
{
  ++this->Internal->Asked[name];
  this->Internal->Frame->RequestLayer(name);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::ReleaseLayer(const std::string& name)
{
  Internals& in = *this->Internal;
  const auto found = in.Asked.find(name);
  if (found == in.Asked.end() || --found->second > 0)
  {
    return;
  }
  in.Asked.erase(found);
  in.Frame->ReleaseLayer(name);
  vtkRenderWindow* window = in.View ? in.View->GetRenderWindow() : nullptr;
  if (in.Asked.empty() && !in.Frame->GetDisplayLayer() && window && !window->GetNeverRendered())
  {
    window->MakeCurrent();
    in.Frame->GetLayersStage()->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::Prepare()
{
  Internals& in = *this->Internal;
  in.Sun.Place(in.View->GetRenderer(), vtkPVRelievoAccess::View::Kit(in.View));
  this->PlacePass();
  if (this->IsAnythingOn())
  {
    ForgetBuffers(this->Internal->View->GetRenderWindow());
    this->ChooseCasters();
    this->ChooseProcesses();
    ++this->NumberOfFrames;
    in.Frame->SetWaitForSamples(vtkPVRelievoAccess::View::IsSaving(in.View));
  }
  this->Internal->Environment.Prepare(this, this->Internal->View);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::Finish()
{
  Internals& in = *this->Internal;
  in.Environment.Finish(in.View);
  in.Legend.Place(in.View, GetDisplay(this),
    this->IsInPlace() && !vtkPVRelievoAccess::View::IsDrawnElsewhere(in.View));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::EndAnnotations()
{
  this->Internal->Legend.ShowOthers();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::KeepLayersSharp()
{
  Internals& in = *this->Internal;
  if (in.Frame->GetDisplayLayer())
  {
    // A layer's pixels are values, which must not be antialiased: several processes would do so
    // after compositing. The view re-enables it before its next picture.
    in.View->GetRenderer()->SetUseFXAA(false);
    vtkPVRelievoAccess::View::Passes(in.View)->SetUseFXAA(false);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::PlacePass()
{
  Internals& in = *this->Internal;
  vtkPVSynchronizedRenderer* passes = vtkPVRelievoAccess::View::Passes(in.View);
  vtkRenderPass* current = passes->GetRenderPass();
  if (this->IsAnythingOn())
  {
    if (!current)
    {
      passes->SetRenderPass(in.Frame);
    }
  }
  else if (current == in.Frame)
  {
    in.Frame->ReleaseGraphicsResources(in.View->GetRenderWindow());
    passes->SetRenderPass(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::ChooseCasters()
{
  Internals& in = *this->Internal;
  vtkRelievoShadowStage* shadows = in.Frame->GetShadowStage();
  vtkLightKit* kit = vtkPVRelievoAccess::View::Kit(in.View);
  auto choose = [shadows](vtkLight* light, bool casts) {
    if (shadows->GetLightCasts(light) != casts)
    {
      shadows->SetLightCasts(light, casts);
    }
  };
  const bool all = this->LightKitCasts == KIT_CASTS_ALL;
  choose(vtkPVRelievoAccess::LightKit::Key(kit),
    all || this->LightKitCasts == KIT_CASTS_KEY_LIGHT ||
      (this->LightKitCasts == KIT_CASTS_WITHOUT_SUN && !in.Sun.On));
  choose(in.Sun.Light, !in.Sun.IsNight());
  for (const auto& other : vtkPVRelievoAccess::LightKit::Others(kit))
  {
    choose(other.first, all);
  }
  // ParaView's own props cannot be picked: outlines, selections, the centre's axes.
  vtkPropCollection* props = in.View->GetRenderer()->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    const int casts = prop->GetPickable() ? vtkRelievoShadowStage::CASTS_IF_OPAQUE
                                          : vtkRelievoShadowStage::CASTS_NEVER;
    if (shadows->GetPropCasts(prop) != casts)
    {
      shadows->SetPropCasts(prop, casts);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::ChooseProcesses()
{
  Internals& in = *this->Internal;
  vtkPVSynchronizedRenderer* passes = vtkPVRelievoAccess::View::Passes(in.View);
  vtkSynchronizedRenderers* ranks = passes->GetParallelSynchronizer();
  vtkMultiProcessController* controller = ranks ? ranks->GetParallelController() : nullptr;
  const bool together = controller && controller->GetNumberOfProcesses() > 1 &&
    passes->GetEnabled() && !passes->GetDataReplicatedOnAllProcesses() &&
    ranks->GetParallelRendering();
  if (together)
  {
    // A process without geometry in view would not be asked to draw, and the others would wait.
    passes->SetRenderEmptyImages(true);
  }
  in.Frame->SetController(together ? controller : nullptr);
  in.Frame->GetShadowStage()->SetController(together ? controller : nullptr);
  this->GivePoints(in.View, together ? controller : nullptr);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetLightName(vtkLight* light, const char* name)
{
  this->GetFrame()->GetShadowStage()->SetLightName(light, name ? name : "");
}

//------------------------------------------------------------------------------
const char* vtkPVRelievoView::GetShadowLayers()
{
  Internals& in = *this->Internal;
  in.ShadowLayers.clear();
  if (in.View)
  {
    // Uses the present settings' names, whatever the age of the last frame.
    in.Sun.Place(in.View->GetRenderer(), vtkPVRelievoAccess::View::Kit(in.View));
    this->ChooseCasters();
    for (const std::string& layer :
      in.Frame->GetShadowStage()->GetShadowLayers(in.View->GetRenderer()))
    {
      in.ShadowLayers += (in.ShadowLayers.empty() ? "" : ",") + layer;
    }
  }
  return in.ShadowLayers.c_str();
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::ReadShownLayer(const char* name, vtkImageData* image)
{
  image->Initialize();
  std::vector<std::string> names = { name };
  if (vtkRelievoLayerCatalogue::GetIsOfLight(name))
  {
    names.emplace_back("depth");             // distinguishes the background
    this->Internal->Frame->SetAmends(false); // of surfaces, which shadows fall on
  }
  // If a server draws, this process draws a frame too, without surfaces.
  const bool good = this->IsInPlace() &&
    !vtkPVRelievoAccess::View::IsDrawnElsewhere(this->Internal->View) &&
    this->Internal->Frame->GetLayersStage()->GetHoldsLayers() &&
    this->Internal->Frame->TryReadLayers(names, image).empty();
  this->Internal->Frame->SetAmends(true);
  if (!good)
  {
    image->Initialize();
  }
  return good;
}

//------------------------------------------------------------------------------
const char* vtkPVRelievoView::GetFrameReport()
{
  this->Internal->Report =
    this->NumberOfFrames && this->IsInPlace() ? this->Internal->Frame->GetFrameReport() : "";
  return this->Internal->Report.c_str();
}

//------------------------------------------------------------------------------
vtkRelievoPass* vtkPVRelievoView::GetFrame()
{
  return this->Internal->Frame;
}

//------------------------------------------------------------------------------
vtkPVRelievoSun& vtkPVRelievoView::GetSunlight()
{
  return this->Internal->Sun;
}

//------------------------------------------------------------------------------
vtkPVRelievoSelection& vtkPVRelievoView::GetSelection()
{
  return this->Internal->Selection;
}

//------------------------------------------------------------------------------
vtkPVRelievoEnvironment& vtkPVRelievoView::GetEnvironment()
{
  return this->Internal->Environment;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->Internal->View.GetPointer() << "\n";
  os << indent << "LightKitCasts: " << this->LightKitCasts << "\n";
  os << indent << "Sun: " << this->Internal->Sun.On << "\n";
  this->Internal->Sun.GetDescription().Print(os, indent.GetNextIndent());
  this->Internal->Sun.Position->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Skybox: " << this->Internal->Environment.Sky << "\n";
  os << indent << "MarkSelection: " << this->Internal->Selection.On << "\n";
  this->Internal->Selection.Look->PrintSelf(os, indent.GetNextIndent());
  os << indent << "NumberOfFrames: " << this->NumberOfFrames << "\n";
  os << indent << "Environment:\n";
  this->Internal->Environment.Environment->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Frame:\n";
  this->Internal->Frame->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadows(bool on)
{
  this->GetFrame()->SetShadows(on);
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::GetShadows()
{
  return this->GetFrame()->GetShadows();
}

//------------------------------------------------------------------------------
int vtkPVRelievoView::GetSamplesLeft()
{
  return this->IsInPlace() ? this->GetFrame()->GetSamplesLeft() : 0;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetLightKitCasts(int casts)
{
  const int least = KIT_CASTS_NOTHING;
  const int most = KIT_CASTS_ALL;
  this->LightKitCasts = vtkPVRelievoClamped(this, "LightKitCasts", casts, least, most);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSun(bool on)
{
  this->GetSunlight().On = on;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunValue(const char* parameter, double value)
{
  vtkPVRelievoSet(this, this->GetSunlight().GetDescription(), parameter, { value });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunValue(const char* parameter, double red, double green, double blue)
{
  vtkPVRelievoSet(this, this->GetSunlight().GetDescription(), parameter, { red, green, blue });
  this->Modified();
}

//------------------------------------------------------------------------------
double* vtkPVRelievoView::GetSunAngles()
{
  this->GetSunlight().GetAngles(this->SunAngles);
  return this->SunAngles;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironment(const char* file)
{
  this->GetEnvironment().SetFile(file);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironmentValue(const char* parameter, double value)
{
  vtkPVRelievoSet(this, this->GetEnvironment().Environment->GetDescription(), parameter, { value });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSkybox(bool on)
{
  this->GetEnvironment().Sky = on;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelection(bool on)
{
  this->GetSelection().On = on;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionValue(const char* parameter, double value)
{
  vtkPVRelievoSet(this, this->GetSelection().Look->GetDescription(), parameter, { value });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionValue(
  const char* parameter, double first, double second, double third)
{
  vtkPVRelievoSet(
    this, this->GetSelection().Look->GetDescription(), parameter, { first, second, third });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetDisplayLayer(const char* name)
{
  // The panel's word for the picture itself.
  const bool picture = !name || !*name || std::string(name) == "None";
  this->GetFrame()->SetDisplayLayer(picture ? nullptr : name);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetDisplayLegend(bool on)
{
  this->Internal->Legend.On = on;
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::IsAnyStageOn()
{
  vtkRelievoPass* frame = this->GetFrame();
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = frame->GetStage(i);
    // Stages that are on by default wait for data, or for the request of a layer.
    if (stage->GetEnabled() && !stage->GetDescription().OnByDefault)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageOn(const char* name, bool on)
{
  if (vtkRelievoStage* stage = this->GetFrame()->GetStage(name))
  {
    stage->SetEnabled(on);
  }
  else if (on && vtkPVRelievoReports()) // for a new view, stages that are off are reported too
  {
    vtkWarningMacro(<< name << ": there is no such stage here.");
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageValue(const char* parameter, double value)
{
  SetParameter(
    this, parameter, [value](const vtkRelievoParameter& found) { return found.Set({ value }); });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageValue(const char* parameter, double first, double second)
{
  SetParameter(this, parameter, [=](const vtkRelievoParameter& found) {
    return found.Set({ first, second });
  });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageValue(
  const char* parameter, double first, double second, double third)
{
  SetParameter(this, parameter, [first, second, third](const vtkRelievoParameter& found) {
    return found.Set({ first, second, third });
  });
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetStageText(const char* parameter, const char* text)
{
  const std::string words = text ? text : "";
  SetParameter(
    this, parameter, [&words](const vtkRelievoParameter& found) { return found.Parse(words); });
}

//------------------------------------------------------------------------------
// Passes representations' points, from all drawing processes, to their stages.
void vtkPVRelievoView::GivePoints(vtkPVView* view, vtkMultiProcessController* controller)
{
  vtkRelievoPass* frame = this->GetFrame();
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    if (auto* stage = vtkRelievoPointStage::SafeDownCast(frame->GetStage(i)))
    {
      std::vector<vtkRelievoPointValues*> selected;
      if (stage == frame->GetMarkersStage())
      {
        const std::vector<vtkRelievoMarkers*> marked = this->GetSelection().FindIn(view);
        selected.assign(marked.begin(), marked.end());
      }
      vtkPVRelievoPoints::Prepare(view, stage, selected, controller);
    }
  }
}
