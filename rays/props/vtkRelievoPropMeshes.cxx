// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPropMeshes.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoCutSurface.h"
#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoMovedMesh.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoPropParts.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstring>
#include <optional>

namespace
{
// How a part casts, and what its blocks inherit.
struct Manner
{
  glm::dmat4 MeshToWorld{ 1.0 };
  double Opacity = 1.0;
  glm::dvec3 Color{ 1.0 };
  vtkMapper* Mapper = nullptr;
  bool Textured = false;    // a texture gives the colours
  bool Overrides = false;   // Color is a block's: it wins over arrays
  bool ArraysKnown = false; // Color is right whatever the mesh has
  bool Visible = true;
  double Reach = 0.0;       // of vtkRelievoPlacedMesh
  bool Translucent = false; // what is translucent casts as well
  bool CullsFront = false;
  bool CullsBack = false;
};

// Numbers that the texture maps to colours have the opacity of these.
bool IsOpaque(vtkTexture* texture)
{
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  if (!texture || !image)
  {
    return !texture;
  }
  const int mode = texture->GetColorMode();
  if (mode == VTK_COLOR_MODE_MAP_SCALARS ||
    (mode == VTK_COLOR_MODE_DEFAULT && image->GetScalarType() != VTK_UNSIGNED_CHAR))
  {
    vtkScalarsToColors* table = texture->GetLookupTable();
    return !table || table->IsOpaque() != 0;
  }
  return image->GetNumberOfScalarComponents() % 2 == 1;
}

// Of an actor that knows what its vertex shader makes of the mesh, and has no other shader code.
vtkRelievoMovedMesh* GetMoved(vtkActor* actor)
{
  auto* moved = dynamic_cast<vtkRelievoMovedMesh*>(actor);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  const bool all = moved && !shaders->HasVertexShaderCode() && !shaders->HasGeometryShaderCode() &&
    !shaders->HasFragmentShaderCode() &&
    shaders->GetNumberOfShaderReplacements() == moved->GetNumberOfMovingReplacements();
  return all ? moved : nullptr;
}

// Whether the actor draws triangles that are known here, all of one opacity.
bool IsSurface(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const bool plain =
    vtkRelievoPlainActor::IsOfClass(actor) && !vtkRelievoPlainActor::HasOwnShaders(actor);
  bool surface = (plain || GetMoved(actor)) && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetVertexVisibility() && (!planes || planes->GetNumberOfItems() == 0) &&
    IsOpaque(actor->GetTexture()) &&
    vtkRelievoCutSurface::GetCutoff(actor->GetPropertyKeys()) <= 0.0;
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

// The array of the data that gives the colours.
vtkAbstractArray* GetColors(vtkMapper* mapper, vtkDataObject* data)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  int cells = 0;
  return set && mapper->GetScalarVisibility()
    ? vtkAbstractMapper::GetAbstractScalars(set, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells)
    : nullptr;
}

// The opacity of an array that is taken for colours as it is; none where it is not one for all.
// Mappers of blocks do not look.
std::optional<double> GetAlpha(vtkMapper* mapper, vtkDataObject* data)
{
  auto* colors = vtkDataArray::SafeDownCast(GetColors(mapper, data));
  const int last = colors ? colors->GetNumberOfComponents() - 1 : 0;
  const bool bytes = vtkUnsignedCharArray::SafeDownCast(colors) != nullptr;
  const bool taken = mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mapper->GetColorMode() == VTK_COLOR_MODE_DEFAULT && bytes);
  if (!taken || (last != 1 && last != 3))
  {
    return 1.0;
  }
  const double* range = colors->GetRange(last);
  return range[0] < range[1] ? std::nullopt
                             : std::optional<double>(range[0] / (bytes ? 255.0 : 1.0));
}

bool HasAlpha(vtkMapper* mapper, vtkDataObject* data)
{
  return GetAlpha(mapper, data) != 1.0;
}

bool AddMesh(vtkPolyData* mesh, const Manner& manner, std::vector<vtkRelievoPlacedMesh>& casters)
{
  if (!mesh || !manner.Visible || !(manner.Opacity > 0.0) ||
    (manner.Opacity < 1.0 && !manner.Translucent))
  {
    return true;
  }
  if (mesh->GetNumberOfVerts() > 0 || mesh->GetNumberOfLines() > 0 ||
    !vtkRelievoMeshTexels::Follows(mesh))
  {
    return false;
  }
  casters.emplace_back();
  vtkRelievoPlacedMesh& caster = casters.back();
  caster.Mesh = mesh;
  caster.MeshToWorld = manner.MeshToWorld;
  caster.Passes = 1.0 - manner.Opacity;
  const bool plain = manner.ArraysKnown || manner.Overrides || !GetColors(manner.Mapper, mesh);
  if (plain && !manner.Textured)
  {
    caster.Color = glm::clamp(manner.Color, 0.0, 1.0);
  }
  caster.Reach = manner.Reach;
  caster.CullsFront = manner.CullsFront;
  caster.CullsBack = manner.CullsBack;
  return true;
}

// Adds the blocks' meshes, with the attributes that VTK's composite mappers hand down to them.
// False if one cannot be followed.
bool AddBlocks(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, Manner manner,
  std::vector<vtkRelievoPlacedMesh>& casters)
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
  if (attributes && attributes->HasBlockColor(data))
  {
    attributes->GetBlockColor(data, &manner.Color.x);
    manner.Overrides = true;
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
  return mesh && !HasAlpha(manner.Mapper, mesh) && AddMesh(mesh, manner, casters);
}

// What the points' data have of colours. False if some are translucent by themselves.
bool FindGlyphColor(vtkGlyph3DMapper* mapper, vtkProperty* property, Manner& manner)
{
  bool colored = false;
  bool opaque = true;
  const auto look = [&](vtkDataObject* points) {
    colored = colored || GetColors(mapper, points);
    opaque = opaque && !HasAlpha(mapper, points);
  };
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkCompositeDataDisplayAttributes* attributes = mapper->GetBlockAttributes();
    colored = attributes && attributes->HasBlockColors();
    auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      look(it->GetCurrentDataObject());
    }
  }
  else
  {
    look(input);
  }
  manner.ArraysKnown = true;
  manner.Color = glm::dvec3(1.0);
  if (!colored)
  {
    property->GetColor(&manner.Color.x); // of glyphs VTK has one colour for all kinds of light
  }
  return opaque;
}

bool AddGlyphs(const std::vector<vtkRelievoGlyphPlaces::Group>& groups, const Manner& manner,
  std::vector<vtkRelievoPlacedMesh>& casters)
{
  for (const vtkRelievoGlyphPlaces::Group& group : groups)
  {
    const std::size_t before = casters.size();
    if (group.Places->empty())
    {
      continue;
    }
    if (!AddMesh(group.Mesh, manner, casters))
    {
      return false;
    }
    for (std::size_t i = before; i < casters.size(); ++i)
    {
      casters[i].Places = group.Places;
    }
  }
  return true;
}

bool AddActor(vtkActor* actor, vtkMatrix4x4* matrix, bool translucent,
  vtkRelievoGlyphPlaces& glyphs, std::vector<vtkRelievoPlacedMesh>& casters)
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
  actor->GetProperty()->GetDiffuseColor(&manner.Color.x);
  manner.Textured = actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0;
  manner.Mapper = mapper;
  manner.CullsFront = actor->GetProperty()->GetFrontfaceCulling() != 0;
  manner.CullsBack = actor->GetProperty()->GetBackfaceCulling() != 0;
  manner.Translucent = translucent;
  if (!(std::abs(glm::determinant(manner.MeshToWorld)) > 0.0) ||
    vtkRelievoIsProjective(matrix ? matrix : actor->GetMatrix()))
  {
    return false; // flattened: no way back from the world; or rays are bent on the way
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
  // Colours with an opacity of their own, by an array or a table.
  const std::optional<double> alpha =
    actor->GetForceOpaque() ? 1.0 : GetAlpha(mapper, mapper->GetInputDataObject(0, 0));
  manner.Opacity *= alpha.value_or(0.0);
  if (!alpha || (manner.Opacity >= 1.0 && !actor->GetForceOpaque() && !actor->HasOpaqueGeometry()))
  {
    return false;
  }
  if (std::strcmp(mapper->GetClassName(), "vtkOpenGLGlyph3DMapper") == 0)
  {
    auto* glyphMapper = static_cast<vtkGlyph3DMapper*>(mapper);
    const auto* groups = glyphs.Find(glyphMapper);
    return groups && FindGlyphColor(glyphMapper, actor->GetProperty(), manner) &&
      AddGlyphs(*groups, manner, casters);
  }
  if (std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") != 0)
  {
    return false;
  }
  vtkPolyData* mesh = static_cast<vtkPolyDataMapper*>(mapper)->GetInput();
  vtkRelievoMovedMesh* moved = GetMoved(actor);
  if (moved && mesh && mesh->GetNumberOfPoints() > 0)
  {
    mesh = moved->GetMovedMesh();
    manner.Reach = moved->GetRoundedReach();
    if (!mesh)
    {
      return false;
    }
  }
  return AddMesh(mesh, manner, casters);
}
}

//------------------------------------------------------------------------------
bool vtkRelievoPropMeshes::Collect(vtkProp* prop, bool translucent, vtkRelievoGlyphPlaces& glyphs,
  std::vector<vtkRelievoPlacedMesh>& casters)
{
  if (vtkLODProp3D::SafeDownCast(prop))
  {
    return false; // one of its parts at a time, by VTK's choice
  }
  std::vector<vtkRelievoPlacedMesh> own;
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
    if (actor && !AddActor(actor, part.Matrix, translucent, glyphs, own))
    {
      return false;
    }
  }
  casters.insert(casters.end(), own.begin(), own.end());
  return true;
}
