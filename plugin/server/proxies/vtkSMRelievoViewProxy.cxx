// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoViewProxy.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoView.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRelievoAccess.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMStringVectorProperty.h"

#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkSMRelievoViewProxy);

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::UpdateVTKObjects()
{
  this->Superclass::UpdateVTKObjects();
  vtkSMProxy* view = this->GetParentProxy();
  if (!this->KnowsView && this->ObjectsCreated && view && view->GetObjectsCreated())
  {
    this->KnowsView = true;
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetView" << VTKOBJECT(view)
           << vtkClientServerStream::End;
    this->ExecuteStream(stream);
    view->AddObserver(vtkCommand::EndEvent, this, &vtkSMRelievoViewProxy::OfferLights);
  }
  if (this->KnowsView)
  {
    this->NameLights(view);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::NameLights(vtkSMProxy* view)
{
  vtkSMPropertyHelper lights(view, "AdditionalLights", /*quiet=*/true);
  std::map<vtkTypeUInt32, std::string> names;
  for (unsigned int i = 0; i < lights.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* light = lights.GetAsProxy(i);
    const char* name = light && light->GetObjectsCreated()
      ? this->GetSessionProxyManager()->GetProxyName("additional_lights", light)
      : nullptr;
    if (!name)
    {
      continue;
    }
    names[light->GetGlobalID()] = name;
    const auto told = this->LightNames.find(light->GetGlobalID());
    if (told == this->LightNames.end() || told->second != name)
    {
      vtkClientServerStream stream;
      stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetLightName"
             << VTKOBJECT(light) << name << vtkClientServerStream::End;
      this->ExecuteStream(stream, false, this->GetLocation() & light->GetLocation());
    }
  }
  this->LightNames = names;
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::OfferLights()
{
  auto* here = vtkPVRelievoView::SafeDownCast(this->GetClientSideObject());
  auto* offered = this->GetProperty("DisplayLayer")->FindDomain<vtkSMStringListDomain>();
  if (!here || !offered)
  {
    return;
  }
  std::vector<std::string> names;
  for (unsigned int i = 0; i < offered->GetNumberOfStrings(); ++i)
  {
    const std::string name = offered->GetString(i);
    if (!vtkRelievoLayerCatalogue::GetIsOfLight(name))
    {
      names.push_back(name);
    }
  }
  std::istringstream layers(here->GetShadowLayers());
  for (std::string layer; std::getline(layers, layer, ',');)
  {
    names.push_back(layer);
  }
  vtkSMRelievoAccess::StringListDomain::Set(offered, names); // has an effect only after changes
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::UpdatePropertyInformationInternal(vtkSMProperty* property)
{
  this->Superclass::UpdatePropertyInformationInternal(property);
  auto* report = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty("FrameReport"));
  vtkSMProxy* parent = this->GetParentProxy();
  auto* view = parent ? vtkPVRenderView::SafeDownCast(parent->GetClientSideObject()) : nullptr;
  vtkSMSession* session = this->GetSession();
  if ((property && property != report) || !report || !this->ObjectsCreated || !session || !view ||
    (session->GetProcessRoles() & vtkPVSession::RENDER_SERVER) != 0 ||
    !view->GetUseDistributedRenderingForRender())
  {
    return;
  }
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GetFrameReport"
         << vtkClientServerStream::End;
  this->ExecuteStream(stream, false, vtkPVSession::RENDER_SERVER_ROOT);
  const char* text = nullptr;
  if (this->GetLastResult(vtkPVSession::RENDER_SERVER_ROOT).GetArgument(0, 0, &text) && text)
  {
    report->SetElement(0, text);
  }
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "KnowsView: " << this->KnowsView << "\n";
}
