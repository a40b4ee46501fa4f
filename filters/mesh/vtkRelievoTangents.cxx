// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTangents.h"

#include "vtkRelievoArrayNames.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoSplitPoints.h"
#include "vtkRelievoTangentSpace.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <string>
#include <utility>
#include <vector>

using relievo::TangentSpace;

vtkStandardNewMacro(vtkRelievoTangents);

namespace
{
// Values that a corner requests of its point: its tangent, and the normal of a flat mesh.
using Splitter = relievo::PointSplitter<7>;

glm::dvec3 VectorAt(vtkDataArray* array, vtkIdType i)
{
  return glm::dvec3(
    array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2));
}

bool IsVectors(vtkDataArray* array, vtkIdType count)
{
  return array && array->GetNumberOfComponents() == 3 && array->GetNumberOfTuples() == count;
}

// The corners' points, three per triangle; empty if any polygon is not a triangle.
std::vector<vtkIdType> Corners(vtkCellArray* polys)
{
  std::vector<vtkIdType> corners;
  const vtkIdType count = polys->GetNumberOfCells();
  corners.reserve(3 * static_cast<std::size_t>(count));
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    vtkIdType size;
    const vtkIdType* points;
    polys->GetCellAtId(cell, size, points);
    if (size != 3)
    {
      return {};
    }
    corners.insert(corners.end(), points, points + 3);
  }
  return corners;
}

TangentSpace::Vertex VertexOf(vtkPolyData* mesh, vtkDataArray* texture, vtkIdType point)
{
  double position[3];
  mesh->GetPoint(point, position);
  return { glm::dvec3(position[0], position[1], position[2]), glm::dvec3(0.),
    glm::dvec2(texture->GetComponent(point, 0), texture->GetComponent(point, 1)) };
}

// Vertices with the points' normals; corners of triangles refer to them.
TangentSpace SmoothSpace(vtkPolyData* mesh, vtkDataArray* texture, vtkDataArray* normals,
  const std::vector<vtkIdType>& corners)
{
  std::vector<TangentSpace::Vertex> vertices;
  vertices.reserve(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    vertices.push_back(VertexOf(mesh, texture, i));
    vertices.back().Normal = VectorAt(normals, i);
  }
  std::vector<TangentSpace::Triangle> triangles(corners.size() / 3);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    triangles[c / 3][c % 3] = static_cast<int>(corners[c]);
  }
  return TangentSpace(std::move(vertices), triangles);
}

// One vertex per corner, with the triangle's normal, which is also written to `flat`.
TangentSpace FlatSpace(vtkPolyData* mesh, vtkDataArray* texture,
  const std::vector<vtkIdType>& corners, std::vector<glm::dvec3>& flat)
{
  vtkDataArray* normals = mesh->GetCellData()->GetNormals();
  const bool given = IsVectors(normals, mesh->GetNumberOfCells());
  // VTK numbers vertices first, then lines, then polygons.
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  std::vector<TangentSpace::Vertex> vertices;
  std::vector<TangentSpace::Triangle> triangles(corners.size() / 3);
  vertices.reserve(corners.size());
  flat.reserve(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangles[f][i] = static_cast<int>(vertices.size());
      vertices.push_back(VertexOf(mesh, texture, corners[3 * f + i]));
    }
    TangentSpace::Vertex* v = &vertices[3 * f];
    glm::dvec3 normal = glm::cross(v[1].Position - v[0].Position, v[2].Position - v[0].Position);
    const double size = glm::length(normal);
    normal = size > 0. ? normal / size : glm::dvec3(0.);
    flat.push_back(given ? VectorAt(normals, first + static_cast<vtkIdType>(f)) : normal);
    v[0].Normal = v[1].Normal = v[2].Normal = flat.back();
  }
  return TangentSpace(std::move(vertices), triangles);
}
}

//------------------------------------------------------------------------------
vtkRelievoTangents::vtkRelievoTangents()
{
  this->SetTangentsName("tangent");
  this->Parameters
    .AddText(
      "tangents_name",
      [this]() { return std::string(this->TangentsName ? this->TangentsName : ""); },
      [this](const std::string& name) { this->SetTangentsName(name.c_str()); },
      "Name of the array of tangents.")
    .Advanced = true;
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::NORMALS);
  this->SetInputArrayToProcess(
    1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::TCOORDS);
}

//------------------------------------------------------------------------------
vtkRelievoTangents::~vtkRelievoTangents()
{
  this->SetTangentsName(nullptr);
}

//------------------------------------------------------------------------------
int vtkRelievoTangents::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  this->NumberOfDegenerateTriangles = 0;
  this->NumberOfAddedPoints = 0;
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return 1;
  }
  vtkDataArray* normals = this->GetInputArrayToProcess(0, inputs);
  vtkDataArray* texture = this->GetInputArrayToProcess(1, inputs);
  std::string problem;
  const std::vector<vtkIdType> corners = Corners(input->GetPolys());
  if (!texture || texture->GetNumberOfComponents() < 2 || texture->GetNumberOfTuples() != count)
  {
    problem = "the mesh needs texture coordinates in its point data (the filter Texture "
              "Coordinates makes them); its point arrays are: " +
      relievo::ArrayNames(input->GetPointData());
  }
  else if (input->GetNumberOfStrips() > 0 ||
    static_cast<vtkIdType>(corners.size()) != 3 * input->GetNumberOfPolys())
  {
    problem = "the mesh has polygons that are not triangles, or triangle strips; "
              "triangulate them first";
  }
  if (!problem.empty())
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No tangents: " << problem << ".");
    return 1;
  }

  std::vector<glm::dvec3> flat;
  const TangentSpace space = IsVectors(normals, count)
    ? SmoothSpace(input, texture, normals, corners)
    : FlatSpace(input, texture, corners, flat);
  Splitter splitter(count);
  std::vector<vtkIdType> points(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const glm::vec4 tangent(space.GetTangent(c / 3, static_cast<int>(c % 3)));
    const glm::vec3 normal(flat.empty() ? glm::dvec3(0.) : flat[c / 3]);
    points[c] = splitter.Get(
      corners[c], { { tangent.x, tangent.y, tangent.z, tangent.w, normal.x, normal.y, normal.z } });
  }
  relievo::SplitPoints(input, splitter.GetOriginals(), points, output);
  this->NumberOfDegenerateTriangles = static_cast<vtkIdType>(space.GetNumberOfDegenerate());
  this->NumberOfAddedPoints = output->GetNumberOfPoints() - count;

  const auto makeArray = [&](const char* name, int components, int from) {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(output->GetNumberOfPoints());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      array->SetTypedTuple(i, splitter.GetValues(i).data() + from);
    }
    output->GetPointData()->AddArray(array);
  };
  const std::string name = this->TangentsName ? this->TangentsName : "tangent";
  makeArray(name.c_str(), 4, 0);
  // VTK's attribute has three components; its users determine the handedness themselves.
  const std::string active = name == "Tangents" ? "Tangents (active)" : "Tangents";
  makeArray(active.c_str(), 3, 0);
  output->GetPointData()->SetActiveTangents(active.c_str());
  if (!flat.empty())
  {
    makeArray("Normals", 3, 4);
    output->GetPointData()->SetActiveNormals("Normals");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoTangents::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TangentsName: " << (this->TangentsName ? this->TangentsName : "(none)") << "\n";
  os << indent << "NumberOfDegenerateTriangles: " << this->NumberOfDegenerateTriangles << "\n";
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
}
