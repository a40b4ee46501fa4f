// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BaselineRecord.h"

#include "DataSets.h"
#include "Numbers.h"
#include "Version.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkCornerAnnotation.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkRelievoColorBar.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoFrameComparison.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkStringArray.h"
#include "vtkTextActor.h"
#include "vtkTextMapper.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace scene
{
namespace
{
using Json = nlohmann::ordered_json;

// The 64-bit hash FNV-1a by Fowler, Noll and Vo (1991).
class CheckSum
{
public:
  void Add(const void* bytes, std::size_t count)
  {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Sum = (this->Sum ^ at[i]) * 0x100000001b3ULL;
    }
  }
  std::string Get() const
  {
    char digits[17];
    std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(this->Sum));
    return digits;
  }

private:
  std::uint64_t Sum = 0xcbf29ce484222325ULL;
};

// Counts and sums that identify the mesh of an actor.
struct MeshRecord
{
  vtkIdType Points = 0, Cells = 0;
  vtkIdType Placed = 0; // points whose coordinates are finite
  CheckSum PointSum, CellSum;
  std::array<double, 3> Center{}; // sum of the points
  double Products[3][3] = {};     // sums of products of coordinates

  // The mean of (p - center) (p - center)^T, which a translation of all points does not change.
  std::array<double, 9> GetSpread() const
  {
    const double count = std::max<double>(1.0, double(this->Placed));
    std::array<double, 9> spread{};
    for (std::size_t i = 0; i < 9; ++i)
    {
      spread[i] = this->Products[i / 3][i % 3] / count -
        this->Center[i / 3] * this->Center[i % 3] / (count * count);
    }
    return spread;
  }

  void AddToMeans(const double point[3])
  {
    ++this->Placed;
    for (int c = 0; c < 3; ++c)
    {
      this->Center[static_cast<std::size_t>(c)] += point[c];
      for (int k = 0; k < 3; ++k)
      {
        this->Products[c][k] += point[c] * point[k];
      }
    }
  }

  void AddCells(vtkCellArray* cells)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    const auto each = vtk::TakeSmartPointer(cells->NewIterator());
    for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
    {
      each->GetCurrentCell(size, ids);
      this->CellSum.Add(&size, sizeof(size));
      this->CellSum.Add(ids, static_cast<std::size_t>(size) * sizeof(vtkIdType));
    }
  }

  void Add(vtkDataSet* data)
  {
    const vtkIdType points = data->GetNumberOfPoints();
    for (vtkIdType i = 0; i < points; ++i)
    {
      double point[3];
      data->GetPoint(i, point);
      for (int c = 0; c < 3; ++c)
      {
        point[c] += 0.0; // turns -0 into 0
      }
      this->PointSum.Add(point, sizeof(point));
      // NaN and infinity have no mean, and JSON cannot represent them.
      if (std::all_of(point, point + 3, [](double each) { return std::isfinite(each); }))
      {
        this->AddToMeans(point);
      }
    }
    this->Points += points;
    this->Cells += data->GetNumberOfCells();
    if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(data))
    {
      for (vtkCellArray* cells :
        { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
      {
        this->AddCells(cells);
      }
    }
    else if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data))
    {
      if (vtkCellArray* cells = grid->GetCells())
      {
        this->AddCells(cells);
      }
    }
  }
};

void AddStrings(vtkImageData* image, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  image->GetFieldData()->AddArray(array);
}

std::string Write(const Json& json)
{
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json DescribeVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

// A colour that vtkProperty::SetColor also sets; null if it is the surface's own, which is recorded
// apart.
Json DescribeOtherColor(vtkProperty* property, const double color[3])
{
  const double* own = property->GetDiffuseColor();
  return std::equal(own, own + 3, color) ? Json() : DescribeVector(color);
}

Json DescribeProperty(vtkProperty* property)
{
  return { { "representation", property->GetRepresentation() },
    { "interpolation", property->GetInterpolation() }, { "ambient", property->GetAmbient() },
    { "ambient_color", DescribeOtherColor(property, property->GetAmbientColor()) },
    { "diffuse", property->GetDiffuse() }, { "specular", property->GetSpecular() },
    { "specular_color", DescribeOtherColor(property, property->GetSpecularColor()) },
    { "specular_power", property->GetSpecularPower() }, { "metallic", property->GetMetallic() },
    { "roughness", property->GetRoughness() }, { "anisotropy", property->GetAnisotropy() },
    { "anisotropy_rotation", property->GetAnisotropyRotation() },
    { "base_ior", property->GetBaseIOR() },
    { "edge_tint", DescribeVector(property->GetEdgeTint()) },
    { "coat_strength", property->GetCoatStrength() },
    { "coat_roughness", property->GetCoatRoughness() }, { "coat_ior", property->GetCoatIOR() },
    { "coat_color", DescribeVector(property->GetCoatColor()) },
    { "coat_normal_scale", property->GetCoatNormalScale() },
    { "emissive_factor", DescribeVector(property->GetEmissiveFactor()) },
    { "occlusion_strength", property->GetOcclusionStrength() },
    { "opacity", property->GetOpacity() }, { "edges", property->GetEdgeVisibility() != 0 },
    { "edge_color", DescribeVector(property->GetEdgeColor()) },
    { "vertices", property->GetVertexVisibility() != 0 },
    { "vertex_color", DescribeVector(property->GetVertexColor()) },
    { "line_width", property->GetLineWidth() }, { "point_size", property->GetPointSize() },
    { "lines_as_tubes", property->GetRenderLinesAsTubes() },
    { "points_as_spheres", property->GetRenderPointsAsSpheres() },
    { "lighting", property->GetLighting() }, { "normal_scale", property->GetNormalScale() },
    { "frontface_culling", property->GetFrontfaceCulling() != 0 },
    { "backface_culling", property->GetBackfaceCulling() != 0 } };
}

// The check sum of a texture's texels; empty without any.
std::string DescribeMap(vtkTexture* map)
{
  vtkImageData* image = map ? map->GetInput() : nullptr;
  vtkDataArray* texels = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!texels)
  {
    return {};
  }
  CheckSum sum;
  sum.Add(image->GetDimensions(), 3 * sizeof(int));
  sum.Add(texels->GetVoidPointer(0),
    static_cast<std::size_t>(texels->GetNumberOfValues()) *
      static_cast<std::size_t>(texels->GetDataTypeSize()));
  return sum.Get();
}

// The origin and the normal of each clipping plane.
Json DescribePlanes(vtkAbstractMapper* mapper)
{
  Json planes = Json::array();
  vtkPlaneCollection* all = mapper ? mapper->GetClippingPlanes() : nullptr;
  for (int i = 0; all && i < all->GetNumberOfItems(); ++i)
  {
    const double* origin = all->GetItem(i)->GetOrigin();
    const double* normal = all->GetItem(i)->GetNormal();
    planes.push_back({ origin[0], origin[1], origin[2], normal[0], normal[1], normal[2] });
  }
  return planes;
}

// Adds the nodes of a transfer function to a check sum.
template <typename Function>
void AddNodes(CheckSum& sum, Function* function)
{
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double node[6] = {}; // of opacities four values
    function->GetNodeValue(i, node);
    sum.Add(node, sizeof(node));
  }
}

// Adds a grey transfer function with the nodes of a grey colour function, into which VTK turns the
// default when it draws a volume.
void AddGrayNodes(CheckSum& sum, vtkPiecewiseFunction* function)
{
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double at[4];
    function->GetNodeValue(i, at);
    const double node[6] = { at[0], at[1], at[1], at[1], at[2], at[3] };
    sum.Add(node, sizeof(node));
  }
}

// Whether a function is 1 everywhere. VTK adds such a gradient opacity when it draws a volume.
bool IsOne(vtkPiecewiseFunction* function)
{
  bool isOne = true;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    isOne = isOne && node[1] == 1.0;
  }
  return isOne;
}

// Describes the colours of a map: 256 of them, across its range.
std::string DescribeColors(vtkScalarsToColors* map)
{
  CheckSum sum;
  const double* range = map->GetRange();
  for (int i = 0; i < 256; ++i)
  {
    const double value = range[0] + (range[1] - range[0]) * i / 255.0;
    sum.Add(map->MapValue(value), 4);
  }
  return sum.Get();
}

vtkAbstractArray* FindScalars(vtkMapper* mapper, vtkDataSet* data, int& isCell)
{
  return vtkMapper::GetAbstractScalars(data, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
    mapper->GetArrayId(), mapper->GetArrayName(), isCell);
}

// Describes the blocks of composite data with attributes of their own. `index` is the flat index of
// the data, and afterwards of its last block.
void AddBlocks(Json& blocks, vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes,
  const std::string& name, int& index)
{
  Json block = { { "block", index } };
  if (!name.empty())
  {
    block["name"] = name;
  }
  if (attributes->HasBlockVisibility(data))
  {
    block["visible"] = attributes->GetBlockVisibility(data);
  }
  if (attributes->HasBlockOpacity(data))
  {
    block["opacity"] = attributes->GetBlockOpacity(data);
  }
  if (attributes->HasBlockColor(data))
  {
    double color[3];
    attributes->GetBlockColor(data, color);
    block["color"] = DescribeVector(color);
  }
  if (block.size() > (name.empty() ? 1 : 2))
  {
    blocks.push_back(block);
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return;
  }
  const auto each = vtk::TakeSmartPointer(tree->NewTreeIterator());
  each->VisitOnlyLeavesOff();
  each->TraverseSubTreeOff();
  each->SkipEmptyNodesOff();
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    ++index;
    if (vtkDataObject* part = each->GetCurrentDataObject())
    {
      vtkInformation* about = each->HasCurrentMetaData() ? each->GetCurrentMetaData() : nullptr;
      const char* named = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
      AddBlocks(blocks, part, attributes, named ? named : "", index);
    }
  }
}

Json DescribeBlocks(vtkMapper* mapper)
{
  auto* composite = vtkRelievoCompositeMapper::SafeDownCast(mapper);
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  vtkCompositeDataDisplayAttributes* attributes = composite
    ? composite->GetCompositeDataDisplayAttributes()
    : glyphs ? glyphs->GetBlockAttributes()
             : nullptr;
  Json blocks = Json::array();
  if (attributes && mapper->GetNumberOfInputConnections(0) > 0)
  {
    int index = 0;
    AddBlocks(blocks, mapper->GetInputDataObject(0, 0), attributes, "", index);
  }
  return blocks;
}

// Adds the names and values of the arrays that scale, choose, mask and orient glyphs.
void AddPlacingArrays(CheckSum& sum, vtkGlyph3DMapper* mapper, vtkDataSet* data)
{
  const std::pair<int, bool> uses[] = { { vtkGlyph3DMapper::SCALE,
                                          mapper->GetScaling() && mapper->GetScaleMode() != 0 },
    { vtkGlyph3DMapper::SOURCE_INDEX, mapper->GetSourceIndexing() != 0 },
    { vtkGlyph3DMapper::MASK, mapper->GetMasking() != 0 },
    { vtkGlyph3DMapper::ORIENTATION, mapper->GetOrient() != 0 } };
  for (const auto& [index, isUsed] : uses)
  {
    vtkInformation* chosen = isUsed ? mapper->GetInputArrayInformation(index) : nullptr;
    vtkDataArray* array = nullptr;
    if (chosen && chosen->Has(vtkDataObject::FIELD_NAME()))
    {
      array = data->GetPointData()->GetArray(chosen->Get(vtkDataObject::FIELD_NAME()));
    }
    else if (chosen && chosen->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
    {
      array =
        data->GetPointData()->GetAttribute(chosen->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
    }
    const std::string name = array && array->GetName() ? array->GetName() : "";
    sum.Add(&index, sizeof(index));
    sum.Add(name.c_str(), name.size());
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double value = array->GetComponent(i, c);
        sum.Add(&value, sizeof(value));
      }
    }
  }
}

// The check sum of the shapes of glyphs, and of how they are placed at the points.
std::string DescribeGlyphs(vtkGlyph3DMapper* mapper)
{
  MeshRecord sources;
  const int ports =
    mapper->GetNumberOfInputPorts() > 1 ? mapper->GetNumberOfInputConnections(1) : 0;
  for (int i = 0; i < ports; ++i)
  {
    if (vtkDataObject* source = mapper->GetInputDataObject(1, i))
    {
      ForEachDataSet(source, [&](vtkDataSet* data) { sources.Add(data); });
    }
  }
  CheckSum placing;
  const double values[] = { double(mapper->GetScaling()), mapper->GetScaleFactor(),
    double(mapper->GetScaleMode()), mapper->GetRange()[0], mapper->GetRange()[1],
    double(mapper->GetClamping()), double(mapper->GetOrient()),
    double(mapper->GetOrientationMode()), double(mapper->GetMasking()),
    double(mapper->GetSourceIndexing()) };
  placing.Add(values, sizeof(values));
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    ForEachDataSet(mapper->GetInputDataObject(0, 0),
      [&](vtkDataSet* data) { AddPlacingArrays(placing, mapper, data); });
  }
  return sources.PointSum.Get() + " " + sources.CellSum.Get() + " " + placing.Get();
}

Json DescribeActor(vtkActor* actor, const std::string& name)
{
  MeshRecord mesh;
  bool isColored = false; // by an array
  vtkMapper* mapper = actor->GetMapper();
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
    ForEachDataSet(mapper->GetInputDataObject(0, 0), [&](vtkDataSet* data) {
      int isCell = 0;
      isColored = isColored || (mapper->GetScalarVisibility() && FindScalars(mapper, data, isCell));
      mesh.Add(data);
    });
  }
  vtkNew<vtkMatrix4x4> matrix;
  actor->GetMatrix(matrix);
  const double count = mesh.Placed > 0 ? double(mesh.Placed) : 1.0;
  double center[4] = { mesh.Center[0] / count, mesh.Center[1] / count, mesh.Center[2] / count,
    1.0 };
  matrix->MultiplyPoint(center, center);
  std::array<double, 6> bounds = { 1., -1., 1., -1., 1., -1. };
  const double* found = actor->GetBounds();
  if (found && std::all_of(found, found + 6, [](double each) { return std::isfinite(each); }))
  {
    std::copy(found, found + 6, bounds.begin());
  }
  Json rows = Json::array();
  for (int i = 0; i < 16; ++i)
  {
    rows.push_back(matrix->GetElement(i / 4, i % 4));
  }
  vtkProperty* property = actor->GetProperty();
  Json json = { { "name", name }, { "visible", actor->GetVisibility() != 0 },
    { "translucent", actor->HasTranslucentPolygonalGeometry() != 0 }, { "matrix", rows },
    { "points", std::to_string(mesh.Points) + " " + mesh.PointSum.Get() },
    { "cells", std::to_string(mesh.Cells) + " " + mesh.CellSum.Get() },
    { "center", { center[0], center[1], center[2] } }, { "spread", mesh.GetSpread() },
    { "bounds", bounds }, { "clipping", DescribePlanes(mapper) },
    { "blocks", DescribeBlocks(mapper) },
    { "normal_map", property->GetTexture("normalTex") != nullptr },
    { "normal_map_sum", DescribeMap(property->GetTexture("normalTex")) },
    { "settings", DescribeProperty(property) } };
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    json["glyphs"] = DescribeGlyphs(glyphs);
  }
  if (!isColored)
  {
    json["color"] = DescribeVector(property->GetDiffuseColor());
  }
  return json;
}

// Adds the points of a volume's data to a check sum.
void AddPlace(CheckSum& sum, vtkDataSet* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    sum.Add(image->GetExtent(), 6 * sizeof(int));
    sum.Add(image->GetOrigin(), 3 * sizeof(double));
    sum.Add(image->GetSpacing(), 3 * sizeof(double));
    sum.Add(image->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
    return;
  }
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    sum.Add(point, sizeof(point));
  }
}

// Describes a volume by its place and by check sums of its data, transfer functions and shading.
Json DescribeVolume(vtkVolume* volume)
{
  CheckSum points, data;
  std::string array;
  int components = 1;
  auto* mapper = vtkAbstractVolumeMapper::SafeDownCast(volume->GetMapper());
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
    ForEachDataSet(mapper->GetInputDataObject(0, 0), [&](vtkDataSet* part) {
      int isCell = 0;
      AddPlace(points, part);
      vtkDataArray* values = vtkAbstractVolumeMapper::GetScalars(part, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isCell);
      components = std::max(components, values ? values->GetNumberOfComponents() : 1);
      array = values && values->GetName() ? values->GetName() : "";
      for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
        {
          const double value = values->GetComponent(i, c);
          data.Add(&value, sizeof(value));
        }
      }
    });
  }
  CheckSum colors, opacities, gradients, shading;
  vtkVolumeProperty* property = volume->GetProperty();
  const double distance = property->GetScalarOpacityUnitDistance();
  opacities.Add(&distance, sizeof(distance));
  const double values[] = { double(property->GetInterpolationType()), double(property->GetShade()),
    property->GetAmbient(), property->GetDiffuse(), property->GetSpecular(),
    property->GetSpecularPower() };
  shading.Add(values, sizeof(values));
  const int functionsOf = property->GetIndependentComponents() ? components : 1;
  for (int c = 0; c < std::min(functionsOf, VTK_MAX_VRCOMP); ++c)
  {
    AddNodes(opacities, property->GetScalarOpacity(c));
    // Requesting the other kind would change the volume.
    property->GetColorChannels(c) == 1 ? AddGrayNodes(colors, property->GetGrayTransferFunction(c))
                                       : AddNodes(colors, property->GetRGBTransferFunction(c));
    if (property->HasGradientOpacity(c) && !property->GetDisableGradientOpacity(c) &&
      !IsOne(property->GetGradientOpacity(c)))
    {
      gradients.Add(&c, sizeof(c));
      AddNodes(gradients, property->GetGradientOpacity(c));
    }
  }
  Json rows = Json::array();
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  for (int i = 0; i < 16; ++i)
  {
    rows.push_back(matrix->GetElement(i / 4, i % 4));
  }
  Json json = { { "visible", volume->GetVisibility() != 0 }, { "matrix", rows },
    { "points", points.Get() }, { "array", array }, { "data", data.Get() },
    { "colors", colors.Get() }, { "opacity", opacities.Get() },
    { "gradient_opacity", gradients.Get() }, { "shading", shading.Get() },
    { "clipping", DescribePlanes(mapper) } };
  if (const double* bounds = volume->GetBounds())
  {
    json["bounds"] = std::vector<double>(bounds, bounds + 6);
  }
  return json;
}

std::vector<std::string> DescribeVolumes(vtkRenderer* renderer)
{
  std::vector<std::string> volumes;
  vtkCollectionSimpleIterator at;
  vtkVolumeCollection* all = renderer->GetVolumes();
  all->InitTraversal(at);
  while (vtkVolume* volume = vtkVolume::SafeDownCast(all->GetNextItemAsObject(at)))
  {
    volumes.push_back(Write(DescribeVolume(volume)));
  }
  return volumes;
}

// Describes an overlay's content, for known classes.
Json DescribeOverlay(vtkActor2D* actor)
{
  Json json = { { "kind", actor->GetClassName() } };
  const double* at = actor->GetPositionCoordinate()->GetValue();
  const double* to = actor->GetPosition2Coordinate()->GetValue();
  json["place"] = { at[0], at[1], to[0], to[1] };
  const double* color = actor->GetProperty()->GetColor();
  json["color"] = { color[0], color[1], color[2], actor->GetProperty()->GetOpacity() };
  const auto addFont = [&json](vtkTextProperty* font) {
    const double* ink = font->GetColor();
    json["font"] = { { "size", font->GetFontSize() }, { "family", font->GetFontFamily() },
      { "bold", font->GetBold() != 0 }, { "italic", font->GetItalic() != 0 },
      { "color", { ink[0], ink[1], ink[2], font->GetOpacity() } } };
  };
  const auto getText = [](const char* text) { return std::string(text ? text : ""); };
  if (auto* text = vtkTextActor::SafeDownCast(actor))
  {
    json["kind"] = "text";
    json["text"] = getText(text->GetInput());
    addFont(text->GetTextProperty());
  }
  else if (auto* own = vtkRelievoColorBar::SafeDownCast(actor))
  {
    json["kind"] = "scalar bar";
    json["text"] = own->GetTitle() + " " + own->GetUnit();
    if (vtkScalarsToColors* map = own->GetLookupTable())
    {
      json["range"] = { map->GetRange()[0], map->GetRange()[1] };
      json["colors"] = DescribeColors(map);
    }
  }
  else if (auto* bar = vtkScalarBarActor::SafeDownCast(actor))
  {
    json["kind"] = "scalar bar";
    json["text"] = getText(bar->GetTitle());
    json["labels"] = bar->GetNumberOfLabels();
    if (vtkScalarsToColors* map = bar->GetLookupTable())
    {
      const double* range = map->GetRange();
      json["range"] = { range[0], range[1] };
      json["colors"] = DescribeColors(map);
    }
    addFont(bar->GetLabelTextProperty());
  }
  else if (auto* corners = vtkCornerAnnotation::SafeDownCast(actor))
  {
    json["kind"] = "corner text";
    json["text"] = Json::array();
    for (int i = 0; i < 8; ++i)
    {
      json["text"].push_back(getText(corners->GetText(i)));
    }
    addFont(corners->GetTextProperty());
  }
  else if (auto* label = vtkTextMapper::SafeDownCast(actor->GetMapper()))
  {
    json["kind"] = "text";
    json["text"] = getText(label->GetInput());
    addFont(label->GetTextProperty());
  }
  return json;
}

std::vector<std::string> DescribeOverlays(vtkRenderer* renderer)
{
  std::vector<std::string> overlays;
  vtkCollectionSimpleIterator at;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at))
  {
    auto* actor = vtkActor2D::SafeDownCast(prop);
    if (actor && actor->GetVisibility())
    {
      overlays.push_back(Write(DescribeOverlay(actor)));
    }
  }
  std::sort(overlays.begin(), overlays.end()); // order matters only where they overlap
  return overlays;
}

bool HasRun(vtkRelievoStage* stage)
{
  return stage->GetReasonCode() == "ran";
}

std::vector<std::string> DescribeSettings(vtkRenderer* renderer)
{
  std::vector<std::string> settings;
  const auto addColor = [&](const char* name, const double* color) {
    settings.push_back(std::string(name) + "=" + WriteNumbers({ color[0], color[1], color[2] }));
  };
  addColor("background", renderer->GetBackground());
  if (renderer->GetGradientBackground())
  {
    addColor("background_top", renderer->GetBackground2());
  }
  addColor("ambient_light", renderer->GetAmbient());
  settings.push_back(
    "multisamples=" + std::to_string(renderer->GetRenderWindow()->GetMultiSamples()));
  settings.push_back(
    std::string("environment=") + (renderer->GetUseImageBasedLighting() ? "on" : "off"));
  auto* pass = vtkRelievoPass::SafeDownCast(renderer->GetPass());
  for (int i = 0; pass && i < pass->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = pass->GetStage(i);
    for (int p = 0; HasRun(stage) && p < stage->GetNumberOfParameters(); ++p)
    {
      const std::string name = stage->GetParameterName(p);
      settings.push_back(stage->GetStageName() + ":" + name + "=" + stage->GetParameter(name));
    }
  }
  return settings;
}
}

//------------------------------------------------------------------------------
bool HasVolumeLayers(vtkRenderer* renderer)
{
  vtkVolumeCollection* all = renderer->GetVolumes();
  bool isAll = all->GetNumberOfItems() > 0;
  vtkCollectionSimpleIterator at;
  all->InitTraversal(at);
  while (vtkVolume* volume = vtkVolume::SafeDownCast(all->GetNextItemAsObject(at)))
  {
    auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
    auto* smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
    const bool isOnGPU = smart
      ? smart->GetRequestedRenderMode() == vtkSmartVolumeMapper::DefaultRenderMode ||
        smart->GetRequestedRenderMode() == vtkSmartVolumeMapper::GPURenderMode
      : vtkGPUVolumeRayCastMapper::SafeDownCast(mapper) != nullptr;
    const int mode = mapper ? mapper->GetBlendMode() : -1;
    isAll = isAll && isOnGPU && !volume->IsA("vtkMultiVolume") &&
      (mode == vtkVolumeMapper::COMPOSITE_BLEND ||
        mode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ||
        mode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND);
  }
  return isAll;
}

//------------------------------------------------------------------------------
std::set<std::string> FindColoringArrays(vtkRenderer* renderer)
{
  std::set<std::string> names;
  vtkCollectionSimpleIterator at;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    vtkMapper* mapper = actor->GetMapper();
    vtkDataObject* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
      ? mapper->GetInputDataObject(0, 0)
      : nullptr;
    if (!data || !mapper->GetScalarVisibility() || !actor->GetVisibility() ||
      actor->HasTranslucentPolygonalGeometry())
    {
      continue;
    }
    ForEachDataSet(data, [&](vtkDataSet* part) {
      int isCell = 0;
      auto* array = vtkDataArray::SafeDownCast(FindScalars(mapper, part, isCell));
      const std::string name = array && array->GetName() ? array->GetName() : "";
      if (!name.empty() && array->GetDataType() != VTK_UNSIGNED_CHAR && isCell < 2 &&
        !vtkRelievoLayerCatalogue::GetIsLayer(name))
      {
        names.insert(name);
      }
    });
  }
  return names;
}

//------------------------------------------------------------------------------
void AddRecord(vtkImageData* image, vtkRenderer* renderer, const std::map<int, std::string>& names)
{
  vtkNew<vtkIntArray> version;
  version->SetName("baseline_version");
  version->InsertNextValue(vtkRelievoFrameComparison::GetRecordVersion());
  image->GetFieldData()->AddArray(version);
  std::vector<std::string> objects;
  vtkCollectionSimpleIterator at;
  vtkActorCollection* actors = renderer->GetActors(); // rebuilt by each call
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    const auto name = names.find(static_cast<int>(objects.size()));
    objects.push_back(
      Write(DescribeActor(actor, name == names.end() ? std::string() : name->second)));
  }
  AddStrings(image, "objects", objects);
  AddStrings(image, "volumes", DescribeVolumes(renderer));
  AddStrings(image, "overlays", DescribeOverlays(renderer));
  AddStrings(image, "settings", DescribeSettings(renderer));
  AddStrings(image, "versions", ListVersions(renderer->GetRenderWindow()));
}
}
