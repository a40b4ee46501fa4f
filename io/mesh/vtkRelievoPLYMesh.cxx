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
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace relievo::ply
{
namespace
{
using Columns = std::vector<Column*>;

// The columns of these names, if all are there and no lists.
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

// By what a number is to be multiplied so that 255 is the whole.
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
// The numbers of an element in an order of their own.
class Arrays
{
public:
  Arrays(Element& element, const std::vector<vtkIdType>& order)
    : Of(element)
    , Order(order)
  {
  }

  // `taken` are no arrays of their own.
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
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Order.size()));
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      for (std::size_t i = 0; i < this->Order.size(); ++i)
      {
        array->SetComponent(
          static_cast<vtkIdType>(i), static_cast<int>(c), GetValue(*columns[c], this->Order[i]));
      }
    }
    return array;
  }

private:
  static double GetValue(const Column& column, vtkIdType i)
  {
    return column.Values[static_cast<std::size_t>(i)];
  }

  vtkSmartPointer<vtkDataArray> MakeColors(const Columns& columns) const
  {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName("RGBA");
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Order.size()));
    array->FillTypedComponent(3, 255);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const double scale = GetColorScale(columns[c]->Type);
      for (std::size_t i = 0; i < this->Order.size(); ++i)
      {
        const double level = std::round(scale * GetValue(*columns[c], this->Order[i]));
        array->SetTypedComponent(static_cast<vtkIdType>(i), static_cast<int>(c),
          static_cast<unsigned char>(level >= 0. ? std::min(level, 255.) : 0.)); // NaN: none
      }
    }
    return array;
  }

  Element& Of;
  const std::vector<vtkIdType>& Order;
};

//------------------------------------------------------------------------------
// Splits points that have different texture coordinates in different faces.
class FacePoints
{
public:
  FacePoints(std::vector<vtkIdType>& order, const Column* coordinates)
    : Order(order)
    , Coordinates(coordinates)
    , First(coordinates ? order.size() : 0)
    , Used(this->First.size(), false)
  {
  }

  // The point for a corner of a face.
  vtkIdType Get(vtkIdType point, std::size_t face, vtkIdType corner)
  {
    const auto start = static_cast<std::size_t>(
      this->Coordinates ? this->Coordinates->Starts[face] + 2 * corner : 0);
    if (!this->Coordinates ||
      start + 1 >= static_cast<std::size_t>(this->Coordinates->Starts[face + 1]))
    {
      return point;
    }
    const Place place = { this->Coordinates->Values[start], this->Coordinates->Values[start + 1] };
    const auto index = static_cast<std::size_t>(point);
    if (!this->Used[index] || this->First[index] == place)
    {
      this->Used[index] = true;
      this->First[index] = place;
      return point;
    }
    const auto [known, isNew] =
      this->Others.emplace(std::pair(point, place), static_cast<vtkIdType>(this->Order.size()));
    if (isNew)
    {
      this->Order.push_back(point);
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

  std::vector<vtkIdType>& Order; // of each point of the mesh the file's point
  const Column* const Coordinates;
  std::vector<Place> First;
  std::vector<bool> Used;
  std::vector<Place> Added;
  std::map<std::pair<vtkIdType, Place>, vtkIdType> Others;
};

//------------------------------------------------------------------------------
// The number as a point's, or a Refusal that names the `place`.
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
// The triangles of strips.
void AddStrips(Element& strips, vtkIdType numberOfPoints, vtkPolyData* mesh)
{
  const Column* indices = strips.Find("vertex_indices");
  if (!indices || indices->CountType == 0 || indices->Starts.empty())
  {
    return;
  }
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType strip = 0; strip < strips.Count; ++strip)
  {
    const auto place = static_cast<std::size_t>(strip);
    vtkIdType before[2] = { 0, 0 }; // the last two, which change places with each triangle
    vtkIdType count = 0;
    for (vtkIdType i = indices->Starts[place]; i < indices->Starts[place + 1]; ++i)
    {
      const double index = indices->Values[static_cast<std::size_t>(i)];
      if (index == -1.)
      {
        count = 0; // a strip of its own
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
  std::vector<vtkIdType> order;
  for (vtkIdType edge = 0; edge < edges.Count; ++edge)
  {
    lines->InsertNextCell(2);
    for (const Column* end : ends)
    {
      lines->InsertCellPoint(
        GetPoint(end->Values[static_cast<std::size_t>(edge)], numberOfPoints, "edge", edge));
    }
    order.push_back(edge);
  }
  mesh->SetLines(lines);
  Arrays(edges, order).AddTo(mesh->GetCellData(), ends);
}

//------------------------------------------------------------------------------
// The faces by kind, and their order.
void AddFaces(Element& faces, vtkIdType numberOfPoints, FacePoints& points, vtkPolyData* mesh)
{
  Column* indices = faces.Find("vertex_indices");
  indices = indices ? indices : faces.Find("vertex_index");
  if (!indices || indices->CountType == 0 || indices->Starts.empty())
  {
    return;
  }
  vtkNew<vtkCellArray> cells[3];
  std::vector<vtkIdType> orders[3];
  std::vector<vtkIdType> corners;
  for (vtkIdType face = 0; face < faces.Count; ++face)
  {
    const auto place = static_cast<std::size_t>(face);
    const vtkIdType first = indices->Starts[place];
    const vtkIdType count = indices->Starts[place + 1] - first;
    corners.clear();
    for (vtkIdType corner = 0; corner < count; ++corner)
    {
      const double index = indices->Values[static_cast<std::size_t>(first + corner)];
      corners.push_back(points.Get(GetPoint(index, numberOfPoints, "face", face), place, corner));
    }
    if (count > 0) // some writers delete faces by it
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
  for (int kind = 1; kind < 3; ++kind)
  {
    orders[0].insert(orders[0].end(), orders[kind].begin(), orders[kind].end());
  }
  Arrays(faces, orders[0]).AddTo(mesh->GetCellData(), {});
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
  std::vector<vtkIdType> order(static_cast<std::size_t>(vertices->Count));
  std::iota(order.begin(), order.end(), vtkIdType(0));
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
