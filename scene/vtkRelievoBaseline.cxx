// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBaseline.h"

#include "Baseline.h"
#include "DataSets.h"
#include "Lens.h"
#include "Numbers.h"
#include "Version.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkActorCollection.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkColorTransferFunction.h"
#include "vtkCornerAnnotation.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoColorBar.h"
#include "vtkRelievoComparisonReport.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoFrameComparison.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoRayLayers.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageDescription.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkStringArray.h"
#include "vtkTextActor.h"
#include "vtkTextMapper.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoBaseline);

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

Json DescribeProperty(vtkProperty* property)
{
  return { { "representation", property->GetRepresentation() },
    { "interpolation", property->GetInterpolation() }, { "ambient", property->GetAmbient() },
    { "diffuse", property->GetDiffuse() }, { "specular", property->GetSpecular() },
    { "specular_power", property->GetSpecularPower() }, { "metallic", property->GetMetallic() },
    { "roughness", property->GetRoughness() }, { "opacity", property->GetOpacity() },
    { "edges", property->GetEdgeVisibility() != 0 }, { "line_width", property->GetLineWidth() },
    { "point_size", property->GetPointSize() }, { "lighting", property->GetLighting() },
    { "normal_scale", property->GetNormalScale() },
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

Json DescribeActor(vtkActor* actor, const std::string& name)
{
  MeshRecord mesh;
  bool isColored = false; // by an array
  vtkMapper* mapper = actor->GetMapper();
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
    scene::ForEachDataSet(mapper->GetInputDataObject(0, 0), [&](vtkDataSet* data) {
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
    { "normal_map", property->GetTexture("normalTex") != nullptr },
    { "normal_map_sum", DescribeMap(property->GetTexture("normalTex")) },
    { "settings", DescribeProperty(property) } };
  if (!isColored)
  {
    const double* color = property->GetDiffuseColor();
    json["color"] = { color[0], color[1], color[2] };
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

// Describes a volume by its place and by check sums of its data and transfer functions.
Json DescribeVolume(vtkVolume* volume)
{
  CheckSum data;
  auto* mapper = vtkAbstractVolumeMapper::SafeDownCast(volume->GetMapper());
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
    scene::ForEachDataSet(mapper->GetInputDataObject(0, 0), [&](vtkDataSet* part) {
      int isCell = 0;
      AddPlace(data, part);
      vtkDataArray* values = vtkAbstractVolumeMapper::GetScalars(part, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isCell);
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
  CheckSum functions;
  vtkVolumeProperty* property = volume->GetProperty();
  const double range[] = { double(property->GetInterpolationType()), double(property->GetShade()),
    property->GetAmbient(), property->GetDiffuse(), property->GetSpecular(),
    property->GetSpecularPower(), property->GetScalarOpacityUnitDistance() };
  functions.Add(range, sizeof(range));
  AddNodes(functions, property->GetScalarOpacity());
  AddNodes(functions, property->GetRGBTransferFunction());
  Json rows = Json::array();
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  for (int i = 0; i < 16; ++i)
  {
    rows.push_back(matrix->GetElement(i / 4, i % 4));
  }
  Json json = { { "visible", volume->GetVisibility() != 0 }, { "matrix", rows },
    { "data", data.Get() }, { "functions", functions.Get() },
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
    settings.push_back(
      std::string(name) + "=" + scene::WriteNumbers({ color[0], color[1], color[2] }));
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

// Text for an element of XML.
std::string Escape(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  }
  return escaped;
}

// The arrays that colour actors through a colour map; bytes are colours themselves.
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
    scene::ForEachDataSet(data, [&](vtkDataSet* part) {
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

// Layers of stages that identify causes.
std::vector<std::string> FindStageLayers(vtkRelievoPass* pass)
{
  std::vector<std::string> layers;
  for (int i = 0; pass && i < pass->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = pass->GetStage(i);
    for (const std::string& layer : stage->GetDescription().Layers)
    {
      static const std::set<std::string> told = { "light", "fog", "ambient", "marker", "blend" };
      if (HasRun(stage) && told.count(layer) != 0)
      {
        layers.push_back(layer);
      }
    }
  }
  return layers;
}
}

//------------------------------------------------------------------------------
vtkRelievoBaseline::vtkRelievoBaseline() = default;

//------------------------------------------------------------------------------
vtkRelievoBaseline::~vtkRelievoBaseline() = default;

//------------------------------------------------------------------------------
void vtkRelievoBaseline::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoBaseline::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkRelievoBaseline::SetObjectName(int actor, RELIEVO_TEXT name)
{
  this->Names[actor] = name;
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoBaseline::GetObjectName(int actor)
{
  const auto found = this->Names.find(actor);
  return found == this->Names.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::Capture(vtkImageData* image)
{
  if (!image)
  {
    vtkErrorMacro("Capture was given no image; give it a vtkImageData to fill.");
    return false;
  }
  image->Initialize();
  vtkNew<vtkRelievoLayerSource> source; // reports errors
  source->SetRenderer(this->Renderer);
  std::vector<std::string> layers = { vtkRelievoLayerCatalogue::GetPicture().Name, "albedo" };
  std::vector<std::string> traced;
  std::vector<std::string>& geometry = this->Portable ? traced : layers;
  geometry.insert(geometry.end(), { "depth", "normal", "actor", "block", "cell" });
  auto* pass = vtkRelievoPass::SafeDownCast(this->Renderer ? this->Renderer->GetPass() : nullptr);
  if (pass && pass->GetShadows() && pass->GetShadowStage())
  {
    const std::vector<std::string> shadows =
      pass->GetShadowStage()->GetShadowLayers(this->Renderer);
    layers.insert(layers.end(), shadows.begin(), shadows.end());
  }
  if (this->Renderer)
  {
    const std::set<std::string> arrays = FindColoringArrays(this->Renderer);
    geometry.insert(geometry.end(), arrays.begin(), arrays.end());
  }
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  source->Update();
  if (source->GetOutput()->GetNumberOfPoints() == 0)
  {
    return false;
  }
  image->ShallowCopy(source->GetOutput());
  const std::vector<std::string> ofStages = FindStageLayers(pass);
  const std::vector<std::string> settings = DescribeSettings(this->Renderer);
  if (!ofStages.empty())
  {
    vtkNew<vtkRelievoLayerSource> more; // without the picture: stages that ran are known now
    more->SetRenderer(this->Renderer);
    for (const std::string& layer : ofStages)
    {
      more->AddLayer(layer);
    }
    more->Update();
    if (more->GetOutput()->GetNumberOfPoints() == 0)
    {
      image->Initialize();
      return false;
    }
    for (const std::string& layer : ofStages)
    {
      image->GetPointData()->AddArray(more->GetOutput()->GetPointData()->GetArray(layer.c_str()));
    }
  }
  if (this->Portable && !this->AddRayLayers(image, traced))
  {
    image->Initialize();
    return false;
  }
  AddStrings(image, "settings", settings);
  this->AddRecord(image);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::AddRayLayers(vtkImageData* image, const std::vector<std::string>& layers)
{
  vtkNew<vtkRelievoRayScene> rays;
  rays->SetRenderer(this->Renderer);
  rays->OpaqueOnlyOn();                    // like the layers of a frame
  const vtkNew<vtkCallbackCommand> silent; // actors that rays do not hit are an error below
  rays->AddObserver(vtkCommand::WarningEvent, silent);
  rays->Update();
  for (int i = 0; i < rays->GetNumberOfPropsLeftOut(); ++i)
  {
    vtkProp* prop = rays->GetPropLeftOut(i);
    if (!vtkVolume::SafeDownCast(prop)) // volumes are in no layer
    {
      const int number = this->Renderer->GetActors()->IsItemPresent(prop) - 1;
      vtkErrorMacro("A portable baseline has actors that rays hit, but they do not hit "
        << (number < 0 ? std::string(prop->GetClassName()) : "actor " + std::to_string(number))
        << "; expected surfaces, not wireframes, points, lines or cut-outs. Use a "
        << "baseline that is not portable.");
      return false;
    }
  }
  const int* size = image->GetDimensions();
  const vtkSmartPointer<vtkRelievoCameraModel> sensor =
    scene::MakeSensor(this->Renderer->GetActiveCamera(), size[0], size[1]);
  vtkNew<vtkRelievoRayLayers> source; // reports errors
  source->SetScene(rays);
  source->SetCamera(sensor);
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer.c_str());
  }
  source->Update();
  if (source->GetOutput()->GetNumberOfPoints() != image->GetNumberOfPoints())
  {
    return false;
  }
  for (const std::string& layer : layers)
  {
    image->GetPointData()->AddArray(source->GetOutput()->GetPointData()->GetArray(layer.c_str()));
  }
  vtkNew<vtkIntArray> portable;
  portable->SetName("portable");
  portable->InsertNextValue(1);
  image->GetFieldData()->AddArray(portable);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::IsPortable(vtkImageData* image)
{
  auto* portable = image ? image->GetFieldData()->GetArray("portable") : nullptr;
  return portable && portable->GetNumberOfValues() == 1 && portable->GetComponent(0, 0) == 1.0;
}

//------------------------------------------------------------------------------
void vtkRelievoBaseline::AddRecord(vtkImageData* image)
{
  vtkNew<vtkIntArray> version;
  version->SetName("baseline_version");
  version->InsertNextValue(vtkRelievoFrameComparison::GetRecordVersion());
  image->GetFieldData()->AddArray(version);
  std::vector<std::string> objects;
  vtkCollectionSimpleIterator at;
  vtkActorCollection* actors = this->Renderer->GetActors(); // rebuilt by each call
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    objects.push_back(
      Write(DescribeActor(actor, this->GetObjectName(static_cast<int>(objects.size())))));
  }
  AddStrings(image, "objects", objects);
  AddStrings(image, "volumes", DescribeVolumes(this->Renderer));
  AddStrings(image, "overlays", DescribeOverlays(this->Renderer));
  AddStrings(image, "versions", scene::ListVersions(this->Renderer->GetRenderWindow()));
}

//------------------------------------------------------------------------------
bool vtkRelievoBaseline::Test(vtkRenderWindow* window, const char* baseline)
{
  namespace fs = std::filesystem;
  vtkNew<vtkRelievoBaseline> source;
  int drawn = 0;
  vtkNew<vtkRendererCollection> none;
  vtkRendererCollection* renderers = window ? window->GetRenderers() : none.Get();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(at))
  {
    if (renderer->GetDraw() && renderer->GetViewProps()->GetNumberOfItems() > 0)
    {
      source->SetRenderer(renderer);
      ++drawn;
    }
  }
  if (drawn != 1 || !baseline)
  {
    vtkErrorWithObjectMacro(source,
      "Test was given " << drawn << " renderers with props" << (baseline ? "" : " and no file")
                        << ", expected a window with one, and a baseline's file. For more "
                           "renderers, Capture() each.");
    return false;
  }
  const std::string stem = fs::path(baseline).stem().string();
  const std::string frameFile = stem + ".frame.exr";
  const std::array<std::string, 2> pictures = { stem + ".baseline.png", stem + ".frame.png" };
  const std::string page = stem + ".html";
  std::error_code ignored; // files of an earlier run may be missing
  for (const std::string& old : { frameFile, pictures[0], pictures[1], page })
  {
    fs::remove(old, ignored);
  }
  vtkNew<vtkRelievoFrameComparison> comparison; // reports errors
  const bool there = fs::exists(baseline, ignored);
  if (there && !comparison->ReadBaseline(baseline))
  {
    return false;
  }
  source->SetPortable(IsPortable(comparison->GetBaseline()));
  vtkNew<vtkImageData> frame;
  if (!source->Capture(frame))
  {
    return false;
  }
  const auto writePicture = [](vtkImageData* of, const std::string& path) {
    const auto picture = scene::MakePicture(of);
    if (picture)
    {
      vtkNew<vtkPNGWriter> writer; // reports errors
      writer->SetInputData(picture);
      writer->SetFileName(path.c_str());
      writer->Write();
    }
    return picture != nullptr;
  };
  const auto keepFrame = [&]() {
    vtkNew<vtkRelievoEXRWriter> writer; // reports errors
    writer->SetInputData(frame);
    writer->SetFileName(frameFile.c_str());
    writer->Write();
    const bool isPicture = fs::path(baseline).extension() == ".png";
    if (isPicture)
    {
      writePicture(frame, pictures[1]);
    }
    std::cout << "If the frame is right, copy " << (isPicture ? pictures[1] : frameFile) << " to "
              << baseline << std::endl;
  };
  if (!there)
  {
    std::cout << "There is no such baseline: " << baseline << "\n";
    keepFrame();
    return false;
  }
  comparison->SetFrame(frame);
  if (!comparison->Compare())
  {
    return false;
  }
  const std::string table = comparison->GetText();
  std::cout << table;
  if (comparison->GetAlike())
  {
    return true;
  }
  keepFrame();
  vtkNew<vtkRelievoComparisonReport> report;
  report->Add(baseline, comparison);
  std::ofstream(page, std::ios::binary) << report->GetHTML();
  std::cout << "<DartMeasurement name=\"Causes\" type=\"text/preformatted\">" << Escape(table)
            << "</DartMeasurement>\n";
  // CDash shows pictures with these names together, one over the other.
  const std::array<const char*, 2> names = { "ValidImage", "TestImage" };
  for (std::size_t i = 0; i < 2; ++i)
  {
    if (writePicture(i == 0 ? comparison->GetBaseline() : comparison->GetFrame(), pictures[i]))
    {
      std::cout << "<DartMeasurementFile name=\"" << names[i] << "\" type=\"image/png\">"
                << Escape(fs::absolute(pictures[i], ignored).string())
                << "</DartMeasurementFile>\n";
    }
  }
  std::cout << std::flush;
  return false;
}

//------------------------------------------------------------------------------
void vtkRelievoBaseline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "Portable: " << this->Portable << "\n";
  for (const auto& [actor, name] : this->Names)
  {
    os << indent << "ObjectName " << actor << ": " << name << "\n";
  }
}
