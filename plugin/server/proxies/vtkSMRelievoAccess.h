// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Access to protected members of ParaView's proxies. The members are named through a derived class
// that is never instantiated, so that the compiler checks them.
#ifndef vtkSMRelievoAccess_h
#define vtkSMRelievoAccess_h

#include "vtkSMMessageMinimal.h"
#include "vtkSMProxy.h"
#include "vtkSMStringListDomain.h"

#include <string>
#include <vector>

class vtkPVXMLElement;
class vtkSMSessionProxyManager;

namespace vtkSMRelievoAccess
{
class Proxy : public vtkSMProxy
{
public:
  static vtkSMProxy* Find(vtkSMProxy* proxy, const char* name)
  {
    vtkSMProxy* (vtkSMProxy::*get)(const char*) = &Proxy::GetSubProxy;
    return (proxy->*get)(name);
  }
  static int Make(vtkSMProxy* proxy, vtkSMSessionProxyManager* manager, vtkPVXMLElement* element)
  {
    return (proxy->*(&Proxy::CreateSubProxiesAndProperties))(manager, element);
  }
  static vtkSMMessage* GetState(vtkSMProxy* proxy) { return proxy->*(&Proxy::State); }
};

class StringListDomain : public vtkSMStringListDomain
{
public:
  static void Set(vtkSMStringListDomain* domain, const std::vector<std::string>& strings)
  {
    (domain->*(&StringListDomain::SetStrings))(strings);
  }
};
}

#endif
