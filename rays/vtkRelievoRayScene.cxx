// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRelievoGlyphPlaces.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoPropMeshes.h"
#include "vtkRelievoPropParts.h"
#include "vtkRelievoRayFile.h"
#include "vtkRelievoRayTree.h"
#include "vtkRelievoThreads.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRelievoRayScene);

namespace
{
using Hit = vtkRelievoRayTree::Hit;
using Line = vtkRelievoRayTree::Line;

constexpr double Endless = std::numeric_limits<double>::infinity();
constexpr vtkIdType Batch = 1 << 16; // rays between two progress events
constexpr vtkIdType Grain = 512;     // rays per task of a thread
constexpr vtkIdType Together = 256;  // rays traced by one call
// Least volume of a box, relative to a rectangular one with its sides.
constexpr double Flat = 1e-6;
constexpr vtkIdType MostCorners = 1 << 24; // of copies

vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* data)
{
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(data);
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(filter->GetOutput());
  return mesh;
}

// A mesh with its own points and cells, which share arrays with the original.
vtkSmartPointer<vtkPolyData> CopyShape(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  if (mesh->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType()); // preserved by copying
    points->DeepCopy(mesh->GetPoints());
    copy->SetPoints(points);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(mesh->GetPolys());
  copy->SetPolys(polygons);
  vtkNew<vtkCellArray> strips;
  strips->DeepCopy(mesh->GetStrips());
  copy->SetStrips(strips);
  return copy;
}

// Restores the outside of cells mirrored by a matrix: reverses polygons from the same corner, so
// that their triangles are the same, and repeats the first corner of strips.
void AppendTurned(vtkCellArray* all, vtkCellArray* cells, vtkIdType first, bool strips)
{
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(count, ids);
    all->InsertNextCell(static_cast<int>(count + (strips && count > 0 ? 1 : 0)));
    for (vtkIdType i = 0; i < count; ++i)
    {
      all->InsertCellPoint(first + ids[strips || i == 0 ? i : count - i]);
      if (strips && i == 0)
      {
        all->InsertCellPoint(first + ids[0]);
      }
    }
  }
}

// Copies all places of a mesh to world coordinates; `cellsOfData`: the mesh's cells in the data, or
// none.
void CopyInWorld(const vtkRelievoPlacedMesh& placed, vtkIdTypeArray* cellsOfData, vtkPolyData* copy)
{
  vtkPolyData* mesh = placed.Mesh;
  const vtkIdType count = mesh->GetNumberOfPoints();
  const std::size_t places = placed.GetNumberOfPlaces();
  copy->Initialize();
  if (!placed.Places)
  {
    copy->GetPointData()->ShallowCopy(mesh->GetPointData());
    copy->GetCellData()->ShallowCopy(mesh->GetCellData());
    copy->GetPointData()->SetNormals(nullptr); // normals are not transformed
    copy->GetCellData()->SetNormals(nullptr);
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t k = 0; k < places; ++k)
  {
    const glm::dmat4 matrix = placed.GetPlace(k);
    for (vtkIdType i = 0; i < count; ++i)
    {
      glm::dvec4 point(0.0, 0.0, 0.0, 1.0);
      mesh->GetPoint(i, &point.x);
      point = matrix * point;
      points->InsertNextPoint(point.x / point.w, point.y / point.w, point.z / point.w);
    }
  }
  copy->SetPoints(points);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("cell");
  vtkIdType first = 0;
  const auto gather = [&](vtkCellArray* cells) {
    auto all = vtkSmartPointer<vtkCellArray>::New();
    const bool strips = cells == mesh->GetStrips();
    const bool turns = strips || cells == mesh->GetPolys();
    for (std::size_t k = 0; k < places; ++k)
    {
      const vtkIdType offset = static_cast<vtkIdType>(k) * count;
      if (turns && glm::determinant(placed.GetPlace(k)) < 0.0)
      {
        AppendTurned(all, cells, offset, strips);
      }
      else
      {
        all->Append(cells, offset);
      }
      for (vtkIdType i = first; i < first + cells->GetNumberOfCells(); ++i)
      {
        ids->InsertNextValue(placed.Points ? (*placed.Points)[k]
            : cellsOfData                  ? cellsOfData->GetValue(i)
                                           : i);
      }
    }
    first += cells->GetNumberOfCells();
    return all;
  };
  copy->SetVerts(gather(mesh->GetVerts()));
  copy->SetLines(gather(mesh->GetLines()));
  copy->SetPolys(gather(mesh->GetPolys()));
  copy->SetStrips(gather(mesh->GetStrips()));
  copy->GetCellData()->AddArray(ids);
}

// Ways of tracing rays in a mesh.
enum class Entry
{
  ByMatrix,
  ByScaledMatrix, // by the matrix divided by its last element
  ByCopy,         // by a copy in world coordinates: the matrix has no exact inverse
  // A matrix is not finite, or maps points to infinity or beyond; or there are too many copies.
  None
};

bool IsCopiedAtMost(const vtkRelievoPlacedMesh& placed, vtkIdType most)
{
  const vtkIdType corners = placed.Mesh->GetPolys()->GetNumberOfConnectivityIds() +
    placed.Mesh->GetStrips()->GetNumberOfConnectivityIds();
  return corners <= most / static_cast<vtkIdType>(placed.GetNumberOfPlaces());
}

Entry FindEntry(const vtkRelievoPlacedMesh& placed)
{
  const glm::dmat4& matrix = placed.MeshToWorld;
  const double* const first = &matrix[0][0];
  const glm::dvec4 last(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
  const glm::dmat3 turn(matrix);
  const double volume = std::abs(glm::determinant(turn));
  if (!std::all_of(first, first + 16, [](double x) { return std::isfinite(x); }) ||
    !std::isfinite(volume))
  {
    return Entry::None;
  }
  const bool isAffine = glm::dvec3(last) == glm::dvec3(0.0);
  if (isAffine && last.w > 0.0 &&
    volume > Flat * glm::length(turn[0]) * glm::length(turn[1]) * glm::length(turn[2]))
  {
    return last.w == 1.0 ? Entry::ByMatrix : Entry::ByScaledMatrix;
  }
  if (!IsCopiedAtMost(placed, MostCorners) || (isAffine && !(last.w > 0.0)))
  {
    return Entry::None;
  }
  for (std::size_t k = 0; k < placed.GetNumberOfPlaces() && !isAffine; ++k)
  {
    for (vtkIdType i = 0; i < placed.Mesh->GetNumberOfPoints(); ++i)
    {
      glm::dvec4 point(0.0, 0.0, 0.0, 1.0);
      placed.Mesh->GetPoint(i, &point.x);
      if (!((placed.GetPlace(k) * point).w > 0.0))
      {
        return Entry::None;
      }
    }
  }
  return Entry::ByCopy;
}

// A ray about the scene's centre. If it is not Valid, it hits nothing.
struct CenteredRay : Line
{
  bool Valid = false;
  bool None = false; // not a ray: causes no warning
};

class CenteredRays
{
public:
  CenteredRays(vtkDataArray* origins, vtkDataArray* directions, const glm::dvec3& center)
    : Origins(origins)
    , Directions(directions)
    , Center(center)
  {
  }

  vtkIdType GetCount() const { return this->Directions->GetNumberOfTuples(); }

  CenteredRay Get(vtkIdType row) const
  {
    CenteredRay ray;
    Read(this->Origins, this->Origins->GetNumberOfTuples() == 1 ? 0 : row, ray.From);
    Read(this->Directions, row, ray.Direction);
    const glm::dvec3 sizes = glm::abs(ray.Direction);
    const double size = std::max(std::max(sizes.x, sizes.y), sizes.z);
    ray.Valid = size > 0.0;
    for (int i = 0; i < 3; ++i)
    {
      ray.Valid = ray.Valid && std::isfinite(ray.From[i]) && std::isfinite(ray.Direction[i]);
    }
    ray.None =
      glm::isnan(ray.Direction.x) && glm::isnan(ray.Direction.y) && glm::isnan(ray.Direction.z);
    ray.From -= this->Center;
    ray.Direction = glm::normalize(ray.Direction / size);
    return ray;
  }

  // Calls trace(lines, count, hits) for several rays at once, and take(row, line, hit) for each ray
  // from row `first` up to `last`. Returns the number of rays that are not valid.
  template <typename Trace, typename Take>
  vtkIdType ForEach(vtkIdType first, vtkIdType last, Trace trace, Take take) const
  {
    vtkIdType invalid = 0;
    Line lines[Together];
    vtkIdType rows[Together];
    Hit hits[Together];
    for (vtkIdType row = first; row < last;)
    {
      int count = 0;
      for (; row < last && count < Together; ++row)
      {
        const CenteredRay ray = this->Get(row);
        lines[count] = ray;
        rows[count] = row;
        if (ray.Valid)
        {
          ++count;
          continue;
        }
        take(row, ray, Hit());
        invalid += ray.None ? 0 : 1;
      }
      trace(lines, count, hits);
      for (int i = 0; i < count; ++i)
      {
        take(rows[i], lines[i], hits[i]);
      }
    }
    return invalid;
  }

private:
  static void Read(vtkDataArray* array, vtkIdType tuple, glm::dvec3& value)
  {
    if (auto* doubles = vtkDoubleArray::FastDownCast(array))
    {
      std::copy_n(doubles->GetPointer(3 * tuple), 3, &value.x);
      return;
    }
    array->GetTuple(tuple, &value.x);
  }

  vtkDataArray* Origins;
  vtkDataArray* Directions;
  glm::dvec3 Center;
};

// The columns of a table of hits, with `count` rows.
class Columns
{
public:
  Columns(vtkTable* table, vtkIdType count)
    : Distance(Add<vtkDoubleArray>(table, "distance", 1, count))
    , Prop(Add<vtkIntArray>(table, "prop", 1, count))
    , Block(Add<vtkIntArray>(table, "block", 1, count))
    , Cell(Add<vtkIdTypeArray>(table, "cell", 1, count))
    , Points(Add<vtkIdTypeArray>(table, "points", 3, count))
    , Weights(Add<vtkDoubleArray>(table, "weights", 3, count))
    , Position(Add<vtkDoubleArray>(table, "position", 3, count))
    , Normal(Add<vtkDoubleArray>(table, "normal", 3, count))
    , GeometricNormal(Add<vtkDoubleArray>(table, "geometric_normal", 3, count))
  {
  }

  template <typename Array>
  static decltype(Array::New()->GetPointer(0)) Add(
    vtkTable* table, const char* name, int components, vtkIdType count)
  {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(count);
    table->GetRowData()->AddArray(array);
    return array->GetPointer(0);
  }

  void SetNone(vtkIdType row) const
  {
    this->Distance[row] = Endless;
    this->Prop[row] = this->Block[row] = -1;
    this->Cell[row] = -1;
    std::fill_n(this->Points + 3 * row, 3, -1);
    for (double* three : { this->Weights, this->Position, this->Normal, this->GeometricNormal })
    {
      std::fill_n(three + 3 * row, 3, 0.0);
    }
  }

  static void Set(double* column, vtkIdType row, const glm::dvec3& value)
  {
    std::copy_n(&value.x, 3, column + 3 * row);
  }

  double* Distance;
  int* Prop;
  int* Block;
  vtkIdType* Cell;
  vtkIdType* Points;
  double* Weights;
  double* Position;
  double* Normal;
  double* GeometricNormal;
};
}

//------------------------------------------------------------------------------
struct vtkRelievoRayScene::Internals
{
  // A placed mesh's origin in the user's data.
  struct Source
  {
    int Prop = -1;
    vtkWeakPointer<vtkActor> Actor;  // in a renderer
    int Added = -1;                  // index in Data
    vtkDataArray* Normals = nullptr; // none: geometric normals
    bool OfCells = false;
    vtkIdTypeArray* Cells = nullptr; // indices of the mesh's cells in the data; none: equal
    vtkIdTypeArray* Points = nullptr;
    // The user's ids of the mesh's points, which identify them for FindMoved; null: `Points` does.
    vtkSmartPointer<vtkIdTypeArray> Ids;
    vtkIdType PointsOfPlace = 0; // points per glyph, if glyphs' places are merged into one mesh
    bool IsOpaque = true;        // drawn as opaque by VTK
    std::shared_ptr<vtkRelievoMeshTree> Tree; // in a file

    vtkIdTypeArray* GetIds() const { return this->Ids ? this->Ids.Get() : this->Points; }
  };

  // An entry of AddData.
  struct Added
  {
    vtkSmartPointer<vtkDataObject> Data;
    vtkSmartPointer<vtkMatrix4x4> Matrix;
  };

  // The outer surface of data other than vtkPolyData.
  struct Surface
  {
    vtkWeakPointer<vtkDataSet> Data;
    vtkMTimeType Time = 0;
    vtkSmartPointer<vtkPolyData> Mesh;
  };

  // A mesh's copy in world coordinates, for matrices that rays cannot be transformed by.
  struct Copy
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkMTimeType Time = 0;
    std::shared_ptr<const std::vector<glm::dmat4>> Places;
    vtkSmartPointer<vtkPolyData> InWorld;
  };
  using CopyKey = std::tuple<vtkPolyData*, const void*, std::array<double, 16>>;

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Added> Data;
  std::map<vtkDataSet*, Surface> Surfaces; // of Data
  std::map<CopyKey, Copy> Copies;          // in the last update
  std::map<CopyKey, Copy> CopiesBefore;    // in the update before
  vtkRelievoGlyphPlaces Glyphs{ vtkRelievoGlyphPlaces::Numbers::Exact };
  std::vector<vtkRelievoPlacedMesh> Meshes;
  std::vector<vtkSmartPointer<vtkPolyData>> Owned; // references to all of Meshes
  std::vector<Source> Sources;                     // one for each of Meshes
  std::vector<vtkSmartPointer<vtkProp>> LeftOut;
  std::set<vtkProp*> Warned; // of LeftOut
  std::string Fault;         // of Data
  class Correspondence;
  bool Frozen = false; // a copy of another scene's state, which is not updated
  std::vector<vtkRelievoPlacedMesh> FrozenMeshes;
  std::vector<Source> FrozenSources;
  // The content of a file: meshes, their trees, the number of props, and the hash of the geometry.
  struct Stored
  {
    std::vector<std::shared_ptr<vtkRelievoMeshTree>> Trees;
    std::vector<vtkRelievoPlacedMesh> Meshes;
    std::vector<Source> Sources;
    std::vector<vtkSmartPointer<vtkPolyData>> Owned; // of Meshes: they have normals and indices
    std::vector<vtkSmartPointer<vtkIdTypeArray>> Indices;
    std::shared_ptr<const void> Memory; // of the arrays
    std::int64_t NumberOfProps = 0;
    std::uint64_t Geometry = 0;

    std::string Read(const std::string& path);
    bool ReadMesh(vtkRelievoRayFileReader& file);
    bool Fits(const std::vector<vtkRelievoPlacedMesh>& meshes) const;
  };
  std::shared_ptr<const Stored> File;
  std::vector<vtkSmartPointer<vtkPolyData>> OwnedBefore; // until the trees have new meshes
  std::vector<Hit>* Nearest = nullptr; // receives the nearest hits, if a caller needs them
  vtkRelievoRayTree Tree;

  static void FindNormals(vtkPolyData* mesh, Source& source);
  void Enter(vtkRelievoPlacedMesh& placed, Source& source);
  void AddProps();
  void AddActors(vtkProp* prop, std::map<vtkProp*, int>& numbers);
  void AddAdded();
  void TakeIds(const char* name);
  bool HasIds() const;
  bool SetMeshes(bool opaqueOnly);
  void TakeTrees(const Stored& file);
  void LeaveFile();
  std::uint64_t GetGeometry() const;
  void WriteMesh(vtkRelievoRayFileWriter& file, std::size_t mesh, std::int64_t tree) const;
  std::string AddBlock(vtkDataObject* data, int block, int prop, vtkMatrix4x4* matrix);
  void Write(const Columns& columns, vtkIdType row, const Line& ray, const Hit& hit) const;
  glm::dvec3 GetShadingNormal(const Hit& hit, const vtkRelievoRayTree::Details& details) const;
};

namespace
{
// Whether the prop can be hit: not a sky, nor lines drawn over the scene.
bool IsShown(vtkProp* prop)
{
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    vtkActor* actor = vtkActor::SafeDownCast(part.Prop);
    const bool isHit = actor && !vtkSkybox::SafeDownCast(actor) &&
      !vtkRelievoPropParts::IsAnnotation(actor) && !vtkRelievoPropParts::DrawsNoOpaque(part);
    if (isHit || vtkVolume::SafeDownCast(part.Prop))
    {
      return true;
    }
  }
  return false;
}

// Whether the meshes from index `first` on draw only points or lines.
bool DrawLinesAlone(const std::vector<vtkRelievoPlacedMesh>& meshes, std::size_t first)
{
  vtkIdType others = 0;
  vtkIdType surfaces = 0;
  for (std::size_t i = first; i < meshes.size(); ++i)
  {
    vtkPolyData* mesh = meshes[i].Mesh;
    others += mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    surfaces += mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips();
  }
  return surfaces == 0 && others > 0;
}

void UpdateMapper(vtkMapper* mapper)
{
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      mapper->GetInputAlgorithm(port, i)->Update();
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Internals::FindNormals(vtkPolyData* mesh, Source& source)
{
  const auto isFit = [](vtkDataArray* normals, vtkIdType count) {
    return normals && normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() == count;
  };
  vtkDataArray* ofPoints = mesh->GetPointData()->GetNormals();
  vtkDataArray* ofCells = mesh->GetCellData()->GetNormals();
  if (isFit(ofPoints, mesh->GetNumberOfPoints()))
  {
    source.Normals = ofPoints;
  }
  else if (isFit(ofCells, mesh->GetNumberOfCells()))
  {
    source.Normals = ofCells;
    source.OfCells = true;
  }
}

//------------------------------------------------------------------------------
// Meshes under a singular or projective matrix are copied to world coordinates.
void vtkRelievoRayScene::Internals::Enter(vtkRelievoPlacedMesh& placed, Source& source)
{
  const Entry entry = FindEntry(placed);
  if (entry == Entry::ByScaledMatrix)
  {
    placed.MeshToWorld /= placed.MeshToWorld[3][3];
  }
  if (entry != Entry::ByCopy)
  {
    return;
  }
  CopyKey key(placed.Mesh, placed.Places.get(), {});
  std::copy_n(&placed.MeshToWorld[0][0], 16, std::get<2>(key).begin());
  const auto before = this->CopiesBefore.find(key);
  Copy& copy = before == this->CopiesBefore.end()
    ? this->Copies[key]
    : this->Copies.try_emplace(key, before->second).first->second;
  if (copy.Mesh != placed.Mesh || copy.Time != placed.Mesh->GetMTime())
  {
    copy = { placed.Mesh, placed.Mesh->GetMTime(), placed.Places,
      vtkSmartPointer<vtkPolyData>::New() };
    CopyInWorld(placed, source.Cells, copy.InWorld);
  }
  source.PointsOfPlace = placed.Places ? placed.Mesh->GetNumberOfPoints() : 0;
  source.Cells = vtkIdTypeArray::SafeDownCast(copy.InWorld->GetCellData()->GetArray("cell"));
  placed.Mesh = copy.InWorld;
  placed.MeshToWorld = glm::dmat4(1.0);
  placed.Places = nullptr;
  placed.Points = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Internals::AddProps()
{
  std::map<vtkProp*, int> numbers;
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  int count = 0;
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    numbers.emplace(actor, count++);
  }
  vtkPropCollection* props = this->Renderer->GetViewProps();
  props->InitTraversal(it);
  std::vector<vtkProp*> all;
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      all.push_back(prop);
    }
  }
  for (vtkProp* prop : all)
  {
    this->AddActors(prop, numbers);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Internals::AddActors(vtkProp* prop, std::map<vtkProp*, int>& numbers)
{
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  bool meshes = false;
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    if (vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part))
    {
      UpdateMapper(actor->GetMapper());
      meshes = true;
    }
  }
  const std::size_t before = this->Meshes.size();
  bool followed = vtkRelievoPropMeshes::Collect(
    prop, vtkRelievoPropMeshes::Wanted::Geometry, this->Glyphs, this->Meshes);
  const bool enters =
    std::none_of(this->Meshes.begin() + static_cast<std::ptrdiff_t>(before), this->Meshes.end(),
      [](const vtkRelievoPlacedMesh& mesh) { return FindEntry(mesh) == Entry::None; });
  if (!enters || DrawLinesAlone(this->Meshes, before))
  {
    followed = false;
    this->Meshes.resize(before);
  }
  if (!(meshes && followed) && IsShown(prop))
  {
    this->LeftOut.emplace_back(prop);
  }
  vtkActor* last = nullptr; // blocks of one actor are consecutive
  bool isOpaque = true;
  for (std::size_t i = before; i < this->Meshes.size(); ++i)
  {
    vtkRelievoPlacedMesh& mesh = this->Meshes[i];
    isOpaque = mesh.Actor == last ? isOpaque : mesh.Actor->HasOpaqueGeometry() != 0;
    last = mesh.Actor;
    Source source;
    const auto number = numbers.find(mesh.Actor);
    source.Prop = number == numbers.end() ? -1 : number->second;
    source.Actor = mesh.Actor;
    // A block may be translucent even if other blocks of its actor are opaque.
    source.IsOpaque = isOpaque && (mesh.Actor->GetForceOpaque() || !(mesh.Opacity < 1.0));
    this->Enter(mesh, source);
    if (mesh.Actor->GetProperty()->GetInterpolation() != VTK_FLAT)
    {
      FindNormals(mesh.Mesh, source);
    }
    this->Sources.push_back(source);
    this->Owned.emplace_back(mesh.Mesh);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Internals::AddAdded()
{
  int prop = this->Renderer ? this->Renderer->GetActors()->GetNumberOfItems() : 0;
  for (const Added& added : this->Data)
  {
    const auto add = [&](vtkDataObject* data, int block) {
      const std::size_t before = this->Sources.size();
      const std::string fault = this->AddBlock(data, block, prop, added.Matrix);
      for (std::size_t i = before; i < this->Sources.size(); ++i)
      {
        this->Sources[i].Added = static_cast<int>(&added - this->Data.data());
      }
      if (!fault.empty() && this->Fault.empty())
      {
        this->Fault = "prop " + std::to_string(prop) + ": " + fault;
      }
    };
    if (auto* blocks = vtkCompositeDataSet::SafeDownCast(added.Data))
    {
      auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        add(it->GetCurrentDataObject(), static_cast<int>(it->GetCurrentFlatIndex()));
      }
    }
    else
    {
      add(added.Data, 0);
    }
    ++prop;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoRayScene::Internals::AddBlock(
  vtkDataObject* data, int block, int prop, vtkMatrix4x4* matrix)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set)
  {
    return {}; // e.g. a table among the blocks
  }
  vtkRelievoPlacedMesh placed;
  placed.Mesh = vtkPolyData::SafeDownCast(set);
  placed.Block = block;
  placed.ByOutline = true;
  Source source;
  source.Prop = prop;
  if (matrix)
  {
    placed.MeshToWorld = vtkRelievoToGlm(matrix);
  }
  if (!placed.Mesh)
  {
    Surface& surface = this->Surfaces[set];
    if (surface.Data != set || surface.Time != set->GetMTime())
    {
      surface = { set, set->GetMTime(), MakeSurface(set) };
    }
    placed.Mesh = surface.Mesh;
    source.Cells =
      vtkIdTypeArray::SafeDownCast(placed.Mesh->GetCellData()->GetArray("vtkOriginalCellIds"));
    source.Points =
      vtkIdTypeArray::SafeDownCast(placed.Mesh->GetPointData()->GetArray("vtkOriginalPointIds"));
  }
  if (const vtkIdType triangles = vtkRelievoMeshTexels::CountTooMany(placed.Mesh))
  {
    return "there are " + std::to_string(triangles) + " triangles, expected at most " +
      std::to_string(vtkRelievoMeshTexels::GetMostTriangles()) + " in a block";
  }
  if (FindEntry(placed) == Entry::None)
  {
    return "got a matrix that is not finite, or maps points to infinity or beyond, expected a "
           "last row that is positive for all points, such as 0 0 0 1";
  }
  this->Enter(placed, source);
  FindNormals(placed.Mesh, source);
  this->Meshes.push_back(placed);
  this->Sources.push_back(source);
  this->Owned.emplace_back(placed.Mesh);
  return {};
}

//------------------------------------------------------------------------------
// Copies the user's ids, so that a copied state keeps them.
void vtkRelievoRayScene::Internals::TakeIds(const char* name)
{
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    vtkPolyData* mesh = this->Meshes[i].Mesh;
    vtkDataArray* given = mesh->GetPointData()->GetArray(name);
    if (given && given->GetNumberOfComponents() == 1 && given->GetDataType() != VTK_FLOAT &&
      given->GetDataType() != VTK_DOUBLE && given->GetNumberOfTuples() == mesh->GetNumberOfPoints())
    {
      this->Sources[i].Ids = vtkSmartPointer<vtkIdTypeArray>::New();
      this->Sources[i].Ids->DeepCopy(given);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::Internals::HasIds() const
{
  return std::any_of(this->Sources.begin(), this->Sources.end(),
    [](const Source& source) { return source.Ids != nullptr; });
}

//------------------------------------------------------------------------------
// Returns whether anything has changed.
bool vtkRelievoRayScene::Internals::SetMeshes(bool opaqueOnly)
{
  std::size_t count = 0;
  for (std::size_t i = 0; opaqueOnly && i < this->Sources.size(); ++i)
  {
    if (this->Sources[i].IsOpaque)
    {
      this->Meshes[count] = this->Meshes[i];
      this->Sources[count] = this->Sources[i];
      ++count;
    }
  }
  if (opaqueOnly)
  {
    this->Meshes.resize(count);
    this->Sources.resize(count);
  }
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    if (this->Sources[i].Tree)
    {
      this->Tree.SetMeshTree(this->Meshes[i].Mesh, this->Meshes[i].ByOutline, this->Sources[i].Tree,
        this->File != nullptr);
    }
  }
  return this->Tree.SetMeshes(this->Meshes);
}

//------------------------------------------------------------------------------
// The file's meshes are deleted with it.
void vtkRelievoRayScene::Internals::LeaveFile()
{
  this->Frozen = false;
  if (this->File)
  {
    this->Meshes.clear();
    this->Sources.clear();
    this->FrozenMeshes.clear();
    this->FrozenSources.clear();
    this->File = nullptr;
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoRayScene::Internals::GetShadingNormal(
  const Hit& hit, const vtkRelievoRayTree::Details& details) const
{
  const Source& source = this->Sources[this->Tree.GetMesh(hit.Place)];
  const vtkRelievoMeshTree& mesh = this->Tree.GetMeshTree(hit.Place);
  glm::dvec3 normal(0.0);
  for (int i = 0; i < 3 && source.Normals; ++i)
  {
    glm::dvec3 each;
    source.Normals->GetTuple(
      source.OfCells ? mesh.GetCell(hit.Triangle) : mesh.GetPoint(hit.Triangle, i), &each.x);
    normal += details.Weights[i] * each;
  }
  // By the transpose of the inverse.
  normal = normal * glm::dmat3(this->Tree.GetToMesh(hit.Place));
  const double length = glm::length(normal);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    normal = details.Normal;
  }
  return glm::normalize(details.Front ? normal : -normal);
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Internals::Write(
  const Columns& columns, vtkIdType row, const Line& ray, const Hit& hit) const
{
  const int index = this->Tree.GetMesh(hit.Place);
  const vtkRelievoPlacedMesh& placed = this->Meshes[index];
  const Source& source = this->Sources[index];
  const vtkRelievoMeshTree& mesh = this->Tree.GetMeshTree(hit.Place);
  const vtkRelievoRayTree::Details details = this->Tree.GetDetails(hit, ray.From, ray.Direction);
  columns.Distance[row] = hit.T;
  columns.Prop[row] = source.Prop;
  columns.Block[row] = placed.Block;
  const vtkIdType cell = mesh.GetCell(hit.Triangle);
  columns.Cell[row] = placed.Points
    ? (*placed.Points)[static_cast<std::size_t>(this->Tree.GetInstance(hit.Place))]
    : source.Cells ? source.Cells->GetValue(cell)
                   : cell;
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType point = mesh.GetPoint(hit.Triangle, i);
    columns.Points[3 * row + i] = source.Points ? source.Points->GetValue(point)
      : source.PointsOfPlace                    ? point % source.PointsOfPlace
                                                : point;
  }
  Columns::Set(columns.Weights, row, details.Weights);
  Columns::Set(columns.Position, row, details.Position);
  Columns::Set(columns.Normal, row, this->GetShadingNormal(hit, details));
  const glm::dvec3 normal = glm::normalize(details.Normal);
  Columns::Set(columns.GeometricNormal, row, details.Front ? normal : -normal);
}

namespace
{
// Calls each(first, last) for ranges of rays in threads, batch by batch, and after(from, to) after
// each batch. False if it was aborted.
template <typename Each, typename After>
bool DoInBatches(vtkRelievoRayScene* scene, vtkIdType count, Each each, After after)
{
  scene->AbortOff();
  for (vtkIdType from = 0; from < count; from += Batch)
  {
    const vtkIdType to = std::min(count, from + Batch);
    vtkRelievoWithThreads([&]() { vtkSMPTools::For(from, to, Grain, each); });
    after(from, to);
    double done = static_cast<double>(to) / static_cast<double>(count);
    scene->InvokeEvent(vtkCommand::ProgressEvent, &done);
    if (scene->GetAbort())
    {
      return false;
    }
  }
  return true;
}

// Error message for rays, or an empty string.
std::string FindFault(vtkDataArray* origins, vtkDataArray* directions, vtkObject* answer)
{
  std::ostringstream out;
  if (!answer)
  {
    out << "got no array or table for the results";
  }
  else if (!origins || !directions)
  {
    out << "got no " << (origins ? "directions" : "origins") << ", expected an array";
  }
  else if (origins->GetNumberOfComponents() != 3 || directions->GetNumberOfComponents() != 3)
  {
    out << "got origins of " << origins->GetNumberOfComponents() << " and directions of "
        << directions->GetNumberOfComponents() << " components, expected 3";
  }
  else if (origins->GetNumberOfTuples() != directions->GetNumberOfTuples() &&
    origins->GetNumberOfTuples() != 1)
  {
    out << "got " << origins->GetNumberOfTuples() << " origins and "
        << directions->GetNumberOfTuples() << " directions, expected equal numbers, or one origin";
  }
  return out.str();
}
}

//------------------------------------------------------------------------------
vtkRelievoRayScene::vtkRelievoRayScene()
  : Internal(new Internals)
  , MaximumDistance(Endless)
{
}

//------------------------------------------------------------------------------
vtkRelievoRayScene::~vtkRelievoRayScene()
{
  this->SetPointIds(nullptr);
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Internal->Renderer.Get() << '\n';
  os << indent << "Data: " << this->Internal->Data.size() << '\n';
  os << indent << "Triangles: " << this->GetNumberOfTriangles() << '\n';
  os << indent << "MinimumDistance: " << this->MinimumDistance << '\n';
  os << indent << "MaximumDistance: " << this->MaximumDistance << '\n';
  os << indent << "OpaqueOnly: " << this->OpaqueOnly << '\n';
  os << indent << "PointIds: " << (this->PointIds ? this->PointIds : "(none)") << '\n';
  os << indent << "Abort: " << this->Abort << '\n';
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::SetRenderer(vtkRenderer* renderer)
{
  this->Internal->LeaveFile();
  if (this->Internal->Renderer != renderer)
  {
    this->Internal->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoRayScene::GetRenderer()
{
  return this->Internal->Renderer;
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::AddData(vtkDataObject* data, vtkMatrix4x4* matrix)
{
  if (!vtkDataSet::SafeDownCast(data) && !vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkErrorMacro("AddData: got " << (data ? data->GetClassName() : "nothing")
                                  << ", expected a vtkDataSet or composite data");
    return -1;
  }
  this->Internal->LeaveFile();
  this->Internal->Data.push_back({ data, matrix });
  this->Modified();
  const int actors =
    this->Internal->Renderer ? this->Internal->Renderer->GetActors()->GetNumberOfItems() : 0;
  return actors + static_cast<int>(this->Internal->Data.size()) - 1;
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::RemoveAllData()
{
  this->Internal->Data.clear();
  this->Internal->Surfaces.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::SetMaximumDistance(double distance)
{
  const double set = distance >= 0.0 ? distance : 0.0;
  if (this->MaximumDistance != set)
  {
    this->MaximumDistance = set;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::Update()
{
  Internals& scene = *this->Internal;
  if (scene.Frozen)
  {
    scene.Meshes = scene.FrozenMeshes;
    scene.Sources = scene.FrozenSources;
    return scene.SetMeshes(this->OpaqueOnly);
  }
  this->Collect();
  const bool changed = scene.SetMeshes(this->OpaqueOnly);
  scene.OwnedBefore.clear();
  return changed;
}

//------------------------------------------------------------------------------
// Lists the meshes of the renderer and the data.
void vtkRelievoRayScene::Collect()
{
  Internals& scene = *this->Internal;
  scene.OwnedBefore = std::move(scene.Owned);
  scene.Owned.clear();
  scene.Meshes.clear();
  scene.Sources.clear();
  scene.LeftOut.clear();
  scene.Fault.clear();
  scene.CopiesBefore.swap(scene.Copies);
  scene.Copies.clear();
  for (auto it = scene.Surfaces.begin(); it != scene.Surfaces.end();)
  {
    it = it->second.Data ? std::next(it) : scene.Surfaces.erase(it);
  }
  if (scene.Renderer)
  {
    scene.AddProps();
  }
  scene.AddAdded();
  if (this->PointIds && *this->PointIds)
  {
    scene.TakeIds(this->PointIds);
  }
  scene.CopiesBefore.clear();
  std::string names;
  for (vtkProp* prop : scene.LeftOut)
  {
    if (scene.Warned.insert(prop).second)
    {
      names += (names.empty() ? "" : ", ") + std::string(prop->GetClassName());
    }
  }
  if (!names.empty())
  {
    vtkWarningMacro("Rays do not hit " << names
                                       << ": volumes, wireframes, points, lines, cut-outs, "
                                          "clipped meshes, grids (give them as data), actors "
                                          "with their own shaders, and actors with matrices "
                                          "that are not finite or map points to infinity are "
                                          "left out");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::Begin(vtkDataArray* origins, vtkDataArray* directions, vtkObject* answer)
{
  std::string fault = FindFault(origins, directions, answer);
  if (fault.empty() && this->MinimumDistance > this->MaximumDistance)
  {
    std::ostringstream out;
    out << "got distances from " << this->MinimumDistance << " to " << this->MaximumDistance
        << ", expected the maximum to be the larger one";
    fault = out.str();
  }
  if (fault.empty())
  {
    this->Update();
    fault = this->Internal->Fault;
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
  }
  return fault.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Warn(vtkIdType invalid, vtkIdType rays)
{
  if (invalid > 0)
  {
    vtkWarningMacro("" << invalid << " of " << rays
                       << " rays are not finite or have no direction: they hit nothing");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::FindNearest(
  vtkDataArray* origins, vtkDataArray* directions, vtkTable* hits)
{
  if (hits)
  {
    hits->Initialize();
  }
  if (!this->Begin(origins, directions, hits))
  {
    return false;
  }
  const Internals& scene = *this->Internal;
  const CenteredRays rays(origins, directions, scene.Tree.GetCenter());
  const Columns columns(hits, rays.GetCount());
  if (scene.Nearest)
  {
    scene.Nearest->resize(static_cast<std::size_t>(rays.GetCount()));
  }
  std::atomic<vtkIdType> invalid(0);
  const auto find = [&](vtkIdType first, vtkIdType last) {
    const auto trace = [&](const Line* lines, int count, Hit* found) {
      scene.Tree.FindNearest(lines, count, this->MinimumDistance, this->MaximumDistance, found);
    };
    invalid +=
      rays.ForEach(first, last, trace, [&](vtkIdType row, const Line& ray, const Hit& hit) {
        if (scene.Nearest)
        {
          (*scene.Nearest)[static_cast<std::size_t>(row)] = hit;
        }
        if (hit.Place >= 0)
        {
          scene.Write(columns, row, ray, hit);
        }
        else
        {
          columns.SetNone(row);
        }
      });
  };
  const bool done = DoInBatches(this, rays.GetCount(), find, [](vtkIdType, vtkIdType) {});
  if (!done)
  {
    hits->Initialize();
  }
  this->Warn(invalid, rays.GetCount());
  return done;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::FindAny(
  vtkDataArray* origins, vtkDataArray* directions, vtkUnsignedCharArray* hit)
{
  if (hit)
  {
    hit->Initialize();
  }
  if (!this->Begin(origins, directions, hit))
  {
    return false;
  }
  const Internals& scene = *this->Internal;
  const CenteredRays rays(origins, directions, scene.Tree.GetCenter());
  hit->SetNumberOfTuples(rays.GetCount());
  unsigned char* const values = hit->GetPointer(0);
  std::atomic<vtkIdType> invalid(0);
  const auto find = [&](vtkIdType first, vtkIdType last) {
    const auto trace = [&](const Line* lines, int count, Hit* found) {
      scene.Tree.FindAny(lines, count, this->MinimumDistance, this->MaximumDistance, found);
    };
    invalid += rays.ForEach(first, last, trace,
      [&](vtkIdType row, const Line&, const Hit& each) { values[row] = each.Place >= 0 ? 1 : 0; });
  };
  const bool done = DoInBatches(this, rays.GetCount(), find, [](vtkIdType, vtkIdType) {});
  if (!done)
  {
    hit->Initialize();
  }
  this->Warn(invalid, rays.GetCount());
  return done;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::FindAll(vtkDataArray* origins, vtkDataArray* directions, vtkTable* hits)
{
  if (hits)
  {
    hits->Initialize();
  }
  if (!this->Begin(origins, directions, hits))
  {
    return false;
  }
  const Internals& scene = *this->Internal;
  const CenteredRays rays(origins, directions, scene.Tree.GetCenter());
  struct RayHit
  {
    vtkIdType Ray;
    Hit What;
  };
  std::vector<RayHit> all;
  std::vector<std::vector<Hit>> batch(static_cast<std::size_t>(std::min(Batch, rays.GetCount())));
  std::atomic<vtkIdType> invalid(0);
  const auto find = [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType row = first; row < last; ++row)
    {
      const CenteredRay ray = rays.Get(row);
      std::vector<Hit>& own = batch[static_cast<std::size_t>(row % Batch)];
      own.clear();
      if (ray.Valid)
      {
        scene.Tree.FindAll(
          ray.From, ray.Direction, this->MinimumDistance, this->MaximumDistance, own);
      }
      else if (!ray.None)
      {
        ++invalid;
      }
    }
  };
  const auto gather = [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType row = from; row < to; ++row)
    {
      for (const Hit& hit : batch[static_cast<std::size_t>(row % Batch)])
      {
        all.push_back({ row, hit });
      }
    }
  };
  if (!DoInBatches(this, rays.GetCount(), find, gather))
  {
    return false;
  }
  const vtkIdType count = static_cast<vtkIdType>(all.size());
  vtkIdType* const numbers = Columns::Add<vtkIdTypeArray>(hits, "ray", 1, count);
  const Columns columns(hits, count);
  double* const opacities = Columns::Add<vtkDoubleArray>(hits, "opacity", 1, count);
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(0, count, Grain, [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType row = first; row < last; ++row)
      {
        const RayHit& one = all[static_cast<std::size_t>(row)];
        numbers[row] = one.Ray;
        scene.Write(columns, row, rays.Get(one.Ray), one.What);
        opacities[row] = scene.Meshes[scene.Tree.GetMesh(one.What.Place)].Opacity;
      }
    });
  });
  this->Warn(invalid, rays.GetCount());
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoRayScene::GetNumberOfTriangles()
{
  return static_cast<vtkIdType>(this->Internal->Tree.GetNumberOfTriangles());
}

//------------------------------------------------------------------------------
const vtkRelievoRayTree& vtkRelievoRayScene::GetTree() const
{
  return this->Internal->Tree;
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetNumberOfMeshesBuilt()
{
  return this->Internal->Tree.GetMeshesBuilt();
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetNumberOfMeshesRefitted()
{
  return this->Internal->Tree.GetMeshesRefitted();
}

//------------------------------------------------------------------------------
unsigned long vtkRelievoRayScene::GetActualMemorySize()
{
  return static_cast<unsigned long>((this->Internal->Tree.GetBytes() + 1023) / 1024);
}

namespace
{
// Adds the values as numbers of one type, whatever the array's own.
template <typename Value>
void AddValues(vtkRelievoRayHash& hash, vtkDataArray* array)
{
  constexpr vtkIdType chunk = 4096; // values: whole blocks of the hash
  const vtkIdType count = array ? array->GetNumberOfValues() : 0;
  const bool isFloating =
    count > 0 && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
  if (count > 0 && array->GetDataTypeSize() == static_cast<int>(sizeof(Value)) &&
    isFloating == std::is_floating_point<Value>::value && array->HasStandardMemoryLayout())
  {
    hash.Add(array->GetVoidPointer(0), static_cast<std::size_t>(count) * sizeof(Value));
    return;
  }
  const int components = count > 0 ? array->GetNumberOfComponents() : 1;
  std::vector<Value> values;
  for (vtkIdType first = 0; first < count; first += chunk)
  {
    values.clear();
    for (vtkIdType i = first; i < std::min(count, first + chunk); ++i)
    {
      values.push_back(
        static_cast<Value>(array->GetComponent(i / components, static_cast<int>(i % components))));
    }
    hash.Add(values.data(), values.size() * sizeof(Value));
  }
}

const char* const Unfit = ": is damaged: its numbers do not fit each other";

// A mesh in a file; arrays that it has come after it, in this order.
struct MeshRecord
{
  std::int64_t Tree, Prop, Block, IsOpaque, NormalsOfCells, ByOutline, PointsOfPlace;
  std::int64_t HasFloatNormals, HasDoubleNormals, HasCells, HasPoints, HasPlaces, HasGlyphPoints;
  double Opacity;
  double MeshToWorld[16];
};

bool IsFiniteAffine(const glm::dmat4& matrix)
{
  const double* const first = &matrix[0][0];
  return std::all_of(first, first + 16, [](double x) { return std::isfinite(x); }) &&
    glm::dvec4(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]) ==
    glm::dvec4(0.0, 0.0, 0.0, 1.0);
}

// An array of values in a file's memory, which must last as long; null: there is none.
template <typename Array>
vtkSmartPointer<Array> TakeArray(vtkRelievoRayFileReader& file, int components)
{
  using Value = std::remove_pointer_t<decltype(std::declval<Array>().GetPointer(0))>;
  const Value* values = nullptr;
  std::size_t count = 0;
  if (!file.Take(values, count) || count % static_cast<std::size_t>(components) != 0)
  {
    return nullptr;
  }
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetArray(const_cast<Value*>(values), static_cast<vtkIdType>(count), 1);
  return array;
}
}

//------------------------------------------------------------------------------
// Hash of the points, cells and matrices of all meshes.
std::uint64_t vtkRelievoRayScene::Internals::GetGeometry() const
{
  if (this->File)
  {
    return this->File->Geometry;
  }
  vtkRelievoRayHash hash;
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    const vtkRelievoPlacedMesh& placed = this->Meshes[i];
    vtkPolyData* mesh = placed.Mesh;
    // Fans depend on nothing else; ears depend on the last bit of points in their own type.
    const bool byEars = !placed.ByOutline && !vtkRelievoPolygonCut::IsFan(VTK_INT_MAX);
    const std::int64_t numbers[] = { this->Sources[i].Prop, placed.Block,
      placed.ByOutline ? 1
        : byEars       ? 0
                       : 2,
      byEars && mesh->GetPoints() ? mesh->GetPoints()->GetDataType() : 0,
      static_cast<std::int64_t>(placed.GetNumberOfPlaces()), mesh->GetNumberOfPoints(),
      mesh->GetNumberOfVerts() + mesh->GetNumberOfLines(), mesh->GetNumberOfPolys(),
      mesh->GetNumberOfStrips() };
    hash.Add(numbers, sizeof(numbers));
    hash.Add(&placed.MeshToWorld, sizeof(glm::dmat4));
    if (placed.Places)
    {
      hash.Add(placed.Places->data(), placed.Places->size() * sizeof(glm::dmat4));
    }
    AddValues<double>(hash, mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr);
    for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
    {
      AddValues<std::int64_t>(hash, cells->GetOffsetsArray());
      AddValues<std::int64_t>(hash, cells->GetConnectivityArray());
    }
  }
  return hash.Get();
}

//------------------------------------------------------------------------------
// For the next SetMeshes. Meshes that equal each other when the file is read may change apart: each
// gets a tree of its own.
void vtkRelievoRayScene::Internals::TakeTrees(const Stored& file)
{
  std::map<std::pair<vtkPolyData*, bool>, std::shared_ptr<vtkRelievoMeshTree>> trees;
  std::set<const vtkRelievoMeshTree*> owned;
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    std::shared_ptr<vtkRelievoMeshTree>& tree =
      trees[{ this->Meshes[i].Mesh, this->Meshes[i].ByOutline }];
    const std::shared_ptr<vtkRelievoMeshTree>& stored = file.Sources[i].Tree;
    if (!tree)
    {
      tree =
        owned.insert(stored.get()).second ? stored : std::make_shared<vtkRelievoMeshTree>(*stored);
    }
    this->Sources[i].Tree = tree;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::Internals::WriteMesh(
  vtkRelievoRayFileWriter& file, std::size_t mesh, std::int64_t tree) const
{
  const vtkRelievoPlacedMesh& placed = this->Meshes[mesh];
  const Source& source = this->Sources[mesh];
  const bool isFloat = source.Normals && source.Normals->GetDataType() == VTK_FLOAT;
  MeshRecord record{};
  record.Tree = tree;
  record.Prop = source.Prop;
  record.Block = placed.Block;
  record.IsOpaque = source.IsOpaque;
  record.NormalsOfCells = source.OfCells;
  record.ByOutline = placed.ByOutline;
  record.PointsOfPlace = source.PointsOfPlace;
  record.HasFloatNormals = isFloat;
  record.HasDoubleNormals = source.Normals && !isFloat;
  record.HasCells = source.Cells != nullptr;
  record.HasPoints = source.Points != nullptr;
  record.HasPlaces = placed.Places != nullptr;
  record.HasGlyphPoints = placed.Points != nullptr;
  record.Opacity = placed.Opacity;
  std::copy_n(&placed.MeshToWorld[0][0], 16, record.MeshToWorld);
  file.Put(&record, 1);
  const auto count =
    static_cast<std::size_t>(source.Normals ? source.Normals->GetNumberOfValues() : 0);
  if (isFloat)
  {
    vtkNew<vtkFloatArray> normals;
    normals->DeepCopy(source.Normals);
    file.Put(normals->GetPointer(0), count);
  }
  else if (source.Normals)
  {
    vtkNew<vtkDoubleArray> normals;
    normals->DeepCopy(source.Normals);
    file.Put(normals->GetPointer(0), count);
  }
  for (vtkIdTypeArray* indices : { source.Cells, source.Points })
  {
    if (indices)
    {
      file.Put(indices->GetPointer(0), static_cast<std::size_t>(indices->GetNumberOfValues()));
    }
  }
  if (placed.Places)
  {
    file.Put(*placed.Places);
  }
  if (placed.Points)
  {
    file.Put(*placed.Points);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::Internals::Stored::ReadMesh(vtkRelievoRayFileReader& file)
{
  std::vector<MeshRecord> records;
  if (!file.Take(records) || records.size() != 1)
  {
    return false;
  }
  const MeshRecord& record = records.front();
  const auto isWithin = [](std::int64_t number, std::int64_t low, std::int64_t high) {
    return number >= low && number <= high;
  };
  if (!isWithin(record.Tree, 0, static_cast<std::int64_t>(this->Trees.size()) - 1) ||
    !isWithin(record.Prop, -1, this->NumberOfProps - 1) ||
    !isWithin(record.Block, 0, VTK_INT_MAX) || !isWithin(record.PointsOfPlace, 0, VTK_INT_MAX))
  {
    return false;
  }
  vtkRelievoPlacedMesh placed;
  Source source;
  source.Tree = this->Trees[static_cast<std::size_t>(record.Tree)];
  const vtkRelievoMeshTree& tree = *source.Tree;
  auto mesh = vtkSmartPointer<vtkPolyData>::New(); // has only arrays
  placed.Mesh = mesh;
  placed.Block = static_cast<int>(record.Block);
  placed.ByOutline = record.ByOutline != 0;
  placed.Opacity = record.Opacity;
  std::copy_n(record.MeshToWorld, 16, &placed.MeshToWorld[0][0]);
  if (!IsFiniteAffine(placed.MeshToWorld))
  {
    return false;
  }
  source.Prop = static_cast<int>(record.Prop);
  source.IsOpaque = record.IsOpaque != 0;
  source.OfCells = record.NormalsOfCells != 0;
  source.PointsOfPlace = static_cast<vtkIdType>(record.PointsOfPlace);
  vtkSmartPointer<vtkDataArray> normals;
  if (record.HasFloatNormals != 0)
  {
    normals = TakeArray<vtkFloatArray>(file, 3);
  }
  else if (record.HasDoubleNormals != 0)
  {
    normals = TakeArray<vtkDoubleArray>(file, 3);
  }
  if (record.HasFloatNormals != 0 || record.HasDoubleNormals != 0)
  {
    if (!normals ||
      normals->GetNumberOfTuples() <= (source.OfCells ? tree.GetLastCell() : tree.GetLastPoint()))
    {
      return false;
    }
    mesh->GetFieldData()->AddArray(normals);
    source.Normals = normals;
  }
  const auto takeIndices = [&](std::int64_t has, vtkIdType last, vtkIdTypeArray*& indices) {
    const auto array = has != 0 ? TakeArray<vtkIdTypeArray>(file, 1) : nullptr;
    this->Indices.push_back(array);
    indices = array;
    return has == 0 || (array && array->GetNumberOfTuples() > last);
  };
  if (!takeIndices(record.HasCells, tree.GetLastCell(), source.Cells) ||
    !takeIndices(record.HasPoints, tree.GetLastPoint(), source.Points))
  {
    return false;
  }
  if (record.HasPlaces != 0)
  {
    const auto places = std::make_shared<std::vector<glm::dmat4>>();
    placed.Places = places;
    if (!file.Take(*places) || !std::all_of(places->begin(), places->end(), IsFiniteAffine))
    {
      return false;
    }
  }
  if (record.HasGlyphPoints != 0)
  {
    const auto points = std::make_shared<std::vector<vtkIdType>>();
    placed.Points = points;
    if (!file.Take(*points) || points->size() != placed.GetNumberOfPlaces())
    {
      return false;
    }
  }
  this->Meshes.push_back(placed);
  this->Sources.push_back(source);
  this->Owned.push_back(mesh);
  return true;
}

//------------------------------------------------------------------------------
// Returns why the file cannot be used; empty: it can.
std::string vtkRelievoRayScene::Internals::Stored::Read(const std::string& path)
{
  vtkRelievoRayFileReader file;
  const std::string fault = file.Open(path);
  if (!fault.empty())
  {
    return fault;
  }
  std::vector<std::int64_t> numbers;
  bool good = file.Take(numbers) && numbers.size() == 4 && numbers[0] >= 0 && numbers[1] >= 0 &&
    numbers[2] >= 0 && numbers[0] <= VTK_INT_MAX;
  if (good)
  {
    this->NumberOfProps = numbers[0];
    this->Geometry = static_cast<std::uint64_t>(numbers[3]);
  }
  for (std::int64_t i = 0; good && i < numbers[1]; ++i)
  {
    this->Trees.push_back(std::make_shared<vtkRelievoMeshTree>());
    good = this->Trees.back()->Read(file);
  }
  for (std::int64_t i = 0; good && i < numbers[2]; ++i)
  {
    good = this->ReadMesh(file);
  }
  this->Memory = file.GetMemory();
  return good && file.IsAtEnd() ? std::string() : path + Unfit;
}

//------------------------------------------------------------------------------
// Whether the trees have no cells or points that these meshes lack.
bool vtkRelievoRayScene::Internals::Stored::Fits(
  const std::vector<vtkRelievoPlacedMesh>& meshes) const
{
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    const vtkRelievoMeshTree& tree = *this->Sources[i].Tree;
    if (tree.GetLastCell() >= meshes[i].Mesh->GetNumberOfCells() ||
      tree.GetLastPoint() >= meshes[i].Mesh->GetNumberOfPoints())
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::Write(RELIEVO_TEXT path)
{
  const bool opaqueOnly = this->OpaqueOnly;
  this->OpaqueOnly = false;
  this->Update();
  this->OpaqueOnly = opaqueOnly;
  const Internals& scene = *this->Internal;
  std::string fault = scene.Fault;
  if (fault.empty())
  {
    vtkRelievoRayFileWriter file(path);
    std::map<std::pair<vtkPolyData*, bool>, std::int64_t> numbers;
    std::vector<const vtkRelievoMeshTree*> trees;
    std::vector<std::int64_t> treeOfMesh;
    for (const vtkRelievoPlacedMesh& placed : scene.Meshes)
    {
      const auto number = numbers.emplace(
        std::make_pair(placed.Mesh, placed.ByOutline), static_cast<std::int64_t>(trees.size()));
      if (number.second)
      {
        trees.push_back(&scene.Tree.GetMeshTree(placed.Mesh, placed.ByOutline));
      }
      treeOfMesh.push_back(number.first->second);
    }
    std::int64_t props = this->GetNumberOfProps(); // 0 for a copied state
    for (const Internals::Source& source : scene.Sources)
    {
      props = std::max<std::int64_t>(props, source.Prop + 1);
    }
    const std::int64_t about[] = { props, static_cast<std::int64_t>(trees.size()),
      static_cast<std::int64_t>(scene.Meshes.size()),
      static_cast<std::int64_t>(scene.GetGeometry()) };
    file.Put(about, std::size(about));
    for (const vtkRelievoMeshTree* tree : trees)
    {
      tree->Write(file);
    }
    for (std::size_t i = 0; i < scene.Meshes.size(); ++i)
    {
      scene.WriteMesh(file, i, treeOfMesh[i]);
    }
    fault = file.Finish();
  }
  if (!fault.empty())
  {
    vtkErrorMacro("Write: " << fault);
  }
  return fault.empty();
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::Read(RELIEVO_TEXT path)
{
  Internals& scene = *this->Internal;
  const auto file = std::make_shared<Internals::Stored>();
  std::string fault = file->Read(path);
  const bool isLive = scene.Renderer || !scene.Data.empty();
  if (fault.empty() && isLive)
  {
    this->Collect();
    fault = scene.GetGeometry() == file->Geometry && scene.Meshes.size() == file->Meshes.size()
      ? scene.Fault
      : path + ": was written of another scene: its points, cells or matrices differ";
    if (fault.empty() && !file->Fits(scene.Meshes))
    {
      fault = path + Unfit;
    }
    if (fault.empty())
    {
      scene.TakeTrees(*file);
    }
    else
    {
      scene.Fault.clear();
    }
  }
  if (!fault.empty())
  {
    vtkErrorMacro("Read: " << fault);
    return false;
  }
  if (isLive)
  {
    scene.SetMeshes(this->OpaqueOnly);
    scene.OwnedBefore.clear();
  }
  else
  {
    scene.File = file;
    scene.Frozen = true;
    scene.Fault.clear();
    scene.LeftOut.clear();
    scene.FrozenMeshes = file->Meshes;
    scene.FrozenSources = file->Sources;
    this->Update();
  }
  this->Modified();
  return true;
}

namespace
{
bool AreEqual(vtkDataArray* a, vtkDataArray* b)
{
  if (a == b || !a || !b)
  {
    return a == b;
  }
  const vtkIdType count = a->GetNumberOfValues();
  if (a->GetDataType() != b->GetDataType() || count != b->GetNumberOfValues())
  {
    return false;
  }
  if (a->HasStandardMemoryLayout() && b->HasStandardMemoryLayout())
  {
    return count == 0 ||
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(count) * static_cast<std::size_t>(a->GetDataTypeSize())) == 0;
  }
  vtkIdType i = 0;
  while (i < count && a->GetComponent(i, 0) == b->GetComponent(i, 0)) // both have one component
  {
    ++i;
  }
  return i == count;
}

bool AreEqual(vtkCellArray* a, vtkCellArray* b)
{
  return a == b ||
    (AreEqual(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
      AreEqual(a->GetConnectivityArray(), b->GetConnectivityArray()));
}
}

//------------------------------------------------------------------------------
// Maps points of this state of a scene to another state: of the mesh of the same actor, or of data
// with the same index in AddData's list, and of the same block; several such meshes are matched in
// order. A mesh with another number of points has no corresponding points, and neither has a cell
// that the other state lacks.
class vtkRelievoRayScene::Internals::Correspondence
{
public:
  Correspondence(const Internals& from, const Internals& to)
    : From(from)
    , To(to)
    , Meshes(from.Meshes.size(), -1)
  {
    std::map<Key, int> targets;
    const std::vector<Key> keys = GetKeys(to);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      targets.emplace(keys[i], static_cast<int>(i));
    }
    const std::vector<Key> wanted = GetKeys(from);
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      const auto found = targets.find(wanted[i]);
      const bool known = std::get<0>(wanted[i]) || std::get<1>(wanted[i]) >= 0;
      this->Meshes[i] = known && found != targets.end() ? found->second : -1;
    }
    for (std::size_t i = 0; i < this->Meshes.size(); ++i)
    {
      const int mesh = this->Meshes[i];
      if (mesh >= 0)
      {
        this->Add(mesh);
        const auto other = static_cast<std::size_t>(mesh);
        const bool samePoints = this->HasSamePoints(i, other);
        this->IsChanged.push_back(!samePoints || !this->HasSameCells(i, other));
        if (this->IsChanged.back() && samePoints)
        {
          this->AddCells(mesh);
        }
      }
      else
      {
        this->IsChanged.push_back(true);
      }
    }
  }

  // NaN if there is no corresponding point.
  glm::dvec3 Get(const Hit& hit, const double weights[3]) const
  {
    const glm::dvec3 nowhere(std::numeric_limits<double>::quiet_NaN());
    const auto from = static_cast<std::size_t>(this->From.Tree.GetMesh(hit.Place));
    const int mesh = this->Meshes[from];
    if (mesh < 0)
    {
      return nowhere;
    }
    const Target& target = this->Targets.at(mesh);
    const vtkRelievoPlacedMesh& placed = this->To.Meshes[static_cast<std::size_t>(mesh)];
    std::size_t instance = 0;
    if (placed.Points)
    {
      const vtkRelievoPlacedMesh& before = this->From.Meshes[from];
      const auto at = before.Points
        ? target.Places.find(
            (*before.Points)[static_cast<std::size_t>(this->From.Tree.GetInstance(hit.Place))])
        : target.Places.end();
      if (at == target.Places.end())
      {
        return nowhere;
      }
      instance = at->second;
    }
    const vtkRelievoMeshTree& triangles = this->From.Tree.GetMeshTree(hit.Place);
    if (this->IsChanged[from] && !this->HasCell(from, triangles.GetCell(hit.Triangle), target))
    {
      return nowhere;
    }
    vtkIdTypeArray* ids = this->From.Sources[from].GetIds();
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i)
    {
      vtkIdType point = triangles.GetPoint(hit.Triangle, i);
      // In equal meshes points have equal indices, even if several have one id.
      if (this->IsChanged[from] && this->To.Sources[static_cast<std::size_t>(mesh)].GetIds())
      {
        const auto at = target.Points.find(ids ? ids->GetValue(point) : point);
        point = at == target.Points.end() ? -1 : at->second;
      }
      if (point < 0 || point >= placed.Mesh->GetNumberOfPoints())
      {
        return nowhere;
      }
      glm::dvec3 corner;
      placed.Mesh->GetPoint(point, &corner.x);
      sum += weights[i] * corner;
    }
    const glm::dvec4 place = placed.GetPlace(instance) * glm::dvec4(sum, 1.0);
    return glm::dvec3(place) / place.w;
  }

private:
  // A cell by its points' ids, or their indices in the data, in ascending order.
  using CellPoints = std::vector<vtkIdType>;

  struct HashOfCellPoints
  {
    std::size_t operator()(const CellPoints& points) const
    {
      std::size_t hash = points.size();
      for (const vtkIdType point : points)
      {
        hash = (hash ^ static_cast<std::size_t>(point)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  // Actor, index in AddData's list, block, and index among equal ones.
  using Key = std::tuple<vtkActor*, int, int, int>;

  struct Target
  {
    std::unordered_map<vtkIdType, std::size_t> Places; // of glyphs, by the input's point
    // In the mesh, by their ids, or their indices in the data; -1: in several places.
    std::unordered_map<vtkIdType, vtkIdType> Points;
    std::unordered_set<CellPoints, HashOfCellPoints> Cells; // only if they have changed
  };

  const Internals& From;
  const Internals& To;
  std::vector<int> Meshes;       // index in To, for each mesh of From; -1: none
  std::vector<bool> IsChanged;   // for each mesh of From, whether its cells differ
  std::map<int, Target> Targets; // for each mesh of To

  // `ids` of the mesh's points; null: their indices.
  static void TakeCellPoints(
    vtkCellArray* cells, vtkIdType cell, vtkIdTypeArray* ids, vtkIdList* list, CellPoints& points)
  {
    cells->GetCellAtId(cell, list);
    points.clear();
    for (vtkIdType i = 0; i < list->GetNumberOfIds(); ++i)
    {
      points.push_back(ids ? ids->GetValue(list->GetId(i)) : list->GetId(i));
    }
    std::sort(points.begin(), points.end());
  }

  bool HasSameCells(std::size_t from, std::size_t to) const
  {
    vtkPolyData* before = this->From.Meshes[from].Mesh;
    vtkPolyData* after = this->To.Meshes[to].Mesh;
    return AreEqual(this->From.Sources[from].GetIds(), this->To.Sources[to].GetIds()) &&
      AreEqual(before->GetPolys(), after->GetPolys()) &&
      AreEqual(before->GetStrips(), after->GetStrips());
  }

  // Points without ids are identified by their index in the data, so a change of the data's points
  // loses all.
  bool HasSamePoints(std::size_t from, std::size_t to) const
  {
    const auto count = [](const Internals& scene, std::size_t mesh) {
      return scene.Sources[mesh].GetIds() ? -1 : scene.Meshes[mesh].Mesh->GetNumberOfPoints();
    };
    // The user's ids and indices in the data do not identify each other.
    return (this->From.Sources[from].Ids != nullptr) == (this->To.Sources[to].Ids != nullptr) &&
      count(this->From, from) == count(this->To, to);
  }

  bool HasCell(std::size_t from, vtkIdType cell, const Target& target) const
  {
    vtkPolyData* mesh = this->From.Meshes[from].Mesh;
    const vtkIdType polygon = cell - mesh->GetNumberOfVerts() - mesh->GetNumberOfLines();
    const vtkIdType polygons = mesh->GetNumberOfPolys();
    vtkNew<vtkIdList> list;
    CellPoints points;
    TakeCellPoints(polygon < polygons ? mesh->GetPolys() : mesh->GetStrips(),
      polygon < polygons ? polygon : polygon - polygons, this->From.Sources[from].GetIds(), list,
      points);
    return target.Cells.count(points) != 0;
  }

  void AddCells(int mesh)
  {
    vtkPolyData* data = this->To.Meshes[static_cast<std::size_t>(mesh)].Mesh;
    vtkIdTypeArray* ids = this->To.Sources[static_cast<std::size_t>(mesh)].GetIds();
    vtkNew<vtkIdList> list;
    CellPoints points;
    for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
    {
      for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
      {
        TakeCellPoints(cells, cell, ids, list, points);
        this->Targets[mesh].Cells.insert(points);
      }
    }
  }

  static std::vector<Key> GetKeys(const Internals& scene)
  {
    std::map<Key, int> counts;
    std::vector<Key> keys;
    for (std::size_t i = 0; i < scene.Meshes.size(); ++i)
    {
      const Source& source = scene.Sources[i];
      Key key(source.Actor, source.Added, scene.Meshes[i].Block, 0);
      std::get<3>(key) = counts[key]++;
      keys.push_back(key);
    }
    return keys;
  }

  void Add(int mesh)
  {
    const vtkRelievoPlacedMesh& placed = this->To.Meshes[static_cast<std::size_t>(mesh)];
    Target& target = this->Targets[mesh];
    for (std::size_t k = 0; placed.Points && k < placed.Points->size(); ++k)
    {
      target.Places.emplace((*placed.Points)[k], k);
    }
    vtkIdTypeArray* points = this->To.Sources[static_cast<std::size_t>(mesh)].GetIds();
    for (vtkIdType k = 0; points && k < points->GetNumberOfTuples(); ++k)
    {
      const auto [known, isNew] = target.Points.emplace(points->GetValue(k), k);
      if (!isNew && known->second >= 0)
      {
        glm::dvec3 first, again;
        placed.Mesh->GetPoint(known->second, &first.x);
        placed.Mesh->GetPoint(k, &again.x);
        known->second = first == again ? known->second : -1;
      }
    }
  }
};

//------------------------------------------------------------------------------
void vtkRelievoRayScene::CopyStateOf(vtkRelievoRayScene* other)
{
  if (!other || other == this)
  {
    vtkErrorMacro("CopyStateOf was given " << (other ? "the scene itself" : "no scene")
                                           << ", expected another one.");
    return;
  }
  if (other->Internal->File)
  {
    vtkErrorMacro("CopyStateOf was given a scene of a file, expected one of a renderer or data.");
    return;
  }
  other->Update();
  Internals& from = *other->Internal;
  Internals& to = *this->Internal;
  to.File = nullptr;
  to.Renderer = nullptr;
  to.Data.clear();
  to.Surfaces.clear();
  to.LeftOut.clear();
  to.Fault = from.Fault;
  to.Frozen = true;
  to.Meshes = from.Meshes;
  to.Sources = from.Sources;
  std::vector<vtkSmartPointer<vtkPolyData>> owned;
  std::map<vtkPolyData*, vtkSmartPointer<vtkPolyData>> copies;
  for (vtkRelievoPlacedMesh& placed : to.Meshes)
  {
    vtkSmartPointer<vtkPolyData>& copy = copies[placed.Mesh];
    if (!copy)
    {
      copy = CopyShape(placed.Mesh);
    }
    placed.Mesh = copy;
    placed.Actor = nullptr;
    owned.push_back(copy);
  }
  to.FrozenMeshes = to.Meshes;
  to.FrozenSources = to.Sources;
  to.SetMeshes(this->OpaqueOnly);
  to.Owned = owned;
  this->SetPointIds(other->PointIds);
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::FindMoved(vtkRelievoRayScene* later, vtkDataArray* origins,
  vtkDataArray* directions, vtkTable* hits, vtkDoubleArray* places)
{
  if (!later || !places)
  {
    vtkErrorMacro("FindMoved was given " << (later ? "no array to fill" : "no other scene")
                                         << ", expected both.");
    return false;
  }
  if (this->Internal->File || later->Internal->File)
  {
    vtkErrorMacro("FindMoved was called with a scene of a file, expected scenes of renderers or "
                  "data.");
    return false;
  }
  std::vector<Hit> nearest;
  this->Internal->Nearest = &nearest;
  const bool found = this->FindNearest(origins, directions, hits);
  this->Internal->Nearest = nullptr;
  if (!found)
  {
    return false;
  }
  later->Update();
  if (later->PointIds && *later->PointIds && !later->Internal->HasIds())
  {
    vtkErrorMacro("No mesh has an array '" << later->PointIds
                                           << "' with one integer for each point; "
                                           << "SetPointIds expects the name of such an array.");
    return false;
  }
  const Internals& scene = *this->Internal;
  const Internals::Correspondence same(scene, *later->Internal);
  const auto count = static_cast<vtkIdType>(nearest.size());
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(count);
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(0, count, Grain, [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType row = first; row < last; ++row)
      {
        const Hit& hit = nearest[static_cast<std::size_t>(row)];
        double weights[3];
        vtkDataArray::SafeDownCast(hits->GetColumnByName("weights"))->GetTuple(row, weights);
        const glm::dvec3 place = hit.Place < 0
          ? glm::dvec3(std::numeric_limits<double>::quiet_NaN())
          : same.Get(hit, weights);
        places->SetTuple(row, &place.x);
      }
    });
  });
  return true;
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetNumberOfProps()
{
  if (this->Internal->File)
  {
    return static_cast<int>(this->Internal->File->NumberOfProps);
  }
  vtkRenderer* renderer = this->Internal->Renderer;
  const int actors = renderer ? renderer->GetActors()->GetNumberOfItems() : 0;
  return actors + static_cast<int>(this->Internal->Data.size());
}

//------------------------------------------------------------------------------
// The mapper of the renderer's actor with this number, if there is one.
vtkMapper* vtkRelievoRayScene::GetMapper(int prop)
{
  vtkRenderer* renderer = this->Internal->Renderer;
  auto* actor = renderer && prop >= 0
    ? vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(prop))
    : nullptr;
  return actor ? actor->GetMapper() : nullptr;
}

//------------------------------------------------------------------------------
vtkDataObject* vtkRelievoRayScene::GetPropData(int prop)
{
  vtkMapper* mapper = this->GetMapper(prop);
  if (mapper)
  {
    return mapper->GetNumberOfInputConnections(0) > 0 ? mapper->GetInputDataObject(0, 0) : nullptr;
  }
  if (this->Internal->File)
  {
    return nullptr;
  }
  const int added =
    prop - (this->GetNumberOfProps() - static_cast<int>(this->Internal->Data.size()));
  return added >= 0 && prop < this->GetNumberOfProps()
    ? this->Internal->Data[static_cast<std::size_t>(added)].Data
    : nullptr;
}

//------------------------------------------------------------------------------
bool vtkRelievoRayScene::GetIsGlyphs(int prop)
{
  vtkMapper* mapper = this->GetMapper(prop);
  return mapper && mapper->IsA("vtkGlyph3DMapper");
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetNumberOfMeshes()
{
  return static_cast<int>(this->Internal->Meshes.size());
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetMeshProp(int mesh)
{
  return mesh >= 0 && mesh < this->GetNumberOfMeshes()
    ? this->Internal->Sources[static_cast<std::size_t>(mesh)].Prop
    : -1;
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetMeshBlock(int mesh)
{
  return mesh >= 0 && mesh < this->GetNumberOfMeshes()
    ? this->Internal->Meshes[static_cast<std::size_t>(mesh)].Block
    : -1;
}

//------------------------------------------------------------------------------
void vtkRelievoRayScene::CopyMesh(int number, vtkPolyData* copy)
{
  if (!copy || number < 0 || number >= this->GetNumberOfMeshes())
  {
    vtkErrorMacro("CopyMesh: got " << (copy ? "" : "nothing to copy to and ") << "mesh " << number
                                   << ", expected one of " << this->GetNumberOfMeshes());
    return;
  }
  if (this->Internal->File)
  {
    vtkErrorMacro("CopyMesh: the scene was read from a file, which has no cells.");
    return;
  }
  const vtkRelievoPlacedMesh& placed = this->Internal->Meshes[static_cast<std::size_t>(number)];
  const Internals::Source& source = this->Internal->Sources[static_cast<std::size_t>(number)];
  CopyInWorld(placed, source.Cells, copy);
}

//------------------------------------------------------------------------------
int vtkRelievoRayScene::GetNumberOfPropsLeftOut()
{
  return static_cast<int>(this->Internal->LeftOut.size());
}

//------------------------------------------------------------------------------
vtkProp* vtkRelievoRayScene::GetPropLeftOut(int index)
{
  const bool there = index >= 0 && index < this->GetNumberOfPropsLeftOut();
  return there ? this->Internal->LeftOut[static_cast<std::size_t>(index)] : nullptr;
}
