// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpaqueMeshes.h"

#include "vtkActor.h"
#include "vtkProp.h"
#include "vtkRelievoFrameScene.h"
#include "vtkRelievoPropMeshes.h"
#include "vtkRelievoShadowCatcher.h"

#include <algorithm>

namespace
{
bool IsMesh(const vtkRelievoFrameProp& prop)
{
  return std::any_of(prop.Parts.begin(), prop.Parts.end(), [](const auto& part) {
    vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
    return actor && !vtkRelievoPropParts::IsAnnotation(actor);
  });
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoPlacedMesh> vtkRelievoOpaqueMeshes::Find(vtkRenderer* renderer)
{
  std::vector<vtkRelievoPlacedMesh> meshes;
  this->LeftOut = 0;
  this->TooManyTriangles = 0;
  for (const vtkRelievoFrameProp& prop : vtkRelievoFrameScene::FindVisible(renderer))
  {
    if (!IsMesh(prop))
    {
      continue;
    }
    prop.Prop->GetBounds(); // updates the prop's pipeline
    if (!vtkRelievoPropMeshes::Collect(prop.Prop, vtkRelievoPropMeshes::Wanted::Opaque,
          this->Glyphs, meshes, &this->TooManyTriangles))
    {
      this->LeftOut += vtkRelievoShadowCatcher::Is(prop.Prop) ? 0 : 1; // which is never opaque
    }
  }
  return meshes;
}
