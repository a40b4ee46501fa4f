// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BareScene.h"

#include "Options.h"
#include "Surface.h"

#include "vtkActorCollection.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <map>

namespace scene
{
namespace
{
// VTK's copy of a property releases textures without having referenced them: once for each name of
// a texture.
vtkSmartPointer<vtkProperty> Copy(vtkProperty* property)
{
  std::map<vtkTexture*, int> counts; // references, including the copy's
  for (const auto& named : property->GetAllTextures())
  {
    const auto known = counts.emplace(named.second, named.second->GetReferenceCount()).first;
    ++known->second;
  }
  auto copy = vtkSmartPointer<vtkProperty>::New();
  copy->DeepCopy(property);
  for (const auto& [texture, count] : counts)
  {
    while (texture->GetReferenceCount() < count)
    {
      texture->Register(copy);
    }
  }
  return copy;
}

std::vector<vtkSmartPointer<vtkProp>> GetProps(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  vtkPropCollection* all = renderer->GetViewProps();
  for (int i = 0; i < all->GetNumberOfItems(); ++i)
  {
    props.emplace_back(vtkProp::SafeDownCast(all->GetItemAsObject(i)));
  }
  return props;
}
}

//------------------------------------------------------------------------------
BareScene::BareScene(const Scene& scene)
  : Read(scene)
{
  vtkRenderer* renderer = this->Read.Renderer;
  this->Props = this->Kept = GetProps(renderer);
  for (vtkProp* prop : this->Props)
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    if (!mapper)
    {
      continue;
    }
    const char* name = mapper->GetArrayName();
    vtkTexture* texture = actor->GetTexture();
    this->Parts.push_back(
      { actor, Copy(actor->GetProperty()), texture, texture && texture->GetUseSRGBColorSpace(),
        vtkRelievoMaterial::Get(actor), mapper->GetScalarVisibility() != 0, mapper->GetScalarMode(),
        mapper->GetColorMode(), mapper->GetArrayAccessMode(), mapper->GetArrayId(),
        name ? name : "", mapper->GetUseLookupTableScalarRange() != 0,
        mapper->GetInterpolateScalarsBeforeMapping() != 0 });
  }
  vtkLightCollection* lights = renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    this->Lights.emplace_back(vtkLight::SafeDownCast(lights->GetItemAsObject(i)));
  }
}

//------------------------------------------------------------------------------
const BareScene::Part* BareScene::Find(vtkActor* actor) const
{
  const auto found = std::find_if(this->Parts.begin(), this->Parts.end(),
    [actor](const Part& part) { return part.Actor == actor; });
  return found == this->Parts.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void BareScene::Restore(const Part& part)
{
  part.Actor->SetProperty(Copy(part.Property));
  part.Actor->SetTexture(part.Texture);
  if (part.Texture)
  {
    part.Texture->SetUseSRGBColorSpace(part.SRGB);
  }
  vtkMapper* mapper = part.Actor->GetMapper();
  mapper->SetScalarVisibility(part.Colored);
  mapper->SetScalarMode(part.ScalarMode);
  mapper->SetColorMode(part.ColorMode);
  mapper->SetUseLookupTableScalarRange(part.OwnRange);
  mapper->SetInterpolateScalarsBeforeMapping(part.Interpolated);
  mapper->SetLookupTable(nullptr);
  mapper->SetArrayName(part.ArrayName.c_str());
  mapper->SetArrayId(part.ArrayId);
  mapper->SetArrayAccessMode(part.ArrayAccess);
}

//------------------------------------------------------------------------------
Scene& BareScene::Undress()
{
  vtkRenderer* renderer = this->Read.Renderer;
  for (const vtkSmartPointer<vtkProp>& prop : GetProps(renderer))
  {
    if (std::find(this->Kept.begin(), this->Kept.end(), prop) == this->Kept.end())
    {
      renderer->RemoveViewProp(prop);
    }
  }
  for (const Part& part : this->Parts)
  {
    this->Restore(part);
  }
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOn();
  for (vtkLight* light : this->Lights)
  {
    renderer->AddLight(light);
  }
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->GradientBackgroundOff();
  return this->Read;
}

//------------------------------------------------------------------------------
void BareScene::TakeOff()
{
  for (const Part& part : this->Parts)
  {
    if (vtkRelievoMaterial* material = vtkRelievoMaterial::Get(part.Actor))
    {
      material->Detach(part.Actor);
    }
    if (part.Material)
    {
      part.Material->Attach(part.Actor);
    }
  }
  for (const vtkSmartPointer<vtkProp>& prop : this->Kept)
  {
    if (std::find(this->Props.begin(), this->Props.end(), prop) == this->Props.end())
    {
      this->Read.Renderer->RemoveViewProp(prop);
    }
  }
  this->Kept = this->Props;
}

//------------------------------------------------------------------------------
void BareScene::Wear(const RenderOptions& options, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoMaterial>> worn;
  for (const Part& part : this->Parts)
  {
    worn.emplace_back(vtkRelievoMaterial::Get(part.Actor));
  }
  const std::vector<vtkSmartPointer<vtkProp>> kept = this->Kept;
  this->TakeOff();
  const std::vector<vtkSmartPointer<vtkProp>> before = GetProps(this->Read.Renderer);
  const auto keepNew = [this, &before] {
    for (const vtkSmartPointer<vtkProp>& prop : GetProps(this->Read.Renderer))
    {
      if (std::find(before.begin(), before.end(), prop) == before.end())
      {
        this->Kept.push_back(prop);
      }
    }
  };
  try
  {
    SetSurface(this->Read, options, progress);
    keepNew();
  }
  catch (...)
  {
    keepNew();
    this->TakeOff();
    for (std::size_t i = 0; i < worn.size(); ++i)
    {
      if (worn[i])
      {
        worn[i]->Attach(this->Parts[i].Actor);
      }
    }
    for (const vtkSmartPointer<vtkProp>& prop : kept)
    {
      if (!this->Read.Renderer->HasViewProp(prop))
      {
        this->Read.Renderer->AddViewProp(prop);
      }
    }
    this->Kept = kept;
    throw;
  }
}
}
