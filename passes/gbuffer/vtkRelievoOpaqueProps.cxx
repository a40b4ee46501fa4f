// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpaqueProps.h"

#include "vtkHiddenLineRemovalPass.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRelievoPropParts.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::Collect(const vtkRenderState* s)
{
  this->Props.clear();
  this->Foreign.clear();
  std::vector<vtkRelievoPropParts::Part> parts;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    vtkRelievoPropParts::Collect(prop, parts);
    bool writes = false;
    for (const vtkRelievoPropParts::Part& part : parts)
    {
      if (vtkRelievoPropParts::DrawsNoOpaque(part))
      {
        continue;
      }
      writes = vtkRelievoPropParts::GetMeshActor(part) != nullptr;
      if (!writes)
      {
        this->Foreign = part.Prop->GetClassName();
        break;
      }
    }
    if (writes)
    {
      this->Props.push_back(prop);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::AddPass(vtkOpenGLRenderPass* pass)
{
  for (vtkProp* prop : this->Props)
  {
    this->Spliced.Add(prop, pass);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::RemovePass(vtkOpenGLRenderPass* pass)
{
  this->Spliced.Remove(pass);
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::RenderOpaque(vtkRenderer* renderer, bool removesHiddenLines)
{
  const int count = static_cast<int>(this->Props.size());
  if (removesHiddenLines &&
    vtkHiddenLineRemovalPass::WireframePropsExist(this->Props.data(), count))
  {
    vtkRenderState state(renderer);
    state.SetPropArrayAndCount(this->Props.data(), count);
    vtkNew<vtkHiddenLineRemovalPass> pass;
    pass->Render(&state);
    return;
  }
  for (vtkProp* prop : this->Props)
  {
    prop->RenderOpaqueGeometry(renderer);
  }
}
