// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpaqueProps.h"

#include "vtkActor.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::Collect(const vtkRelievoFrameScene& scene)
{
  this->Props.clear();
  this->Mixed.clear();
  this->Foreign.clear();
  this->Edges = false;
  for (const vtkRelievoFrameProp& drawn : scene.Props)
  {
    vtkProp* prop = drawn.Prop;
    const std::vector<vtkRelievoPropParts::Part>& parts = drawn.Parts;
    bool writes = false;
    bool foreign = false;
    for (const vtkRelievoPropParts::Part& part : parts)
    {
      if (vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part))
      {
        writes = true;
        this->Edges = this->Edges ||
          (actor->GetProperty()->GetEdgeVisibility() &&
            actor->GetProperty()->GetRepresentation() == VTK_SURFACE);
      }
      else if (!vtkRelievoPropParts::DrawsNoOpaque(part))
      {
        foreign = true;
        this->Foreign = part.Prop->GetClassName();
      }
    }
    if (writes && !foreign)
    {
      this->Props.push_back(prop);
    }
    else if (vtkRelievoPropParts::IsMixed(prop, parts))
    {
      this->Props.push_back(prop);
      this->Mixed.insert(prop);
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
  std::vector<vtkProp*> whole = this->Props;
  whole.erase(std::remove_if(whole.begin(), whole.end(),
                [this](vtkProp* prop) { return this->Mixed.count(prop) > 0; }),
    whole.end());
  const int count = static_cast<int>(whole.size());
  const bool together =
    removesHiddenLines && vtkHiddenLineRemovalPass::WireframePropsExist(whole.data(), count);
  if (together)
  {
    vtkRenderState state(renderer);
    state.SetPropArrayAndCount(whole.data(), count);
    vtkNew<vtkHiddenLineRemovalPass> pass;
    pass->Render(&state);
  }
  for (vtkProp* prop : this->Props)
  {
    if (this->Mixed.count(prop))
    {
      vtkRelievoPropParts::RenderMeshes(prop, false, renderer);
    }
    else if (!together)
    {
      prop->RenderOpaqueGeometry(renderer);
    }
  }
}
