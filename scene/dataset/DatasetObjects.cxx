// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetObjects.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace scene
{
namespace
{
// What says which blocks are shown; nullptr for a mapper of one mesh.
vtkCompositeDataDisplayAttributes* GetAttributes(vtkActor* actor)
{
  auto* mapper = vtkRelievoCompositeMapper::SafeDownCast(actor->GetMapper());
  if (mapper && !mapper->GetCompositeDataDisplayAttributes())
  {
    mapper->SetCompositeDataDisplayAttributes(
      vtkSmartPointer<vtkCompositeDataDisplayAttributes>::New());
  }
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}

// The blocks that hold data, by their flat index.
std::vector<std::pair<int, vtkDataObject*>> GetBlocks(vtkActor* actor)
{
  std::vector<std::pair<int, vtkDataObject*>> blocks;
  vtkMapper* mapper = actor->GetMapper();
  auto* data = vtkCompositeDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  vtkCompositeDataDisplayAttributes* attributes = data ? GetAttributes(actor) : nullptr;
  if (attributes)
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(data->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      vtkDataObject* block = it->GetCurrentDataObject();
      if (!attributes->HasBlockVisibility(block) || attributes->GetBlockVisibility(block))
      {
        blocks.emplace_back(static_cast<int>(it->GetCurrentFlatIndex()), block);
      }
    }
  }
  return blocks;
}
}

//------------------------------------------------------------------------------
DatasetObjects::DatasetObjects(
  vtkRenderer* renderer, const std::map<int, std::string>& names, bool blocks)
  : Renderer(renderer)
{
  std::map<std::string, int> known;
  vtkActorCollection* actors = renderer->GetActors();
  for (int number = 0; number < actors->GetNumberOfItems(); ++number)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(number));
    if (!actor || !actor->GetVisibility() || !actor->GetMapper())
    {
      continue;
    }
    const auto given = names.find(number);
    const std::string name =
      given == names.end() ? "actor_" + std::to_string(number) : given->second;
    const auto add = [&](int block, vtkDataObject* data) {
      const std::string own = block > 0 ? name + "_" + std::to_string(block) : name;
      int object = -1;
      if (!name.empty())
      {
        const auto [place, isNew] = known.emplace(own, static_cast<int>(this->Objects.size()));
        object = place->second;
        if (isNew)
        {
          this->Objects.push_back({ own, actor });
        }
        this->Numbers[{ number, block }] = object;
      }
      this->Parts.push_back({ actor, number, block, data, object });
    };
    actor->GetMapper()->Update();
    const auto parts = blocks ? GetBlocks(actor) : std::vector<std::pair<int, vtkDataObject*>>();
    for (const auto& [block, data] : parts)
    {
      add(block, data);
    }
    if (parts.empty())
    {
      add(-1, nullptr);
    }
  }
}

//------------------------------------------------------------------------------
vtkBoundingBox DatasetObjects::GetBounds() const
{
  vtkBoundingBox box;
  for (const Part& part : this->Parts)
  {
    if (part.Object >= 0)
    {
      box.AddBounds(part.Actor->GetBounds());
    }
  }
  if (!box.IsValid())
  {
    box.SetBounds(this->Renderer->ComputeVisiblePropBounds());
  }
  return box;
}

//------------------------------------------------------------------------------
vtkBoundingBox DatasetObjects::GetOpaqueBounds() const
{
  vtkBoundingBox box;
  for (const Part& part : this->Parts)
  {
    if (!part.Actor->HasTranslucentPolygonalGeometry())
    {
      box.AddBounds(part.Actor->GetBounds());
    }
  }
  return box;
}

//------------------------------------------------------------------------------
int DatasetObjects::Find(int actor, int block) const
{
  auto found = this->Numbers.find({ actor, -1 });
  found = found == this->Numbers.end() ? this->Numbers.find({ actor, block }) : found;
  return found == this->Numbers.end() ? -1 : found->second;
}

//------------------------------------------------------------------------------
bool DatasetObjects::Has(int object, vtkActor* actor) const
{
  return std::any_of(this->Parts.begin(), this->Parts.end(),
    [=](const Part& part) { return part.Object == object && part.Actor == actor; });
}

//------------------------------------------------------------------------------
DatasetObjects::Alone::Alone(const DatasetObjects& objects, int object)
{
  const auto hide = [this](vtkProp* prop) {
    if (prop->GetVisibility())
    {
      prop->VisibilityOff();
      this->Hidden.push_back(prop);
    }
  };
  // Assemblies without a part of it, volumes.
  vtkPropCollection* props = objects.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
    vtkNew<vtkPropCollection> inside;
    prop->GetActors(inside);
    bool any = false;
    for (int k = 0; k < inside->GetNumberOfItems(); ++k)
    {
      auto* actor = vtkActor::SafeDownCast(inside->GetItemAsObject(k));
      any = any || (actor && objects.Has(object, actor));
    }
    if (!any)
    {
      hide(prop);
    }
  }
  // Of assemblies and composite data, the other parts.
  for (const Part& part : objects.Parts)
  {
    const bool any = objects.Has(object, part.Actor);
    if (!any)
    {
      hide(part.Actor);
    }
    else if (part.Object != object && part.Data)
    {
      vtkCompositeDataDisplayAttributes* attributes = GetAttributes(part.Actor);
      this->Blocks.push_back({ part.Actor, part.Data, attributes->HasBlockVisibility(part.Data),
        attributes->GetBlockVisibility(part.Data) });
      attributes->SetBlockVisibility(part.Data, false);
      part.Actor->GetMapper()->Modified();
    }
  }
}

//------------------------------------------------------------------------------
DatasetObjects::Alone::~Alone()
{
  for (vtkProp* prop : this->Hidden)
  {
    prop->VisibilityOn();
  }
  for (auto block = this->Blocks.rbegin(); block != this->Blocks.rend(); ++block)
  {
    vtkCompositeDataDisplayAttributes* attributes = GetAttributes(block->Actor);
    if (block->Has)
    {
      attributes->SetBlockVisibility(block->Data, block->Visible);
    }
    else
    {
      attributes->RemoveBlockVisibility(block->Data);
    }
    block->Actor->GetMapper()->Modified();
  }
}
}
