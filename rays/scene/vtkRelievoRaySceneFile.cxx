// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRaySceneFile.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayContent.h"
#include "vtkRelievoRayFile.h"
#include "vtkRelievoRayTree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

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

void WriteMesh(vtkRelievoRayFileWriter& file, const vtkRelievoPlacedMesh& placed,
  const vtkRelievoRaySource& source, std::int64_t tree)
{
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
}

//------------------------------------------------------------------------------
std::uint64_t vtkRelievoRaySceneFile::HashGeometry(const vtkRelievoRayContent& content)
{
  vtkRelievoRayHash hash;
  for (std::size_t i = 0; i < content.Meshes.size(); ++i)
  {
    const vtkRelievoPlacedMesh& placed = content.Meshes[i];
    vtkPolyData* mesh = placed.Mesh;
    // Fans depend on nothing else; ears depend on the last bit of points in their own type.
    const bool byEars = !placed.ByOutline && !vtkRelievoPolygonCut::IsFan(VTK_INT_MAX);
    const std::int64_t numbers[] = { content.Sources[i].Prop, placed.Block,
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
std::string vtkRelievoRaySceneFile::Write(const std::string& path,
  const vtkRelievoRayContent& content, const vtkRelievoRayTree& tree, std::int64_t numberOfProps,
  std::uint64_t geometry)
{
  vtkRelievoRayFileWriter file(path);
  std::map<std::pair<vtkPolyData*, bool>, std::int64_t> numbers;
  std::vector<const vtkRelievoMeshTree*> trees;
  std::vector<std::int64_t> treeOfMesh;
  for (const vtkRelievoPlacedMesh& placed : content.Meshes)
  {
    const auto number = numbers.emplace(
      std::make_pair(placed.Mesh, placed.ByOutline), static_cast<std::int64_t>(trees.size()));
    if (number.second)
    {
      trees.push_back(&tree.GetMeshTree(placed.Mesh, placed.ByOutline));
    }
    treeOfMesh.push_back(number.first->second);
  }
  std::int64_t props = numberOfProps; // 0 for a copied state
  for (const vtkRelievoRaySource& source : content.Sources)
  {
    props = std::max<std::int64_t>(props, source.Prop + 1);
  }
  const std::int64_t about[] = { props, static_cast<std::int64_t>(trees.size()),
    static_cast<std::int64_t>(content.Meshes.size()), static_cast<std::int64_t>(geometry) };
  file.Put(about, std::size(about));
  for (const vtkRelievoMeshTree* each : trees)
  {
    each->Write(file);
  }
  for (std::size_t i = 0; i < content.Meshes.size(); ++i)
  {
    WriteMesh(file, content.Meshes[i], content.Sources[i], treeOfMesh[i]);
  }
  return file.Finish();
}

//------------------------------------------------------------------------------
bool vtkRelievoRaySceneFile::ReadMesh(vtkRelievoRayFileReader& file)
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
  vtkRelievoRaySource source;
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
std::string vtkRelievoRaySceneFile::Read(const std::string& path)
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
bool vtkRelievoRaySceneFile::Fits(const std::vector<vtkRelievoPlacedMesh>& meshes) const
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
// Meshes that equal each other when the file is read may change apart: each gets a tree of its own.
void vtkRelievoRaySceneFile::GiveTrees(vtkRelievoRayContent& content) const
{
  std::map<std::pair<vtkPolyData*, bool>, std::shared_ptr<vtkRelievoMeshTree>> trees;
  std::set<const vtkRelievoMeshTree*> owned;
  for (std::size_t i = 0; i < content.Meshes.size(); ++i)
  {
    std::shared_ptr<vtkRelievoMeshTree>& tree =
      trees[{ content.Meshes[i].Mesh, content.Meshes[i].ByOutline }];
    const std::shared_ptr<vtkRelievoMeshTree>& stored = this->Sources[i].Tree;
    if (!tree)
    {
      tree =
        owned.insert(stored.get()).second ? stored : std::make_shared<vtkRelievoMeshTree>(*stored);
    }
    content.Sources[i].Tree = tree;
  }
}
