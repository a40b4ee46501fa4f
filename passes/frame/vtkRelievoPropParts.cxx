// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPropParts.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkSkybox.h"
#include "vtkVolume.h"

//------------------------------------------------------------------------------
void vtkRelievoPropParts::Collect(vtkProp* prop, std::vector<Part>& parts)
{
  parts.clear();
  if (vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* leaf = path->GetLastNode();
      parts.push_back({ leaf->GetViewProp(), leaf->GetMatrix() });
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
      parts.push_back({ level, nullptr });
    }
  }
  else
  {
    parts.push_back({ prop, nullptr });
  }
}

//------------------------------------------------------------------------------
vtkActor* vtkRelievoPropParts::GetMeshActor(const Part& part)
{
  vtkActor* actor = vtkActor::SafeDownCast(part.Prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || vtkSkybox::SafeDownCast(actor))
  {
    return nullptr;
  }
  // Surface LIC draws into buffers of its own, and from them into the picture.
  return mapper->IsA("vtkSurfaceLICMapper") || mapper->IsA("vtkCompositeSurfaceLICMapper") ? nullptr
                                                                                           : actor;
}

//------------------------------------------------------------------------------
bool vtkRelievoPropParts::DrawsNoOpaque(const Part& part)
{
  // Of VTK's 2D actors, captions draw a leader among what is opaque.
  return (vtkActor2D::SafeDownCast(part.Prop) && !part.Prop->IsA("vtkCaptionActor2D")) ||
    vtkVolume::SafeDownCast(part.Prop);
}
