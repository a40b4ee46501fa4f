// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOBJMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo::obj
{
namespace
{
constexpr vtkIdType None = -1;
using Vector = std::array<double, 3>;

struct Corner
{
  vtkIdType Point;
  vtkIdType TextureCoordinates;
  vtkIdType Normal;

  bool operator==(const Corner& other) const
  {
    return this->Point == other.Point && this->TextureCoordinates == other.TextureCoordinates &&
      this->Normal == other.Normal;
  }
};

struct HashCorner
{
  std::size_t operator()(const Corner& corner) const
  {
    constexpr std::size_t mix = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
    std::size_t hash = static_cast<std::size_t>(corner.Point);
    hash = (hash ^ (hash >> 29)) * mix + static_cast<std::size_t>(corner.TextureCoordinates);
    hash = (hash ^ (hash >> 29)) * mix + static_cast<std::size_t>(corner.Normal);
    return (hash ^ (hash >> 32)) * mix;
  }
};

vtkIdType At(const std::vector<vtkIdType>& of, vtkIdType corner)
{
  return of.empty() ? None : of[static_cast<std::size_t>(corner)];
}

// Corners with an invalid normal or texture coordinate get none.
void DropInvalid(std::vector<vtkIdType>& ofCorners, const std::vector<float>& values, int size)
{
  bool any = false;
  for (vtkIdType& each : ofCorners)
  {
    each = each >= 0 && std::isnan(values[static_cast<std::size_t>(size * each)]) ? None : each;
    any = any || each >= 0;
  }
  if (!any)
  {
    ofCorners.clear();
  }
}

//------------------------------------------------------------------------------
// Makes normals for the corners without one, in a file that has some.
class NormalMaker
{
public:
  NormalMaker(Content& content)
    : All(content)
    , Faces(content.Cells[Polys])
  {
  }

  void Fill()
  {
    this->Faces.Normals.resize(this->Faces.Points.size(), None);
    for (std::size_t face = 0; face < this->Faces.States.size(); ++face)
    {
      this->FillFace(face);
    }
    for (const auto& [normal, sum] : this->Sums)
    {
      this->Set(normal, sum);
    }
  }

private:
  void FillFace(std::size_t face)
  {
    const auto first = static_cast<std::size_t>(this->Faces.Starts[face]);
    const auto end = static_cast<std::size_t>(this->Faces.Starts[face + 1]);
    const vtkIdType* const normals = this->Faces.Normals.data();
    if (std::find(normals + first, normals + end, None) == normals + end)
    {
      return;
    }
    const Vector normal = this->GetAreaNormal(first, end);
    const int group =
      this->All.States[static_cast<std::size_t>(this->Faces.States[face])].Smoothing;
    const vtkIdType own = group > 0 ? None : this->Add();
    if (own != None)
    {
      this->Set(own, normal);
    }
    for (std::size_t corner = first; corner < end; ++corner)
    {
      vtkIdType& place = this->Faces.Normals[corner];
      if (place == None)
      {
        place = own != None ? own : this->AddTo({ this->Faces.Points[corner], group, 0 }, normal);
      }
    }
  }

  vtkIdType Add()
  {
    this->All.Normals.resize(this->All.Normals.size() + 3);
    return static_cast<vtkIdType>(this->All.Normals.size() / 3) - 1;
  }

  void Set(vtkIdType place, Vector normal)
  {
    if (!(vtkMath::Normalize(normal.data()) > 0.))
    {
      normal = { 0., 0., 1. };
    }
    std::copy(normal.begin(), normal.end(), this->All.Normals.begin() + 3 * place);
  }

  vtkIdType AddTo(const Corner& pointOfGroup, const Vector& normal)
  {
    const auto [known, isNew] = this->OfGroups.emplace(pointOfGroup, None);
    known->second = isNew ? this->Add() : known->second;
    Vector& sum = this->Sums[known->second];
    vtkMath::Add(sum.data(), normal.data(), sum.data());
    return known->second;
  }

  // The normal with a length of twice the area, by Newell's method.
  Vector GetAreaNormal(std::size_t first, std::size_t end) const
  {
    const auto point = [this](std::size_t corner) {
      return this->All.Points.data() + 3 * this->Faces.Points[corner];
    };
    Vector sum = {};
    for (std::size_t corner = first + 1; corner + 1 < end; ++corner)
    {
      Vector a, b, cross;
      vtkMath::Subtract(point(corner), point(first), a.data());
      vtkMath::Subtract(point(corner + 1), point(first), b.data());
      vtkMath::Cross(a.data(), b.data(), cross.data());
      vtkMath::Add(sum.data(), cross.data(), sum.data());
    }
    return sum;
  }

  Content& All;
  CellList& Faces;
  std::unordered_map<Corner, vtkIdType, HashCorner> OfGroups; // by point and group
  std::unordered_map<vtkIdType, Vector> Sums;                 // by the normal's index
};

//------------------------------------------------------------------------------
// Splits points so that each point of the mesh has at most one texture coordinate and normal.
class PointSplitter
{
public:
  explicit PointSplitter(Content& content)
    : All(content)
    , Uses(content.Points.size() / 3, { Unused, None, None })
  {
  }

  // Replaces the corners' points by those of the mesh.
  void Split(CellList& cells, bool alwaysNormals)
  {
    for (std::size_t i = 0; i < cells.Points.size(); ++i)
    {
      const auto corner = static_cast<vtkIdType>(i);
      Corner use = { cells.Points[i], At(cells.TextureCoordinates, corner),
        At(cells.Normals, corner) };
      Corner& first = this->Uses[static_cast<std::size_t>(use.Point)];
      if (!alwaysNormals && first.Point != Unused)
      {
        // Lines and vertices use the values that faces have at their points.
        use.TextureCoordinates =
          use.TextureCoordinates == None ? first.TextureCoordinates : use.TextureCoordinates;
        use.Normal = first.Normal;
      }
      if (first.Point == Unused)
      {
        first = use;
      }
      else if (!(first == use))
      {
        const auto [known, isNew] =
          this->Extra.emplace(use, static_cast<vtkIdType>(this->Uses.size()));
        cells.Points[i] = known->second;
        if (isNew)
        {
          this->Uses.push_back(use);
        }
      }
    }
  }

  // The file's point of each point of the mesh; Unused: its own.
  const std::vector<Corner>& GetUses() const { return this->Uses; }

  static constexpr vtkIdType Unused = -2;

private:
  const Content& All;
  std::vector<Corner> Uses;
  std::unordered_map<Corner, vtkIdType, HashCorner> Extra;
};

//------------------------------------------------------------------------------
bool HasAny(const Content& content, std::vector<vtkIdType> CellList::*what)
{
  return std::any_of(std::begin(content.Cells), std::end(content.Cells),
    [what](const CellList& cells) { return !(cells.*what).empty(); });
}

std::vector<bool> FindInvalid(const Content& content)
{
  std::vector<bool> invalid;
  if (content.InvalidPoints.Count > 0)
  {
    invalid.resize(content.Points.size() / 3);
    for (std::size_t i = 0; i < invalid.size(); ++i)
    {
      const double* p = content.Points.data() + 3 * i;
      invalid[i] = std::isnan(p[0] + p[1] + p[2]);
    }
  }
  return invalid;
}

//------------------------------------------------------------------------------
// Removes cells with invalid points; `left` gets the numbers of the others, counted from `number`.
void RemoveCells(
  CellList& cells, const std::vector<bool>& invalid, vtkIdType number, std::vector<vtkIdType>& left)
{
  CellList kept;
  const auto append = [](std::vector<vtkIdType>& to, const std::vector<vtkIdType>& from,
                        vtkIdType first, vtkIdType end) {
    if (!from.empty())
    {
      to.insert(to.end(), from.begin() + first, from.begin() + end);
    }
  };
  for (std::size_t cell = 0; cell < cells.States.size(); ++cell)
  {
    const vtkIdType first = cells.Starts[cell];
    const vtkIdType end = cells.Starts[cell + 1];
    if (std::none_of(cells.Points.begin() + first, cells.Points.begin() + end,
          [&invalid](vtkIdType point) { return invalid[static_cast<std::size_t>(point)]; }))
    {
      append(kept.Points, cells.Points, first, end);
      append(kept.TextureCoordinates, cells.TextureCoordinates, first, end);
      append(kept.Normals, cells.Normals, first, end);
      kept.Starts.push_back(static_cast<vtkIdType>(kept.Points.size()));
      kept.States.push_back(cells.States[cell]);
      left.push_back(number + static_cast<vtkIdType>(cell));
    }
  }
  cells = std::move(kept);
}

//------------------------------------------------------------------------------
template <typename Array, typename Value>
vtkSmartPointer<Array> ToArray(const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkCellArray> ToCells(const CellList& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(ToArray<vtkIdTypeArray>(cells.Starts), ToArray<vtkIdTypeArray>(cells.Points));
  return array;
}

void AddNames(vtkPolyData* mesh, const char* name, const std::vector<std::string>& names)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& each : names)
  {
    array->InsertNextValue(each);
  }
  mesh->GetFieldData()->AddArray(array);
}

// Adds arrays of the states that hold for the cells, in VTK's order.
void AddStates(vtkPolyData* mesh, const Content& content, const char* what, int State::*value,
  const NameList& names)
{
  if (names.Names.empty())
  {
    return;
  }
  vtkNew<vtkIntArray> array;
  array->SetName((std::string(what) + "Ids").c_str());
  for (const CellList& cells : content.Cells)
  {
    for (const int state : cells.States)
    {
      array->InsertNextValue(content.States[static_cast<std::size_t>(state)].*value);
    }
  }
  mesh->GetCellData()->AddArray(array);
  AddNames(mesh, (std::string(what) + "Names").c_str(), names.Names);
}

//------------------------------------------------------------------------------
// Makes the arrays of the mesh's points.
class PointArrays
{
public:
  PointArrays(const Content& content, const std::vector<Corner>& uses)
    : All(content)
    , Uses(uses)
    , Count(static_cast<vtkIdType>(uses.size()))
  {
  }

  // Invalid points are put at a valid point's position, so that bounds stay correct.
  void MakePoints(vtkPolyData* mesh, int type, const std::vector<bool>& invalid)
  {
    const auto good =
      static_cast<vtkIdType>(std::find(invalid.begin(), invalid.end(), false) - invalid.begin());
    const bool none = good * 3 == static_cast<vtkIdType>(this->All.Points.size());
    const double middle[3] = {};
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->SetNumberOfPoints(this->Count);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const vtkIdType from = this->GetSource(i);
      const bool isInvalid = !invalid.empty() && invalid[static_cast<std::size_t>(from)];
      points->SetPoint(
        i, isInvalid && none ? middle : this->All.Points.data() + 3 * (isInvalid ? good : from));
    }
    mesh->SetPoints(points);
  }

  void AddTextureCoordinates(vtkPolyData* mesh) const
  {
    const vtkSmartPointer<vtkFloatArray> array = this->Make("TextureCoordinates", 2);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const vtkIdType from = this->Uses[static_cast<std::size_t>(i)].TextureCoordinates;
      const float nothing[2] = {};
      array->SetTypedTuple(
        i, from == None ? nothing : this->All.TextureCoordinates.data() + 2 * from);
    }
    mesh->GetPointData()->SetTCoords(array);
  }

  // Points without a normal get one that points away from the middle.
  void AddNormals(vtkPolyData* mesh) const
  {
    double middle[3];
    mesh->GetPoints()->ComputeBounds();
    const double* bounds = mesh->GetPoints()->GetBounds();
    for (int i = 0; i < 3; ++i)
    {
      middle[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    }
    const vtkSmartPointer<vtkFloatArray> array = this->Make("Normals", 3);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const vtkIdType from = this->Uses[static_cast<std::size_t>(i)].Normal;
      if (from != None)
      {
        array->SetTypedTuple(i, this->All.Normals.data() + 3 * from);
        continue;
      }
      Vector outwards;
      mesh->GetPoint(i, outwards.data());
      vtkMath::Subtract(outwards.data(), middle, outwards.data());
      if (!(vtkMath::Normalize(outwards.data()) > 0.))
      {
        outwards = { 0., 0., 1. };
      }
      array->SetTuple(i, outwards.data());
    }
    mesh->GetPointData()->SetNormals(array);
  }

  void AddColors(vtkPolyData* mesh) const
  {
    const std::vector<float>& colors = this->All.Colors;
    const bool bytes = std::any_of(colors.begin(), colors.end(), [](float c) { return c > 1.f; });
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName("RGBA");
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(this->Count);
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const float* color = colors.data() + 3 * this->GetSource(i);
      for (int c = 0; c < 3; ++c)
      {
        // -1 or NaN: no colour.
        const float level = color[c] >= 0.f ? (bytes ? color[c] : 255.f * color[c]) : 255.f;
        array->SetTypedComponent(
          i, c, static_cast<unsigned char>(std::min(std::round(level), 255.f)));
      }
      array->SetTypedComponent(i, 3, 255);
    }
    mesh->GetPointData()->SetScalars(array);
  }

private:
  vtkIdType GetSource(vtkIdType point) const
  {
    const vtkIdType from = this->Uses[static_cast<std::size_t>(point)].Point;
    return from == PointSplitter::Unused ? point : from;
  }

  vtkSmartPointer<vtkFloatArray> Make(const char* name, int components) const
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Count);
    return array;
  }

  const Content& All;
  const std::vector<Corner>& Uses;
  const vtkIdType Count;
};
}

//------------------------------------------------------------------------------
vtkIdType MakeMesh(Content& content, int typeOfPoints, bool groups, vtkPolyData* mesh)
{
  const std::vector<bool> invalid = FindInvalid(content);
  const bool isCloud = std::all_of(std::begin(content.Cells), std::end(content.Cells),
    [](const CellList& cells) { return cells.States.empty(); });
  for (std::size_t i = 0; isCloud && i < invalid.size(); ++i)
  {
    if (!invalid[i])
    {
      CellList& vertices = content.Cells[Verts];
      vertices.Points.push_back(static_cast<vtkIdType>(i));
      vertices.Starts.push_back(static_cast<vtkIdType>(vertices.Points.size()));
      vertices.States.emplace_back();
    }
  }
  vtkIdType before = 0;
  std::vector<vtkIdType> left;
  for (CellList& cells : content.Cells)
  {
    const auto count = static_cast<vtkIdType>(cells.States.size());
    if (!invalid.empty())
    {
      RemoveCells(cells, invalid, before, left);
    }
    DropInvalid(cells.TextureCoordinates, content.TextureCoordinates, 2);
    DropInvalid(cells.Normals, content.Normals, 3);
    before += count;
  }
  const bool textured = HasAny(content, &CellList::TextureCoordinates);
  const bool normals = HasAny(content, &CellList::Normals);
  if (normals)
  {
    NormalMaker(content).Fill();
  }
  PointSplitter splitter(content);
  if (normals || textured)
  {
    splitter.Split(content.Cells[Polys], true);
    splitter.Split(content.Cells[Lines], false);
    splitter.Split(content.Cells[Verts], false);
  }
  mesh->SetVerts(ToCells(content.Cells[Verts]));
  mesh->SetLines(ToCells(content.Cells[Lines]));
  mesh->SetPolys(ToCells(content.Cells[Polys]));

  PointArrays arrays(content, splitter.GetUses());
  arrays.MakePoints(mesh, typeOfPoints, invalid);
  if (normals)
  {
    arrays.AddNormals(mesh);
  }
  if (textured)
  {
    arrays.AddTextureCoordinates(mesh);
  }
  if (!content.Colors.empty())
  {
    arrays.AddColors(mesh);
  }

  AddStates(mesh, content, "Material", &State::Material, content.Materials);
  if (!content.Libraries.empty())
  {
    AddNames(mesh, "MaterialLibraries", content.Libraries);
  }
  if (groups)
  {
    AddStates(mesh, content, "Group", &State::Group, content.Groups);
    AddStates(mesh, content, "Object", &State::Object, content.Objects);
  }
  const auto kept = static_cast<vtkIdType>(left.size());
  if (!invalid.empty() && (kept < before || before == 0))
  {
    const vtkSmartPointer<vtkIdTypeArray> ids = ToArray<vtkIdTypeArray>(left);
    ids->SetName("vtkOriginalCellIds");
    mesh->GetCellData()->AddArray(ids);
  }
  return invalid.empty() ? 0 : before - kept;
}
}
