// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkyGrid.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Cells = 48;     // along the longest side of the scene
constexpr int Margin = 3;     // cells around it
constexpr double Away = 1.75; // cells from a surface to the place at which it looks the sky up
constexpr double MostTriangles = 4e6; // visited: others lie close to them

// Weights of the directions to a cell's 26 neighbours by the number of axes that they follow: V. I.
// Lebedev's quadrature of the sphere, exact for polynomials up to degree 7.
constexpr double Weights[] = { 0.0, 1.0 / 21.0, 4.0 / 105.0, 9.0 / 280.0 };

std::vector<glm::ivec3> GetDirections()
{
  std::vector<glm::ivec3> all;
  for (int z = -1; z <= 1; ++z)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int x = -1; x <= 1; ++x)
      {
        if (x != 0 || y != 0 || z != 0)
        {
          all.emplace_back(x, y, z);
        }
      }
    }
  }
  return all;
}

double GetWeight(const glm::ivec3& direction)
{
  return Weights[std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z)];
}

std::uint8_t MakeByte(float value)
{
  return static_cast<std::uint8_t>(std::clamp(value, 0.F, 1.F) * 255.F + 0.5F);
}
}

//------------------------------------------------------------------------------
bool vtkRelievoSkyGrid::Update(
  const std::vector<vtkRelievoPlacedMesh>& meshes, const Ground& ground)
{
  std::vector<Part> parts;
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    vtkPoints* points = mesh.Mesh->GetPoints();
    parts.push_back({ { points ? points->GetMTime() : 0, mesh.Mesh->GetPolys()->GetMTime(),
                        mesh.Mesh->GetStrips()->GetMTime() },
      mesh.MeshToWorld, mesh.Places });
  }
  if (parts == this->Parts && ground == this->Below)
  {
    return false;
  }
  this->Parts = parts;
  this->Below = ground;
  this->Texels.clear();
  if (this->Fit(meshes, ground))
  {
    this->Occupy(meshes);
    this->Look(ground);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoSkyGrid::Fit(const std::vector<vtkRelievoPlacedMesh>& meshes, const Ground& ground)
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-std::numeric_limits<double>::max());
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    double bounds[6];
    mesh.Mesh->GetBounds(bounds);
    for (std::size_t place = 0; place < mesh.GetNumberOfPlaces(); ++place)
    {
      const glm::dmat4 toWorld = mesh.GetPlace(place);
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::dvec3 at(toWorld *
          glm::dvec4(
            bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)], 1.0));
        low = glm::min(low, at);
        high = glm::max(high, at);
      }
    }
  }
  if (ground.Axis >= 0) // from the plane to the meshes
  {
    (ground.Above ? low : high)[ground.Axis] = ground.Height;
    double& other = (ground.Above ? high : low)[ground.Axis];
    other = ground.Above ? std::max(other, ground.Height) : std::min(other, ground.Height);
  }
  const glm::dvec3 sides = high - low;
  this->Cell = std::max({ sides.x, sides.y, sides.z }) / Cells;
  if (!(this->Cell > 0.0) || !std::isfinite(this->Cell))
  {
    return false;
  }
  this->Size = glm::ivec3(glm::ceil(sides / this->Cell)) + 2 * Margin;
  this->Origin = low - Margin * this->Cell;
  if (ground.Axis >= 0) // the grid ends at the plane
  {
    const int axis = ground.Axis;
    this->Size[axis] -= Margin;
    this->Origin[axis] =
      ground.Above ? ground.Height : ground.Height - this->Cell * this->Size[axis];
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoSkyGrid::Add(const glm::vec3& place)
{
  constexpr float rounding = 0.01F;
  if (glm::all(glm::greaterThan(place, glm::vec3(-rounding))) &&
    glm::all(glm::lessThan(place, glm::vec3(this->Size) + rounding)))
  {
    const glm::ivec3 at = glm::min(glm::ivec3(place), this->Size - 1);
    this->Occupied[this->GetIndex(at.x, at.y, at.z)] = 1;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSkyGrid::AddTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
  const glm::vec3 sides = glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
  const float longest = std::max({ sides.x, sides.y, sides.z });
  const int steps = static_cast<int>(std::clamp(std::ceil(1.5F * longest), 1.F, 3.F * Cells));
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const float u = static_cast<float>(i) / static_cast<float>(steps);
      const float v = static_cast<float>(j) / static_cast<float>(steps);
      this->Add((1.F - u - v) * a + u * b + v * c);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSkyGrid::Occupy(const std::vector<vtkRelievoPlacedMesh>& meshes)
{
  this->Occupied.assign(this->GetIndex(0, 0, this->Size.z), 0);
  double triangles = 0.0;
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    triangles +=
      static_cast<double>(mesh.Mesh->GetNumberOfPolys() + mesh.Mesh->GetNumberOfStrips()) *
      static_cast<double>(mesh.GetNumberOfPlaces());
  }
  const auto stride = static_cast<vtkIdType>(std::ceil(std::max(1.0, triangles / MostTriangles)));
  const glm::dmat4 toCells =
    glm::translate(glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / this->Cell)), -this->Origin);
  vtkIdType number = 0; // of the next one to visit, in the present array
  for (const vtkRelievoPlacedMesh& mesh : meshes)
  {
    for (std::size_t place = 0; place < mesh.GetNumberOfPlaces(); ++place)
    {
      const glm::dmat4 meshToCells = toCells * mesh.GetPlace(place);
      const auto find = [&](vtkIdType id) {
        double point[3];
        mesh.Mesh->GetPoint(id, point);
        return glm::vec3(meshToCells * glm::dvec4(point[0], point[1], point[2], 1.0));
      };
      for (const bool strips : { false, true })
      {
        vtkCellArray* array = strips ? mesh.Mesh->GetStrips() : mesh.Mesh->GetPolys();
        const auto cells = vtk::TakeSmartPointer(array->NewIterator());
        for (; number < array->GetNumberOfCells(); number += stride)
        {
          cells->GoToCell(number);
          vtkIdType size = 0;
          const vtkIdType* ids = nullptr;
          cells->GetCurrentCell(size, ids);
          if (size < 3)
          {
            continue;
          }
          glm::vec3 first = find(ids[0]);
          glm::vec3 second = find(ids[1]);
          for (vtkIdType i = 2; i < size; ++i)
          {
            const glm::vec3 third = find(ids[i]);
            this->AddTriangle(first, second, third);
            first = strips ? second : first;
            second = third;
          }
        }
        number -= array->GetNumberOfCells();
      }
    }
  }
}

//------------------------------------------------------------------------------
// In each direction the view from a cell is that from the next one, unless that is occupied.
void vtkRelievoSkyGrid::Look(const Ground& ground)
{
  const glm::ivec3 size = this->Size;
  const std::size_t cells = this->Occupied.size();
  std::vector<glm::vec4> sums(cells, glm::vec4(0.F)); // of directions with visible sky
  std::vector<float> sees(cells);
  std::vector<float> ofGround; // the light of the ground, by its cells
  const int axis = std::max(0, ground.Axis);
  const int first = (axis + 1) % 3;
  const int second = (axis + 2) % 3;
  const int up = ground.Above ? 1 : -1;
  const int lowest = ground.Above ? 0 : size[axis] - 1;
  const auto look = [&](const glm::ivec3& direction) {
    const glm::vec4 sum = static_cast<float>(GetWeight(direction)) *
      glm::vec4(glm::normalize(glm::vec3(direction)), 1.F);
    const auto from = [&direction](int i, int count) { return direction[i] > 0 ? count - 1 : 0; };
    const auto step = [&direction](int i) { return direction[i] > 0 ? -1 : 1; };
    glm::ivec3 at;
    for (at.z = from(2, size.z); at.z >= 0 && at.z < size.z; at.z += step(2))
    {
      for (at.y = from(1, size.y); at.y >= 0 && at.y < size.y; at.y += step(1))
      {
        for (at.x = from(0, size.x); at.x >= 0 && at.x < size.x; at.x += step(0))
        {
          const glm::ivec3 next = at + direction;
          const bool inside = next.x >= 0 && next.y >= 0 && next.z >= 0 && next.x < size.x &&
            next.y < size.y && next.z < size.z;
          float sky = 1.F;
          if (inside)
          {
            const std::size_t there = this->GetIndex(next.x, next.y, next.z);
            sky = this->Occupied[there] ? 0.F : sees[there];
          }
          else if (!ofGround.empty() && next[axis] == lowest - up)
          {
            sky = ofGround[static_cast<std::size_t>(at[second]) * size[first] + at[first]];
          }
          const std::size_t here = this->GetIndex(at.x, at.y, at.z);
          sees[here] = sky;
          sums[here] += sky * sum;
        }
      }
    }
  };
  const std::vector<glm::ivec3> directions = GetDirections();
  const auto isDown = [&](const glm::ivec3& direction) {
    return ground.Axis >= 0 && direction[axis] == -up;
  };
  for (const glm::ivec3& direction : directions)
  {
    if (!isDown(direction))
    {
      look(direction);
    }
  }
  if (ground.Axis >= 0)
  {
    ofGround.resize(static_cast<std::size_t>(size[first]) * size[second]);
    float whole = 0.F;
    for (const glm::ivec3& direction : directions)
    {
      whole += static_cast<float>(GetWeight(direction)) *
        std::max(0.F, glm::normalize(glm::vec3(direction))[axis] * static_cast<float>(up));
    }
    for (int j = 0; j < size[second]; ++j)
    {
      for (int i = 0; i < size[first]; ++i)
      {
        glm::ivec3 at;
        at[axis] = lowest;
        at[first] = i;
        at[second] = j;
        const std::size_t here = this->GetIndex(at.x, at.y, at.z);
        ofGround[static_cast<std::size_t>(j) * size[first] + i] =
          this->Occupied[here] ? 0.F : sums[here][axis] * static_cast<float>(up) / whole;
      }
    }
    for (const glm::ivec3& direction : directions)
    {
      if (isDown(direction))
      {
        look(direction);
      }
    }
  }
  this->Texels.resize(4 * cells);
  for (std::size_t i = 0; i < cells; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Texels[4 * i + k] = MakeByte(sums[i][k] + 0.5F);
    }
    this->Texels[4 * i + 3] = MakeByte(sums[i].w);
  }
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoSkyGrid::GetWorldToTexture() const
{
  const glm::dvec3 scale = 1.0 / (this->Cell * glm::dvec3(this->Size));
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i)
  {
    matrix[i][i] = scale[i];
    matrix[3][i] = -this->Origin[i] * scale[i];
  }
  return matrix;
}

//------------------------------------------------------------------------------
double vtkRelievoSkyGrid::GetAway() const
{
  return Away * this->Cell;
}
