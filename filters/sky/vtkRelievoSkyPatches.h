// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light of a whole period by its direction, in patches of the sky that are divided where
// something hides a part of them.
#ifndef vtkRelievoSkyPatches_h
#define vtkRelievoSkyPatches_h

#include "vtkRelievoConeSight.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// The hemisphere is mapped to a square that keeps areas (P. Shirley, K. Chiu, A low distortion map
// between disk and square, 1997). Its patches are divided in four, from 4 x 4 to 512 x 512, 0.3
// degrees wide. Each has the sums of the light from its directions. A patch of which all directions
// are free, or all blocked, counts wholly or not at all; others count by the share of free rays to
// their corners, with a bound of all that this may miss.
class vtkRelievoSkyPatches
{
public:
  // Columns: east, north and up, in the world.
  explicit vtkRelievoSkyPatches(const glm::dmat3& world);

  // Adds light from a direction (east, north, up): direct and diffuse energy on a plane that faces
  // it, and hours of sun.
  void AddSun(const glm::dvec3& local, double direct, double diffuse, double hours);

  // Adds the energy of a uniform sky on open level ground; the energy of the horizon on an upright
  // plane.
  void AddSky(double uniform, double horizon);

  // Sums up patches; call it after all light was added.
  void Finish();

  struct Sums
  {
    double Direct = 0.0;
    double Diffuse = 0.0;
    double Bound = 0.0; // of the error of both
    double Hours = 0.0;
    double HoursBound = 0.0;
    double Insolation = 0.0; // hours times the cosine
  };

  // Finds the light at places, with rays until the bound is below a share of the light.
  class Receiver
  {
  public:
    Receiver(const vtkRelievoSkyPatches& sky, const vtkRelievoRayTree& tree,
      const vtkRelievoConeSight& sight, double tolerance);

    // The place is in the world's coordinates, in front of its surface.
    Sums Receive(const glm::dvec3& place, const glm::dvec3& normal);

  private:
    struct Node
    {
      int Level;
      int Column;
      int Row;
      Sums Light;
    };
    void Add(int level, int column, int row);
    void Divide(int level, int column, int row);
    bool IsFree(int column, int row);

    const vtkRelievoSkyPatches& Sky;
    const vtkRelievoRayTree& Tree;
    const vtkRelievoConeSight& Sight;
    double Tolerance;
    glm::dvec3 Place{}; // about the tree's centre
    glm::dvec3 Normal{};
    std::vector<Node> Nodes;
    std::vector<std::uint32_t> Seen; // of corners: twice the place's number, plus 1 if seen
    std::uint32_t Number = 0;
  };

private:
  struct Frame;
  static constexpr int FirstLevel = 2; // 2^2 patches a side
  static constexpr int RayLevel = 4;   // the first one with rays to corners
  static constexpr int LastLevel = 9;
  static constexpr int Side = 1 << LastLevel;

  struct Patch
  {
    glm::dvec3 Direct{}; // sums of directions weighted by energy, and their weights
    glm::dvec3 Diffuse{};
    glm::dvec3 Insolation{};
    double DirectSize = 0.0;
    double DiffuseSize = 0.0;
    double Hours = 0.0;
    // By which the great circles between its corners are moved away from its middle, so that the
    // patch lies between them; 1: as far again as they are from the middle.
    double Excess = 0.0;
  };

  static glm::dvec3 GetLocal(double x, double y);
  Patch& FindPatch(const glm::dvec3& local);
  void FindExcess(int level, int column, int row);
  // The great circles around a patch, and the least and the largest cosine of its directions to a
  // normal, or beyond. The last two of the cone's normals are the receiver's and the zenith.
  vtkRelievoConeSight::Cone GetCone(
    int level, int column, int row, const glm::dvec3& normal, double& least, double& most) const;
  const Patch& Get(int level, int column, int row) const
  {
    return this->Levels[static_cast<std::size_t>(level - FirstLevel)]
                       [static_cast<std::size_t>((row << level) + column)];
  }
  const glm::dvec3& GetCorner(int column, int row) const
  {
    return this->Corners[static_cast<std::size_t>(row * (Side + 1) + column)];
  }

  glm::dmat3 World;
  std::array<std::vector<Patch>, LastLevel - FirstLevel + 1> Levels;
  std::vector<glm::dvec3> Corners; // in the world
};

#endif
