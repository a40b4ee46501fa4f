// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpaqueProps.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkVolume.h"

namespace
{
bool WritesLayers(vtkActor* actor)
{
  return actor && actor->GetMapper() && !vtkSkybox::SafeDownCast(actor);
}
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::Collect(const vtkRenderState* s)
{
  this->Props.clear();
  this->Actors.clear();
  this->Foreign.clear();
  vtkNew<vtkPropCollection> parts;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    // These draw nothing in the opaque phase.
    if (vtkActor2D::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop))
    {
      continue;
    }
    parts->RemoveAllItems();
    if (vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop))
    {
      prop->GetActors(parts);
    }
    else
    {
      parts->AddItem(prop);
    }
    bool writes = true;
    const std::size_t before = this->Actors.size();
    vtkCollectionSimpleIterator it;
    parts->InitTraversal(it);
    while (vtkProp* part = parts->GetNextProp(it))
    {
      vtkActor* actor = vtkActor::SafeDownCast(part);
      if (WritesLayers(actor))
      {
        this->Actors.push_back(actor);
      }
      else
      {
        writes = false;
        this->Foreign = part->GetClassName();
      }
    }
    if (writes)
    {
      this->Props.push_back(prop);
    }
    else
    {
      this->Actors.resize(before);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::AddPass(vtkOpenGLRenderPass* pass)
{
  for (vtkActor* actor : this->Actors)
  {
    vtkInformation* keys = actor->GetPropertyKeys();
    if (!keys)
    {
      vtkNew<vtkInformation> made;
      actor->SetPropertyKeys(made);
      keys = made;
    }
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::RemovePass(vtkOpenGLRenderPass* pass)
{
  for (vtkActor* actor : this->Actors)
  {
    vtkInformation* keys = actor->GetPropertyKeys();
    if (!keys)
    {
      continue;
    }
    keys->Remove(vtkOpenGLRenderPass::RenderPasses(), pass);
    if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::RenderOpaque(vtkRenderer* renderer)
{
  for (vtkProp* prop : this->Props)
  {
    prop->RenderOpaqueGeometry(renderer);
  }
}
