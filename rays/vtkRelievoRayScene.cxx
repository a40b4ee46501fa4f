// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoCenteredRays.h"
#include "vtkRelievoHitColumns.h"
#include "vtkRelievoMovedPoints.h"
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayContent.h"
#include "vtkRelievoRaySceneFile.h"
#include "vtkRelievoRayTree.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoWorldCopies.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
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
}

//------------------------------------------------------------------------------
struct vtkRelievoRayScene::Internals : vtkRelievoRayContent
{
  std::set<vtkProp*> Warned; // of LeftOut
  bool Frozen = false;       // a copy of another scene's state, which is not updated
  std::vector<vtkRelievoPlacedMesh> FrozenMeshes;
  std::vector<vtkRelievoRaySource> FrozenSources;
  std::shared_ptr<const vtkRelievoRaySceneFile> File;
  std::vector<Hit>* Nearest = nullptr; // receives the nearest hits, if a caller needs them
  vtkRelievoRayTree Tree;

  bool SetMeshes(bool opaqueOnly);
  bool Refuse(const std::string& lack);
  void LeaveFile();
  std::uint64_t GetGeometry() const;
  void Write(
    const vtkRelievoHitColumns& columns, vtkIdType row, const Line& ray, const Hit& hit) const;
  glm::dvec3 GetShadingNormal(const Hit& hit, const vtkRelievoRayTree::Details& details) const;
};

//------------------------------------------------------------------------------
// Returns whether anything has changed. Without memory for the trees the scene is empty, with a
// fault.
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
  std::string lack;
  const bool changed = this->Tree.SetMeshes(this->Meshes, lack);
  return lack.empty() ? changed : this->Refuse(lack);
}

//------------------------------------------------------------------------------
// Empties the scene, with a fault.
bool vtkRelievoRayScene::Internals::Refuse(const std::string& lack)
{
  std::set<vtkPolyData*> counted;
  vtkIdType triangles = 0;
  for (const vtkRelievoPlacedMesh& placed : this->Meshes)
  {
    triangles +=
      counted.insert(placed.Mesh).second ? vtkRelievoPolygonCut::CountTriangles(placed.Mesh) : 0;
  }
  this->Fault = "no tree for rays at " + std::to_string(triangles) + " triangles: " + lack +
    ". Expected a coarser mesh, or more memory; each part of divided work needs the whole tree";
  this->Meshes.clear();
  this->Sources.clear();
  return true;
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
std::uint64_t vtkRelievoRayScene::Internals::GetGeometry() const
{
  return this->File ? this->File->Geometry : vtkRelievoRaySceneFile::HashGeometry(*this);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoRayScene::Internals::GetShadingNormal(
  const Hit& hit, const vtkRelievoRayTree::Details& details) const
{
  const vtkRelievoRaySource& source = this->Sources[this->Tree.GetMesh(hit.Place)];
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
  const vtkRelievoHitColumns& columns, vtkIdType row, const Line& ray, const Hit& hit) const
{
  const int index = this->Tree.GetMesh(hit.Place);
  const vtkRelievoPlacedMesh& placed = this->Meshes[index];
  const vtkRelievoRaySource& source = this->Sources[index];
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
  vtkRelievoHitColumns::Set(columns.Weights, row, details.Weights);
  vtkRelievoHitColumns::Set(columns.Position, row, details.Position);
  vtkRelievoHitColumns::Set(columns.Normal, row, this->GetShadingNormal(hit, details));
  const glm::dvec3 normal = glm::normalize(details.Normal);
  vtkRelievoHitColumns::Set(columns.GeometricNormal, row, details.Front ? normal : -normal);
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
    vtkRelievoForRanges(from, to, Grain, each);
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
  this->Internal->RemoveData();
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
  scene.Release();
  return changed;
}

//------------------------------------------------------------------------------
// Lists the meshes of the renderer and the data.
void vtkRelievoRayScene::Collect()
{
  Internals& scene = *this->Internal;
  scene.vtkRelievoRayContent::Collect(this->PointIds);
  std::set<vtkProp*> warned; // only of these props: others may be gone, and their addresses reused
  std::string names;
  for (vtkProp* prop : scene.LeftOut)
  {
    if (warned.insert(prop).second && scene.Warned.count(prop) == 0)
    {
      names += (names.empty() ? "" : ", ") + std::string(prop->GetClassName());
    }
  }
  scene.Warned = std::move(warned);
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
  const vtkRelievoCenteredRays rays(origins, directions, scene.Tree.GetCenter());
  const vtkRelievoHitColumns columns(hits, rays.GetCount());
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
  const vtkRelievoCenteredRays rays(origins, directions, scene.Tree.GetCenter());
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
  const vtkRelievoCenteredRays rays(origins, directions, scene.Tree.GetCenter());
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
      const vtkRelievoCenteredRays::Ray ray = rays.Get(row);
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
  vtkIdType* const numbers = vtkRelievoHitColumns::Add<vtkIdTypeArray>(hits, "ray", 1, count);
  const vtkRelievoHitColumns columns(hits, count);
  double* const opacities = vtkRelievoHitColumns::Add<vtkDoubleArray>(hits, "opacity", 1, count);
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
std::string vtkRelievoRayScene::GetFault() const
{
  return this->Internal->Fault;
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
    fault = vtkRelievoRaySceneFile::Write(
      path, scene, scene.Tree, this->GetNumberOfProps(), scene.GetGeometry());
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
  const auto file = std::make_shared<vtkRelievoRaySceneFile>();
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
      fault = path + vtkRelievoRaySceneFile::Unfit;
    }
    if (fault.empty())
    {
      file->GiveTrees(scene);
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
    scene.Release();
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
  to.RemoveData();
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
  const vtkRelievoMovedPoints moved(scene, scene.Tree, *later->Internal);
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
          : moved.Get(hit, weights);
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
  const vtkRelievoRaySource& source = this->Internal->Sources[static_cast<std::size_t>(number)];
  vtkRelievoWorldCopies::CopyInWorld(placed, source.Cells, copy);
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
