// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockCorners.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace relievo
{
namespace
{
// The corners of faces around each vertex, in the order of the faces.
struct Around
{
  std::vector<vtkIdType> Starts;
  std::vector<vtkIdType> Corners; // 4 * face + corner

  Around(const BlockSurface& surface)
    : Starts(surface.Points->GetNumberOfTuples() + 1, 0)
    , Corners(4 * surface.Faces.GetSize())
  {
    for (vtkIdType face = 0; face < surface.Faces.GetSize(); ++face)
    {
      for (const vtkTypeUInt32 point : surface.Faces[face].Points)
      {
        ++this->Starts[static_cast<vtkIdType>(point) + 1];
      }
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
    for (vtkIdType corner = 0; corner < 4 * surface.Faces.GetSize(); ++corner)
    {
      this->Corners[next[surface.Faces[corner / 4].Points[corner % 4]]++] = corner;
    }
  }
};

// Groups of a vertex's corners that share a normal: at most one for each face around the vertex.
struct Groups
{
  static constexpr int Most = 12;
  int Of[Most] = {};
  int Count = 0;
  std::array<float, 3> Normals[Most];
};

class Grouping
{
public:
  Grouping(const BlockSurface& surface, const BlockLabels& labels, const BlockSettings& settings,
    const BlockMeshSettings& mesh)
    : Surface(surface)
    , Labels(labels)
    , Settings(settings)
    , Mesh(mesh)
  {
    double transposed[3][3];
    vtkMath::Transpose3x3(settings.Axes, transposed);
    vtkMath::Invert3x3(transposed, this->NormalAxes);
  }

  Groups Of(const vtkIdType* corners, int count) const
  {
    Groups groups;
    vtkTypeInt64 materials[Groups::Most] = {};
    std::array<double, 3> areas[Groups::Most];
    std::array<double, 3> sums[Groups::Most] = {};
    int members[Groups::Most] = {};
    for (int i = 0; i < count; ++i)
    {
      const BlockFace& face = this->Surface.Faces[corners[i] / 4];
      const vtkTypeInt64 material =
        this->Mesh.SplitMaterials ? this->Labels.LabelAt(face.Owner) : 0;
      int group = 0;
      while (group < groups.Count && materials[group] != material)
      {
        ++group;
      }
      groups.Count = std::max(groups.Count, group + 1);
      materials[group] = material;
      groups.Of[i] = group;
      ++members[group];
      areas[i] = this->AreaOfFace(face);
      for (int c = 0; c < 3; ++c)
      {
        sums[group][c] += areas[i][c];
      }
    }
    if (!this->Settings.Normals)
    {
      return groups;
    }
    for (int group = 0, all = groups.Count; group < all; ++group)
    {
      if (this->SetNormal(sums[group], groups.Normals[group]) || members[group] == 1)
      {
        continue;
      }
      // The normals cancel out: each face keeps its own; the first face stays in this group.
      bool first = true;
      for (int i = 0; i < count; ++i)
      {
        if (groups.Of[i] == group)
        {
          groups.Of[i] = first ? group : groups.Count++;
          this->SetNormal(areas[i], groups.Normals[groups.Of[i]]);
          first = false;
        }
      }
    }
    return groups;
  }

  void SetNormalOf(const BlockFace& face, std::array<float, 3>& normal) const
  {
    this->SetNormal(this->AreaOfFace(face), normal);
  }

private:
  std::array<double, 3> AreaOfFace(const BlockFace& face) const
  {
    const BlockRule::Offset* corners[4];
    const bool inOrder = face.Low != (vtkMath::Determinant3x3(this->Settings.Axes) < 0.);
    for (int corner = 0; corner < 4; ++corner)
    {
      const int at = inOrder ? (face.First + corner) & 3 : (face.First + 4 - corner) & 3;
      corners[at] = &this->Surface.Offsets[face.Points[corner]];
    }
    std::array<double, 3> area = AreaOf(face.Axis, corners);
    if (!face.Low)
    {
      for (double& value : area)
      {
        value = -value;
      }
    }
    return area;
  }

  bool SetNormal(const std::array<double, 3>& area, std::array<float, 3>& normal) const
  {
    double turned[3];
    vtkMath::Multiply3x3(this->NormalAxes, area.data(), turned);
    vtkMath::Normalize(turned);
    for (int c = 0; c < 3; ++c)
    {
      normal[c] = static_cast<float>(turned[c]);
    }
    return !IsNull(area);
  }

  const BlockSurface& Surface;
  const BlockLabels& Labels;
  const BlockSettings& Settings;
  const BlockMeshSettings& Mesh;
  double NormalAxes[3][3];
};

// A face between two labels counts half for each; a face beside air counts fully for its label.
void MakeWeights(const BlockSurface& surface, const BlockLabels& labels, const Around& around,
  const BlockSettings& settings, std::vector<vtkTypeInt64> weighted, BlockCorners& result)
{
  const vtkTypeInt64 air = labels.LabelAt(-1);
  const vtkIdType faces = surface.Faces.GetSize();
  std::vector<vtkTypeInt64> materials(faces);
  std::vector<vtkTypeInt64> beyond(settings.Faces.BetweenLabels ? faces : 0);
  vtkRelievoForAll(faces, [&](vtkIdType i) {
    const BlockFace& face = surface.Faces[i];
    materials[i] = labels.LabelAt(face.Owner);
    if (!beyond.empty())
    {
      const vtkTypeInt64 other = labels.LabelAt(labels.Beside(face.Owner, face.Axis, face.Low));
      beyond[i] = other == air ? materials[i] : other;
    }
  });
  const std::vector<vtkTypeInt64>& others = beyond.empty() ? materials : beyond;
  if (weighted.empty())
  {
    weighted = materials;
    weighted.insert(weighted.end(), beyond.begin(), beyond.end());
  }
  std::sort(weighted.begin(), weighted.end());
  weighted.erase(std::unique(weighted.begin(), weighted.end()), weighted.end());
  for (const vtkTypeInt64 label : weighted)
  {
    result.WeightNames.push_back(std::to_string(label));
  }
  const std::size_t count = weighted.size();
  if (static_cast<vtkIdType>(count) > BlockMeshSettings::MostWeights)
  {
    return;
  }
  const vtkIdType vertices = surface.Points->GetNumberOfTuples();
  result.Weights.assign(count * vertices, 0.f);
  vtkRelievoForAll(vertices, [&](vtkIdType vertex) {
    const vtkIdType begin = around.Starts[vertex];
    const vtkIdType end = around.Starts[vertex + 1];
    for (std::size_t i = 0; i < count; ++i)
    {
      int halves = 0;
      for (vtkIdType corner = begin; corner < end; ++corner)
      {
        const vtkIdType face = around.Corners[corner] / 4;
        halves += (materials[face] == weighted[i]) + (others[face] == weighted[i]);
      }
      result.Weights[count * vertex + i] =
        static_cast<float>(halves) / static_cast<float>(2 * std::max<vtkIdType>(end - begin, 1));
    }
  });
}
}

//------------------------------------------------------------------------------
void SplitNullNormals(BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh)
{
  const Grouping grouping(surface, labels, settings, mesh);
  const vtkIdType vertices = surface.Points->GetNumberOfTuples();
  const float* normals = surface.Normals->GetPointer(0);
  const auto isNull = [normals](vtkIdType vertex) {
    const float* normal = normals + 3 * vertex;
    return normal[0] == 0.f && normal[1] == 0.f && normal[2] == 0.f;
  };
  std::vector<unsigned char> hasNull(surface.Faces.GetSize());
  vtkRelievoForAll(surface.Faces.GetSize(), [&](vtkIdType face) {
    const vtkTypeUInt32* points = surface.Faces[face].Points;
    hasNull[face] = std::any_of(points, points + 4, isNull);
  });
  // The first face at a vertex keeps the vertex; the others get points at the end.
  std::vector<bool> isUsed(vertices, false);
  std::vector<std::pair<vtkIdType, std::array<float, 3>>> kept;
  std::vector<std::pair<vtkIdType, std::array<float, 3>>> added;
  for (vtkIdType face = 0; face < surface.Faces.GetSize(); ++face)
  {
    if (!hasNull[face])
    {
      continue;
    }
    std::array<float, 3> normal;
    grouping.SetNormalOf(surface.Faces[face], normal);
    for (vtkTypeUInt32& point : surface.Faces[face].Points)
    {
      const vtkIdType vertex = point;
      if (isNull(vertex))
      {
        (isUsed[vertex] ? added : kept).emplace_back(vertex, normal);
        point = isUsed[vertex]
          ? static_cast<vtkTypeUInt32>(vertices + static_cast<vtkIdType>(added.size()) - 1)
          : point;
        isUsed[vertex] = true;
      }
    }
  }
  const auto count = vertices + static_cast<vtkIdType>(added.size());
  if (!added.empty())
  {
    // Keeps the values in every VTK: SetNumberOfTuples does not, and Resize is deprecated.
    const double place[3] = { 0.0, 0.0, 0.0 };
    surface.Points->InsertTuple(count - 1, place);
    surface.Normals->InsertTuple(count - 1, place);
  }
  for (const auto& vertex : kept)
  {
    surface.Normals->SetTypedTuple(vertex.first, vertex.second.data());
  }
  for (vtkIdType i = vertices; i < count; ++i)
  {
    double place[3];
    surface.Points->GetTuple(added[i - vertices].first, place);
    surface.Points->SetTuple(i, place);
    surface.Normals->SetTypedTuple(i, added[i - vertices].second.data());
  }
}

//------------------------------------------------------------------------------
BlockCorners MakeBlockCorners(const BlockSurface& surface, const BlockLabels& labels,
  const BlockSettings& settings, const BlockMeshSettings& mesh)
{
  BlockCorners result;
  const Around around(surface);
  const Grouping grouping(surface, labels, settings, mesh);
  const vtkIdType vertices = surface.Points->GetNumberOfTuples();
  const auto groupsOf = [&](vtkIdType vertex) {
    const vtkIdType begin = around.Starts[vertex];
    return grouping.Of(
      around.Corners.data() + begin, static_cast<int>(around.Starts[vertex + 1] - begin));
  };
  std::vector<vtkIdType> starts(vertices + 1, 0);
  vtkRelievoForAll(
    vertices, [&](vtkIdType vertex) { starts[vertex + 1] = groupsOf(vertex).Count; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  result.Points.resize(around.Corners.size());
  result.Vertices.resize(starts[vertices]);
  result.Normals.resize(settings.Normals ? starts[vertices] : 0);
  vtkRelievoForAll(vertices, [&](vtkIdType vertex) {
    const Groups groups = groupsOf(vertex);
    for (int group = 0; group < groups.Count; ++group)
    {
      result.Vertices[starts[vertex] + group] = vertex;
      if (settings.Normals)
      {
        result.Normals[starts[vertex] + group] = groups.Normals[group];
      }
    }
    for (vtkIdType i = around.Starts[vertex]; i < around.Starts[vertex + 1]; ++i)
    {
      result.Points[around.Corners[i]] = starts[vertex] + groups.Of[i - around.Starts[vertex]];
    }
  });
  if (mesh.Weights)
  {
    MakeWeights(surface, labels, around, settings, mesh.WeightedLabels, result);
  }
  if (!mesh.TextureCoordinates)
  {
    return result;
  }
  // Corners of two faces have different coordinates: each gets its own point.
  const auto corners = static_cast<vtkIdType>(around.Corners.size());
  result.Texture.resize(corners);
  std::vector<vtkIdType> ofCorners(corners);
  std::atomic<double> tileSize{ 0. };
  std::vector<std::array<float, 3>> normals(settings.Normals ? corners : 0);
  vtkRelievoForAll(corners / 4, [&](vtkIdType face) {
    const FaceTexture texture = TextureOf(surface.Faces[face], surface, labels, settings, mesh);
    double largest = tileSize;
    while (texture.TileSize > largest && !tileSize.compare_exchange_weak(largest, texture.TileSize))
    {
    }
    for (vtkIdType corner = 4 * face; corner < 4 * face + 4; ++corner)
    {
      const vtkIdType point = result.Points[corner];
      ofCorners[corner] = result.Vertices[point];
      if (settings.Normals)
      {
        normals[corner] = result.Normals[point];
      }
      result.Texture[corner] = texture.Places[corner - 4 * face];
      result.Points[corner] = corner;
    }
  });
  result.TileSize = tileSize;
  result.Vertices.swap(ofCorners);
  result.Normals.swap(normals);
  return result;
}
}
