// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Optical depths of volumes between a light and every point, in a grid along the light's rays: its
// first two axes number the rays, its third is the distance along them. A point behind the
// volumes has the depth of its whole ray, one before them none. The light that reaches a point is
// exp(-depth), without a limit on how the extinction changes along the ray (T. Lokovic, E. Veach:
// Deep shadow maps, 2000), since the grid has a node at every voxel. Instead of nodes, a ray may
// have a few terms of a Fourier series of its extinction, which take less memory and cost exactness
// (J. Jansen, L. Bavoil: Fourier opacity mapping, 2010).
#ifndef vtkRelievoOpticalDepths_h
#define vtkRelievoOpticalDepths_h

#include "vtkRelievoVolumesModule.h" // for the export macro

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <functional>
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

  // Where fields are, for which a grid is laid.
  struct Extent
  {
    std::vector<glm::dvec3> Corners; // world, eight of each field
    double Spacing = 0.0;            // the smallest distance of two samples
    glm::dmat3 Axes{ 1.0 };          // of the first field
    bool Tinted = false;
  };
  static Extent GetExtent(const std::vector<vtkRelievoVolumeExtinction>& fields);

  // exp(-64) is darkness: deeper rays need no more of a series or a half float.
  static constexpr float Deepest = 64.f;

  // Marches through the fields: a node for each voxel, in each direction at most `most`.
  // `harmonics`: of each ray's series, in place of its nodes; 0: nodes.
  void Make(const std::vector<vtkRelievoVolumeExtinction>& fields, const Source& source, int most,
    int harmonics = 0);

  // Make in two steps: a grid without nodes, and its nodes, which hold the light of these fields,
  // some or all of the extent's.
  void Lay(const Extent& extent, const Source& source, int most, int harmonics = 0);
  void Fill(const std::vector<vtkRelievoVolumeExtinction>& fields, bool tinted);

  // The share of places in and behind the volumes whose light a laid grid misses by more than
  // `slack`, found at `places` random ones by rays in double; -1 if none of them is in any shade.
  double EstimateWrongShare(const std::vector<vtkRelievoVolumeExtinction>& fields,
    const Source& source, double slack, int places) const;

  // The interpolated depth at a point of the world, and without a grid, by rays in double.
  double GetDepth(const glm::dvec3& world) const;
  static double GetExactDepth(const std::vector<vtkRelievoVolumeExtinction>& fields,
    const Source& source, const glm::dvec3& world);

  // From the world to the argument `map` of relievoVolumeTexel, or of relievoVolumeTexelAround if
  // rays go in all directions (shaders/volumes/texel.glsl).
  const glm::dmat4& GetWorldToMap() const { return this->WorldToMap; }
  bool IsAround() const { return this->Around; }
  const glm::ivec3& GetSize() const { return this->Size; }

  // The terms of a ray's series (shaders/volumes/shade.glsl) are the whole depth, and for each
  // harmonic m the factors of sin(2 pi m t) and 1 - cos(2 pi m t), for t from 0 to 1 along the ray.
  int GetHarmonics() const { return this->Harmonics; }
  // Numbers of values along each axis: of nodes, or of rays and terms.
  glm::ivec3 GetStored() const
  {
    const int along = this->Harmonics > 0 ? 2 * this->Harmonics + 1 : this->Size.z;
    return { this->Size.x, this->Size.y, along };
  }
  // x fastest
  std::vector<float>& GetDepths() { return this->Depths; }
  // The tints of vtkRelievoVolumeExtinction, or empty.
  std::vector<glm::vec3>& GetTints() { return this->Tints; }

  // Frees the nodes; the matrix and the size stay.
  void ReleaseNodes()
  {
    std::vector<float>().swap(this->Depths);
    std::vector<glm::vec3>().swap(this->Tints);
  }

private:
  void March(const std::vector<vtkRelievoVolumeExtinction>& fields, int i, int j,
    std::vector<float>& depths, std::vector<glm::vec3>& tints) const;
  bool FindTexel(const glm::dvec3& world, glm::dvec3& texel) const;
  double Interpolate(const glm::dvec3& texel) const;

  glm::dmat4 WorldToMap{ 1.0 };
  bool Around = false;
  glm::ivec3 Size{ 0 };
  int Harmonics = 0;
  int Samples = 1;                                                                    // of a piece
  std::function<void(double i, double j, glm::dvec3& from, glm::dvec3& step)> GetRay; // at a texel
  std::vector<float> Depths;
  std::vector<glm::vec3> Tints;
};

#endif
