// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetObjects.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <set>
#include <string>

namespace dataset
{
namespace
{
// The attributes that hide blocks; nullptr for a mapper of one mesh.
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

// The blocks with data, by flat index.
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

void AddTo(vtkBoundingBox& box, const std::vector<std::array<double, 3>>& points)
{
  for (const std::array<double, 3>& point : points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
}

// World corners of a box.
std::vector<std::array<double, 3>> PlaceCorners(const double* bounds, vtkMatrix4x4* pose)
{
  std::vector<std::array<double, 3>> corners;
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return corners;
  }
  for (int i = 0; i < 8; ++i)
  {
    const double corner[4] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)], 1.0 };
    double placed[4];
    pose->MultiplyPoint(corner, placed);
    corners.push_back({ placed[0] / placed[3], placed[1] / placed[3], placed[2] / placed[3] });
  }
  return corners;
}

// The renderer's actors in the order of their numbers, with their drawing matrices: an assembly's
// part combines the assembly's matrix with its own.
std::vector<std::pair<vtkActor*, vtkSmartPointer<vtkMatrix4x4>>> GetPlacedActors(
  vtkRenderer* renderer)
{
  std::vector<std::pair<vtkActor*, vtkSmartPointer<vtkMatrix4x4>>> placed;
  const auto add = [&placed](vtkActor* actor, vtkMatrix4x4* matrix) {
    placed.emplace_back(actor, vtkSmartPointer<vtkMatrix4x4>::New());
    placed.back().second->DeepCopy(matrix);
  };
  vtkPropCollection* props = renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
    if (vtkAssembly::SafeDownCast(prop))
    {
      prop->InitPathTraversal();
      while (vtkAssemblyPath* path = prop->GetNextPath())
      {
        vtkAssemblyNode* leaf = path->GetLastNode();
        if (auto* actor = vtkActor::SafeDownCast(leaf->GetViewProp()))
        {
          add(actor, leaf->GetMatrix());
        }
      }
      continue;
    }
    vtkNew<vtkPropCollection> inside;
    prop->GetActors(inside);
    for (int k = 0; k < inside->GetNumberOfItems(); ++k)
    {
      if (auto* actor = vtkActor::SafeDownCast(inside->GetItemAsObject(k)))
      {
        add(actor, actor->GetMatrix());
      }
    }
  }
  return placed;
}
}

//------------------------------------------------------------------------------
void GetRigidPose(vtkMatrix4x4* pose, double rotation[9], double place[3])
{
  double turned[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      turned[i][j] = pose->GetElement(i, j);
    }
    place[i] = pose->GetElement(i, 3);
  }
  vtkMath::Orthogonalize3x3(turned, turned);
  const double sign = vtkMath::Determinant3x3(turned) < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 9; ++i)
  {
    rotation[i] = sign * turned[i / 3][i % 3];
  }
}

//------------------------------------------------------------------------------
DatasetObjects::DatasetObjects(
  vtkRenderer* renderer, const std::map<int, std::string>& names, bool blocks)
  : Renderer(renderer)
{
  std::map<std::string, int> known;
  int number = -1;
  for (const auto& [shown, pose] : GetPlacedActors(renderer))
  {
    vtkActor* actor = shown;
    ++number;
    if (!actor->GetVisibility() || !actor->GetMapper())
    {
      continue;
    }
    const auto given = names.find(number);
    const std::string name =
      given == names.end() ? "actor_" + std::to_string(number) : given->second;
    const auto add = [&, &pose = pose](int block, vtkDataObject* data) {
      const std::string own = block > 0 ? name + "_" + std::to_string(block) : name;
      int object = -1;
      if (!name.empty())
      {
        const auto [place, isNew] = known.emplace(own, static_cast<int>(this->Objects.size()));
        object = place->second;
        if (isNew)
        {
          this->Objects.push_back({ own, pose });
        }
        this->Numbers[{ number, block }] = object;
      }
      this->Parts.push_back({ actor, number, block, data, object, pose });
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
  auto* frame = vtkRelievoPass::SafeDownCast(renderer->GetPass());
  if (frame && frame->GetStage("volumes")->GetParameter("solid") == "on")
  {
    this->AddVolumes();
  }
}

//------------------------------------------------------------------------------
void DatasetObjects::AddVolumes()
{
  std::set<std::string> names; // of actors, which may have one like a volume's
  for (const auto& object : this->Objects)
  {
    names.insert(object.Name);
  }
  vtkVolumeCollection* volumes = this->Renderer->GetVolumes();
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
    if (volume && volume->GetVisibility() && volume->GetMapper())
    {
      vtkNew<vtkMatrix4x4> pose;
      volume->GetMatrix(pose);
      this->Volumes[i] = { volume, volume->GetMapper()->GetBounds(),
        static_cast<int>(this->Objects.size()), pose };
      int number = i;
      while (!names.insert("volume_" + std::to_string(number)).second)
      {
        ++number;
      }
      this->Objects.push_back({ "volume_" + std::to_string(number), pose });
    }
  }
}

//------------------------------------------------------------------------------
int DatasetObjects::FindVolume(int volume) const
{
  const auto found = this->Volumes.find(volume);
  return found == this->Volumes.end() ? -1 : found->second.Object;
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> DatasetObjects::GetCorners(const Part& part)
{
  auto* block = vtkDataSet::SafeDownCast(part.Data);
  return PlaceCorners(block ? block->GetBounds() : part.Actor->GetMapper()->GetBounds(), part.Pose);
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> DatasetObjects::GetCorners(int object) const
{
  std::vector<std::array<double, 3>> corners;
  for (const Part& part : this->Parts)
  {
    if (part.Object == object)
    {
      const std::vector<std::array<double, 3>> more = GetCorners(part);
      corners.insert(corners.end(), more.begin(), more.end());
    }
  }
  for (const auto& [number, volume] : this->Volumes)
  {
    if (volume.Object == object)
    {
      corners = PlaceCorners(volume.Bounds, volume.Pose);
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
vtkBoundingBox DatasetObjects::GetBounds() const
{
  vtkBoundingBox box;
  for (const Part& part : this->Parts)
  {
    if (part.Object >= 0)
    {
      AddTo(box, GetCorners(part));
    }
  }
  for (const auto& [number, volume] : this->Volumes)
  {
    AddTo(box, PlaceCorners(volume.Bounds, volume.Pose));
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
    if (part.Actor->HasOpaqueGeometry())
    {
      AddTo(box, GetCorners(part));
    }
  }
  for (const auto& [number, volume] : this->Volumes)
  {
    AddTo(box, PlaceCorners(volume.Bounds, volume.Pose));
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
// Classes are compared by name: subclasses may draw anything. A projected point may leave the box
// of the projected corners.
std::optional<double> DatasetObjects::GetBorder(int object) const
{
  double border = 0.0;
  for (const Part& part : this->Parts)
  {
    if (part.Object != object)
    {
      continue;
    }
    const std::string mapper = part.Actor->GetMapper()->GetClassName();
    const double* last = part.Pose->GetData() + 12;
    bool isPlain = std::string(part.Actor->GetClassName()) == "vtkOpenGLActor" &&
      !vtkRelievoPlainActor::HasOwnShaders(part.Actor) &&
      (mapper == "vtkOpenGLPolyDataMapper" || mapper == "vtkDataSetMapper") && last[0] == 0.0 &&
      last[1] == 0.0 && last[2] == 0.0 && last[3] == 1.0;
#ifdef RELIEVO_VTK_COORDINATE_SYSTEMS
    isPlain = isPlain && part.Actor->GetCoordinateSystem() == vtkProp3D::WORLD;
#endif
    if (!isPlain)
    {
      return std::nullopt;
    }
    vtkProperty* property = part.Actor->GetProperty();
    border = std::max({ border, static_cast<double>(property->GetLineWidth()),
      static_cast<double>(property->GetPointSize()) });
  }
  return border;
}

//------------------------------------------------------------------------------
bool DatasetObjects::Has(const std::vector<int>& objects, vtkActor* actor) const
{
  return std::any_of(this->Parts.begin(), this->Parts.end(), [&](const Part& part) {
    return part.Actor == actor &&
      std::find(objects.begin(), objects.end(), part.Object) != objects.end();
  });
}

//------------------------------------------------------------------------------
DatasetObjects::Alone::Alone(const DatasetObjects& objects, const std::vector<int>& shown)
{
  const auto hide = [this](vtkProp* prop) {
    if (prop->GetVisibility())
    {
      prop->VisibilityOff();
      this->Hidden.push_back(prop);
    }
  };
  const auto isVolumeShown = [&objects, &shown](vtkProp* prop) {
    return std::any_of(
      objects.Volumes.begin(), objects.Volumes.end(), [&shown, prop](const auto& each) {
        return each.second.Prop == prop &&
          std::find(shown.begin(), shown.end(), each.second.Object) != shown.end();
      });
  };
  // Hides other volumes, and assemblies that contain no part of the objects.
  vtkPropCollection* props = objects.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
    vtkNew<vtkPropCollection> inside;
    prop->GetActors(inside);
    bool any = isVolumeShown(prop);
    for (int k = 0; k < inside->GetNumberOfItems(); ++k)
    {
      auto* actor = vtkActor::SafeDownCast(inside->GetItemAsObject(k));
      any = any || (actor && objects.Has(shown, actor));
    }
    if (!any)
    {
      hide(prop);
    }
  }
  // Hides the other parts of assemblies and composite data.
  for (const Part& part : objects.Parts)
  {
    const bool any = objects.Has(shown, part.Actor);
    if (!any)
    {
      hide(part.Actor);
    }
    else if (part.Data && std::find(shown.begin(), shown.end(), part.Object) == shown.end())
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
