// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockMesh.h"

#include "vtkRelievoBlockCorners.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoReserve.h"
#include "vtkRelievoThreads.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>
#include <type_traits>

namespace relievo
{
namespace
{
bool IsIn(const std::array<int, 6>& range, vtkIdType place, const BlockBox& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto index = static_cast<int>(place % box.Size[axis]) + 1;
    place /= box.Size[axis];
    if (index < range[2 * axis] || index > range[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}

// Selected indices; an empty list selects all.
struct Selection
{
  std::vector<vtkIdType> List;
  vtkIdType Count = 0;
  vtkIdType operator[](vtkIdType i) const { return this->List.empty() ? i : this->List[i]; }
};

Selection SelectFaces(
  const BlockSurface& surface, const BlockLabels& labels, const BlockMeshSettings& mesh)
{
  Selection selection;
  selection.Count = surface.Faces.GetSize();
  if (mesh.HasGhosts)
  {
    for (vtkIdType i = 0; i < selection.Count; ++i)
    {
      if (IsIn(mesh.Included, surface.Faces[i].Owner, labels.GetBox()))
      {
        selection.List.push_back(i);
      }
    }
    selection.Count = static_cast<vtkIdType>(selection.List.size());
  }
  return selection;
}

// Polygons of four points each: pointOf(quad, corner).
template <typename ArrayType, typename PointOf>
void MakeCells(vtkIdType quads, bool triangles, vtkPolyData* output, PointOf&& pointOf)
{
  using Id = typename ArrayType::ValueType;
  const int corners = triangles ? 3 : 4;
  const vtkIdType cells = triangles ? 2 * quads : quads;
  vtkNew<ArrayType> offsets;
  offsets->SetNumberOfValues(cells + 1);
  vtkNew<ArrayType> connectivity;
  connectivity->SetNumberOfValues(corners * cells);
  Id* starts = offsets->GetPointer(0);
  Id* ids = connectivity->GetPointer(0);
  vtkRelievoForAll(cells + 1, [&](vtkIdType i) { starts[i] = static_cast<Id>(corners * i); });
  static const int fan[6] = { 0, 1, 2, 0, 2, 3 };
  vtkRelievoForAll(quads, [&](vtkIdType quad) {
    Id* to = ids + (triangles ? 6 : 4) * quad;
    for (int i = 0; i < (triangles ? 6 : 4); ++i)
    {
      to[i] = static_cast<Id>(pointOf(quad, triangles ? fan[i] : i));
    }
  });
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  output->SetPolys(polygons);
}

// An array with a value for each cell. VTK's mappers take unsigned bytes for colours, so labels of
// that type become short.
template <typename LabelOfFace>
void AddLabels(int type, const char* name, vtkIdType faces, int cellsPerFace, vtkPolyData* output,
  LabelOfFace&& labelOf)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(type == VTK_UNSIGNED_CHAR ? VTK_SHORT : type));
  array->SetName(name);
  array->SetNumberOfTuples(cellsPerFace * faces);
  switch (array->GetDataType())
  {
    vtkTemplateMacro(if constexpr (std::is_integral<VTK_TT>::value) {
      auto* values = static_cast<VTK_TT*>(array->GetVoidPointer(0));
      vtkRelievoForAll(faces, [&](vtkIdType face) {
        const auto value = static_cast<VTK_TT>(labelOf(face));
        for (int i = 0; i < cellsPerFace; ++i)
        {
          values[cellsPerFace * face + i] = value;
        }
      });
    });
  }
  output->GetCellData()->AddArray(array);
}

// Copies the tuples of the selected points.
template <typename T>
void CopyTuples(const T* from, int components, const Selection& points, T* to)
{
  vtkRelievoForAll(points.Count, [&](vtkIdType i) {
    std::memcpy(to + components * i, from + components * points[i], sizeof(T) * components);
  });
}

vtkSmartPointer<vtkFloatArray> FloatsOf(
  const float* values, int components, const Selection& points, const char* name)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(points.Count);
  CopyTuples(values, components, points, array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkDataArray> PointsOf(vtkDataArray* vertices, const Selection& which)
{
  vtkSmartPointer<vtkDataArray> points;
  points.TakeReference(vtkDataArray::CreateDataArray(vertices->GetDataType()));
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(which.Count);
  if (vertices->GetDataType() == VTK_DOUBLE)
  {
    CopyTuples(static_cast<double*>(vertices->GetVoidPointer(0)), 3, which,
      static_cast<double*>(points->GetVoidPointer(0)));
  }
  else
  {
    CopyTuples(static_cast<float*>(vertices->GetVoidPointer(0)), 3, which,
      static_cast<float*>(points->GetVoidPointer(0)));
  }
  return points;
}

// Numbers the points that the cells use, in order, and renumbers the cells.
Selection UsedPoints(std::vector<vtkIdType>& cells, vtkIdType count, bool all)
{
  Selection selection;
  selection.Count = count;
  if (all)
  {
    return selection;
  }
  std::vector<vtkIdType> numbers(count, -1);
  for (const vtkIdType point : cells)
  {
    numbers[point] = 0;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (numbers[i] == 0)
    {
      numbers[i] = static_cast<vtkIdType>(selection.List.size());
      selection.List.push_back(i);
    }
  }
  for (vtkIdType& point : cells)
  {
    point = numbers[point];
  }
  selection.Count = static_cast<vtkIdType>(selection.List.size());
  return selection;
}

void MarkGhosts(const BlockSurface& surface, const BlockLabels& labels,
  const BlockMeshSettings& mesh, const Selection& faces, int cellsPerFace, vtkPolyData* output)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(cellsPerFace * faces.Count);
  unsigned char* values = ghosts->GetPointer(0);
  vtkRelievoForAll(faces.Count, [&](vtkIdType i) {
    const bool owned = IsIn(mesh.Owned, surface.Faces[faces[i]].Owner, labels.GetBox());
    std::memset(
      values + cellsPerFace * i, owned ? 0 : vtkDataSetAttributes::DUPLICATECELL, cellsPerFace);
  });
  output->GetCellData()->AddArray(ghosts);
}
}

//------------------------------------------------------------------------------
BlockMeshReport MakeBlockMesh(BlockSurface& surface, const BlockLabels& labels, vtkDataArray* array,
  const BlockSettings& settings, const BlockMeshSettings& mesh, vtkPolyData* output)
{
  const Selection faces = SelectFaces(surface, labels, mesh);
  const bool fits =
    surface.Points->GetNumberOfTuples() + 12 * surface.NullNormals < VTK_TYPE_UINT32_MAX;
  const bool own = mesh.SplitMaterials || mesh.TextureCoordinates || mesh.Weights ||
    (surface.NullNormals > 0 && !fits);
  BlockCorners corners;
  if (!own && surface.NullNormals > 0)
  {
    SplitNullNormals(surface, labels, settings, mesh);
  }
  if (own)
  {
    corners = MakeBlockCorners(surface, labels, settings, mesh);
  }
  std::vector<vtkIdType> cells; // if they are not those of the faces
  if (own || mesh.HasGhosts)
  {
    cells.resize(4 * faces.Count);
    vtkRelievoForAll(4 * faces.Count, [&](vtkIdType i) {
      const vtkIdType face = faces[i / 4];
      cells[i] = own ? corners.Points[4 * face + i % 4]
                     : static_cast<vtkIdType>(surface.Faces[face].Points[i % 4]);
    });
  }
  const vtkIdType count =
    own ? static_cast<vtkIdType>(corners.Vertices.size()) : surface.Points->GetNumberOfTuples();
  const Selection selection = UsedPoints(cells, count, !mesh.HasGhosts);
  Selection vertices = selection; // the vertex of each point
  if (own)
  {
    vertices.List.resize(selection.Count);
    vtkRelievoForAll(
      selection.Count, [&](vtkIdType i) { vertices.List[i] = corners.Vertices[selection[i]]; });
  }
  const bool asTheyAre = vertices.List.empty() && selection.Count == count;
  vtkNew<vtkPoints> points;
  points->SetData(asTheyAre ? surface.Points : PointsOf(surface.Points, vertices));
  output->SetPoints(points);
  if (settings.Normals)
  {
    output->GetPointData()->SetNormals(own
        ? FloatsOf(
            corners.Normals.empty() ? nullptr : corners.Normals[0].data(), 3, selection, "Normals")
        : (asTheyAre ? surface.Normals
                     : FloatsOf(surface.Normals->GetPointer(0), 3, selection, "Normals")));
  }
  if (mesh.TextureCoordinates)
  {
    output->GetPointData()->SetTCoords(
      FloatsOf(corners.Texture.empty() ? nullptr : corners.Texture[0].data(), 2, selection,
        "Texture Coordinates"));
  }
  if (!corners.Weights.empty())
  {
    const auto components = static_cast<int>(corners.WeightNames.size());
    vtkSmartPointer<vtkFloatArray> weights =
      FloatsOf(corners.Weights.data(), components, vertices, "weights");
    for (int i = 0; i < components; ++i)
    {
      weights->SetComponentName(i, corners.WeightNames[i].c_str());
    }
    output->GetPointData()->AddArray(weights);
  }
  const vtkIdType largest = std::max<vtkIdType>(6 * faces.Count + 1, selection.Count);
  const auto pointOf = [&](vtkIdType quad, int corner) {
    return cells.empty() ? static_cast<vtkIdType>(surface.Faces[quad].Points[corner])
                         : cells[4 * quad + corner];
  };
  if (largest < VTK_TYPE_INT32_MAX)
  {
    MakeCells<vtkTypeInt32Array>(faces.Count, mesh.Triangles, output, pointOf);
  }
  else
  {
    MakeCells<vtkTypeInt64Array>(faces.Count, mesh.Triangles, output, pointOf);
  }
  const int cellsPerFace = mesh.Triangles ? 2 : 1;
  AddLabels(array->GetDataType(), "material", faces.Count, cellsPerFace, output,
    [&](vtkIdType i) { return labels.LabelAt(surface.Faces[faces[i]].Owner); });
  if (settings.Faces.BetweenLabels)
  {
    const int type = labels.CanHoldAir() ? array->GetDataType() : VTK_TYPE_INT64;
    AddLabels(type, "neighbor", faces.Count, cellsPerFace, output, [&](vtkIdType i) {
      const BlockFace& face = surface.Faces[faces[i]];
      return labels.LabelAt(labels.Beside(face.Owner, face.Axis, face.Low));
    });
  }
  output->GetCellData()->SetActiveScalars("material");
  if (mesh.HasGhosts)
  {
    MarkGhosts(surface, labels, mesh, faces, cellsPerFace, output);
  }
  return { static_cast<vtkIdType>(corners.WeightNames.size()), corners.TileSize };
}

//------------------------------------------------------------------------------
void MakeBlockSeams(const BlockSurface& surface, const std::array<int, 6>& owned,
  const std::array<int, 3>& size, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(surface.Points->GetDataType());
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> uses;
  uses->SetName("uses");
  // Allocated at once: growing takes twice the room.
  const auto most = static_cast<vtkIdType>(surface.Seams.size());
  Reserve(points, 2 * most);
  lines->AllocateExact(most, 2 * most);
  Reserve(uses, most);
  for (const BlockSeam& seam : surface.Seams)
  {
    bool mine = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      // Vertex i is below block i + 1; the last vertices have no such block.
      const int last = owned[2 * axis + 1];
      const int vertex = seam.Vertex[axis] + 1;
      mine = mine && vertex >= owned[2 * axis] &&
        (vertex <= last || (last == size[axis] && vertex == last + 1));
    }
    if (mine)
    {
      lines->InsertNextCell(2);
      for (const vtkIdType point : seam.Points)
      {
        double place[3];
        surface.Points->GetTuple(point, place);
        lines->InsertCellPoint(points->InsertNextPoint(place));
      }
      uses->InsertNextValue(seam.Uses);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(uses);
}
}
