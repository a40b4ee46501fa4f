// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoCapture.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoLayerMerge.h"
#include "vtkPVRelievoView.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkPointData.h"
#include "vtkProcessModule.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoLayersStage.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeCollection.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPVRelievoCapture);

namespace
{
constexpr int MoveTag = 46121;

// The window's picture, a layer that the frame does not have.
const std::string& Picture()
{
  return vtkRelievoLayerCatalogue::GetPicture().Name;
}
using vtkPVRelievoLayerMerge::ProcessLayer;

// Reads the available layers: with several processes, each lacks arrays of surfaces drawn by
// others. Returns the error of the first missing one.
std::string ReadSome(
  vtkRelievoPass* frame, const std::vector<std::string>& names, vtkImageData* image)
{
  std::string first;
  auto next = names.begin();
  while (next != names.end())
  {
    const std::vector<std::string> rest(next, names.end());
    const std::string error = frame->TryReadLayers(rest, image);
    if (error.empty())
    {
      break;
    }
    first = first.empty() ? error : first;
    next = std::find_if(next, names.end(),
      [&](const std::string& name) { return !image->GetPointData()->HasArray(name.c_str()); });
    next += next != names.end() ? 1 : 0;
  }
  return first;
}
}

namespace
{
// Whether the layer is the nearer of surface and volume.
bool IsOfSolidVolumes(const std::string& name, vtkPVRelievoView* view, vtkRenderer* renderer)
{
  vtkRelievoStage* volumes = view ? view->GetFrame()->GetStage("volumes") : nullptr;
  return volumes && volumes->GetParameter("solid") == "on" &&
    (name == "depth" || name == "range" || name == "position") &&
    renderer->GetVolumes()->GetNumberOfItems() > 0;
}
}

class vtkPVRelievoCapture::Internals
{
public:
  vtkWeakPointer<vtkPVView> View;
  std::vector<std::string> Layers;
  vtkWeakPointer<vtkPVRelievoView> Started; // the view that makes the layers at present
  std::vector<std::string> Requested;       // from that view
  bool Failed = false;                      // whether the last Read() failed
  vtkNew<vtkImageData> Image;

  bool IsAsked(const std::string& name) const
  {
    return std::find(this->Layers.begin(), this->Layers.end(), name) != this->Layers.end();
  }
};

//------------------------------------------------------------------------------
vtkPVRelievoCapture::vtkPVRelievoCapture()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkPVRelievoCapture::~vtkPVRelievoCapture()
{
  this->Stop();
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::SetView(vtkPVView* view)
{
  if (this->Internal->View != view)
  {
    this->Stop();
    this->Internal->View = view;
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::AddLayer(const char* name)
{
  if (name && *name && !this->Internal->IsAsked(name))
  {
    this->Internal->Layers.emplace_back(name);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::RemoveAllLayers()
{
  this->Internal->Layers.clear();
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::Start()
{
  Internals& in = *this->Internal;
  this->Stop();
  in.Started = vtkPVRelievoView::Find(in.View);
  if (!in.Started)
  {
    return;
  }
  in.Requested = in.Layers;
  in.Requested.erase(
    std::remove(in.Requested.begin(), in.Requested.end(), Picture()), in.Requested.end());
  // Merging several parts needs the depth; a single process does not pay for an unrequested layer.
  const bool parts = vtkProcessModule::GetProcessType() != vtkProcessModule::PROCESS_CLIENT &&
    vtkProcessModule::GetProcessModule()->GetNumberOfLocalPartitions() > 1;
  if (parts && !in.Requested.empty() && !in.IsAsked("depth"))
  {
    in.Requested.emplace_back("depth");
  }
  vtkRenderWindow* window = vtkPVRenderView::SafeDownCast(in.View)->GetRenderWindow();
  if (window && !window->GetNeverRendered())
  {
    // A server without geometry takes no part in the picture: its old layers are invalid.
    window->MakeCurrent();
    in.Started->GetFrame()->GetLayersStage()->ReleaseGraphicsResources(window);
  }
  for (const std::string& name : in.Requested)
  {
    in.Started->RequestLayer(name);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::Stop()
{
  Internals& in = *this->Internal;
  for (const std::string& name : in.Requested)
  {
    if (in.Started)
    {
      in.Started->ReleaseLayer(name);
    }
  }
  in.Requested.clear();
  in.Started = nullptr;
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::Read(bool together, bool quiet)
{
  Internals& in = *this->Internal;
  in.Image->Initialize();
  in.Failed = false;
  vtkPVRelievoView* view = in.Started;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int process = controller ? controller->GetLocalProcessId() : 0;
  const int processes = together && controller ? controller->GetNumberOfProcesses() : 1;
  if (!together && process != 0)
  {
    return; // the root drew everything
  }
  std::vector<std::string> names = in.Requested;
  std::string error;
  if (!view)
  {
    error = "Relievo does not work in this view. Take a render view made after the plugin was "
            "loaded.";
  }
  else if (!names.empty() && !view->IsInPlace())
  {
    error = "The view was not drawn with Relievo: it is hidden, or another feature draws it (ray "
            "tracing, for example). Show the view or switch that off, and grab again.";
  }
  else if (!names.empty() && view->GetFrame()->GetLayersStage()->GetHoldsLayers())
  {
    error = ReadSome(view->GetFrame(), names, in.Image);
  }
  else if (!names.empty() && processes == 1)
  {
    error = "The view was not drawn. Show it, and grab again.";
  }

  if (processes > 1 && !names.empty())
  {
    if (in.IsAsked("cell") && !in.IsAsked(ProcessLayer))
    {
      vtkPVRelievoLayerMerge::AddProcess(process, in.Image);
      names.emplace_back(ProcessLayer);
    }
    const std::string parted = vtkPVRelievoLayerMerge::Merge(controller, names, in.Image);
    error = parted.empty() ? error : "The processes' layers do not fit together: " + parted + ".";
    if (process != 0)
    {
      return;
    }
  }
  vtkRenderer* renderer = view ? vtkPVRenderView::SafeDownCast(in.View)->GetRenderer() : nullptr;
  if (processes > 1 && view && view->IsInPlace())
  {
    int size[2];
    renderer->GetTiledSize(&size[0], &size[1]);
    vtkPVRelievoLayerMerge::FillBackground(names, size, in.Image);
  }
  for (const std::string& name : names)
  {
    const bool apart = processes > 1 &&
      ((name.compare(0, 6, "volume") == 0 &&
         vtkRelievoLayerCatalogue::Find(name).Kind != vtkRelievoLayer::ARRAY) ||
        IsOfSolidVolumes(name, view, renderer));
    if (apart)
    {
      error = "'" + name + "' is known only for a whole volume, of which each of the " +
        std::to_string(processes) +
        " processes draws a part. Run ParaView with one process, or leave out the layers of "
        "volumes, and switch Volumes Are Solid off.";
    }
    if (apart || !in.Image->GetPointData()->HasArray(name.c_str()))
    {
      // A layer missing on another process is no error.
      error = error.empty() ? "Nothing that is drawn has the array '" + name + "'." : error;
      in.Image->Initialize();
      in.Failed = true;
      if (!quiet)
      {
        vtkErrorMacro("No layers. " << error);
      }
      return;
    }
  }
  if (!names.empty())
  {
    vtkRelievoLayerSource::AddCamera(renderer, in.Image, view->GetFrame());
  }
  this->Arrange();
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::ReadColor()
{
  Internals& in = *this->Internal;
  auto* view = vtkPVRenderView::SafeDownCast(in.View);
  if (!view || in.Failed || !in.IsAsked(Picture()) ||
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkRenderer* renderer = view->GetRenderer();
  const vtkIdType points = in.Image->GetNumberOfPoints();
  int size[2];
  renderer->GetTiledSize(&size[0], &size[1]);
  if (points > 0 && points != static_cast<vtkIdType>(size[0]) * size[1])
  {
    vtkErrorMacro("No layer '" << Picture() << "': the window has " << size[0] << " x " << size[1]
                               << " pixels, the layers " << points << "; grab again.");
    in.Image->Initialize();
    return;
  }
  vtkRelievoLayerSource::AddColor(renderer, in.Image);
  if (!view->GetUseDistributedRenderingForRender())
  {
    vtkRelievoLayerSource::AmendAlpha(renderer, in.Image);
  }
  if (points == 0)
  {
    vtkPVRelievoView* settings = vtkPVRelievoView::Find(in.View);
    vtkRelievoLayerSource::AddCamera(renderer, in.Image, settings ? settings->GetFrame() : nullptr);
  }
  this->Arrange();
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::MoveToServer()
{
  this->Move(true);
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::MoveToClient()
{
  this->Move(false);
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::Move(bool toServer)
{
  Internals& in = *this->Internal;
  auto* session =
    vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession());
  if (!session)
  {
    return;
  }
  // The other side: the server for the client, the client for the servers' root, none for others.
  vtkMultiProcessController* server = session->GetController(vtkPVSession::DATA_SERVER_ROOT);
  vtkMultiProcessController* client = session->GetController(vtkPVSession::CLIENT);
  vtkMultiProcessController* peer = server ? server : client;
  if (!peer)
  {
    return;
  }
  const bool gives = (server != nullptr) == toServer;
  if (gives)
  {
    peer->Send(in.Image, 1, MoveTag);
    in.Image->Initialize();
    return;
  }
  auto received = vtk::TakeSmartPointer(peer->ReceiveDataObject(1, MoveTag));
  auto* image = vtkImageData::SafeDownCast(received);
  if (in.Failed || !image || image->GetNumberOfPoints() == 0)
  {
    in.Image->Initialize(); // an incomplete set counts as none
    return;
  }
  if (in.Image->GetNumberOfPoints() == 0)
  {
    in.Image->ShallowCopy(image);
  }
  else if (image->GetNumberOfPoints() == in.Image->GetNumberOfPoints())
  {
    for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
    {
      in.Image->GetPointData()->AddArray(image->GetPointData()->GetArray(i));
    }
  }
  else
  {
    vtkErrorMacro("The picture has " << image->GetNumberOfPoints() << " pixels here, "
                                     << in.Image->GetNumberOfPoints()
                                     << " on the other side; grab again.");
    in.Image->Initialize();
  }
  this->Arrange();
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::Arrange()
{
  // The requested arrays in their order, without others.
  Internals& in = *this->Internal;
  vtkPointData* layers = in.Image->GetPointData();
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  for (const std::string& name : in.Layers)
  {
    arrays.emplace_back(layers->GetArray(name.c_str()));
  }
  arrays.emplace_back(layers->GetArray(ProcessLayer));
  layers->Initialize();
  for (vtkDataArray* array : arrays)
  {
    if (array)
    {
      layers->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkPVRelievoCapture::GetImage()
{
  return this->Internal->Image;
}

//------------------------------------------------------------------------------
void vtkPVRelievoCapture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->Internal->View.GetPointer() << "\n";
  os << indent << "Layers:";
  for (const std::string& name : this->Internal->Layers)
  {
    os << " " << name;
  }
  os << "\n" << indent << "Image:\n";
  this->Internal->Image->PrintSelf(os, indent.GetNextIndent());
}
