// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPLYMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace relievo::ply
{
namespace
{
using Columns = std::vector<Column*>;

// The columns of these names, if all exist and none is a list.
Columns FindAll(Element& element, const std::vector<std::string>& names)
{
  Columns found;
  for (const std::string& name : names)
  {
    Column* column = element.Find(name);
    if (column && column->CountType == 0)
    {
      found.push_back(column);
    }
  }
  return found.size() == names.size() ? found : Columns();
}

// The factor that scales a colour's number to 255.
double GetColorScale(int type)
{
  switch (type)
  {
    case VTK_SIGNED_CHAR:
      return 255. / 127.;
    case VTK_SHORT:
      return 255. / 32767.;
    case VTK_UNSIGNED_SHORT:
      return 255. / 65535.;
    case VTK_INT:
      return 255. / 2147483647.;
    case VTK_UNSIGNED_INT:
      return 255. / 4294967295.;
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return 255.;
    default:
      return 1.;
  }
}

//------------------------------------------------------------------------------
// The indices of an element's numbers to use, in order.
class Order
{
public:
  explicit Order(vtkIdType count = 0)
    : Same(count)
  {
  }

  vtkIdType GetCount() const { return this->Same + static_cast<vtkIdType>(this->Others.size()); }
  vtkIdType operator[](vtkIdType i) const
  {
    return i < this->Same ? i : this->Others[static_cast<std::size_t>(i - this->Same)];
  }

  void Add(vtkIdType number)
  {
    if (this->Others.empty() && number == this->Same)
    {
      ++this->Same;
    }
    else
    {
      this->Others.push_back(number);
    }
  }

private:
  vtkIdType Same; // number of leading indices in their own order
  std::vector<vtkIdType> Others;
};

//------------------------------------------------------------------------------
// Reorders the numbers of an element.
class Arrays
{
public:
  Arrays(Element& element, const Order& order)
    : Of(element)
    , Used(order)
  {
  }

  // The columns in `taken` become no arrays.
  void AddTo(vtkDataSetAttributes* data, Columns taken)
  {
    const auto take = [this, &taken](const std::vector<std::string>& names) {
      const Columns found = FindAll(this->Of, names);
      taken.insert(taken.end(), found.begin(), found.end());
      return found;
    };
    if (const Columns normals = take({ "nx", "ny", "nz" }); !normals.empty())
    {
      data->SetNormals(this->Make("Normals", VTK_FLOAT, normals));
    }
    for (const auto& [u, v] : { std::pair("s", "t"), std::pair("u", "v"),
           std::pair("texture_s", "texture_t"), std::pair("texture_u", "texture_v") })
    {
      if (const Columns coordinates = take({ u, v }); !coordinates.empty())
      {
        data->SetTCoords(this->Make("TextureCoordinates", VTK_FLOAT, coordinates));
        break;
      }
    }
    for (const std::string before : { "", "diffuse_" })
    {
      Columns colors = take({ before + "red", before + "green", before + "blue" });
      if (!colors.empty())
      {
        const Columns alpha = take({ before + "alpha" });
        colors.insert(colors.end(), alpha.begin(), alpha.end());
        data->SetScalars(this->MakeColors(colors));
        break;
      }
    }
    for (Column& column : this->Of.Columns)
    {
      if (column.CountType == 0 && std::find(taken.begin(), taken.end(), &column) == taken.end())
      {
        data->AddArray(this->Make(column.Name.c_str(), column.Type, { &column }));
      }
    }
  }

  vtkSmartPointer<vtkDataArray> Make(const char* name, int type, const Columns& columns) const
  {
    auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(columns.size()));
    array->SetNumberOfTuples(this->Used.GetCount());
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      switch (type)
      {
        vtkTemplateMacro(this->Fill(
          static_cast<VTK_TT*>(array->GetVoidPointer(0)) + c, columns.size(), type, *columns[c]));
      }
    }
    return array;
  }

private:
  // Converts every `step`-th number from `to` on.
  template <typename Number>
  void Fill(Number* to, std::size_t step, int type, const Column& column) const
  {
    const Numbers& values = column.Values;
    const Number* const same = values.GetType() == type ? values.As<Number>() : nullptr;
    for (vtkIdType i = 0; i < this->Used.GetCount(); ++i)
    {
      const auto from = static_cast<std::size_t>(this->Used[i]);
      to[static_cast<std::size_t>(i) * step] =
        same ? same[from] : static_cast<Number>(values.Get(from));
    }
  }

  vtkSmartPointer<vtkDataArray> MakeColors(const Columns& columns) const
  {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName("RGBA");
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(this->Used.GetCount());
    array->FillTypedComponent(3, 255);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const double scale = GetColorScale(columns[c]->Type);
      for (vtkIdType i = 0; i < this->Used.GetCount(); ++i)
      {
        const double level =
          std::round(scale * columns[c]->Values.Get(static_cast<std::size_t>(this->Used[i])));
        array->SetTypedComponent(i, static_cast<int>(c),
          static_cast<unsigned char>(level >= 0. ? std::min(level, 255.) : 0.)); // NaN: none
      }
    }
    return array;
  }

  Element& Of;
  const Order& Used;
};

//------------------------------------------------------------------------------
// Splits points with different texture coordinates in different faces.
class FacePoints
{
public:
  FacePoints(Order& order, const Column* coordinates)
    : Points(order)
    , Coordinates(coordinates)
    , First(coordinates ? static_cast<std::size_t>(order.GetCount()) : 0)
    , Used(this->First.size(), false)
  {
  }

  // Whether faces share their points.
  bool AreShared() const { return !this->Coordinates; }

  // The point for a corner of a face.
  vtkIdType Get(vtkIdType point, vtkIdType face, vtkIdType corner)
  {
    const auto start = static_cast<std::size_t>(
      this->Coordinates ? this->Coordinates->GetStart(face) + 2 * corner : 0);
    if (!this->Coordinates ||
      start + 1 >= static_cast<std::size_t>(this->Coordinates->GetStart(face + 1)))
    {
      return point;
    }
    const Place place = { this->Coordinates->Values.Get(start),
      this->Coordinates->Values.Get(start + 1) };
    const auto index = static_cast<std::size_t>(point);
    if (!this->Used[index] || this->First[index] == place)
    {
      this->Used[index] = true;
      this->First[index] = place;
      return point;
    }
    const auto [known, isNew] =
      this->Others.emplace(std::pair(point, place), this->Points.GetCount());
    if (isNew)
    {
      this->Points.Add(point);
      this->Added.push_back(place);
    }
    return known->second;
  }

  void AddTo(vtkPointData* data) const
  {
    if (!this->Coordinates)
    {
      return;
    }
    vtkNew<vtkFloatArray> array;
    array->SetName("TextureCoordinates");
    array->SetNumberOfComponents(2);
    for (const std::vector<Place>* list : { &this->First, &this->Added })
    {
      for (const Place& place : *list)
      {
        array->InsertNextTuple(place.data());
      }
    }
    data->SetTCoords(array);
  }

private:
  using Place = std::array<double, 2>;

  Order& Points; // of each point of the mesh the file's point
  const Column* const Coordinates;
  std::vector<Place> First;
  std::vector<bool> Used;
  std::vector<Place> Added;
  std::map<std::pair<vtkIdType, Place>, vtkIdType> Others;
};

//------------------------------------------------------------------------------
// The number as a point's index, or a Refusal that names the `place`.
vtkIdType GetPoint(double index, vtkIdType numberOfPoints, const char* noun, vtkIdType place,
  const char* otherwise = "")
{
  if (!(index >= 0. && index < static_cast<double>(numberOfPoints)))
  {
    throw Refusal{ vtkErrorCode::FileFormatError,
      noun + (" " + std::to_string(place)) + ": expected the index of a vertex, from 0 to " +
        std::to_string(numberOfPoints - 1) + otherwise + ", not " +
        std::to_string(static_cast<long long>(index)) };
  }
  return static_cast<vtkIdType>(index);
}

//------------------------------------------------------------------------------
// Converts strips to triangles.
void AddStrips(Element& strips, vtkIdType numberOfPoints, vtkPolyData* mesh)
{
  const Column* indices = strips.Find("vertex_indices");
  if (!indices || indices->CountType == 0)
  {
    return;
  }
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType strip = 0; strip < strips.Count; ++strip)
  {
    vtkIdType before[2] = { 0, 0 }; // the last two, which swap with each triangle
    vtkIdType count = 0;
    for (vtkIdType i = indices->GetStart(strip); i < indices->GetStart(strip + 1); ++i)
    {
      const double index = indices->Values.Get(static_cast<std::size_t>(i));
      if (index == -1.)
      {
        count = 0; // the strip has ended
        continue;
      }
      const vtkIdType point = GetPoint(index, numberOfPoints, "tristrips", strip, ", or -1");
      const vtkIdType corners[3] = { before[0], before[1], point };
      const bool flat =
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
      if (count >= 2 && !flat)
      {
        triangles->InsertNextCell(3, corners);
      }
      before[count % 2] = point;
      ++count;
    }
  }
  mesh->SetPolys(triangles);
}

//------------------------------------------------------------------------------
void AddEdges(Element& edges, vtkIdType numberOfPoints, vtkPolyData* mesh)
{
  const Columns ends = FindAll(edges, { "vertex1", "vertex2" });
  if (ends.empty())
  {
    return;
  }
  vtkNew<vtkCellArray> lines;
  for (vtkIdType edge = 0; edge < edges.Count; ++edge)
  {
    lines->InsertNextCell(2);
    for (const Column* end : ends)
    {
      lines->InsertCellPoint(
        GetPoint(end->Values.Get(static_cast<std::size_t>(edge)), numberOfPoints, "edge", edge));
    }
  }
  mesh->SetLines(lines);
  Arrays(edges, Order(edges.Count)).AddTo(mesh->GetCellData(), ends);
}

//------------------------------------------------------------------------------
// Takes polygons of one size whose corners lie contiguously in the file, without copying. False,
// without changes, if they do not.
bool TakeFaces(Column& indices, vtkIdType count, vtkIdType numberOfPoints, vtkPolyData* mesh)
{
  const int type = indices.Values.GetType();
  const auto corners = static_cast<vtkIdType>(indices.Values.GetSize());
  if ((type != VTK_INT && type != VTK_UNSIGNED_INT) || indices.ListSize < 3 ||
    corners > std::numeric_limits<std::int32_t>::max() ||
    numberOfPoints > std::numeric_limits<std::int32_t>::max())
  {
    return false;
  }
  const auto* const first = indices.Values.As<std::uint32_t>(); // -1 is out of range, too
  if (std::any_of(first, first + corners,
        [numberOfPoints](std::uint32_t corner) { return corner >= numberOfPoints; }))
  {
    return false; // checking each index finds it later
  }
  vtkNew<vtkTypeInt32Array> starts, points;
  starts->SetNumberOfValues(count + 1);
  for (vtkIdType face = 0; face <= count; ++face)
  {
    starts->SetValue(face, static_cast<std::int32_t>(face * indices.ListSize));
  }
  points->SetArray(static_cast<std::int32_t*>(indices.Values.Release()), corners, 0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(starts.Get(), points.Get());
  mesh->SetPolys(polygons);
  return true;
}

//------------------------------------------------------------------------------
// Adds the faces by kind, and their order.
void AddFaces(Element& faces, vtkIdType numberOfPoints, FacePoints& points, vtkPolyData* mesh)
{
  Column* indices = faces.Find("vertex_indices");
  indices = indices ? indices : faces.Find("vertex_index");
  if (!indices || indices->CountType == 0)
  {
    return;
  }
  if (points.AreShared() && TakeFaces(*indices, faces.Count, numberOfPoints, mesh))
  {
    Arrays(faces, Order(faces.Count)).AddTo(mesh->GetCellData(), {});
    return;
  }
  vtkNew<vtkCellArray> cells[3];
  std::vector<vtkIdType> orders[3];
  std::vector<vtkIdType> corners;
  for (vtkIdType face = 0; face < faces.Count; ++face)
  {
    const vtkIdType first = indices->GetStart(face);
    const vtkIdType count = indices->GetStart(face + 1) - first;
    corners.clear();
    for (vtkIdType corner = 0; corner < count; ++corner)
    {
      const double index = indices->Values.Get(static_cast<std::size_t>(first + corner));
      corners.push_back(points.Get(GetPoint(index, numberOfPoints, "face", face), face, corner));
    }
    if (count > 0) // some writers delete faces by an empty list
    {
      const auto kind = static_cast<std::size_t>(std::min<vtkIdType>(count, 3) - 1);
      cells[kind]->InsertNextCell(count, corners.data());
      orders[kind].push_back(face);
    }
  }
  mesh->SetVerts(cells[0]);
  mesh->SetLines(cells[1]);
  mesh->SetPolys(cells[2]);
  // Cell data follow VTK's order: vertices, lines, polygons.
  Order order;
  for (const std::vector<vtkIdType>& kind : orders)
  {
    for (const vtkIdType face : kind)
    {
      order.Add(face);
    }
  }
  Arrays(faces, order).AddTo(mesh->GetCellData(), {});
}
}

//------------------------------------------------------------------------------
void MakeMesh(Content& content, vtkPolyData* mesh)
{
  Element* vertices = content.Find("vertex");
  const Columns places = vertices ? FindAll(*vertices, { "x", "y", "z" }) : Columns();
  if (!vertices || places.empty())
  {
    throw Refusal{ vtkErrorCode::FileFormatError,
      "expected an element vertex with the properties x, y and z" };
  }
  Order order(vertices->Count);
  Element* faces = content.Find("face");
  const Column* coordinates = faces ? faces->Find("texcoord") : nullptr;
  FacePoints points(order, coordinates && coordinates->CountType != 0 ? coordinates : nullptr);
  if (faces && faces->Count > 0)
  {
    AddFaces(*faces, vertices->Count, points, mesh);
  }
  else if (Element* strips = content.Find("tristrips"))
  {
    AddStrips(*strips, vertices->Count, mesh);
  }
  else if (Element* edges = content.Find("edge"))
  {
    AddEdges(*edges, vertices->Count, mesh);
  }
  Arrays arrays(*vertices, order);
  vtkNew<vtkPoints> corners;
  corners->SetData(
    arrays.Make("Points", places[0]->Type == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT, places));
  mesh->SetPoints(corners);
  arrays.AddTo(mesh->GetPointData(), places);
  points.AddTo(mesh->GetPointData());
  if (!content.Textures.empty())
  {
    vtkNew<vtkStringArray> names;
    names->SetName("TextureFiles");
    for (const std::string& name : content.Textures)
    {
      names->InsertNextValue(name);
    }
    mesh->GetFieldData()->AddArray(names);
  }
}
}
