// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureCoordinates.h"

#include "DataSets.h"
#include "ReadContext.h"
#include "SurfaceOptions.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoTextureCoordinates.h"
#include "vtkTriangleFilter.h"

namespace look
{
namespace
{
bool NeedsTextureCoordinates(vtkDataObject* data)
{
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0 &&
    !mesh->GetPointData()->GetTCoords();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithTextureCoordinates(vtkDataObject* data, Mapping mapping, int up)
{
  vtkSmartPointer<vtkPolyData> mesh = vtkPolyData::SafeDownCast(data);
  if (mesh->GetNumberOfStrips() > 0)
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(mesh);
    triangles->PassVertsOn();
    triangles->PassLinesOn();
    triangles->Update();
    mesh = triangles->GetOutput();
  }
  constexpr int mappings[] = { vtkRelievoTextureCoordinates::BOX,
    vtkRelievoTextureCoordinates::PLANE, vtkRelievoTextureCoordinates::SPHERE };
  vtkNew<vtkRelievoTextureCoordinates> filter;
  filter->SetInputData(mesh);
  filter->SetMapping(mappings[static_cast<int>(mapping)]);
  filter->SetUp(up);
  filter->Update();
  mesh = filter->GetOutput();
  mesh->GetPointData()->RemoveArray("vtkOriginalPointIds");
  return mesh;
}
}

//------------------------------------------------------------------------------
void AddTextureCoordinates(vtkActor* actor, const std::optional<Mapping>& chosen, int up,
  const std::string& path, ReadContext& context)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  mapper->Update();
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  bool needed = false;
  ForEachDataSet(
    data, [&needed](vtkDataSet* block) { needed = needed || NeedsTextureCoordinates(block); });
  if (!needed)
  {
    return;
  }
  const Mapping mapping = chosen.value_or(Mapping::Box);
  if (vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataSet> copy;
    copy.TakeReference(blocks->NewInstance());
    copy->ShallowCopy(blocks);
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(blocks->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      vtkDataObject* block = it->GetCurrentDataObject();
      if (NeedsTextureCoordinates(block))
      {
        copy->SetDataSet(it, WithTextureCoordinates(block, mapping, up));
      }
    }
    mapper->SetInputDataObject(copy);
  }
  else
  {
    mapper->SetInputDataObject(WithTextureCoordinates(data, mapping, up));
  }
  if (!chosen)
  {
    context.Note(path +
      ": a mesh has no texture coordinates; maps are laid on it as on a box "
      "(--texture-coordinates)");
  }
  context.Check(path);
}
}
