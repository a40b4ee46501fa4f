// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayLayers.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRelievoAbort.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoFlow.h"
#include "vtkRelievoLayer.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoReturns.h"
#include "vtkRelievoSkySamples.h"
#include "vtkRelievoSkyTurn.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

vtkStandardNewMacro(vtkRelievoRayLayers);

namespace
{
constexpr vtkIdType RaysAtOnce = 1 << 15; // their hits fit into caches, and memory is reused

// The columns of hits for these layers.
const std::map<std::string, const char*> Columns = { { "range", "distance" },
  { "normal", "normal" }, { "geometric_normal", "geometric_normal" }, { "position", "position" },
  { "actor", "prop" }, { "block", "block" }, { "cell", "cell" } };

// Layers without a column.
constexpr const char* Depth = "depth";
constexpr const char* Ambient = "ambient";

// A named array of the data: of points, otherwise of cells.
struct Named
{
  vtkDataArray* OfPoints = nullptr;
  vtkDataArray* OfCells = nullptr;
  bool OfGlyphs = false; // the cells are the points

  Named(vtkDataSet* data, const std::string& name, bool glyphs)
    : OfGlyphs(glyphs)
  {
    const std::string kind = name.substr(0, name.find(':') + 1);
    const std::string own = kind == "point:" || kind == "cell:" ? name.substr(kind.size()) : name;
    if (kind != "cell:")
    {
      this->OfPoints = data->GetPointData()->GetArray(own.c_str());
    }
    if (!this->OfPoints && kind != "point:" && !glyphs)
    {
      this->OfCells = data->GetCellData()->GetArray(own.c_str());
    }
  }
  vtkDataArray* Get() const { return this->OfPoints ? this->OfPoints : this->OfCells; }
};

bool IsExactInFloats(int type)
{
  return type == VTK_FLOAT || type == VTK_CHAR || type == VTK_SIGNED_CHAR ||
    type == VTK_UNSIGNED_CHAR || type == VTK_SHORT || type == VTK_UNSIGNED_SHORT;
}

// The data sets of a scene by prop and block.
using Blocks = std::map<std::pair<int, int>, vtkDataSet*>;

Blocks GetBlocks(vtkRelievoRayScene* scene)
{
  Blocks blocks;
  for (int prop = 0; prop < scene->GetNumberOfProps(); ++prop)
  {
    vtkDataObject* data = scene->GetPropData(prop);
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
    {
      vtkSmartPointer<vtkCompositeDataIterator> it;
      it.TakeReference(composite->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        if (auto* block = vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
        {
          blocks[{ prop, static_cast<int>(it->GetCurrentFlatIndex()) }] = block;
        }
      }
    }
    else if (auto* single = vtkDataSet::SafeDownCast(data))
    {
      blocks[{ prop, 0 }] = single;
    }
  }
  return blocks;
}

// A layer being filled.
struct Layer
{
  std::string Name;
  const char* Column = nullptr; // none: depth, or an array of the data
  vtkSmartPointer<vtkDataArray> Array;
  std::map<std::pair<int, int>, Named> Sources; // arrays of the data

  void Make(int type, int components, double background, vtkIdType pixels)
  {
    this->Array.TakeReference(vtkDataArray::CreateDataArray(type));
    this->Array->SetName(this->Name.c_str());
    this->Array->SetNumberOfComponents(components);
    this->Array->SetNumberOfTuples(pixels);
    for (int i = 0; i < components; ++i)
    {
      this->Array->FillComponent(i, background);
    }
  }

  // False if no data set has an array of this name.
  bool MakeOfData(vtkRelievoRayScene* scene, const Blocks& blocks, vtkIdType pixels)
  {
    int components = 0;
    int type = VTK_FLOAT;
    for (const auto& block : blocks)
    {
      const Named named(block.second, this->Name, scene->GetIsGlyphs(block.first.first));
      vtkDataArray* array = named.Get();
      // If blocks differ, those that match the first one count.
      if (array && (components == 0 || components == array->GetNumberOfComponents()))
      {
        components = array->GetNumberOfComponents();
        type = IsExactInFloats(array->GetDataType()) ? type : VTK_DOUBLE;
        this->Sources.emplace(block.first, named);
      }
    }
    if (components > 0)
    {
      this->Make(type, components, std::numeric_limits<double>::quiet_NaN(), pixels);
    }
    return components > 0;
  }
};

// The columns of hits, each looked up once.
struct Hits
{
  vtkDataArray* Distance;
  vtkDataArray* Prop;
  vtkDataArray* Block;
  vtkDataArray* Cell;
  vtkDataArray* Points;
  vtkDataArray* Weights;
  vtkDataArray* Position;
  vtkDataArray* Normal; // of triangles

  explicit Hits(vtkTable* table)
    : Distance(Get(table, "distance"))
    , Prop(Get(table, "prop"))
    , Block(Get(table, "block"))
    , Cell(Get(table, "cell"))
    , Points(Get(table, "points"))
    , Weights(Get(table, "weights"))
    , Position(Get(table, "position"))
    , Normal(Get(table, "geometric_normal"))
  {
  }

  static vtkDataArray* Get(vtkTable* table, const char* name)
  {
    return vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  }
};

// Sets the value of a data array at a hit.
void SetValue(Layer& layer, const Hits& hits, vtkIdType i, vtkIdType pixel)
{
  const auto prop = static_cast<int>(hits.Prop->GetComponent(i, 0));
  const auto block = static_cast<int>(hits.Block->GetComponent(i, 0));
  const auto found = layer.Sources.find({ prop, block });
  if (found == layer.Sources.end())
  {
    return;
  }
  const Named& named = found->second;
  const auto cell = static_cast<vtkIdType>(hits.Cell->GetComponent(i, 0));
  if (!named.OfPoints || named.OfGlyphs)
  {
    layer.Array->SetTuple(pixel, named.Get()->GetTuple(cell)); // works for any type in all versions
    return;
  }
  for (int component = 0; component < layer.Array->GetNumberOfComponents(); ++component)
  {
    double value = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      value += hits.Weights->GetComponent(i, k) *
        named.OfPoints->GetComponent(
          static_cast<vtkIdType>(hits.Points->GetComponent(i, k)), component);
    }
    layer.Array->SetComponent(pixel, component, value);
  }
}
}

//------------------------------------------------------------------------------
// The rays of the layer `ambient`, one per pixel at a time.
struct vtkRelievoRayLayers::SkyRays
{
  std::vector<vtkRelievoSkySamples::Point> Points;
  std::vector<vtkIdType> Hit; // rays of the camera that hit something
  vtkNew<vtkDoubleArray> Origins;
  vtkNew<vtkDoubleArray> Directions;
  vtkNew<vtkUnsignedCharArray> Occluded;

  // Origins lie in front of the surfaces by a bound of rounding.
  void TakeOrigins(const Hits& hits)
  {
    constexpr double share = 1e-9; // of the distance
    constexpr double steps = 64.0; // units in the last place of the largest coordinate
    this->Hit.clear();
    this->Origins->SetNumberOfComponents(3);
    this->Directions->SetNumberOfComponents(3);
    this->Origins->Reset();
    for (vtkIdType i = 0; i < hits.Distance->GetNumberOfTuples(); ++i)
    {
      const double distance = hits.Distance->GetComponent(i, 0);
      if (std::isinf(distance))
      {
        continue;
      }
      double place[3];
      double normal[3];
      hits.Position->GetTuple(i, place);
      hits.Normal->GetTuple(i, normal);
      const double largest =
        std::max({ std::abs(place[0]), std::abs(place[1]), std::abs(place[2]) });
      const double before =
        share * distance + steps * std::numeric_limits<double>::epsilon() * largest;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] += before * normal[axis];
      }
      this->Hit.push_back(i);
      this->Origins->InsertNextTuple(place);
    }
    this->Directions->SetNumberOfTuples(static_cast<vtkIdType>(this->Hit.size()));
  }
};

//------------------------------------------------------------------------------
bool vtkRelievoRayLayers::FindAmbient(
  SkyRays& sky, vtkTable* table, vtkIdType firstPixel, std::vector<double>& share)
{
  using namespace relievo::f64;
  const Hits hits(table);
  sky.TakeOrigins(hits);
  share.assign(static_cast<std::size_t>(hits.Distance->GetNumberOfTuples()), 1.0);
  const double nearest = this->Scene->GetMinimumDistance();
  const double farthest = this->Scene->GetMaximumDistance();
  this->Scene->SetMinimumDistance(0.0);
  this->Scene->SetMaximumDistance(
    this->AmbientRadius > 0.0 ? this->AmbientRadius : std::numeric_limits<double>::infinity());
  bool good = true;
  for (const vtkRelievoSkySamples::Point& point : sky.Points)
  {
    for (std::size_t k = 0; k < sky.Hit.size(); ++k)
    {
      const auto pixel = static_cast<unsigned int>(firstPixel + sky.Hit[k]);
      const auto getShare = [&](unsigned int which) {
        return relievoNoiseHash(pixel, which, 0u, static_cast<unsigned int>(this->Seed)) /
          4294967296.0;
      };
      const glm::dvec2 moved = relievoSkyShift(glm::dvec2(point.X, point.Y),
        glm::dvec2(getShare(0u), getShare(1u)), 1.0 / this->AmbientSamples);
      const glm::dvec3 ray =
        vtkRelievoSkyTurn(relievoSkyDirection(moved.x, moved.y, this->AmbientByCosine),
          hits.Normal->GetTuple(sky.Hit[k]));
      sky.Directions->SetTuple(static_cast<vtkIdType>(k), &ray.x);
    }
    good = sky.Hit.empty() || this->Scene->FindAny(sky.Origins, sky.Directions, sky.Occluded);
    if (!good || relievo::IsStopped(this))
    {
      break;
    }
    for (std::size_t k = 0; k < sky.Hit.size(); ++k)
    {
      share[static_cast<std::size_t>(sky.Hit[k])] -=
        sky.Occluded->GetValue(static_cast<vtkIdType>(k)) != 0 ? 1.0 / this->AmbientSamples : 0.0;
    }
  }
  this->Scene->SetMinimumDistance(nearest);
  this->Scene->SetMaximumDistance(farthest);
  return good;
}

//------------------------------------------------------------------------------
vtkRelievoRayLayers::vtkRelievoRayLayers()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoRayLayers::~vtkRelievoRayLayers() = default;

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::SetScene(vtkRelievoRayScene* scene)
{
  this->Scene = scene;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRelievoRayScene* vtkRelievoRayLayers::GetScene()
{
  return this->Scene;
}

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::SetCamera(vtkRelievoCameraModel* camera)
{
  this->Camera = camera;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRelievoCameraModel* vtkRelievoRayLayers::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::SetOther(vtkRelievoRayScene* scene, vtkRelievoCameraModel* camera)
{
  this->OtherScene = scene;
  this->OtherCamera = camera;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRelievoRayScene* vtkRelievoRayLayers::GetOtherScene()
{
  return this->OtherScene;
}

//------------------------------------------------------------------------------
vtkRelievoCameraModel* vtkRelievoRayLayers::GetOtherCamera()
{
  return this->OtherCamera;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayLayers::IsFlow(const char* given)
{
  const std::string name = given ? given : "";
  return name == "flow" || name == "motion" || name == "flow_valid";
}

//------------------------------------------------------------------------------
// Computes the flow to the other state; `share` is its part of the progress. False after an error
// or an abort.
bool vtkRelievoRayLayers::FindFlow(vtkImageData* image, double share)
{
  vtkNew<vtkRelievoFlow> flow;
  flow->SetFrom(this->Scene, this->Camera);
  flow->SetTo(this->OtherScene, this->OtherCamera);
  this->FlowShare = share;
  this->FlowError.clear();
  flow->AddObserver(vtkCommand::ProgressEvent, this, &vtkRelievoRayLayers::FollowFlow);
  flow->AddObserver(vtkCommand::ErrorEvent, this, &vtkRelievoRayLayers::FollowFlow);
  flow->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &vtkRelievoRayLayers::FollowFlow);
  flow->Update();
  image->ShallowCopy(flow->GetOutput());
  if (!this->FlowError.empty())
  {
    vtkErrorMacro(<< this->FlowError);
  }
  return image->GetNumberOfPoints() > 0;
}

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::FollowFlow(vtkObject* caller, unsigned long event, void* data)
{
  if (event == vtkCommand::ProgressEvent)
  {
    auto* flow = static_cast<vtkRelievoFlow*>(caller);
    this->UpdateProgress(this->FlowShare * flow->GetProgress());
    flow->SetAbortExecute(relievo::IsStopped(this));
  }
  else if (this->FlowError.empty())
  {
    // The message follows the file, the line, the class and its address.
    const std::string text = static_cast<const char*>(data);
    const std::size_t place = text.find("): ");
    this->FlowError = text.substr(place == std::string::npos ? 0 : place + 3);
    this->FlowError.erase(this->FlowError.find_last_not_of('\n') + 1);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::AddLayer(const char* name)
{
  this->Layers.emplace_back(name ? name : "");
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::RemoveAllLayers()
{
  this->Layers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoRayLayers::GetLayerNames()
{
  std::string names = std::string(Depth) + ", " + Ambient;
  for (const auto& column : Columns)
  {
    names += ", " + column.first;
  }
  return names;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayLayers::HasLayer(const char* given)
{
  const std::string name = given ? given : "";
  return name == Depth || name == Ambient || Columns.count(name) != 0 ||
    vtkRelievoLayerCatalogue::Find(name).Kind == vtkRelievoLayer::ARRAY;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoRayLayers::GetMTime()
{
  this->Modified();
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
int vtkRelievoRayLayers::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int extent[6] = { 0, -1, 0, -1, 0, 0 };
  if (this->Camera)
  {
    extent[1] = this->Camera->GetSize()[0] - 1;
    extent[3] = this->Camera->GetSize()[1] - 1;
  }
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoRayLayers::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  if (!this->Scene || !this->Camera)
  {
    vtkErrorMacro("It has no " << (this->Scene ? "camera; give it one by SetCamera."
                                               : "scene; give it one by SetScene."));
    return 0;
  }
  vtkImageData* image = vtkImageData::GetData(outputs);
  const vtkIdType columns = this->Camera->GetSize()[0];
  const vtkIdType rows = this->Camera->GetSize()[1];
  this->Scene->Update();
  const Blocks blocks = GetBlocks(this->Scene);
  std::vector<Layer> layers;
  vtkNew<vtkImageData> flow;
  const bool hasOther = this->OtherScene && this->OtherCamera;
  const auto flows = std::count_if(this->Layers.begin(), this->Layers.end(),
    [hasOther](const std::string& name) { return hasOther && IsFlow(name.c_str()); });
  const bool isAll = flows == static_cast<std::ptrdiff_t>(this->Layers.size());
  const double flowShare = flows == 0 ? 0.0 : isAll ? 1.0 : 0.5;
  if (flows > 0 && !this->FindFlow(flow, flowShare))
  {
    relievo::Discard(outputs);
    return relievo::IsStopped(this) ? 1 : 0;
  }
  for (const std::string& name : this->Layers)
  {
    if (hasOther && IsFlow(name.c_str()))
    {
      continue;
    }
    Layer layer;
    layer.Name = name;
    const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::Find(name);
    const auto column = Columns.find(name);
    if (column != Columns.end() || name == Depth || name == Ambient)
    {
      layer.Column = column == Columns.end() ? nullptr : column->second;
      layer.Make(known.Type, known.Components, known.Background, columns * rows);
    }
    else if (known.Kind != vtkRelievoLayer::ARRAY ||
      !layer.MakeOfData(this->Scene, blocks, columns * rows))
    {
      vtkErrorMacro("Rays have no layer '"
        << name << "'; they have " << GetLayerNames() << ", and the arrays of the scene's data"
        << (IsFlow(name.c_str()) ? "; flow goes to another state of the scene, and "
                                   "there is none."
                                 : "."));
      return 0;
    }
    layers.push_back(layer);
  }

  vtkNew<vtkDoubleArray> origins;
  vtkNew<vtkDoubleArray> directions;
  vtkNew<vtkTable> table;
  vtkRelievoReturns returns(this->Scene, this->Camera);
  SkyRays sky;
  std::vector<double> ambient;
  if (std::find(this->Layers.begin(), this->Layers.end(), Ambient) != this->Layers.end())
  {
    sky.Points = vtkRelievoSkySamples::Get(this->AmbientSamples, false);
  }
  const vtkIdType rowsAtOnce = std::max<vtkIdType>(1, RaysAtOnce / columns);
  for (vtkIdType row = 0; row < rows && !layers.empty(); row += rowsAtOnce)
  {
    const vtkIdType end = std::min(rows, row + rowsAtOnce);
    this->Camera->GetRowRays(static_cast<int>(row), static_cast<int>(end), origins, directions);
    if (!returns.Find(origins, directions, table) ||
      (!sky.Points.empty() && !this->FindAmbient(sky, table, row * columns, ambient)))
    {
      vtkErrorMacro("The rays of the camera were not followed; see the errors before.");
      return 0;
    }
    returns.AddNoise(origins, row * columns, table);
    const Hits hits(table);
    for (vtkIdType i = 0; i < origins->GetNumberOfTuples(); ++i)
    {
      if (std::isinf(hits.Distance->GetComponent(i, 0)))
      {
        continue;
      }
      // Rows run downwards in cameras and upwards in images.
      const vtkIdType pixel = (rows - 1 - row - i / columns) * columns + i % columns;
      for (Layer& layer : layers)
      {
        if (layer.Column)
        {
          layer.Array->SetTuple(pixel, hits.Get(table, layer.Column)->GetTuple(i));
        }
        else if (layer.Name == Ambient)
        {
          layer.Array->SetComponent(pixel, 0, ambient[static_cast<std::size_t>(i)]);
        }
        else if (layer.Name == Depth)
        {
          layer.Array->SetComponent(pixel, 0,
            this->Camera->GetDepth(origins->GetPointer(3 * i), hits.Position->GetTuple(i)));
        }
        else
        {
          SetValue(layer, hits, i, pixel);
        }
      }
    }
    this->UpdateProgress(
      flowShare + (1.0 - flowShare) * static_cast<double>(end) / static_cast<double>(rows));
    if (relievo::IsStopped(this))
    {
      relievo::Discard(outputs);
      return 1;
    }
  }
  image->SetDimensions(static_cast<int>(columns), static_cast<int>(rows), 1);
  auto found = layers.begin();
  for (const std::string& name : this->Layers)
  {
    const bool isFlow = hasOther && IsFlow(name.c_str());
    image->GetPointData()->AddArray(
      isFlow ? flow->GetPointData()->GetArray(name.c_str()) : (found++)->Array.GetPointer());
  }
  this->Camera->AddTo(image->GetFieldData());
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoRayLayers::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << this->Scene << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "OtherScene: " << this->OtherScene << "\n";
  os << indent << "OtherCamera: " << this->OtherCamera << "\n";
  os << indent << "Layers:";
  for (const std::string& name : this->Layers)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "AmbientSamples: " << this->AmbientSamples << "\n";
  os << indent << "AmbientRadius: " << this->AmbientRadius << "\n";
  os << indent << "AmbientByCosine: " << this->AmbientByCosine << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
