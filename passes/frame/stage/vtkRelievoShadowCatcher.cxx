// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCatcher.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <iterator>

namespace
{
vtkInformationIntegerKey* GetKey()
{
  static auto* const key =
    vtkInformationIntegerKey::MakeKey("SHADOW_CATCHER", "vtkRelievoShadowCatcher");
  return key;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCatcher::Make(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> made;
    prop->SetPropertyKeys(made);
  }
  prop->GetPropertyKeys()->Set(GetKey(), 1);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowCatcher::Is(vtkProp* prop)
{
  return prop->GetPropertyKeys() && prop->GetPropertyKeys()->Has(GetKey());
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkRelievoShadowCatcher::Find(const vtkRelievoFrameContext& context)
{
  std::vector<vtkProp*> found;
  vtkProp** const props = context.State->GetPropArray();
  std::copy_if(props, props + context.State->GetPropArrayCount(), std::back_inserter(found), Is);
  return found;
}
