// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTextureCoordinates.h"

#include "vtkRelievoParameter.h"
#include "vtkRelievoSplitPoints.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkRelievoTextureCoordinates);

//------------------------------------------------------------------------------
vtkRelievoTextureCoordinates::vtkRelievoTextureCoordinates()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddChoice("mapping", vtkRelievoMember(Mapping), { "plane", "box", "sphere" },
    "The projection of the texture.");
  list.AddNumber("tile_size", vtkRelievoMember(TileSize), 0.0, infinity, "",
    "Size of one copy of the texture, in the data's units. With 0 one copy covers the whole mesh, "
    "along its longest side or once around.");
  vtkRelievoParameter& up = list.AddChoice("up", vtkRelievoMember(Up), { "x", "y", "z" },
    "The axis of the data that points up; the texture's v grows towards it where possible.");
  up.Label = "Up Axis";
  list
    .AddVector("plane_normal", vtkRelievoMember(PlaneNormal),
      "The direction from which a plane's texture is projected. 0 0 0 uses the plane that fits "
      "best.")
    .OnlyIf = "mapping=plane";
}

namespace
{
// The mesh, with points relative to the lower corner of their bounds.
class Mesh
{
public:
  explicit Mesh(vtkPolyData* data)
    : Data(data)
    , Polys(data->GetPolys())
  {
    double bounds[6];
    data->GetPoints()->GetBounds(bounds);
    this->Lower = glm::dvec3(bounds[0], bounds[2], bounds[4]);
    this->Size = glm::dvec3(bounds[1], bounds[3], bounds[5]) - this->Lower;
  }

  vtkIdType GetNumberOfPoints() const { return this->Data->GetNumberOfPoints(); }
  vtkIdType GetNumberOfPolys() const { return this->Polys->GetNumberOfCells(); }
  const glm::dvec3& GetSize() const { return this->Size; }

  glm::dvec3 GetPoint(vtkIdType i) const
  {
    double point[3];
    this->Data->GetPoint(i, point);
    return glm::dvec3(point[0], point[1], point[2]) - this->Lower;
  }

  void GetPoly(vtkIdType cell, std::vector<vtkIdType>& corners) const
  {
    vtkIdType size;
    const vtkIdType* points;
    this->Polys->GetCellAtId(cell, size, points);
    corners.assign(points, points + size);
  }

  // Twice the polygon's area along its normal.
  glm::dvec3 GetArea(const std::vector<vtkIdType>& corners) const
  {
    glm::dvec3 sum(0.);
    const glm::dvec3 first = corners.empty() ? glm::dvec3(0.) : this->GetPoint(corners[0]);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    {
      sum += glm::cross(this->GetPoint(corners[i]) - first, this->GetPoint(corners[i + 1]) - first);
    }
    return sum;
  }

private:
  vtkPolyData* Data;
  vtkCellArray* Polys;
  glm::dvec3 Lower;
  glm::dvec3 Size;
};

glm::dvec3 AxisOf(int number)
{
  glm::dvec3 axis(0.);
  axis[number % 3] = 1.;
  return axis;
}

// A projection of the mesh: along -normal, v upwards if possible, u to the right.
class Side
{
public:
  Side(const glm::dvec3& normal, int up)
  {
    glm::dvec3 v = AxisOf(up) - normal * normal[up];
    v = glm::length(v) > 1e-6 ? glm::normalize(v) : AxisOf(up + 2);
    this->U = glm::normalize(glm::cross(v, normal));
    this->V = v;
  }

  // Starts coordinates at the lower left of the projected bounds.
  void StartAtBounds(const glm::dvec3& size)
  {
    const glm::dvec3 none(0.);
    const glm::dvec3 u = glm::min(this->U * size, none);
    const glm::dvec3 v = glm::min(this->V * size, none);
    this->Start = glm::dvec2(u.x + u.y + u.z, v.x + v.y + v.z);
  }

  // Starts coordinates at the points' lower left; returns their larger extent.
  double StartAtPoints(const Mesh& mesh)
  {
    glm::dvec2 lower(std::numeric_limits<double>::max());
    glm::dvec2 upper(-std::numeric_limits<double>::max());
    this->Start = glm::dvec2(0.);
    for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      const glm::dvec2 place = this->Place(mesh.GetPoint(i));
      lower = glm::min(lower, place);
      upper = glm::max(upper, place);
    }
    this->Start = lower;
    return std::max(upper.x - lower.x, upper.y - lower.y);
  }

  glm::dvec2 Place(const glm::dvec3& point) const
  {
    return glm::dvec2(glm::dot(point, this->U), glm::dot(point, this->V)) - this->Start;
  }

private:
  glm::dvec3 U;
  glm::dvec3 V;
  glm::dvec2 Start = glm::dvec2(0.);
};

// Fits a plane to the points by least squares; returns its normal on the side that the polygons
// face.
glm::dvec3 FitNormal(const Mesh& mesh, int up)
{
  std::vector<glm::dvec3> points;
  glm::dvec3 mean(0.);
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    const glm::dvec3 point = mesh.GetPoint(i);
    if (std::isfinite(point.x + point.y + point.z))
    {
      points.push_back(point);
      mean += point;
    }
  }
  mean /= std::max<double>(1., static_cast<double>(points.size()));
  double rows[3][3] = {};
  for (const glm::dvec3& point : points)
  {
    const glm::dvec3 off = point - mean;
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c < 3; ++c)
      {
        rows[r][c] += off[r] * off[c];
      }
    }
  }
  double* matrix[3] = { rows[0], rows[1], rows[2] };
  double values[3];
  double columns[3][3];
  double* vectors[3] = { columns[0], columns[1], columns[2] };
  vtkMath::Jacobi(matrix, values, vectors); // largest value first
  glm::dvec3 normal(columns[0][2], columns[1][2], columns[2][2]);
  glm::dvec3 shown(0.);
  std::vector<vtkIdType> corners;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfPolys(); ++cell)
  {
    mesh.GetPoly(cell, corners);
    shown += mesh.GetArea(corners);
  }
  const double side = glm::dot(shown, normal);
  // A closed body faces no side: it is then projected from above.
  const bool open = std::abs(side) > 1e-6 * glm::dot(mesh.GetSize(), mesh.GetSize());
  return (open ? side : normal[up]) < 0. ? -normal : normal;
}

double OrOne(double size)
{
  return size > 0. && std::isfinite(size) ? size : 1.;
}

// The texture coordinates of all corners in order.
using Coordinates = std::vector<glm::dvec2>;

Coordinates MapBox(const Mesh& mesh, double tile, int up)
{
  const glm::dvec3& size = mesh.GetSize();
  const double scale = OrOne(tile > 0. ? tile : std::max({ size.x, size.y, size.z }));
  std::vector<Side> sides;
  for (int s = 0; s < 6; ++s)
  {
    sides.emplace_back(AxisOf(s / 2) * (s % 2 ? -1. : 1.), up);
    sides.back().StartAtBounds(size);
  }
  Coordinates result;
  std::vector<vtkIdType> corners;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfPolys(); ++cell)
  {
    mesh.GetPoly(cell, corners);
    const glm::dvec3 area = mesh.GetArea(corners);
    const glm::dvec3 amount = glm::abs(area);
    // Polygons without area are projected from above.
    int axis = up;
    for (int other : { (up + 1) % 3, (up + 2) % 3 })
    {
      axis = amount[other] > amount[axis] ? other : axis;
    }
    const Side& side = sides[2 * axis + (area[axis] < 0. ? 1 : 0)];
    for (const vtkIdType corner : corners)
    {
      result.push_back(side.Place(mesh.GetPoint(corner)) / scale);
    }
  }
  return result;
}

Coordinates MapSphere(const Mesh& mesh, double tile, int up)
{
  const glm::dvec3 middle = 0.5 * mesh.GetSize();
  const auto count = mesh.GetNumberOfPoints();
  double radius = 0.;
  for (vtkIdType i = 0; i < count; ++i)
  {
    radius += glm::length(mesh.GetPoint(i) - middle) / static_cast<double>(count);
  }
  const double pi = vtkMath::Pi();
  const auto tiles = [&](double length) {
    return tile > 0. ? std::max(1., std::round(length / tile)) : 1.;
  };
  const glm::dvec2 repeat(tiles(2. * pi * radius), tiles(pi * radius));
  Coordinates result;
  std::vector<vtkIdType> corners;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfPolys(); ++cell)
  {
    mesh.GetPoly(cell, corners);
    const std::size_t first = result.size();
    std::vector<std::size_t> poles;
    double low = 2.;
    double high = -1.;
    for (const vtkIdType corner : corners)
    {
      const glm::dvec3 d = mesh.GetPoint(corner) - middle;
      const double a = d[(up + 1) % 3];
      const double b = d[(up + 2) % 3];
      const double across = std::hypot(a, b);
      const double u = std::atan2(b, a) / (2. * pi) + 0.5;
      const double v = std::atan2(d[up], across) / pi + 0.5;
      if (across <= 1e-6 * radius)
      {
        poles.push_back(result.size());
      }
      else
      {
        low = std::min(low, u);
        high = std::max(high, u);
      }
      result.emplace_back(u, v);
    }
    double sum = 0.;
    for (std::size_t i = first; i < result.size(); ++i)
    {
      const bool pole = std::find(poles.begin(), poles.end(), i) != poles.end();
      // Corners beyond the seam continue above 1.
      result[i].x += !pole && high - low > 0.5 && result[i].x < 0.5 ? 1. : 0.;
      sum += pole ? 0. : result[i].x;
    }
    for (const std::size_t pole : poles)
    {
      const auto others = static_cast<double>(corners.size() - poles.size());
      result[pole].x = others > 0. ? sum / others : 0.5;
    }
    for (std::size_t i = first; i < result.size(); ++i)
    {
      result[i] *= repeat;
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
int vtkRelievoTextureCoordinates::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  this->NumberOfAddedPoints = 0;
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return 1;
  }
  if (input->GetNumberOfStrips() > 0)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("No texture coordinates: the mesh has triangle strips; triangulate them first.");
    return 1;
  }
  const Mesh mesh(input);
  relievo::PointSplitter<2> splitter(count);
  std::vector<vtkIdType> points;
  const auto value = [](const glm::dvec2& place) {
    return relievo::PointSplitter<2>::Values{ { static_cast<float>(place.x),
      static_cast<float>(place.y) } };
  };
  if (this->Mapping == PLANE)
  {
    const glm::dvec3 given(this->PlaneNormal[0], this->PlaneNormal[1], this->PlaneNormal[2]);
    const double size = glm::length(given);
    Side side(size > 0. ? given / size : FitNormal(mesh, this->Up), this->Up);
    const double extent = side.StartAtPoints(mesh);
    const double scale = OrOne(this->TileSize > 0. ? this->TileSize : extent);
    for (vtkIdType i = 0; i < count; ++i)
    {
      splitter.Get(i, value(side.Place(mesh.GetPoint(i)) / scale));
    }
  }
  else
  {
    const Coordinates coordinates = this->Mapping == BOX
      ? MapBox(mesh, this->TileSize, this->Up)
      : MapSphere(mesh, this->TileSize, this->Up);
    std::vector<vtkIdType> corners;
    points.reserve(coordinates.size());
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfPolys(); ++cell)
    {
      mesh.GetPoly(cell, corners);
      for (const vtkIdType corner : corners)
      {
        points.push_back(splitter.Get(corner, value(coordinates[points.size()])));
      }
    }
  }
  relievo::SplitPoints(input, splitter.GetOriginals(), points, output);
  this->NumberOfAddedPoints = output->GetNumberOfPoints() - count;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("TCoords");
  texture->SetNumberOfComponents(2);
  texture->SetNumberOfTuples(output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    texture->SetTypedTuple(i, splitter.GetValues(i).data());
  }
  output->GetPointData()->SetTCoords(texture);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoTextureCoordinates::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  os << indent << "NumberOfAddedPoints: " << this->NumberOfAddedPoints << "\n";
}
