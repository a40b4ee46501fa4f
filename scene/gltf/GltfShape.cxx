// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfShape.h"

#include "GltfMaterials.h"
#include "GltfSurface.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTriangleFilter.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace scene
{
namespace
{
bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The cells of a surface in triangles, lines and points, with the number of the mesh's cell that
// each is a part of.
class Pieces
{
public:
  explicit Pieces(const GltfSurface& surface)
  {
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(surface.Mesh);
    vtkNew<vtkIdTypeArray> numbers;
    numbers->SetName(NumbersName);
    numbers->SetNumberOfValues(copy->GetNumberOfCells());
    for (vtkIdType i = 0; i < numbers->GetNumberOfValues(); ++i)
    {
      numbers->SetValue(i, i);
    }
    copy->GetCellData()->AddArray(numbers);
    this->Filter->SetInputData(copy);
    this->Filter->Update();
    this->Mesh = this->Filter->GetOutput();
    this->Numbers =
      vtkIdTypeArray::SafeDownCast(this->Mesh->GetCellData()->GetAbstractArray(NumbersName));
  }

  // Calls work(cell, corners) for each cell of verts, lines and polygons.
  template <typename Work>
  void ForVerts(Work&& work) const
  {
    this->For(this->Mesh->GetVerts(), 0, work);
  }
  template <typename Work>
  void ForLines(Work&& work) const
  {
    this->For(this->Mesh->GetLines(), this->Mesh->GetNumberOfVerts(), work);
  }
  template <typename Work>
  void ForTriangles(Work&& work) const
  {
    this->For(this->Mesh->GetPolys(),
      this->Mesh->GetNumberOfVerts() + this->Mesh->GetNumberOfLines(), work);
  }

  vtkPolyData* GetMesh() const { return this->Mesh; }

private:
  static constexpr const char* NumbersName = "relievo cell";

  template <typename Work>
  void For(vtkCellArray* cells, vtkIdType first, Work&& work) const
  {
    auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
    vtkIdType place = first;
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++place)
    {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      it->GetCurrentCell(count, corners);
      work(this->Numbers->GetValue(place), corners, count);
    }
  }

  vtkNew<vtkTriangleFilter> Filter;
  vtkPolyData* Mesh = nullptr;
  vtkIdTypeArray* Numbers = nullptr;
};

// Makes a primitive of a surface's cells.
class Maker
{
public:
  Maker(const GltfSurface& surface, const Pieces& pieces, const glm::dmat4& baked,
    GltfPrimitive::Kind kind)
    : Surface(surface)
    , Mesh(pieces.GetMesh())
    , Baked(baked)
  {
    this->Made.Mode = kind;
    vtkPolyData* const mesh = this->Mesh;
    vtkProperty* property = surface.Actor->GetProperty();
    if (kind == GltfPrimitive::Triangles && property->GetInterpolation() != VTK_FLAT)
    {
      this->PointNormals = mesh->GetPointData()->GetNormals();
      this->CellNormals = this->PointNormals ? nullptr : surface.Mesh->GetCellData()->GetNormals();
    }
    this->Coordinates =
      surface.Map ? surface.MapCoordinates.Get() : mesh->GetPointData()->GetTCoords();
    if (this->Coordinates && this->Coordinates->GetNumberOfTuples() != mesh->GetNumberOfPoints())
    {
      this->Coordinates = nullptr;
    }
    this->ByCell =
      this->CellNormals || (surface.Colors && surface.Of == GltfSurface::ColorsOf::Cells);
    this->IsLinear = HasLinearColors(surface);
  }

  GltfPrimitive& Get() { return this->Made; }

  // Adds a cell at each of the surface's places, unless a corner is not finite.
  void Add(vtkIdType cell, const vtkIdType* corners, vtkIdType count)
  {
    for (std::size_t place = 0; place < this->GetNumberOfPlaces(); ++place)
    {
      this->AddAt(place, cell, corners, count);
    }
  }

private:
  std::size_t GetNumberOfPlaces() const
  {
    return this->Surface.Places ? this->Surface.Places->size() : 1;
  }

  void AddAt(std::size_t place, vtkIdType cell, const vtkIdType* corners, vtkIdType count)
  {
    const glm::dmat4 matrix =
      this->Surface.Places ? this->Baked * (*this->Surface.Places)[place] : this->Baked;
    std::array<std::uint32_t, 3> added{};
    for (vtkIdType i = 0; i < count; ++i)
    {
      glm::dvec3 point;
      this->Mesh->GetPoint(corners[i], &point.x);
      point = glm::dvec3(matrix * glm::dvec4(point, 1.));
      if (!IsFinite(point))
      {
        return;
      }
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      added[static_cast<std::size_t>(i)] = this->AddVertex(place, matrix, cell, corners[i]);
    }
    if (count == 3 && glm::determinant(glm::dmat3(matrix)) < 0.)
    {
      std::swap(added[1], added[2]); // a mirrored triangle has its other side outside
    }
    this->Made.Indices.insert(this->Made.Indices.end(), added.begin(), added.begin() + count);
  }

  std::uint32_t AddVertex(
    std::size_t place, const glm::dmat4& matrix, vtkIdType cell, vtkIdType point)
  {
    const auto next = static_cast<std::uint32_t>(this->Made.Positions.size());
    if (!this->ByCell)
    {
      const auto [found, isNew] = this->Vertices.emplace(
        static_cast<vtkIdType>(place) * this->Mesh->GetNumberOfPoints() + point, next);
      if (!isNew)
      {
        return found->second;
      }
    }
    glm::dvec3 at;
    this->Mesh->GetPoint(point, &at.x);
    this->Made.Positions.emplace_back(matrix * glm::dvec4(at, 1.));
    vtkDataArray* normals = this->PointNormals ? this->PointNormals : this->CellNormals;
    if (normals)
    {
      glm::dvec3 normal;
      normals->GetTuple(this->PointNormals ? point : cell, &normal.x);
      normal = glm::transpose(glm::inverse(glm::dmat3(matrix))) * normal;
      const double length = glm::length(normal);
      // glTF has unit vectors alone.
      const glm::vec3 unit(
        length > 0. && std::isfinite(length) ? normal / length : glm::dvec3(0., 0., 1.));
      this->Made.Normals.insert(this->Made.Normals.end(), { unit.x, unit.y, unit.z });
    }
    if (this->Coordinates)
    {
      const double u = this->Coordinates->GetComponent(point, 0);
      const double v = this->Coordinates->GetNumberOfComponents() > 1
        ? this->Coordinates->GetComponent(point, 1)
        : 0.;
      this->Made.Coordinates.insert(
        this->Made.Coordinates.end(), { static_cast<float>(u), static_cast<float>(1. - v) });
    }
    if (this->Surface.Colors)
    {
      const vtkIdType tuple = this->Surface.Of == GltfSurface::ColorsOf::Cells ? cell
        : this->Surface.Of == GltfSurface::ColorsOf::Places ? (*this->Surface.Points)[place]
                                                            : point;
      for (int i = 0; i < 4; ++i)
      {
        const double level = this->Surface.Colors->GetComponent(tuple, i) / 255.;
        const double light = i == 3 ? level : ToLinearFromMapped(level, this->IsLinear);
        this->Made.Colors.push_back(static_cast<std::uint16_t>(std::lround(65535. * light)));
      }
    }
    return next;
  }

  const GltfSurface& Surface;
  vtkPolyData* Mesh;
  glm::dmat4 Baked;
  vtkDataArray* PointNormals = nullptr;
  vtkDataArray* CellNormals = nullptr;
  vtkDataArray* Coordinates = nullptr;
  bool ByCell = false; // no two cells share a vertex
  bool IsLinear = false;
  std::unordered_map<vtkIdType, std::uint32_t> Vertices;
  GltfPrimitive Made;
};
}

//------------------------------------------------------------------------------
std::optional<GltfPlace> GltfPlace::Find(const glm::dmat4& matrix)
{
  GltfPlace place;
  place.Translation = glm::dvec3(matrix[3]);
  glm::dmat3 axes(matrix);
  for (int i = 0; i < 3; ++i)
  {
    place.Scale[i] = glm::length(axes[i]);
    axes[i] /= place.Scale[i];
  }
  constexpr double round = 1e-6;
  const double shear = std::max({ std::abs(glm::dot(axes[0], axes[1])),
    std::abs(glm::dot(axes[1], axes[2])), std::abs(glm::dot(axes[2], axes[0])) });
  if (!(shear <= round)) // or NaN
  {
    return std::nullopt;
  }
  constexpr double last = 1e-14; // the last bits of a rotation's axes
  if (glm::length(place.Scale - glm::dvec3(1.)) < last)
  {
    place.Scale = glm::dvec3(1.);
  }
  if (glm::determinant(axes) < 0.)
  {
    place.Scale.x = -place.Scale.x;
    axes[0] = -axes[0];
  }
  const glm::dquat rotation = glm::normalize(glm::quat_cast(axes));
  place.Rotation = { rotation.x, rotation.y, rotation.z, rotation.w };
  return place;
}

//------------------------------------------------------------------------------
glm::dvec3 GltfPlace::Turn(const glm::dvec3& vector) const
{
  const glm::dquat rotation(this->Rotation.w, this->Rotation.x, this->Rotation.y, this->Rotation.z);
  return rotation * (this->Scale * vector);
}

//------------------------------------------------------------------------------
GltfBuffer::Json GltfPlace::GetNode(const std::string& name) const
{
  GltfBuffer::Json node;
  if (!name.empty())
  {
    node["name"] = name;
  }
  if (this->Translation != glm::dvec3(0.))
  {
    node["translation"] = { this->Translation.x, this->Translation.y, this->Translation.z };
  }
  if (this->Rotation != glm::dvec4(0., 0., 0., 1.))
  {
    node["rotation"] = { this->Rotation.x, this->Rotation.y, this->Rotation.z, this->Rotation.w };
  }
  if (this->Scale != glm::dvec3(1.))
  {
    node["scale"] = { this->Scale.x, this->Scale.y, this->Scale.z };
  }
  return node;
}

//------------------------------------------------------------------------------
GltfShape::GltfShape(const GltfSurface& surface)
{
  const std::optional<GltfPlace> found = GltfPlace::Find(surface.MeshToWorld);
  this->Place = found.value_or(GltfPlace());
  this->IsPlaced = found.has_value();
  const glm::dmat4 baked = found ? glm::dmat4(1.) : surface.MeshToWorld;
  const int representation = surface.Actor->GetProperty()->GetRepresentation();
  const Pieces pieces(surface);
  Maker triangles(surface, pieces, baked, GltfPrimitive::Triangles);
  Maker lines(surface, pieces, baked, GltfPrimitive::Lines);
  Maker points(surface, pieces, baked, GltfPrimitive::Points);
  const auto addCorners = [&points](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
    for (vtkIdType i = 0; i < count; ++i)
    {
      points.Add(cell, corners + i, 1);
    }
  };
  const auto addLine = [&lines](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
    lines.Add(cell, corners, count);
  };
  pieces.ForVerts(addCorners);
  if (representation == VTK_POINTS)
  {
    pieces.ForLines(addCorners);
    pieces.ForTriangles(addCorners);
  }
  else
  {
    pieces.ForLines(addLine);
  }
  if (representation == VTK_WIREFRAME)
  {
    std::set<std::pair<vtkIdType, vtkIdType>> edges;
    pieces.ForTriangles([&](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
      for (vtkIdType i = 0; i < count; ++i)
      {
        const vtkIdType ends[2] = { corners[i], corners[(i + 1) % count] };
        if (edges.insert(std::minmax(ends[0], ends[1])).second)
        {
          addLine(cell, ends, 2);
        }
      }
    });
  }
  else if (representation == VTK_SURFACE)
  {
    pieces.ForTriangles([&](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
      triangles.Add(cell, corners, count);
    });
  }
  for (Maker* maker : { &triangles, &lines, &points })
  {
    if (!maker->Get().Indices.empty())
    {
      this->Primitives.push_back(std::move(maker->Get()));
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 GltfShape::ChooseOrigin() const
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high = -low;
  for (const GltfPrimitive& primitive : this->Primitives)
  {
    for (const glm::dvec3& point : primitive.Positions)
    {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  constexpr double few = 16.; // sizes of the mesh, at which a float loses four of its 24 bits
  const glm::dvec3 center = (low + high) / 2.;
  return glm::length(center) > few * glm::length(high - low) ? center : glm::dvec3(0.);
}
}
