// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCatcher.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

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
const char* vtkRelievoShadowCatcher::GetColorsName()
{
  return "relievoCatcher";
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCatcher::MapColors(vtkPolyDataMapper* mapper)
{
  mapper->MapDataArrayToVertexAttribute(
    GetColorsName(), GetColorsName(), vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowCatcher::HasColors(vtkPolyDataMapper* mapper)
{
  vtkPolyData* mesh = mapper->GetInput();
  return mesh && mesh->GetPointData()->HasArray(GetColorsName());
}

//------------------------------------------------------------------------------
glm::vec3 vtkRelievoShadowCatcher::GetRise(vtkRenderer* renderer)
{
  const auto darkest = 1.0 / 255.0; // black has no share
  glm::vec3 rise(0.F);
  for (int i = 0; i < 3 && renderer->GetGradientBackground(); ++i)
  {
    rise[i] = static_cast<float>(
      renderer->GetBackground2()[i] / std::max(renderer->GetBackground()[i], darkest) - 1.0);
  }
  return rise;
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkRelievoShadowCatcher::Find(const vtkRelievoFrameContext& context)
{
  std::vector<vtkProp*> found;
  vtkProp** const props = context.State->GetPropArray();
  std::copy_if(props, props + context.State->GetPropArrayCount(), std::back_inserter(found), Is);
  return found;
}
