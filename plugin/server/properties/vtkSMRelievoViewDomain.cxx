// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoViewDomain.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

vtkStandardNewMacro(vtkSMRelievoViewDomain);

//------------------------------------------------------------------------------
int vtkSMRelievoViewDomain::IsInDomain(vtkSMProperty* property)
{
  vtkSMPropertyHelper values(property, /*quiet=*/true);
  values.SetUseUnchecked(true);
  for (unsigned int i = 0; i < values.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* value = values.GetAsProxy(i);
    if (value && !vtkSMRenderViewProxy::SafeDownCast(value))
    {
      return vtkSMDomain::NOT_IN_DOMAIN;
    }
  }
  return vtkSMDomain::IN_DOMAIN;
}

//------------------------------------------------------------------------------
int vtkSMRelievoViewDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  vtkSMProxy* owner = property->GetParent();
  vtkSMSessionProxyManager* manager = owner ? owner->GetSessionProxyManager() : nullptr;
  if (!manager)
  {
    return 0;
  }
  vtkSMProxySelectionModel* active = manager->GetSelectionModel("ActiveView");
  auto* view = vtkSMRenderViewProxy::SafeDownCast(active ? active->GetCurrentProxy() : nullptr);
  if (!view)
  {
    vtkNew<vtkSMProxyIterator> each;
    each->SetSessionProxyManager(manager);
    for (each->Begin("views"); !view && !each->IsAtEnd(); each->Next())
    {
      view = vtkSMRenderViewProxy::SafeDownCast(each->GetProxy());
    }
  }
  if (!view)
  {
    return 0;
  }
  vtkSMPropertyHelper value(property);
  value.SetUseUnchecked(useUncheckedValues);
  value.Set(view);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSMRelievoViewDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
