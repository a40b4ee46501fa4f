// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCasterFollow.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoPropParts.h"
#include "vtkRelievoView.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"

#include <cmath>
#include <cstring>

namespace
{
// How a part casts, and what its blocks inherit.
struct Manner
{
  glm::dmat4 MeshToWorld{ 1.0 };
  double Opacity = 1.0;
  bool Visible = true;
  bool Translucent = false; // what is translucent casts as well
  bool CullsFront = false;
  bool CullsBack = false;
};

bool IsOpaque(vtkTexture* texture)
{
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  return !texture || (image && image->GetNumberOfScalarComponents() % 2 == 1);
}

// Whether the actor draws its mapper's triangles as they are, all of one opacity.
bool IsSurface(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  bool surface = vtkRelievoCasterDraw::IsPlainClass(actor) &&
    !vtkRelievoCasterDraw::HasOwnShaders(actor) && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetVertexVisibility() && (!planes || planes->GetNumberOfItems() == 0) &&
    IsOpaque(actor->GetTexture());
  for (const auto& named : property->GetAllTextures())
  {
    surface = surface && IsOpaque(named.second);
  }
  return surface;
}

// Of data with these colours: whether they leave the opacity alone.
bool HasOpaqueColors(vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility())
  {
    return true;
  }
  vtkScalarsToColors* table = mapper->GetLookupTable();
  return !table || table->IsOpaque() != 0;
}

bool AddMesh(vtkPolyData* mesh, const Manner& manner, std::vector<vtkRelievoCaster>& casters)
{
  if (!mesh || !manner.Visible || (manner.Opacity < 1.0 && !manner.Translucent))
  {
    return true;
  }
  if (mesh->GetNumberOfVerts() > 0 || mesh->GetNumberOfLines() > 0 ||
    !vtkRelievoCasterMesh::Follows(mesh))
  {
    return false;
  }
  casters.push_back(
    { mesh, manner.MeshToWorld, 1.0 - manner.Opacity, manner.CullsFront, manner.CullsBack });
  return true;
}

// As VTK's composite mappers hand their attributes down.
bool AddBlocks(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, Manner manner,
  std::vector<vtkRelievoCaster>& casters)
{
  if (!data)
  {
    return true;
  }
  if (attributes && attributes->HasBlockVisibility(data))
  {
    manner.Visible = attributes->GetBlockVisibility(data);
  }
  if (attributes && attributes->HasBlockOpacity(data))
  {
    manner.Opacity = attributes->GetBlockOpacity(data);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    bool followed = true;
    auto it = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    it->VisitOnlyLeavesOff();
    it->TraverseSubTreeOff();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      followed = followed && AddBlocks(it->GetCurrentDataObject(), attributes, manner, casters);
    }
    return followed;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && AddMesh(mesh, manner, casters);
}

bool AddActor(
  vtkActor* actor, vtkMatrix4x4* matrix, bool translucent, std::vector<vtkRelievoCaster>& casters)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!actor->GetVisibility())
  {
    return true;
  }
  if (!IsSurface(actor) || !HasOpaqueColors(mapper))
  {
    return false;
  }
  Manner manner;
  manner.MeshToWorld = vtkRelievoToGlm(matrix ? matrix : actor->GetMatrix());
  // VTK draws what is forced to be opaque as such, whatever its opacity.
  manner.Opacity = actor->GetForceOpaque() ? 1.0 : actor->GetProperty()->GetOpacity();
  manner.CullsFront = actor->GetProperty()->GetFrontfaceCulling() != 0;
  manner.CullsBack = actor->GetProperty()->GetBackfaceCulling() != 0;
  manner.Translucent = translucent;
  if (!(std::abs(glm::determinant(manner.MeshToWorld)) > 0.0))
  {
    return false; // flattened: no way back from the world
  }
  if (auto* composite = vtkRelievoCompositeMapper::SafeDownCast(mapper))
  {
    if (actor->GetForceOpaque())
    {
      return false; // blocks have opacities of their own
    }
    return AddBlocks(composite->GetInputDataObject(0, 0),
      composite->GetCompositeDataDisplayAttributes(), manner, casters);
  }
  if (std::strcmp(mapper->GetClassName(), "vtkDataSetMapper") == 0)
  {
    auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
    return mesh && AddMesh(mesh, manner, casters);
  }
  if (std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") != 0)
  {
    return false;
  }
  // Colours with an opacity of their own, by an array or a table.
  const bool own = manner.Opacity >= 1.0 && !actor->GetForceOpaque() && !actor->HasOpaqueGeometry();
  return !own && AddMesh(static_cast<vtkPolyDataMapper*>(mapper)->GetInput(), manner, casters);
}
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterFollow::Collect(
  vtkProp* prop, bool translucent, std::vector<vtkRelievoCaster>& casters)
{
  if (vtkLODProp3D::SafeDownCast(prop))
  {
    return false; // one of its parts at a time, by VTK's choice
  }
  std::vector<vtkRelievoCaster> own;
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
    if (actor && !AddActor(actor, part.Matrix, translucent, own))
    {
      return false;
    }
  }
  casters.insert(casters.end(), own.begin(), own.end());
  return true;
}
