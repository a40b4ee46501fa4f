// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoViews.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVPluginTracker.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSMMessage.h"
#include "vtkSMPluginManager.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyDefinitionManager.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMRelievoAccess.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSettings.h"
#include "vtkSMStateLocator.h"
#include "vtkSMUndoStackBuilder.h"
#include "vtkSessionIterator.h"
#include "vtkSmartPointer.h"
#if VTK_MODULE_ENABLE_VTK_PythonInterpreter
#include "vtkPythonInterpreter.h"
#endif

#include <cstring>
#include <vector>

vtkStandardNewMacro(vtkSMRelievoViews);

namespace
{
constexpr const char* SubProxyName = "Relievo";

vtkSmartPointer<vtkSMRelievoViews>& Instance()
{
  static vtkSmartPointer<vtkSMRelievoViews> instance;
  return instance;
}

// The part of a view's definition that makes Relievo's sub-proxy, or nullptr.
vtkPVXMLElement* FindSubProxyElement(vtkPVXMLElement* definition)
{
  for (unsigned int i = 0; definition && i < definition->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = definition->GetNestedElement(i);
    vtkPVXMLElement* proxy = std::strcmp(element->GetName(), "SubProxy") == 0
      ? element->FindNestedElementByName("Proxy")
      : nullptr;
    if (proxy && std::strcmp(proxy->GetAttributeOrEmpty("name"), SubProxyName) == 0)
    {
      return element;
    }
  }
  return nullptr;
}

// What the user saved as defaults of render views; ParaView gives it to new views only.
void TakeUserDefaults(vtkSMSessionProxyManager* manager, vtkSMProxy* view, vtkSMProxy* settings)
{
  auto fresh = vtk::TakeSmartPointer(manager->NewProxy(view->GetXMLGroup(), view->GetXMLName()));
  if (!fresh)
  {
    return;
  }
  fresh->SetSession(nullptr);
  fresh->SetLocation(0);
  fresh->SetPrototype(true);
  vtkSMSettings::GetInstance()->GetProxySettings(fresh);
  vtkSMProxy* from = vtkSMRelievoAccess::Proxy::Find(fresh, SubProxyName);
  auto property = vtk::TakeSmartPointer(settings->NewPropertyIterator());
  for (property->Begin(); from && !property->IsAtEnd(); property->Next())
  {
    if (!property->GetProperty()->GetInformationOnly())
    {
      property->GetProperty()->Copy(from->GetProperty(property->GetKey()));
    }
  }
}

// Undo makes a closed view anew from a state that names its sub-proxies.
void AddToState(vtkSMProxy* view, vtkSMProxy* settings)
{
  auto add = [settings](vtkSMMessage& state) {
    ProxyState_SubProxy* entry = state.AddExtension(ProxyState::subproxy);
    entry->set_name(SubProxyName);
    entry->set_global_id(settings->GetGlobalID());
  };
  add(*vtkSMRelievoAccess::Proxy::GetState(view));
  vtkSMMessage kept;
  vtkSMStateLocator* states = view->GetSession()->GetStateLocator();
  if (states && states->FindState(view->GetGlobalID(), &kept, false))
  {
    add(kept);
    states->RegisterState(&kept);
  }
}

// Prototypes that were made of old definitions.
void DropPrototypes(vtkSMSessionProxyManager* manager)
{
  std::vector<vtkSmartPointer<vtkSMProxy>> old;
  vtkNew<vtkSMProxyIterator> prototype;
  prototype->SetSessionProxyManager(manager);
  prototype->SetSkipPrototypes(false);
  for (prototype->Begin("views_prototypes"); !prototype->IsAtEnd(); prototype->Next())
  {
    old.emplace_back(prototype->GetProxy());
  }
  for (vtkSMProxy* each : old)
  {
    manager->UnRegisterProxy("views_prototypes", each->GetXMLName(), each);
  }
}

// paraview.servermanager keeps a class of each kind of view from its first use on.
void TellPython()
{
#if VTK_MODULE_ENABLE_VTK_PythonInterpreter
  if (!vtkPythonInterpreter::IsInitialized())
  {
    return;
  }
  vtkPythonInterpreter::RunSimpleString(R"(exec('''
import sys
sm = sys.modules.get("paraview.servermanager")
make = getattr(sm, "_createClassProperties", None)
if make and sm.ActiveConnection:
    manager = sm.ActiveConnection.Session.GetSessionProxyManager()
    for kind in vars(sm.ActiveConnection.ProxiesNS.rendering).values():
        if isinstance(kind, type) and issubclass(kind, sm.Proxy):
            proto = manager.GetPrototypeProxy("views", kind.__name__)
            for name, value in make(proto).items() if proto else ():
                if name.startswith("Relievo") and not hasattr(kind, name):
                    setattr(kind, name, value)
''', {}))");
#endif
}
}

//------------------------------------------------------------------------------
void vtkSMRelievoViews::Start()
{
  const auto type = vtkProcessModule::GetProcessType();
  if (Instance() ||
    (type != vtkProcessModule::PROCESS_CLIENT && type != vtkProcessModule::PROCESS_BATCH))
  {
    return;
  }
  Instance() = vtkSmartPointer<vtkSMRelievoViews>::New();
  // Loaded here: after those who read the plugin's XML. Loaded on a server: after its definitions
  // came. vtkSMProxyDefinitionManager's own event comes while it still answers with old ones.
  vtkPVPluginTracker::GetInstance()->AddObserver(
    vtkCommand::RegisterEvent, Instance().Get(), &vtkSMRelievoViews::OnChange, -100.0F);
  vtkSMProxyManager::GetProxyManager()->GetPluginManager()->AddObserver(
    vtkSMPluginManager::RemotePluginLoadedEvent, Instance().Get(), &vtkSMRelievoViews::OnChange);
}

//------------------------------------------------------------------------------
vtkSMRelievoViews* vtkSMRelievoViews::GetInstance()
{
  return Instance();
}

//------------------------------------------------------------------------------
void vtkSMRelievoViews::OnChange()
{
  if (!this->Upgrading)
  {
    this->Upgrading = true;
    this->Upgrade();
    this->Upgrading = false;
  }
}

//------------------------------------------------------------------------------
int vtkSMRelievoViews::Upgrade()
{
  std::vector<vtkSmartPointer<vtkSMProxy>> views;
  auto session = vtk::TakeSmartPointer(vtkProcessModule::GetProcessModule()->NewSessionIterator());
  for (session->InitTraversal(); !session->IsDoneWithTraversal(); session->GoToNextItem())
  {
    auto* current = vtkSMSession::SafeDownCast(session->GetCurrentSession());
    if (!current || !current->GetSessionProxyManager() || current->IsMultiClients())
    {
      continue; // in a shared session proxies must stay as the server sent them
    }
    DropPrototypes(current->GetSessionProxyManager());
    vtkNew<vtkSMProxyIterator> view;
    view->SetSessionProxyManager(current->GetSessionProxyManager());
    for (view->Begin("views"); !view->IsAtEnd(); view->Next())
    {
      views.emplace_back(view->GetProxy());
    }
  }

  // It is no step that a user would undo.
  vtkSMUndoStackBuilder* undo = vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder();
  const bool ignored = undo && undo->GetIgnoreAllChanges();
  if (undo)
  {
    undo->SetIgnoreAllChanges(true);
  }
  int count = 0;
  for (vtkSMProxy* view : views)
  {
    count += vtkSMRelievoViews::UpgradeView(view) ? 1 : 0;
  }
  if (undo)
  {
    undo->SetIgnoreAllChanges(ignored);
  }
  TellPython();
  if (count)
  {
    this->InvokeEvent(vtkCommand::UpdateEvent);
  }
  return count;
}

//------------------------------------------------------------------------------
bool vtkSMRelievoViews::UpgradeView(vtkSMProxy* view)
{
  if (!view || !view->GetObjectsCreated() || vtkSMRelievoViews::GetSettings(view))
  {
    return false;
  }
  vtkSMSessionProxyManager* manager = view->GetSessionProxyManager();
  vtkPVXMLElement* element =
    FindSubProxyElement(manager->GetProxyDefinitionManager()->GetCollapsedProxyDefinition(
      view->GetXMLGroup(), view->GetXMLName(), nullptr, false));
  if (!element)
  {
    return false;
  }
  vtkNew<vtkPVXMLElement> part;
  part->AddNestedElement(element, 0);
  if (!vtkSMRelievoAccess::Proxy::Make(view, manager, part))
  {
    return false;
  }
  vtkSMProxy* settings = vtkSMRelievoViews::GetSettings(view);
  TakeUserDefaults(manager, view, settings);
  settings->UpdateVTKObjects();
  AddToState(view, settings);
  return true;
}

//------------------------------------------------------------------------------
vtkSMProxy* vtkSMRelievoViews::GetSettings(vtkSMProxy* view)
{
  return view ? vtkSMRelievoAccess::Proxy::Find(view, SubProxyName) : nullptr;
}

//------------------------------------------------------------------------------
void vtkSMRelievoViews::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Upgrading: " << this->Upgrading << "\n";
}
