// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfSurface.h"

#include "vtkActor.h"
#include "vtkClipPolyData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoMovedMesh.h"

#include <glm/mat3x3.hpp>

namespace scene
{
namespace
{
// Maps the data's colours as the mapper does, without changing the mapper.
void MapColors(vtkMapper* mapper, vtkDataSet* data, GltfSurface& surface)
{
  vtkNew<vtkPolyDataMapper> own;
  own->ShallowCopy(mapper);
  if (surface.Places)
  {
    own->InterpolateScalarsBeforeMappingOff(); // a glyph has one colour
  }
  int of = 0;
  vtkUnsignedCharArray* colors = own->MapScalars(data, 1., of);
  if (own->GetColorTextureMap() && own->GetColorCoordinates())
  {
    surface.Map = own->GetColorTextureMap();
    surface.MapCoordinates = own->GetColorCoordinates();
    return;
  }
  const bool isOfCells = of != 0; // also of an array of the field data, with a colour for each cell
  if (!colors || colors->GetNumberOfComponents() != 4 ||
    colors->GetNumberOfTuples() <
      (isOfCells ? data->GetNumberOfCells() : data->GetNumberOfPoints()))
  {
    return;
  }
  surface.Of = isOfCells ? GltfSurface::ColorsOf::Cells : GltfSurface::ColorsOf::Points;
  surface.Colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  surface.Colors->ShallowCopy(colors);
}

// The mesh without the parts that the mapper's clipping planes hide.
vtkSmartPointer<vtkPolyData> Clip(
  vtkPolyData* mesh, vtkMapper* mapper, const glm::dmat4& meshToWorld)
{
  vtkSmartPointer<vtkPolyData> rest = mesh;
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    glm::dvec3 origin;
    glm::dvec3 normal;
    planes->GetItem(i)->GetOrigin(&origin.x);
    planes->GetItem(i)->GetNormal(&normal.x);
    origin = glm::dvec3(glm::inverse(meshToWorld) * glm::dvec4(origin, 1.));
    normal = glm::transpose(glm::dmat3(meshToWorld)) * normal;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(&origin.x);
    plane->SetNormal(&normal.x);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(rest);
    clip->SetClipFunction(plane);
    clip->Update();
    rest = clip->GetOutput();
  }
  return rest;
}

// Adds the leaves of composite data, with the attributes inherited from their parents.
void AddBlocks(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes,
  vtkMapper* mapper, GltfSurface surface, bool isVisible, bool isColored,
  std::vector<GltfSurface>& surfaces)
{
  if (data && attributes)
  {
    isVisible =
      attributes->HasBlockVisibility(data) ? attributes->GetBlockVisibility(data) : isVisible;
    surface.Opacity =
      attributes->HasBlockOpacity(data) ? attributes->GetBlockOpacity(data) : surface.Opacity;
    if (attributes->HasBlockColor(data))
    {
      isColored = true;
      attributes->GetBlockColor(data, &surface.Color.x);
    }
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    it->VisitOnlyLeavesOff();
    it->TraverseSubTreeOff();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      AddBlocks(
        it->GetCurrentDataObject(), attributes, mapper, surface, isVisible, isColored, surfaces);
    }
    return;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || !isVisible || mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  surface.Mesh = Clip(mesh, mapper, surface.MeshToWorld);
  if (!isColored)
  {
    MapColors(mapper, surface.Mesh, surface);
  }
  surfaces.push_back(surface);
}

// The block with a flat index, or the data if it has no blocks.
vtkDataSet* FindBlock(vtkDataObject* data, int index)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return vtkDataSet::SafeDownCast(data);
  }
  auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (static_cast<int>(it->GetCurrentFlatIndex()) == index)
    {
      return vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
    }
  }
  return nullptr;
}

bool AddGlyphs(vtkGlyph3DMapper* mapper, vtkRelievoGlyphPlaces& glyphs, const GltfSurface& like,
  std::vector<GltfSurface>& surfaces)
{
  const auto* groups = glyphs.Find(mapper);
  if (!groups)
  {
    return false;
  }
  for (const vtkRelievoGlyphPlaces::Group& group : *groups)
  {
    if (!group.Mesh || group.Places->empty())
    {
      continue;
    }
    GltfSurface surface = like;
    surface.Mesh = group.Mesh;
    surface.Places = group.Places;
    surface.Points = group.Points;
    if (vtkDataSet* points = FindBlock(mapper->GetInputDataObject(0, 0), group.Block))
    {
      MapColors(mapper, points, surface);
      surface.Of = GltfSurface::ColorsOf::Places;
    }
    surfaces.push_back(surface);
  }
  return true;
}
}

//------------------------------------------------------------------------------
std::string CollectSurfaces(vtkActor* actor, vtkMatrix4x4* matrix, vtkRelievoGlyphPlaces& glyphs,
  std::vector<GltfSurface>& surfaces)
{
  vtkMapper* mapper = actor->GetMapper();
  if (vtkRelievoIsProjective(matrix ? matrix : actor->GetMatrix()))
  {
    return "its matrix is projective";
  }
  mapper->Update();
  GltfSurface surface;
  surface.Actor = actor;
  surface.MeshToWorld = vtkRelievoToGlm(matrix ? matrix : actor->GetMatrix());
  surface.Opacity = actor->GetForceOpaque() ? 1. : actor->GetProperty()->GetOpacity();
  vtkProperty* property = actor->GetProperty();
  if (property->GetDiffuse() <= 0. && property->GetAmbient() > 0.)
  {
    property->GetAmbientColor(&surface.Color.x);
  }
  else
  {
    property->GetDiffuseColor(&surface.Color.x);
  }
  const std::size_t before = surfaces.size();
  if (auto* composite = vtkRelievoCompositeMapper::SafeDownCast(mapper))
  {
    AddBlocks(composite->GetInputDataObject(0, 0), composite->GetCompositeDataDisplayAttributes(),
      mapper, surface, true, false, surfaces);
  }
  else if (auto* glyphMapper = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    if (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0)
    {
      return "its glyphs are clipped";
    }
    if (!AddGlyphs(glyphMapper, glyphs, surface, surfaces))
    {
      return "its glyphs have places that only OpenGL knows";
    }
  }
  else
  {
    auto* outer = vtkDataSetMapper::SafeDownCast(mapper);
    auto* inner = outer ? outer->GetPolyDataMapper() : vtkPolyDataMapper::SafeDownCast(mapper);
    vtkPolyData* mesh = inner ? inner->GetInput() : nullptr;
    if (auto* moved = dynamic_cast<vtkRelievoMovedMesh*>(actor))
    {
      mesh = moved->GetMovedMesh();
    }
    if (!mesh)
    {
      return std::string("a ") + mapper->GetClassName() + " has no surface that is known";
    }
    surface.Mesh = Clip(mesh, mapper, surface.MeshToWorld);
    MapColors(mapper, surface.Mesh, surface);
    surfaces.push_back(surface);
  }
  for (std::size_t i = before; i < surfaces.size(); ++i)
  {
    surfaces[i].Number = static_cast<int>(i - before);
  }
  return "";
}
}
