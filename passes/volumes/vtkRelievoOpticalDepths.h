// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Optical depths of volumes between a light and every point, in a grid along the light's rays: its
// first two axes number the rays, its third is the distance along them. A point behind the
// volumes has the depth of its whole ray, one before them none. The light that reaches a point is
// exp(-depth), without a limit on how the extinction changes along the ray (T. Lokovic, E. Veach:
// Deep shadow maps, 2000), since the grid has a node at every voxel.
#ifndef vtkRelievoOpticalDepths_h
#define vtkRelievoOpticalDepths_h

#include "vtkRelievoVolumesModule.h" // for the export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

class vtkRelievoVolumeExtinction;

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoOpticalDepths
{
public:
  struct Source
  {
    bool Positional = false;
    glm::dvec3 Position{ 0.0 };         // world, for positional lights
    glm::dvec3 Direction{ 0.0, 0, -1 }; // world, unit, direction of the rays of the others

    bool operator==(const Source& other) const
    {
      return this->Positional == other.Positional &&
        (this->Positional ? this->Position == other.Position : this->Direction == other.Direction);
    }
  };

  // Marches through the fields: a node for each voxel, in each direction at most `most`.
  void Make(const std::vector<vtkRelievoVolumeExtinction>& fields, const Source& source, int most);

  // The interpolated depth at a point of the world.
  double GetDepth(const glm::dvec3& world) const;

  // From the world to the argument `map` of relievoVolumeTexel, or of relievoVolumeTexelAround if
  // rays go in all directions (shaders/volumes/texel.glsl).
  const glm::dmat4& GetWorldToMap() const { return this->WorldToMap; }
  bool IsAround() const { return this->Around; }
  const glm::ivec3& GetSize() const { return this->Size; }
  const std::vector<float>& GetDepths() const { return this->Depths; } // x fastest

  // Frees the nodes; the matrix and the size stay.
  void ReleaseNodes() { std::vector<float>().swap(this->Depths); }

private:
  glm::dmat4 WorldToMap{ 1.0 };
  bool Around = false;
  glm::ivec3 Size{ 0 };
  std::vector<float> Depths;
};

#endif
