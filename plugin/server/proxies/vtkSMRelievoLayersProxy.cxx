// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoLayersProxy.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkRenderWindow.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMRelievoCaptureProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <cstring>

vtkStandardNewMacro(vtkSMRelievoLayersProxy);

//------------------------------------------------------------------------------
vtkSMRelievoLayersProxy::vtkSMRelievoLayersProxy()
{
  this->AddObserver(vtkCommand::UpdatePropertyEvent, this, &vtkSMRelievoLayersProxy::OnPushed);
}

//------------------------------------------------------------------------------
vtkSMRelievoLayersProxy::~vtkSMRelievoLayersProxy()
{
  this->Watch(nullptr);
  if (this->ManagerTag && this->GetSessionProxyManager())
  {
    this->GetSessionProxyManager()->RemoveObserver(this->ManagerTag);
  }
}

//------------------------------------------------------------------------------
vtkSMViewProxy* vtkSMRelievoLayersProxy::GetView()
{
  return vtkSMRenderViewProxy::SafeDownCast(vtkSMPropertyHelper(this, "View").GetAsProxy());
}

//------------------------------------------------------------------------------
vtkSMRelievoCaptureProxy* vtkSMRelievoLayersProxy::GetCapture()
{
  return vtkSMRelievoCaptureProxy::SafeDownCast(this->GetSubProxy("Capture"));
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::Connect()
{
  if (this->Connected || !this->ObjectsCreated || this->Location == 0)
  {
    return;
  }
  this->Connected = true;
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetCapture"
         << VTKOBJECT(this->GetCapture()) << vtkClientServerStream::End;
  this->ExecuteStream(stream);
  this->ManagerTag = this->GetSessionProxyManager()->AddObserver(
    vtkCommand::UnRegisterEvent, this, &vtkSMRelievoLayersProxy::OnUnregistered);
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::Watch(vtkSMViewProxy* view)
{
  if (this->Watched == view)
  {
    return;
  }
  if (this->Watched)
  {
    this->Watched->RemoveObserver(this->StartTag);
    this->Watched->RemoveObserver(this->EndTag);
  }
  this->Watched = view;
  this->Early = view && view->GetRenderWindow() && view->GetRenderWindow()->GetNeverRendered();
  if (view)
  {
    this->StartTag =
      view->AddObserver(vtkCommand::StartEvent, this, &vtkSMRelievoLayersProxy::OnViewStarts);
    this->EndTag =
      view->AddObserver(vtkCommand::EndEvent, this, &vtkSMRelievoLayersProxy::OnViewEnds);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::UpdateVTKObjects()
{
  this->Pushing = true;
  this->Superclass::UpdateVTKObjects();
  this->Pushing = false;
  this->Connect();
  if (!this->Connected)
  {
    return;
  }
  vtkSMViewProxy* view = this->GetView();
  this->Watch(view);
  if (this->Wanted && view && !this->GetSessionProxyManager()->GetInLoadXMLState())
  {
    // A scene that was never drawn may still be incomplete: missing layers are no error yet, and
    // its first picture is grabbed again.
    this->Grab(this->Early);
    this->Wanted = this->Early;
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::UpdatePipeline()
{
  if (this->Wanted)
  {
    this->Grab(false);
  }
  this->Superclass::UpdatePipeline();
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::UpdatePipeline(double time)
{
  if (this->Wanted)
  {
    this->Grab(false);
  }
  this->Superclass::UpdatePipeline(time);
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::PostUpdateData(bool usingCache)
{
  if (!usingCache)
  {
    this->InvalidateDataInformation();
  }
  this->PostUpdateDataSelfOnly(usingCache);
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::MarkDirtyFromProducer(vtkSMProxy*, vtkSMProxy*, vtkSMProperty*)
{
  // Its only producer is the view.
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::Grab(bool quiet)
{
  if (this->Grabbing || this->Started)
  {
    return;
  }
  vtkSMViewProxy* view = this->GetView();
  const std::vector<std::string> layers =
    vtkSMRelievoCaptureProxy::GetSelected(this->GetProperty("Layers"));
  if (!view || layers.empty())
  {
    this->Wanted = false;
    vtkErrorMacro("No layers: " << (view ? "none is chosen; choose some in Layers"
                                         : "View is no render view; set it to one")
                                << ".");
    return;
  }
  this->Grabbing = true;
  this->Wanted = false;
  if (this->GetCapture()->Capture(view, layers, vtkSMRelievoCaptureProxy::TO_SERVER, quiet))
  {
    this->Publish();
  }
  this->Grabbing = false;
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::Publish()
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "Modified"
         << vtkClientServerStream::End;
  this->ExecuteStream(stream);
  this->MarkModified(this);
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::OnPushed(vtkObject*, unsigned long, void* name)
{
  const char* property = static_cast<const char*>(name);
  if (!property || this->Location == 0)
  {
    return;
  }
  const bool again = std::strcmp(property, "GrabAgain") == 0;
  if (again || std::strcmp(property, "View") == 0 || std::strcmp(property, "Layers") == 0)
  {
    this->Wanted = true;
  }
  if (again && !this->Pushing)
  {
    this->Connect();
    this->Watch(this->GetView());
    this->Grab(false);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::OnViewStarts(vtkObject*, unsigned long, void* interactive)
{
  const bool due = this->Wanted || vtkSMPropertyHelper(this, "FollowView").GetAsInt() != 0;
  const std::vector<std::string> layers =
    vtkSMRelievoCaptureProxy::GetSelected(this->GetProperty("Layers"));
  if (!due || this->Grabbing || this->Started || *static_cast<int*>(interactive) != 0 ||
    layers.empty() || !this->Connected || !this->Watched)
  {
    return;
  }
  vtkRenderWindow* window = this->Watched->GetRenderWindow();
  const int* tiles = window ? window->GetTileScale() : nullptr;
  if (tiles && (tiles[0] > 1 || tiles[1] > 1))
  {
    return; // a tile of a picture larger than the screen
  }
  this->Started = true;
  this->GetCapture()->Start(this->Watched, layers);
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::OnViewEnds()
{
  this->Early = this->Early && this->Grabbing;
  if (this->Started)
  {
    this->Wanted = false;
    this->GetCapture()->Finish(vtkSMRelievoCaptureProxy::TO_SERVER, false);
    this->Started = false;
    this->Publish();
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::OnUnregistered(vtkObject*, unsigned long, void* what)
{
  auto* info = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(what);
  if (info && this->Watched && info->Proxy == this->Watched && info->GroupName &&
    std::strcmp(info->GroupName, "views") == 0)
  {
    // The layers must not keep a closed view alive.
    this->Watch(nullptr);
    vtkSMPropertyHelper(this, "View").RemoveAllValues();
    this->UpdateVTKObjects();
    this->Wanted = false;
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoLayersProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wanted: " << this->Wanted << "\n";
  os << indent << "Early: " << this->Early << "\n";
  os << indent << "Watched: " << this->Watched.GetPointer() << "\n";
}
