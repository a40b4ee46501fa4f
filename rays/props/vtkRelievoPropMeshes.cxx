// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPropMeshes.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
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
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoCutSurface.h"
#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoMeshTree.h"
#include "vtkRelievoMovedMesh.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoPropParts.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace
{
using Wanted = vtkRelievoPropMeshes::Wanted;

// Drawing attributes of a part, inherited by its blocks.
struct Manner
{
  glm::dmat4 MeshToWorld{ 1.0 };
  double Opacity = 1.0;
  glm::dvec3 Color{ 1.0 };
  vtkMapper* Mapper = nullptr;
  bool Textured = false;    // colours come from a texture
  bool Overrides = false;   // Color is a block's: it overrides arrays
  bool ArraysKnown = false; // Color is valid whatever arrays the mesh has
  bool Visible = true;
  double Reach = 0.0; // see vtkRelievoPlacedMesh; 0: that of the mesh alone
  Wanted Meshes = Wanted::Opaque;
  bool OpacityKnown = true; // and constant
  vtkActor* Actor = nullptr;
  int Block = 0;
  bool CullsFront = false;
  bool CullsBack = false;
  vtkIdType* TooMany = nullptr; // number of triangles of a mesh that is left out for its size
};

// Numbers that the texture maps to colours have the opacity of the colours.
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

// The actor's interface, if its vertex shader only moves the mesh in a known way.
vtkRelievoMovedMesh* GetMoved(vtkActor* actor)
{
  auto* moved = dynamic_cast<vtkRelievoMovedMesh*>(actor);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  const bool all = moved && !shaders->HasVertexShaderCode() && !shaders->HasGeometryShaderCode() &&
    !shaders->HasFragmentShaderCode() &&
    shaders->GetNumberOfShaderReplacements() == moved->GetNumberOfMovingReplacements();
  return all ? moved : nullptr;
}

// Whether the actor draws known triangles, of constant opacity unless any opacity is accepted.
bool IsSurface(vtkActor* actor, bool anyOpacity)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const bool plain =
    vtkRelievoPlainActor::IsOfClass(actor) && !vtkRelievoPlainActor::HasOwnShaders(actor);
  bool surface = (plain || GetMoved(actor)) && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetVertexVisibility() && (!planes || planes->GetNumberOfItems() == 0) &&
    (anyOpacity || IsOpaque(actor->GetTexture())) &&
    vtkRelievoCutSurface::GetCutoff(actor->GetPropertyKeys()) <= 0.0;
  for (const auto& named : property->GetAllTextures())
  {
    surface = surface && (anyOpacity || IsOpaque(named.second));
  }
  return surface;
}

// Whether the mapper's colours do not change the opacity.
bool HasOpaqueColors(vtkMapper* mapper)
{
  if (!mapper->GetScalarVisibility())
  {
    return true;
  }
  vtkScalarsToColors* table = mapper->GetLookupTable();
  return !table || table->IsOpaque() != 0;
}

// The data's array of colours.
vtkAbstractArray* GetColors(vtkMapper* mapper, vtkDataObject* data)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  int cells = 0;
  return set && mapper->GetScalarVisibility()
    ? vtkAbstractMapper::GetAbstractScalars(set, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells)
    : nullptr;
}

// The opacity of an array that is used directly as colours; none if it is not constant. Mappers of
// blocks ignore it.
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

// The mappers whose shift of coordinates before rounding to floats is known.
#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
using Shifting = vtkOpenGLPolyDataMapper;
#else
using Shifting = vtkPolyDataMapper;
#endif

// The rule of vtkOpenGLVertexBufferObject for points alone.
bool IsFarOrUnlikeOne(const glm::dvec3& low, const glm::dvec3& high)
{
  const double size = glm::length(high - low);
  const double away = 0.5 * glm::length(low + high);
  return size > 0.0 ? away > 1e3 * size || std::abs(std::log10(size)) > 1.5 : away > 1e3;
}

// The largest coordinate that VTK's buffer of these points holds as a float, in units of the mesh:
// VTK shifts points that are large or far from the origin to their centre. Blocks are shifted
// together.
double GetReach(vtkMapper* mapper, const vtkBoundingBox& points, bool blocks)
{
  using Buffer = vtkOpenGLVertexBufferObject;
  glm::dvec3 low(0.0);
  glm::dvec3 high(0.0);
  if (points.IsValid())
  {
    points.GetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
  }
  const glm::dvec3 half = 0.5 * (high - low);
  const glm::dvec3 most = glm::max(glm::abs(low), glm::abs(high));
  auto* shifting = Shifting::SafeDownCast(mapper);
  const int method = !Buffer::GetGlobalCoordShiftAndScaleEnabled() ? Buffer::DISABLE_SHIFT_SCALE
    : shifting ? shifting->GetVBOShiftScaleMethod()
               : Buffer::AUTO_SHIFT_SCALE;
  bool shifts = method != Buffer::DISABLE_SHIFT_SCALE;
  if (method == Buffer::AUTO_SHIFT_SCALE && !blocks)
  {
    shifts = IsFarOrUnlikeOne(low, high);
  }
  // For blocks, the other methods use one block's centre for all blocks.
  const bool first = blocks && method != Buffer::AUTO_SHIFT_SCALE;
  const glm::dvec3 reach = !shifts ? most : first ? 2.0 * half : half;
  const double largest = std::max({ reach.x, reach.y, reach.z });
  return std::isfinite(largest) ? largest : 0.0; // VTK then draws nothing
}

vtkBoundingBox GetBox(vtkPolyData* mesh)
{
  vtkPoints* points = mesh ? mesh->GetPoints() : nullptr;
  return points && points->GetNumberOfPoints() > 0 ? vtkBoundingBox(points->GetBounds())
                                                   : vtkBoundingBox();
}

double GetReachOfBlocks(vtkRelievoCompositeMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return GetReach(mapper, GetBox(vtkPolyData::SafeDownCast(data)), true);
  }
  vtkBoundingBox box;
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    box.AddBox(GetBox(vtkPolyData::SafeDownCast(it->GetCurrentDataObject())));
  }
  return GetReach(mapper, box, true);
}

bool AddMesh(vtkPolyData* mesh, const Manner& manner, std::vector<vtkRelievoPlacedMesh>& meshes)
{
  if (!mesh || !manner.Visible || !(manner.Opacity > 0.0) ||
    (manner.Opacity < 1.0 && manner.Meshes == Wanted::Opaque))
  {
    return true;
  }
  const bool others = mesh->GetNumberOfVerts() > 0 || mesh->GetNumberOfLines() > 0;
  const bool forShaders = manner.Meshes != Wanted::Geometry;
  const vtkIdType most =
    forShaders ? vtkRelievoMeshTexels::GetMostTriangles() : vtkRelievoMeshTree::MostTriangles;
  const vtkIdType triangles = vtkRelievoPolygonCut::CountTriangles(mesh);
  if (triangles > most && manner.TooMany)
  {
    *manner.TooMany = triangles;
  }
  if ((others && forShaders) || triangles > most)
  {
    return false;
  }
  meshes.emplace_back();
  vtkRelievoPlacedMesh& placed = meshes.back();
  placed.Mesh = mesh;
  placed.MeshToWorld = manner.MeshToWorld;
  placed.Opacity = manner.OpacityKnown ? manner.Opacity : vtkMath::Nan();
  placed.Actor = manner.Actor;
  placed.Block = manner.Block;
  const bool plain = manner.ArraysKnown || manner.Overrides || !GetColors(manner.Mapper, mesh);
  if (plain && !manner.Textured)
  {
    placed.Color = glm::clamp(manner.Color, 0.0, 1.0);
  }
  placed.Reach = manner.Reach > 0.0 ? manner.Reach : GetReach(manner.Mapper, GetBox(mesh), false);
  placed.CullsFront = manner.CullsFront;
  placed.CullsBack = manner.CullsBack;
  return true;
}

// Adds the blocks' meshes, with the attributes inherited by VTK's composite mappers. `index` is the
// flat index of the data, and afterwards of the last block. False if a block is not supported.
bool AddBlocks(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, Manner manner,
  int& index, std::vector<vtkRelievoPlacedMesh>& meshes)
{
  if (!data)
  {
    return true;
  }
  manner.Block = index;
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
    it->SkipEmptyNodesOff();
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      ++index;
      followed =
        followed && AddBlocks(it->GetCurrentDataObject(), attributes, manner, index, meshes);
    }
    return followed;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (manner.Meshes == Wanted::Geometry)
  {
    manner.OpacityKnown = manner.OpacityKnown && !HasAlpha(manner.Mapper, mesh);
    return !mesh || AddMesh(mesh, manner, meshes);
  }
  return mesh && !HasAlpha(manner.Mapper, mesh) && AddMesh(mesh, manner, meshes);
}

// Evaluates the colours of the glyphs' points. False if some points are translucent.
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
    property->GetColor(&manner.Color.x); // VTK uses one colour of glyphs for all kinds of light
  }
  return opaque;
}

bool AddGlyphs(const std::vector<vtkRelievoGlyphPlaces::Group>& groups, const Manner& manner,
  std::vector<vtkRelievoPlacedMesh>& meshes)
{
  for (const vtkRelievoGlyphPlaces::Group& group : groups)
  {
    const std::size_t before = meshes.size();
    if (group.Places->empty())
    {
      continue;
    }
    if (!AddMesh(group.Mesh, manner, meshes))
    {
      return false;
    }
    for (std::size_t i = before; i < meshes.size(); ++i)
    {
      meshes[i].Places = group.Places;
      meshes[i].Points = group.Points;
      meshes[i].Block = group.Block;
    }
  }
  return true;
}

bool AddActor(vtkActor* actor, vtkMatrix4x4* matrix, Wanted wanted, vtkRelievoGlyphPlaces& glyphs,
  std::vector<vtkRelievoPlacedMesh>& meshes, vtkIdType* tooMany)
{
  vtkMapper* mapper = actor->GetMapper();
  const bool anyOpacity = wanted == Wanted::Geometry;
  if (!actor->GetVisibility())
  {
    return true;
  }
  if (!IsSurface(actor, anyOpacity) || (!anyOpacity && !HasOpaqueColors(mapper)))
  {
    return false;
  }
  Manner manner;
  manner.MeshToWorld = vtkRelievoToGlm(matrix ? matrix : actor->GetMatrix());
  // VTK draws forced-opaque actors as opaque, whatever their opacity.
  manner.Opacity = actor->GetForceOpaque() ? 1.0 : actor->GetProperty()->GetOpacity();
  actor->GetProperty()->GetDiffuseColor(&manner.Color.x);
  manner.Textured = actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0;
  manner.Mapper = mapper;
  manner.Actor = actor;
  manner.CullsFront = actor->GetProperty()->GetFrontfaceCulling() != 0;
  manner.CullsBack = actor->GetProperty()->GetBackfaceCulling() != 0;
  manner.Meshes = wanted;
  manner.TooMany = tooMany;
  manner.OpacityKnown =
    !anyOpacity || actor->GetForceOpaque() || (HasOpaqueColors(mapper) && IsSurface(actor, false));
  if (!anyOpacity &&
    (!(std::abs(glm::determinant(manner.MeshToWorld)) > 0.0) ||
      vtkRelievoIsProjective(matrix ? matrix : actor->GetMatrix())))
  {
    return false; // a singular matrix cannot be inverted, and a projective one bends rays
  }
  if (auto* composite = vtkRelievoCompositeMapper::SafeDownCast(mapper))
  {
    if (actor->GetForceOpaque() && !anyOpacity)
    {
      return false; // blocks have different opacities
    }
    manner.Reach = GetReachOfBlocks(composite);
    int index = 0;
    return AddBlocks(composite->GetInputDataObject(0, 0),
      composite->GetCompositeDataDisplayAttributes(), manner, index, meshes);
  }
  if (std::strcmp(mapper->GetClassName(), "vtkDataSetMapper") == 0)
  {
    auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
    return mesh && AddMesh(mesh, manner, meshes);
  }
  // Colours with their own opacity, from an array or a table.
  const std::optional<double> alpha =
    actor->GetForceOpaque() ? 1.0 : GetAlpha(mapper, mapper->GetInputDataObject(0, 0));
  if (anyOpacity)
  {
    manner.OpacityKnown = manner.OpacityKnown && alpha;
    manner.Opacity *= alpha.value_or(1.0);
  }
  else
  {
    manner.Opacity *= alpha.value_or(0.0);
    if (!alpha ||
      (manner.Opacity >= 1.0 && !actor->GetForceOpaque() && !actor->HasOpaqueGeometry()))
    {
      return false;
    }
  }
  if (std::strcmp(mapper->GetClassName(), "vtkOpenGLGlyph3DMapper") == 0)
  {
    auto* glyphMapper = static_cast<vtkGlyph3DMapper*>(mapper);
    const auto* groups = glyphs.Find(glyphMapper);
    const bool opaque = groups && FindGlyphColor(glyphMapper, actor->GetProperty(), manner);
    manner.OpacityKnown = manner.OpacityKnown && opaque;
    return groups && (opaque || anyOpacity) && AddGlyphs(*groups, manner, meshes);
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
  return AddMesh(mesh, manner, meshes);
}
}

//------------------------------------------------------------------------------
double vtkRelievoPropMeshes::GetReach(vtkMapper* mapper, vtkPolyData* mesh)
{
  return ::GetReach(mapper, GetBox(mesh), false);
}

//------------------------------------------------------------------------------
bool vtkRelievoPropMeshes::IsShifted(vtkPolyData* mesh)
{
  const vtkBoundingBox box = GetBox(mesh);
  glm::dvec3 low(0.0);
  glm::dvec3 high(0.0);
  if (box.IsValid())
  {
    box.GetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
  }
  return vtkOpenGLVertexBufferObject::GetGlobalCoordShiftAndScaleEnabled() &&
    IsFarOrUnlikeOne(low, high);
}

//------------------------------------------------------------------------------
double vtkRelievoPropMeshes::GetRoundedReach(const vtkRelievoPlacedMesh& mesh)
{
  double reach = mesh.Reach;
  if (mesh.Places)
  {
    double largest = 0.0;
    for (const glm::dmat4& place : *mesh.Places)
    {
      const double from = glm::length(glm::vec3(place[3]));
      largest = std::max(largest, from + reach * vtkRelievoGetScale(place));
    }
    reach = largest;
  }
  return reach * vtkRelievoGetScale(mesh.MeshToWorld);
}

//------------------------------------------------------------------------------
bool vtkRelievoPropMeshes::Collect(vtkProp* prop, Wanted wanted, vtkRelievoGlyphPlaces& glyphs,
  std::vector<vtkRelievoPlacedMesh>& meshes, vtkIdType* tooMany)
{
  if (vtkLODProp3D::SafeDownCast(prop))
  {
    return false; // VTK draws one of its parts at a time, by its own choice
  }
  std::vector<vtkRelievoPlacedMesh> own;
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part);
    if (actor && !AddActor(actor, part.Matrix, wanted, glyphs, own, tooMany))
    {
      return false;
    }
  }
  meshes.insert(meshes.end(), own.begin(), own.end());
  return true;
}
