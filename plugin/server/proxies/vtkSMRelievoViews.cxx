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
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSMRelievoViews);

namespace
{
// The parts added to older proxies: the sub-proxy of view.xml, and those of material.xml and
// points.xml, in the order of new proxies.
struct Kind
{
  const char* Group;
  const char* SubProxy;
};
constexpr Kind View{ "views", "Relievo" };
constexpr Kind Material{ "representations", "RelievoMaterial" };
constexpr Kind Fog{ "representations", "RelievoFog" };
constexpr Kind Lamps{ "representations", "RelievoLamps" };
constexpr Kind Markers{ "representations", "RelievoMarkers" };

vtkSmartPointer<vtkSMRelievoViews>& Instance()
{
  static vtkSmartPointer<vtkSMRelievoViews> instance;
  return instance;
}

// The part of a definition that creates Relievo's sub-proxy, or nullptr.
vtkPVXMLElement* FindSubProxyElement(vtkPVXMLElement* definition, const char* name)
{
  for (unsigned int i = 0; definition && i < definition->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = definition->GetNestedElement(i);
    vtkPVXMLElement* proxy = std::strcmp(element->GetName(), "SubProxy") == 0
      ? element->FindNestedElementByName("Proxy")
      : nullptr;
    if (proxy && std::strcmp(proxy->GetAttributeOrEmpty("name"), name) == 0)
    {
      return element;
    }
  }
  return nullptr;
}

// The user's saved defaults of such proxies; ParaView applies them only to new ones.
void TakeUserDefaults(vtkSMSessionProxyManager* manager, vtkSMProxy* proxy, const char* name)
{
  vtkSMProxy* settings = vtkSMRelievoAccess::Proxy::Find(proxy, name);
  auto fresh = vtk::TakeSmartPointer(manager->NewProxy(proxy->GetXMLGroup(), proxy->GetXMLName()));
  if (!fresh)
  {
    return;
  }
  fresh->SetSession(nullptr);
  fresh->SetLocation(0);
  fresh->SetPrototype(true);
  vtkSMSettings::GetInstance()->GetProxySettings(fresh);
  vtkSMProxy* from = vtkSMRelievoAccess::Proxy::Find(fresh, name);
  auto property = vtk::TakeSmartPointer(settings->NewPropertyIterator());
  for (property->Begin(); from && !property->IsAtEnd(); property->Next())
  {
    if (!property->GetProperty()->GetInformationOnly())
    {
      property->GetProperty()->Copy(from->GetProperty(property->GetKey()));
    }
  }
}

// Undo recreates a closed view or deleted representation from a state that names its sub-proxies.
void AddToState(vtkSMProxy* proxy, const char* name)
{
  vtkSMProxy* settings = vtkSMRelievoAccess::Proxy::Find(proxy, name);
  auto add = [settings, name](vtkSMMessage& state) {
    ProxyState_SubProxy* entry = state.AddExtension(ProxyState::subproxy);
    entry->set_name(name);
    entry->set_global_id(settings->GetGlobalID());
  };
  add(*vtkSMRelievoAccess::Proxy::GetState(proxy));
  vtkSMMessage kept;
  vtkSMStateLocator* states = proxy->GetSession()->GetStateLocator();
  if (states && states->FindState(proxy->GetGlobalID(), &kept, false))
  {
    add(kept);
    states->RegisterState(&kept);
  }
}

// Removes prototypes made from old definitions.
void DropPrototypes(vtkSMSessionProxyManager* manager, const Kind& kind)
{
  const std::string group = std::string(kind.Group) + "_prototypes";
  std::vector<vtkSmartPointer<vtkSMProxy>> old;
  vtkNew<vtkSMProxyIterator> prototype;
  prototype->SetSessionProxyManager(manager);
  prototype->SetSkipPrototypes(false);
  for (prototype->Begin(group.c_str()); !prototype->IsAtEnd(); prototype->Next())
  {
    old.emplace_back(prototype->GetProxy());
  }
  for (vtkSMProxy* each : old)
  {
    manager->UnRegisterProxy(group.c_str(), each->GetXMLName(), each);
  }
}

// paraview.servermanager caches a class of each kind of proxy from its first use on.
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
            for group in "views", "representations":
                if not manager.GetProxyDefinitionManager().HasDefinition(group, kind.__name__):
                    continue
                proto = manager.GetPrototypeProxy(group, kind.__name__)
                for name, value in make(proto).items() if proto else ():
                    if name.startswith("Relievo") and not hasattr(kind, name):
                        setattr(kind, name, value)
''', {}))");
#endif
}

// Adds the missing parts to one proxy; false if nothing was missing.
bool UpgradeProxy(vtkSMProxy* proxy, const Kind& kind)
{
  if (!proxy || !proxy->GetObjectsCreated() ||
    vtkSMRelievoAccess::Proxy::Find(proxy, kind.SubProxy))
  {
    return false;
  }
  vtkSMSessionProxyManager* manager = proxy->GetSessionProxyManager();
  vtkPVXMLElement* element =
    FindSubProxyElement(manager->GetProxyDefinitionManager()->GetCollapsedProxyDefinition(
                          proxy->GetXMLGroup(), proxy->GetXMLName(), nullptr, false),
      kind.SubProxy);
  if (!element)
  {
    return false;
  }
  vtkNew<vtkPVXMLElement> part;
  part->AddNestedElement(element, 0);
  if (!vtkSMRelievoAccess::Proxy::Make(proxy, manager, part))
  {
    return false;
  }
  TakeUserDefaults(manager, proxy, kind.SubProxy);
  vtkSMRelievoAccess::Proxy::Find(proxy, kind.SubProxy)->UpdateVTKObjects();
  AddToState(proxy, kind.SubProxy);
  return true;
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
  // Plugin loaded here: called after the observers that read its XML. Loaded on a server: called
  // after its definitions arrived. vtkSMProxyDefinitionManager's own event comes while it still
  // returns old definitions.
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
  std::vector<std::pair<vtkSmartPointer<vtkSMProxy>, const Kind*>> older;
  auto session = vtk::TakeSmartPointer(vtkProcessModule::GetProcessModule()->NewSessionIterator());
  for (session->InitTraversal(); !session->IsDoneWithTraversal(); session->GoToNextItem())
  {
    auto* current = vtkSMSession::SafeDownCast(session->GetCurrentSession());
    if (!current || !current->GetSessionProxyManager() || current->IsMultiClients())
    {
      continue; // in a shared session proxies must stay as the server sent them
    }
    for (const Kind* kind : { &View, &Material, &Fog, &Lamps, &Markers })
    {
      DropPrototypes(current->GetSessionProxyManager(), *kind);
      vtkNew<vtkSMProxyIterator> proxy;
      proxy->SetSessionProxyManager(current->GetSessionProxyManager());
      for (proxy->Begin(kind->Group); !proxy->IsAtEnd(); proxy->Next())
      {
        older.emplace_back(proxy->GetProxy(), kind);
      }
    }
  }

  // not an undo step for users
  vtkSMUndoStackBuilder* undo = vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder();
  const bool ignored = undo && undo->GetIgnoreAllChanges();
  if (undo)
  {
    undo->SetIgnoreAllChanges(true);
  }
  int count = 0;
  for (const auto& each : older)
  {
    count += UpgradeProxy(each.first, *each.second) ? 1 : 0;
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
  return UpgradeProxy(view, View);
}

//------------------------------------------------------------------------------
vtkSMProxy* vtkSMRelievoViews::GetSettings(vtkSMProxy* view)
{
  return view ? vtkSMRelievoAccess::Proxy::Find(view, View.SubProxy) : nullptr;
}

//------------------------------------------------------------------------------
void vtkSMRelievoViews::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Upgrading: " << this->Upgrading << "\n";
}
