// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpaqueProps.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLODProp3D.h"
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

// What the prop draws: the leaves of an assembly, the levels of detail, or itself.
void CollectParts(vtkProp* prop, std::vector<vtkProp*>& parts)
{
  parts.clear();
  if (vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      parts.push_back(path->GetLastNode()->GetViewProp());
    }
  }
  else if (vtkLODProp3D::SafeDownCast(prop))
  {
    vtkNew<vtkPropCollection> levels;
    prop->GetActors(levels);
    vtkCollectionSimpleIterator it;
    levels->InitTraversal(it);
    while (vtkProp* level = levels->GetNextProp(it))
    {
      parts.push_back(level);
    }
  }
  else
  {
    parts.push_back(prop);
  }
}
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::Collect(const vtkRenderState* s)
{
  this->Props.clear();
  this->Foreign.clear();
  std::vector<vtkProp*> parts;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    CollectParts(prop, parts);
    bool writes = false;
    for (vtkProp* part : parts)
    {
      // These draw nothing in the opaque phase.
      if (vtkActor2D::SafeDownCast(part) || vtkVolume::SafeDownCast(part))
      {
        continue;
      }
      writes = WritesLayers(vtkActor::SafeDownCast(part));
      if (!writes)
      {
        this->Foreign = part->GetClassName();
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
  // An assembly's own keys: it hands them to its parts whenever it draws them.
  for (vtkProp* prop : this->Props)
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    if (!keys)
    {
      vtkNew<vtkInformation> made;
      prop->SetPropertyKeys(made);
      keys = made;
    }
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOpaqueProps::RemovePass(vtkOpenGLRenderPass* pass)
{
  for (vtkProp* prop : this->Props)
  {
    vtkInformation* keys = prop->GetPropertyKeys();
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
