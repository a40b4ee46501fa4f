// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoCaptureProxy.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoCapture.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"
#include "vtkSMViewProxy.h"

#include <algorithm>

vtkStandardNewMacro(vtkSMRelievoCaptureProxy);

//------------------------------------------------------------------------------
vtkSMRelievoCaptureProxy::vtkSMRelievoCaptureProxy() = default;

//------------------------------------------------------------------------------
vtkSMRelievoCaptureProxy::~vtkSMRelievoCaptureProxy() = default;

//------------------------------------------------------------------------------
void vtkSMRelievoCaptureProxy::Call(const char* method, vtkTypeUInt32 where)
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << method
         << vtkClientServerStream::End;
  this->ExecuteStream(stream, false, where);
}

//------------------------------------------------------------------------------
bool vtkSMRelievoCaptureProxy::Capture(
  vtkSMViewProxy* view, const std::vector<std::string>& layers, int destination, bool quiet)
{
  this->Start(view, layers);
  this->Drawn = false;
  const unsigned long tag =
    view->AddObserver(vtkCommand::EndEvent, this, &vtkSMRelievoCaptureProxy::OnDrawn);
  view->StillRender();
  view->RemoveObserver(tag);
  if (this->Drawn)
  {
    this->Finish(destination, quiet);
    return true;
  }
  this->Call("Stop", this->GetLocation());
  this->View = nullptr;
  if (!quiet)
  {
    vtkErrorMacro("No layers: the view is hidden, and ParaView draws no hidden view; show it, and "
                  "grab again.");
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkSMRelievoCaptureProxy::OnDrawn()
{
  this->Drawn = true;
}

//------------------------------------------------------------------------------
void vtkSMRelievoCaptureProxy::Start(vtkSMViewProxy* view, const std::vector<std::string>& layers)
{
  this->CreateVTKObjects();
  this->View = view;
  this->Color = std::find(layers.begin(), layers.end(),
                  vtkRelievoLayerCatalogue::GetPicture().Name) != layers.end();
  this->Others = layers.size() > (this->Color ? 1U : 0U);
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetView" << VTKOBJECT(view)
         << vtkClientServerStream::End;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "RemoveAllLayers"
         << vtkClientServerStream::End;
  for (const std::string& layer : layers)
  {
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "AddLayer" << layer.c_str()
           << vtkClientServerStream::End;
  }
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "Start"
         << vtkClientServerStream::End;
  this->ExecuteStream(stream);
}

//------------------------------------------------------------------------------
void vtkSMRelievoCaptureProxy::Finish(int destination, bool quiet)
{
  auto* view =
    vtkPVRenderView::SafeDownCast(this->View ? this->View->GetClientSideObject() : nullptr);
  if (!view)
  {
    return;
  }
  // The image would have to go from render servers to data servers.
  vtkSMSession* session = this->GetSession();
  if (session->GetController(vtkPVSession::DATA_SERVER_ROOT) !=
    session->GetController(vtkPVSession::RENDER_SERVER_ROOT))
  {
    this->Call("Stop", this->GetLocation());
    this->View = nullptr;
    vtkErrorMacro("No layers of a data server with a render server of its own: connect to a "
                  "pvserver, which is both.");
    return;
  }
  // Messages of servers reach the client while progress is prepared.
  session->PrepareProgress();
  const bool together = view->GetUseDistributedRenderingForRender();
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "Read" << (together ? 1 : 0)
         << (quiet ? 1 : 0) << vtkClientServerStream::End;
  this->ExecuteStream(stream, false, together ? vtkPVSession::RENDER_SERVER : vtkPVSession::CLIENT);
  if (this->Color)
  {
    this->Call("ReadColor", vtkPVSession::CLIENT);
  }
  const vtkTypeUInt32 both = vtkPVSession::CLIENT | vtkPVSession::DATA_SERVER;
  if (destination == TO_SERVER && (!together || this->Color))
  {
    this->Call("MoveToServer", both);
  }
  else if (destination == TO_CLIENT && together && this->Others)
  {
    this->Call("MoveToClient", both);
  }
  this->Call("Stop", this->GetLocation());
  session->CleanupPendingProgress();
  this->View = nullptr;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkSMRelievoCaptureProxy::GetSelected(vtkSMProperty* property)
{
  vtkSMPropertyHelper values(property);
  std::vector<std::string> names;
  for (unsigned int i = 0; i + 1 < values.GetNumberOfElements(); i += 2)
  {
    if (std::string(values.GetAsString(i + 1)) != "0")
    {
      names.emplace_back(values.GetAsString(i));
    }
  }
  return names;
}

//------------------------------------------------------------------------------
vtkImageData* vtkSMRelievoCaptureProxy::GetImage()
{
  auto* capture = vtkPVRelievoCapture::SafeDownCast(this->GetClientSideObject());
  return capture ? capture->GetImage() : nullptr;
}

//------------------------------------------------------------------------------
void vtkSMRelievoCaptureProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View << "\n";
  os << indent << "Drawn: " << this->Drawn << "\n";
  os << indent << "Color: " << this->Color << "\n";
  os << indent << "Others: " << this->Others << "\n";
}
