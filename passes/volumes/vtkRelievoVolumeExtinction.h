// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The extinction of a volume along rays, on the CPU, by the definitions of VTK's ray-cast mappers:
// scalars interpolated in the image, their opacity from the property's scalar opacity function,
// times its gradient opacity, per unit distance in the volume's own coordinates: a path of length s
// through opacity a lets (1 - a)^(s / unit distance) of the light pass. Cropping and clipping
// planes cut the volume.
#ifndef vtkRelievoVolumeExtinction_h
#define vtkRelievoVolumeExtinction_h

#include "vtkRelievoVolumesModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMatrix4x4;
class vtkVolume;
class vtkVolumeMapper;

// A volume where it is drawn.
struct VTKRELIEVOVOLUMES_EXPORT vtkRelievoPlacedVolume
{
  // Without a matrix to the world: where its own one places it.
  vtkRelievoPlacedVolume(vtkVolume* volume, vtkMatrix4x4* toWorld = nullptr);

  vtkVolume* Volume;
  glm::dmat4 ToWorld;
};

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoVolumeExtinction
{
public:
  vtkRelievoVolumeExtinction();
  ~vtkRelievoVolumeExtinction();
  vtkRelievoVolumeExtinction(const vtkRelievoVolumeExtinction&);
  vtkRelievoVolumeExtinction& operator=(const vtkRelievoVolumeExtinction&);

  // The fields of a volume: one for each image that its mapper draws. Empty if nothing can be
  // traced; `why` then has the reason, as the end of a sentence, or is empty if there is nothing to
  // draw.
  static std::vector<vtkRelievoVolumeExtinction> Collect(
    const vtkRelievoPlacedVolume& placed, std::string& why);

  // Why the shader of a volume's mapper, if it has one, cannot place samples in the world by
  // GetTextureToWorld, as the end of a sentence, or "".
  static std::string FindWhyNotPlaced(vtkVolume* volume);

  // From the texture coordinates of the mapper's image, as VTK's ray march has them, to the world.
  static glm::dmat4 GetTextureToWorld(vtkVolumeMapper* mapper, vtkVolume* volume);

  // The state of everything that the fields of a volume depend on, for comparison. Cheap.
  static void AddState(const vtkRelievoPlacedVolume& placed, std::vector<std::uint64_t>& state);

  // The corners of the image, in world coordinates.
  const std::vector<glm::dvec3>& GetCorners() const { return this->Corners; }

  // The smallest distance of two samples of the image, and the directions of its axes (the length
  // of a voxel), in world coordinates.
  double GetSpacing() const;
  const glm::dmat3& GetAxes() const { return this->Axes; }

  // Adds the optical depths of the pieces of a ray to `depths`: piece k reaches from t = k to k + 1
  // of from + t * step (world). `samples`: of each piece.
  void AddDepths(
    const glm::dvec3& from, const glm::dvec3& step, int samples, std::vector<float>& depths) const;

private:
  template <typename T>
  void March(const T* values, const glm::dvec3& from, const glm::dvec3& step, double first,
    double last, int samples, std::vector<float>& depths) const;
  template <typename T>
  float GetScalar(const T* values, const glm::vec3& place) const;
  template <typename T>
  float GetExtinction(const T* values, const glm::vec3& place) const;
  bool Clip(const glm::dvec3& from, const glm::dvec3& step, double& first, double& last) const;

  vtkSmartPointer<vtkDataArray> Array;
  int Component = 0;
  int Size[3] = { 1, 1, 1 };   // samples
  double Low[3] = { 0, 0, 0 }; // of the box, in indices of samples
  double High[3] = { 0, 0, 0 };
  bool Nearest = false;
  glm::dmat4 WorldToIndex{ 1.0 };
  glm::dmat3 IndexToData{ 1.0 }; // of directions: lengths count in the volume's own coordinates
  glm::dmat3 Axes{ 1.0 };
  std::vector<glm::dvec3> Corners;
  std::vector<glm::dvec4> Planes;        // in world coordinates: positive inside
  int Cropped = -1;                      // flags of the 27 regions; -1: none is cut
  double Crop[6] = { 0, 0, 0, 0, 0, 0 }; // in indices of samples
  std::vector<float> Extinction; // of scalars, per unit of length in the volume's coordinates
  float First = 0.f;             // the scalar of its first entry
  float PerScalar = 0.f;         // entries
  // Of the gradient's length, from 0 to a quarter of the scalars' range, beyond which it stays;
  // empty: none. The length is that of differences of neighbours, each times its weight.
  std::vector<float> GradientOpacity;
  glm::vec3 Weights{ 1.f };
};

#endif
