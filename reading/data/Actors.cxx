// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Actors.h"

#include "DataSets.h"
#include "Errors.h"
#include "FinitePoints.h"
#include "Progress.h"
#include "ReadContext.h"
#include "TriangleMapper.h"
#include "VolumeImages.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkRelievoCompositeMapper.h"
#include "vtkRelievoConvexPolygons.h"
#include "vtkRelievoPointNormals.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkSMPTools.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace reading
{
namespace
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> Run(vtkAlgorithm* filter, vtkDataObject* data, Progress& progress)
{
  progress.Observe(filter);
  filter->SetInputDataObject(data);
  filter->Update();
  return filter->GetOutputDataObject(0);
}

//------------------------------------------------------------------------------
// Gives points without cells, such as a laser scan's, a vertex each, because VTK draws only cells.
// If a reader has removed cells, the points are not such a cloud.
vtkSmartPointer<vtkDataObject> WithVertices(vtkDataObject* data)
{
  const auto isCloud = [](vtkDataObject* object) {
    auto* block = vtkPointSet::SafeDownCast(object);
    return block && block->GetNumberOfCells() == 0 && block->GetNumberOfPoints() > 0 &&
      !block->GetCellData()->HasArray("vtkOriginalCellIds");
  };
  bool any = false;
  ForEachDataSet(data, [&](vtkDataSet* block) { any = any || isCloud(block); });
  if (!any)
  {
    return data;
  }
  return ReplaceDataSets(data, [&isCloud](vtkDataObject* object) {
    if (!isCloud(object))
    {
      return vtkSmartPointer<vtkDataObject>(object);
    }
    auto* block = vtkPointSet::SafeDownCast(object);
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      vertices->InsertNextCell(1, &i);
    }
    auto cloud = vtkSmartPointer<vtkPolyData>::New();
    cloud->SetPoints(block->GetPoints());
    cloud->SetVerts(vertices);
    cloud->GetPointData()->ShallowCopy(block->GetPointData());
    cloud->GetFieldData()->ShallowCopy(block->GetFieldData());
    return vtkSmartPointer<vtkDataObject>(cloud);
  });
}

//------------------------------------------------------------------------------
// Whether the array vtkGhostType hides a cell; tools use it for cut-off parts.
bool IsHidden(vtkDataSet* data, vtkIdType cell)
{
  return (data->GetCellGhostArray()->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) != 0;
}

bool HasHidden(vtkDataSet* data)
{
  const vtkIdType count = data->GetCellGhostArray() ? data->GetNumberOfCells() : 0;
  vtkIdType cell = 0;
  while (cell < count && !IsHidden(data, cell))
  {
    ++cell;
  }
  return cell < count;
}

// The polygons without hidden ones; `vtkOriginalCellIds` keeps the numbers of the others.
vtkSmartPointer<vtkDataObject> LeaveOutHidden(vtkDataObject* surface)
{
  return ReplaceDataSets(surface, [](vtkDataObject* block) {
    auto* mesh = vtkPolyData::SafeDownCast(block);
    if (!mesh || !HasHidden(mesh))
    {
      return vtkSmartPointer<vtkDataObject>(block);
    }
    auto shown = vtkSmartPointer<vtkPolyData>::New();
    shown->ShallowCopy(mesh);
    if (!shown->GetCellData()->HasArray("vtkOriginalCellIds"))
    {
      NumberCells(shown);
    }
    shown->BuildCells();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (IsHidden(mesh, cell))
      {
        shown->DeleteCell(cell);
      }
    }
    shown->RemoveDeletedCells();
    return vtkSmartPointer<vtkDataObject>(shown);
  });
}

//------------------------------------------------------------------------------
// Runs VTK's filter serially where its polygon numbers depend on the order in which threads finish,
// because the layer `cell` shows these numbers.
vtkSmartPointer<vtkDataObject> RunSurface(
  vtkGeometryFilter* surface, vtkDataObject* data, Progress& progress)
{
#ifdef RELIEVO_VTK_RANDOM_POLYGONS
  vtkSmartPointer<vtkDataObject> made;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ std::string("Sequential") }, [&] { made = Run(surface, data, progress); });
  return made;
#else
  return Run(surface, data, progress);
#endif
}

//------------------------------------------------------------------------------
// The polygons to draw. For a grid, `vtkOriginalCellIds` maps each polygon to the cell that it
// bounds.
vtkSmartPointer<vtkDataObject> Surface(vtkDataObject* data, Progress& progress)
{
  bool polygonal = true;
  ForEachDataSet(
    data, [&polygonal](vtkDataSet* block) { polygonal = polygonal && block->IsA("vtkPolyData"); });
  if (polygonal)
  {
    return data;
  }
  return ReplaceDataSets(data, [&progress](vtkDataObject* block) {
    const bool structured = block->IsA("vtkImageData") || block->IsA("vtkRectilinearGrid") ||
      block->IsA("vtkStructuredGrid");
    vtkNew<vtkGeometryFilter> surface;
    if (structured) // may have more cells than memory can number
    {
      surface->PassThroughCellIdsOn();
      const vtkSmartPointer<vtkDataObject> made = RunSurface(surface, block, progress);
      auto* image = vtkImageData::SafeDownCast(block);
      auto* faces = vtkPolyData::SafeDownCast(made);
      return image && faces ? vtkSmartPointer<vtkDataObject>(TurnOutwards(faces, image)) : made;
    }
    // With nonlinear cells, the filter's numbers refer to its copy without them.
    vtkSmartPointer<vtkDataObject> numbered = CopyDataSets(block);
    ForEachDataSet(numbered, NumberCells);
    // Hidden cells go first: their neighbours then get faces there.
    auto* grid = vtkUnstructuredGrid::SafeDownCast(numbered);
    if (grid && HasHidden(grid))
    {
      const char* const name = "vtkRelievoShown";
      vtkNew<vtkUnsignedCharArray> shown;
      shown->SetName(name);
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        shown->InsertNextValue(IsHidden(grid, cell) ? 0 : 1);
      }
      grid->GetCellData()->AddArray(shown);
      vtkNew<vtkThreshold> threshold;
      threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name);
      threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
      threshold->SetUpperThreshold(1.0);
      numbered = Run(threshold, grid, progress);
      vtkDataSet::SafeDownCast(numbered)->GetCellData()->RemoveArray(name);
    }
    return RunSurface(surface, numbered, progress);
  });
}

//------------------------------------------------------------------------------
bool LacksNormals(vtkPolyData* mesh)
{
  return mesh && !mesh->GetPointData()->GetNormals() && !mesh->GetCellData()->GetNormals() &&
    mesh->GetNumberOfPolys() > 0;
}

// Whether vertices or lines use points that no polygon uses: their normals would be undefined.
bool LeavesUnlit(vtkPolyData* mesh)
{
  std::vector<bool> ofPolygons(static_cast<std::size_t>(mesh->GetNumberOfPoints()), false);
  const auto forEach = [](vtkCellArray* cells, const auto& visit) {
    vtkDataArray* corners = cells->GetConnectivityArray();
    for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i)
    {
      visit(static_cast<std::size_t>(corners->GetTuple1(i)));
    }
  };
  if (mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() == 0)
  {
    return false;
  }
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    forEach(cells, [&ofPolygons](std::size_t point) { ofPolygons[point] = true; });
  }
  bool unlit = false;
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines() })
  {
    forEach(cells, [&](std::size_t point) { unlit = unlit || !ofPolygons[point]; });
  }
  return unlit;
}

//------------------------------------------------------------------------------
// VTK's time for normals grows with the square or cube of the number of polygons at a point or an
// edge. Where it is large, as with a repeated polygon, each polygon gets points of its own, and so
// the normal of its plane.
vtkSmartPointer<vtkDataObject> SeparateCrowded(vtkPolyData* mesh)
{
  constexpr int mostAtEdge = 64;
  constexpr int mostAtPoint = 4096;
  std::vector<int> counts(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 0);
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, corners);
    std::for_each(
      corners, corners + size, [&](vtkIdType point) { ++counts[static_cast<std::size_t>(point)]; });
  }
  if (*std::max_element(counts.begin(), counts.end()) <= mostAtEdge)
  {
    return mesh;
  }
  const auto isCrowded = [&] {
    const auto above = [&](int most) {
      return std::count_if(corners, corners + size,
        [&](vtkIdType point) { return counts[static_cast<std::size_t>(point)] > most; });
    };
    return above(mostAtEdge) > 1 || above(mostAtPoint) > 0;
  };
  std::vector<vtkIdType> sources(counts.size()); // source point of each new point
  std::iota(sources.begin(), sources.end(), vtkIdType(0));
  vtkNew<vtkCellArray> separate;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, corners);
    const bool alone = isCrowded();
    separate->InsertNextCell(static_cast<int>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      separate->InsertCellPoint(alone ? static_cast<vtkIdType>(sources.size()) : corners[i]);
      if (alone)
      {
        sources.push_back(corners[i]);
      }
    }
  }
  if (sources.size() == counts.size())
  {
    return mesh;
  }
  vtkNew<vtkIdList> from;
  from->SetNumberOfIds(static_cast<vtkIdType>(sources.size()));
  std::copy(sources.begin(), sources.end(), from->GetPointer(0));
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  mesh->GetPoints()->GetPoints(from, points);
  result->SetPoints(points);
  result->SetPolys(separate);
  result->GetPointData()->Initialize();
  result->GetPointData()->CopyAllOn();
  result->GetPointData()->CopyAllocate(mesh->GetPointData(), from->GetNumberOfIds());
  for (vtkIdType i = 0; i < from->GetNumberOfIds(); ++i)
  {
    result->GetPointData()->CopyData(mesh->GetPointData(), from->GetId(i), i);
  }
  return result;
}

//------------------------------------------------------------------------------
// Leaves meshes unchanged if smooth normals would make their lines black.
vtkSmartPointer<vtkDataObject> WithNormals(
  vtkDataObject* data, const std::string& path, ReadContext& context)
{
  bool needed = false;
  ForEachDataSet(data, [&needed](vtkDataSet* block) {
    needed = needed || LacksNormals(vtkPolyData::SafeDownCast(block));
  });
  if (!needed)
  {
    return data;
  }
  bool unlit = false;
  const auto smooth = ReplaceDataSets(data, [&](vtkDataObject* block) {
    vtkPolyData* mesh = vtkPolyData::SafeDownCast(block);
    const bool kept = LacksNormals(mesh) && LeavesUnlit(mesh);
    unlit = unlit || kept;
    if (kept || !LacksNormals(mesh))
    {
      return vtkSmartPointer<vtkDataObject>(block);
    }
    // Either filter keeps the file's winding, as the author's other tools do.
    if (mesh->GetNumberOfCells() == mesh->GetNumberOfPolys())
    {
      vtkNew<vtkRelievoPointNormals> fast;
      context.GetProgress().Observe(fast);
      auto result = vtkSmartPointer<vtkPolyData>::New();
      fast->MakeNormals(mesh, result);
      return vtkSmartPointer<vtkDataObject>(result);
    }
    vtkNew<vtkPolyDataNormals> normals;
    normals->ConsistencyOff();
    return Run(normals, SeparateCrowded(mesh), context.GetProgress());
  });
  if (unlit)
  {
    context.Note(path +
      ": drawn without smooth normals, which would leave its lines or points "
      "without any; give it normals to smooth it");
  }
  return smooth;
}

//------------------------------------------------------------------------------
// VTK lights a triangle's front, whose corners run counterclockwise, by its normal, and its back by
// the reversed normal. If the file's normals oppose the winding, both sides are dark.
void NoteNormals(vtkDataObject* surface, const std::string& path, ReadContext& context)
{
  vtkIdType corners = 0;
  vtkIdType against = 0;
  ForEachDataSet(surface, [&](vtkDataSet* block) {
    auto* mesh = vtkPolyData::SafeDownCast(block);
    vtkDataArray* normals = mesh ? mesh->GetPointData()->GetNormals() : nullptr;
    if (!normals || normals->GetNumberOfComponents() != 3)
    {
      return;
    }
    vtkNew<vtkIdList> points;
    auto faces = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (faces->GoToFirstCell(); !faces->IsDoneWithTraversal(); faces->GoToNextCell())
    {
      faces->GetCurrentCell(points);
      double face[3];
      vtkPolygon::ComputeNormal(
        mesh->GetPoints(), static_cast<int>(points->GetNumberOfIds()), points->GetPointer(0), face);
      for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
      {
        const double side = vtkMath::Dot(face, normals->GetTuple3(points->GetId(i)));
        corners += side != 0.0 ? 1 : 0;
        against += side < 0.0 ? 1 : 0;
      }
    }
  });
  if (2 * against > corners)
  {
    context.Note(path +
      ": most of its normals point against the winding of its faces, and VTK draws these dark; "
      "turn its normals, or the order of its faces' points");
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> MakeSurface(
  vtkDataObject* data, bool smooth, const std::string& path, ReadContext& context)
{
  if (!vtkDataSet::SafeDownCast(data) && !vtkCompositeDataSet::SafeDownCast(data))
  {
    throw WorkError(
      path + ": holds a " + data->GetClassName() + ", expected a mesh, a grid or an image");
  }
  vtkSmartPointer<vtkDataObject> surface = LeaveOutInfinite(
    LeaveOutHidden(Surface(WithVertices(data), context.GetProgress())), path, context);
  // Before normals: VTK's normals of such polygons may point to the wrong side.
  surface = ReplaceDataSets(surface, [&context](vtkDataObject* block) {
    auto* mesh = vtkPolyData::SafeDownCast(block);
    if (!mesh)
    {
      return vtkSmartPointer<vtkDataObject>(block);
    }
    if (mesh->GetPolys()->IsHomogeneous() == 3) // a pipeline costs more than a small mesh
    {
      return CopyDataSets(mesh);
    }
    vtkNew<vtkRelievoConvexPolygons> convex;
    return Run(convex, block, context.GetProgress());
  });
  NoteNormals(surface, path, context);
  if (smooth)
  {
    surface = WithNormals(surface, path, context);
  }
  context.Check(path);
  return surface;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> DrawSurface(vtkDataObject* surface)
{
  vtkSmartPointer<vtkMapper> mapper;
  if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(surface))
  {
    vtkNew<TriangleMapper> single;
    single->SetInputData(mesh);
    mapper = single;
  }
  else
  {
    vtkNew<vtkRelievoCompositeMapper> composite;
    composite->SetInputDataObject(surface);
    mapper = composite;
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPhong();
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(
  vtkDataObject* data, bool smooth, const std::string& path, ReadContext& context)
{
  return DrawSurface(MakeSurface(data, smooth, path, context));
}

//------------------------------------------------------------------------------
void AddArrayNames(vtkActor* actor, ArrayNames& arrays)
{
  if (!actor->GetMapper())
  {
    return;
  }
  actor->GetMapper()->Update();
  const auto add = [&](vtkDataSetAttributes* attributes, const char* place) {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() && array->GetDataType() != VTK_BIT) // VTK cannot draw bits
      {
        arrays.Names.insert(array->GetName());
        arrays.Placed.insert(std::string(place) + array->GetName());
      }
    }
  };
  ForEachDataSet(actor->GetMapper()->GetInputDataObject(0, 0), [&add](vtkDataSet* block) {
    add(block->GetPointData(), "point:");
    add(block->GetCellData(), "cell:");
  });
}
}
