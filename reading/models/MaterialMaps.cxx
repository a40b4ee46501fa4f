// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MaterialMaps.h"

#include "Images.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkTransform.h"

namespace reading
{
//------------------------------------------------------------------------------
void MaterialPainter::Put(vtkActor* actor, const MaterialMaps& maps)
{
  double cutoff = maps.Cutoff.value_or(0.0);
  if (maps.Color)
  {
    actor->SetTexture(this->GetTexture(maps));
    cutoff = maps.Cutoff ? cutoff : FindCutoff(maps.Color, actor);
  }
  if (maps.Normals || cutoff > 0.0)
  {
    this->GetMaterial(maps, cutoff)->Attach(actor);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MaterialPainter::GetTexture(const MaterialMaps& maps)
{
  vtkSmartPointer<vtkTexture>& texture = this->Textures[{ maps.Color, maps.Scale, maps.Offset }];
  if (!texture)
  {
    texture = MakeTexture(maps.Color);
    if (maps.Scale != MaterialMaps().Scale || maps.Offset != MaterialMaps().Offset)
    {
      vtkNew<vtkTransform> transform;
      transform->Translate(maps.Offset[0], maps.Offset[1], 0.0);
      transform->Scale(maps.Scale[0], maps.Scale[1], 1.0);
      texture->SetTransform(transform);
    }
  }
  return texture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoMaterial> MaterialPainter::GetMaterial(
  const MaterialMaps& maps, double cutoff)
{
  vtkSmartPointer<vtkRelievoMaterial>& material =
    this->Materials[{ maps.Normals, maps.NormalStrength, cutoff, maps.NormalsRepeat }];
  if (!material)
  {
    material = vtkSmartPointer<vtkRelievoMaterial>::New();
    material->SetNormalMap(maps.Normals);
    material->SetNormalStrength(maps.NormalStrength);
    material->SetRepeat(maps.NormalsRepeat);
    material->SetAlphaCutoff(cutoff);
  }
  return material;
}
}
