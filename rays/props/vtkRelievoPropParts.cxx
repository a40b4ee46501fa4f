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
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkVolume.h"

#include <string>

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
      if (leaf->GetViewProp()->GetVisibility())
      {
        parts.push_back({ leaf->GetViewProp(), leaf->GetMatrix() });
      }
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
  // Surface LIC draws into its own buffers, and from them into the picture.
  return mapper->IsA("vtkSurfaceLICMapper") || mapper->IsA("vtkCompositeSurfaceLICMapper") ? nullptr
                                                                                           : actor;
}

//------------------------------------------------------------------------------
bool vtkRelievoPropParts::IsAnnotation(vtkActor* actor)
{
  return actor->GetForceTranslucent() && !actor->GetProperty()->GetLighting() &&
    !actor->GetPickable();
}

//------------------------------------------------------------------------------
bool vtkRelievoPropParts::DrawsNoOpaque(const Part& part)
{
  // Exactly these classes: subclasses draw without a mapper of their own.
  const std::string name = part.Prop->GetClassName();
  if ((name == "vtkOpenGLActor" || name == "vtkFollower") &&
    !static_cast<vtkActor*>(part.Prop)->GetMapper())
  {
    return true;
  }
  // Among VTK's 2D actors, captions draw a leader in the opaque phase.
  return (vtkActor2D::SafeDownCast(part.Prop) && !part.Prop->IsA("vtkCaptionActor2D")) ||
    vtkVolume::SafeDownCast(part.Prop);
}

//------------------------------------------------------------------------------
bool vtkRelievoPropParts::IsMixed(vtkProp* prop, const std::vector<Part>& parts)
{
  bool meshes = false;
  bool others = false;
  for (const Part& part : parts)
  {
    const bool mesh = GetMeshActor(part) != nullptr;
    meshes = meshes || mesh;
    others = others || (!mesh && !DrawsNoOpaque(part));
  }
  return meshes && others && !vtkLODProp3D::SafeDownCast(prop);
}

//------------------------------------------------------------------------------
void vtkRelievoPropParts::RenderMeshes(vtkProp* prop, bool translucent, vtkRenderer* renderer)
{
  // Collected anew: drawing changes the matrices of an assembly.
  std::vector<Part> parts;
  Collect(prop, parts);
  for (const Part& part : parts)
  {
    if (vtkActor* actor = GetMeshActor(part))
    {
      actor->SetPropertyKeys(prop->GetPropertyKeys());
      actor->PokeMatrix(part.Matrix);
      translucent ? actor->RenderTranslucentPolygonalGeometry(renderer)
                  : actor->RenderOpaqueGeometry(renderer);
      actor->PokeMatrix(nullptr);
    }
  }
}
