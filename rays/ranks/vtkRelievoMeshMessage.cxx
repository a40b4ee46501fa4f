// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshMessage.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoNonGhostCells.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
template <typename T>
void Put(vtkRelievoBytes& bytes, const T* values, std::size_t count)
{
  const auto* from = reinterpret_cast<const unsigned char*>(values);
  bytes.insert(bytes.end(), from, from + count * sizeof(T));
}

template <typename T>
void Put(vtkRelievoBytes& bytes, const T& value)
{
  Put(bytes, &value, 1);
}

class Reader
{
public:
  explicit Reader(const vtkRelievoBytes& bytes)
    : At(bytes.data())
  {
  }
  template <typename T>
  void Take(T* values, std::size_t count)
  {
    if (count > 0)
    {
      std::memcpy(values, this->At, count * sizeof(T));
      this->At += count * sizeof(T);
    }
  }
  template <typename T>
  T Take()
  {
    T value;
    this->Take(&value, 1);
    return value;
  }

private:
  const unsigned char* At;
};

void Put(vtkRelievoBytes& bytes, const std::vector<vtkRelievoBox>& boxes)
{
  Put(bytes, static_cast<int>(boxes.size()));
  for (const vtkRelievoBox& box : boxes)
  {
    Put(bytes, box.Number);
    Put(bytes, &box.Min.x, 3);
    Put(bytes, &box.Max.x, 3);
  }
}

std::vector<vtkRelievoBox> TakeBoxes(Reader& from)
{
  std::vector<vtkRelievoBox> boxes(static_cast<std::size_t>(from.Take<int>()));
  for (vtkRelievoBox& box : boxes)
  {
    box.Number = from.Take<int>();
    from.Take(&box.Min.x, 3);
    from.Take(&box.Max.x, 3);
  }
  return boxes;
}

bool IsSame(const std::vector<vtkRelievoBox>& a, const std::vector<vtkRelievoBox>& b)
{
  return std::equal(
    a.begin(), a.end(), b.begin(), b.end(), [](const vtkRelievoBox& x, const vtkRelievoBox& y) {
      return x.Number == y.Number && x.Min == y.Min && x.Max == y.Max;
    });
}

std::vector<vtkMTimeType> GetTimes(vtkPolyData* mesh)
{
  vtkUnsignedCharArray* ghosts = vtkRelievoNonGhostCells::GetGhosts(mesh);
  return { mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0, mesh->GetPolys()->GetMTime(),
    mesh->GetStrips()->GetMTime(), ghosts ? ghosts->GetMTime() : 0 };
}

template <typename T>
void PutPoints(vtkRelievoBytes& bytes, vtkPolyData* mesh, const std::vector<vtkIdType>& ids)
{
  std::vector<T> numbers;
  numbers.reserve(3 * ids.size());
  for (const vtkIdType id : ids)
  {
    double p[3];
    mesh->GetPoint(id, p);
    numbers.insert(
      numbers.end(), { static_cast<T>(p[0]), static_cast<T>(p[1]), static_cast<T>(p[2]) });
  }
  Put(bytes, numbers.data(), numbers.size());
}

bool IsFloat(vtkPolyData* mesh)
{
  return mesh->GetPoints() && mesh->GetPoints()->GetDataType() == VTK_FLOAT;
}

template <typename Array>
vtkSmartPointer<vtkDataArray> TakePoints(Reader& from, std::size_t count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  from.Take(array->GetPointer(0), 3 * count);
  return array;
}

void ReadMesh(Reader& from, vtkPolyData* mesh)
{
  const bool same = from.Take<int>() != 0;
  const bool floats = from.Take<int>() != 0;
  const auto size = from.Take<std::size_t>();
  vtkNew<vtkPoints> points;
  points->SetData(
    floats ? TakePoints<vtkFloatArray>(from, size) : TakePoints<vtkDoubleArray>(from, size));
  mesh->SetPoints(points); // the tree over the mesh is refitted if the cells are unchanged
  if (!same)
  {
    const auto corners = from.Take<std::size_t>();
    vtkNew<vtkTypeInt32Array> ids;
    ids->SetNumberOfValues(static_cast<vtkIdType>(corners));
    from.Take(ids->GetPointer(0), corners);
    vtkNew<vtkCellArray> triangles;
    if (corners > 0)
    {
      triangles->SetData(3, ids);
    }
    mesh->SetPolys(triangles);
  }
}
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshSender::IsSame(
  const vtkRelievoPlacedMesh& now, const vtkRelievoPlacedMesh& before) const
{
  const auto sent = this->Meshes.find(now.Mesh);
  return now.Mesh == before.Mesh && sent != this->Meshes.end() && sent->second.Data == now.Mesh &&
    sent->second.Times == GetTimes(now.Mesh) && now.MeshToWorld == before.MeshToWorld &&
    now.Places == before.Places && now.Opacity == before.Opacity && now.Color == before.Color &&
    now.Reach == before.Reach;
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshSender::IsNews(const vtkRelievoMeshPart& part) const
{
  return !this->Written || !::IsSame(part.Receivers, this->Last.Receivers) ||
    !::IsSame(part.InMaps, this->Last.InMaps) ||
    !std::equal(part.Meshes.begin(), part.Meshes.end(), this->Last.Meshes.begin(),
      this->Last.Meshes.end(),
      [this](const vtkRelievoPlacedMesh& now, const vtkRelievoPlacedMesh& before) {
        return this->IsSame(now, before);
      });
}

//------------------------------------------------------------------------------
// Writes points of triangles, as floats or doubles, and the triangles, if they have changed.
int vtkRelievoMeshSender::WriteMesh(Sent& sent, vtkPolyData* mesh, vtkRelievoBytes& bytes)
{
  const std::vector<vtkMTimeType> times = GetTimes(mesh);
  const bool known = sent.Data == mesh;
  if (known && sent.Times == times)
  {
    return 0;
  }
  sent.Id = known ? sent.Id : this->NextId++;
  sent.Data = mesh;
  sent.Times = times;
  sent.Own = vtkRelievoNonGhostCells::Find(mesh);
  std::vector<int> places(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1);
  std::vector<vtkIdType> ids;
  std::vector<int> triangles;
  vtkRelievoPolygonCut::ForEachTriangle(
    sent.Own, [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
      for (const vtkIdType id : { a, b, c })
      {
        int& place = places[static_cast<std::size_t>(id)];
        if (place < 0)
        {
          place = static_cast<int>(ids.size());
          ids.push_back(id);
        }
        triangles.push_back(place);
      }
    });
  const bool same = known && triangles == sent.Triangles;
  const bool floats = IsFloat(mesh);
  Put(bytes, sent.Id);
  Put(bytes, same ? 1 : 0);
  Put(bytes, floats ? 1 : 0);
  Put(bytes, ids.size());
  floats ? PutPoints<float>(bytes, mesh, ids) : PutPoints<double>(bytes, mesh, ids);
  if (!same)
  {
    Put(bytes, triangles.size());
    Put(bytes, triangles.data(), triangles.size());
    sent.Triangles.swap(triangles);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkRelievoBytes vtkRelievoMeshSender::Write(vtkRelievoMeshPart& part)
{
  vtkRelievoBytes bytes;
  if (this->IsNews(part))
  {
    this->WritePart(part, bytes);
    this->Last = part;
    this->Written = true;
  }
  for (vtkRelievoPlacedMesh& placed : part.Meshes)
  {
    placed.Mesh = this->Meshes[placed.Mesh].Own;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshSender::WritePart(const vtkRelievoMeshPart& part, vtkRelievoBytes& bytes)
{
  std::map<vtkPolyData*, Sent> meshes;
  std::map<const void*, int> places;
  vtkRelievoBytes written[3]; // meshes, places, list of placements
  int counts[3] = { 0, 0, static_cast<int>(part.Meshes.size()) };
  for (const vtkRelievoPlacedMesh& placed : part.Meshes)
  {
    auto known = meshes.find(placed.Mesh);
    if (known == meshes.end())
    {
      known = meshes.emplace(placed.Mesh, std::move(this->Meshes[placed.Mesh])).first;
      counts[0] += this->WriteMesh(known->second, placed.Mesh, written[0]);
    }
    const auto* at = placed.Places.get();
    if (at && places.count(at) == 0)
    {
      const auto before = this->Places.find(at);
      const bool sent = before != this->Places.end();
      places[at] = sent ? before->second : this->NextId++;
      if (!sent)
      {
        ++counts[1];
        Put(written[1], places[at]);
        Put(written[1], at->size());
        Put(written[1], at->data(), at->size());
      }
    }
    Put(written[2], known->second.Id);
    Put(written[2], at ? places[at] : -1);
    Put(written[2], &placed.MeshToWorld[0][0], 16);
    Put(written[2], &placed.Color.x, 3);
    Put(written[2], placed.Opacity);
    Put(written[2], placed.Reach);
  }
  for (int i = 0; i < 3; ++i)
  {
    Put(bytes, counts[i]);
    Put(bytes, written[i].data(), written[i].size());
  }
  Put(bytes, part.Receivers);
  Put(bytes, part.InMaps);
  this->Meshes.swap(meshes);
  this->Places.swap(places);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkRelievoMeshSender::GetOwn(vtkPolyData* mesh) const
{
  const auto sent = this->Meshes.find(mesh);
  return sent != this->Meshes.end() && sent->second.Data == mesh ? sent->second.Own.Get() : mesh;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshReceiver::Read(const vtkRelievoBytes& bytes)
{
  if (bytes.empty())
  {
    return;
  }
  Reader from(bytes);
  for (int count = from.Take<int>(); count > 0; --count)
  {
    vtkSmartPointer<vtkPolyData>& mesh = this->Meshes[from.Take<int>()];
    if (!mesh)
    {
      mesh = vtkSmartPointer<vtkPolyData>::New();
    }
    ReadMesh(from, mesh);
  }
  for (int count = from.Take<int>(); count > 0; --count)
  {
    auto& places = this->Places[from.Take<int>()];
    auto matrices = std::make_shared<std::vector<glm::dmat4>>(from.Take<std::size_t>());
    from.Take(matrices->data(), matrices->size());
    places = matrices;
  }
  std::map<int, vtkSmartPointer<vtkPolyData>> meshes;
  std::map<int, std::shared_ptr<const std::vector<glm::dmat4>>> places;
  this->Part.Meshes.resize(static_cast<std::size_t>(from.Take<int>()));
  for (vtkRelievoPlacedMesh& placed : this->Part.Meshes)
  {
    const int mesh = from.Take<int>();
    const int place = from.Take<int>();
    meshes[mesh] = this->Meshes[mesh];
    placed.Mesh = meshes[mesh];
    if (place >= 0)
    {
      places[place] = this->Places[place];
    }
    placed.Places = place >= 0 ? places[place] : nullptr;
    from.Take(&placed.MeshToWorld[0][0], 16);
    from.Take(&placed.Color.x, 3);
    placed.Opacity = from.Take<double>();
    placed.Reach = from.Take<double>();
  }
  this->Part.Receivers = TakeBoxes(from);
  this->Part.InMaps = TakeBoxes(from);
  this->Meshes.swap(meshes); // drops unused meshes, like the sender
  this->Places.swap(places);
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoMeshReceiver::GetNumberOfTriangles() const
{
  vtkIdType count = 0;
  for (const auto& mesh : this->Meshes)
  {
    count += mesh.second->GetNumberOfPolys();
  }
  return count;
}
