// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A coarse grid around a scene, with the directions in which the sky is visible from each cell.
#ifndef vtkRelievoSkyGrid_h
#define vtkRelievoSkyGrid_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoPlacedMesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoSkyGrid
{
public:
  // A plane below the scene that reflects the light of the sky that it sees.
  struct Ground
  {
    int Axis = -1;     // -1: there is none
    bool Above = true; // the scene lies above the plane, in the direction of the axis
    double Height = 0.0;

    bool operator==(const Ground& other) const
    {
      return this->Axis == other.Axis && this->Above == other.Above && this->Height == other.Height;
    }
  };

  // For these meshes and no others. Returns whether the grid has changed.
  bool Update(const std::vector<vtkRelievoPlacedMesh>& meshes, const Ground& ground);

  bool IsEmpty() const { return this->Texels.empty(); }

  // Number of cells along each axis, and their values, x fastest:
  // shaders/formulas/light/sky_grid.glsl.
  const glm::ivec3& GetSize() const { return this->Size; }
  const std::vector<std::uint8_t>& GetTexels() const { return this->Texels; }

  // From the world to texture coordinates, and the distance from a surface, in world units, of a
  // cell that the surface itself does not block.
  glm::dmat4 GetWorldToTexture() const;
  double GetAway() const;

private:
  struct Part
  {
    std::array<vtkMTimeType, 3> Times; // of points, polygons and strips: no two objects share one
    glm::dmat4 Place;
    std::shared_ptr<const std::vector<glm::dmat4>> Places;

    bool operator==(const Part& other) const
    {
      return this->Times == other.Times && this->Place == other.Place &&
        this->Places == other.Places;
    }
  };

  bool Fit(const std::vector<vtkRelievoPlacedMesh>& meshes, const Ground& ground);
  void Occupy(const std::vector<vtkRelievoPlacedMesh>& meshes);
  void AddTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c); // in cells
  void Add(const glm::vec3& place);
  void Look(const Ground& ground);
  std::size_t GetIndex(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->Size.y + y) * this->Size.x + x;
  }

  std::vector<Part> Parts;
  Ground Below;
  glm::ivec3 Size{ 0 };
  glm::dvec3 Origin{ 0.0 };
  double Cell = 0.0; // side
  std::vector<std::uint8_t> Occupied;
  std::vector<std::uint8_t> Texels;
};

#endif
