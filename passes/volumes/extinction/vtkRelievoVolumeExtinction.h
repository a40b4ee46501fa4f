// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The extinction of a volume along rays, on the CPU, by the definitions of VTK's ray-cast mappers:
// scalars interpolated in the image, their opacity from the property's scalar opacity function,
// times its gradient opacity, per unit distance in the volume's own coordinates: a path of length s
// through opacity a lets (1 - a)^(s / unit distance) of the light pass. Cropping, clipping planes,
// binary masks and blanked points and cells cut the volume.
//
// Colours of the transfer function colour the light, if asked for: a path of optical depth t
// multiplies it by colour^t, besides exp(-t). A depth of 1 so colours the light like a pane of that
// colour and opacity. The tint is the sum of -log(colour) * depth.
#ifndef vtkRelievoVolumeExtinction_h
#define vtkRelievoVolumeExtinction_h

#include "vtkRelievoVolumeChannel.h"
#include "vtkRelievoVolumeCuts.h"
#include "vtkRelievoVolumesModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkDataArray;
struct vtkRelievoPlacedVolume;

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoVolumeExtinction
{
public:
  vtkRelievoVolumeExtinction();
  ~vtkRelievoVolumeExtinction();
  vtkRelievoVolumeExtinction(const vtkRelievoVolumeExtinction&);
  vtkRelievoVolumeExtinction& operator=(const vtkRelievoVolumeExtinction&);

  // The fields of a volume: one for each image that its mapper draws. Empty if nothing can be
  // traced; `why` then has the reason, as the end of a sentence, or is empty if there is nothing to
  // draw. `colored`: with tints, of fields that are not white.
  static std::vector<vtkRelievoVolumeExtinction> Collect(
    const vtkRelievoPlacedVolume& placed, std::string& why, bool colored = false);

  // The corners of the image, in world coordinates.
  const std::vector<glm::dvec3>& GetCorners() const { return this->Corners; }

  // The smallest distance of two samples of the image, and the directions of its axes (the length
  // of a voxel), in world coordinates.
  double GetSpacing() const;
  const glm::dmat3& GetAxes() const { return this->Axes; }

  // Whether light that passes is coloured.
  bool HasTints() const;

  // Adds the optical depths of the pieces of a ray to `depths`, and their tints to `tints` if it
  // has room for them: piece k reaches from t = k to k + 1 of from + t * step (world). `samples`:
  // of each piece.
  void AddDepths(const glm::dvec3& from, const glm::dvec3& step, int samples,
    std::vector<float>& depths, std::vector<glm::vec3>& tints) const;

  // The optical depth between two places (world), in double: samples are halved until the light
  // that passes changes by less than 1e-6. Opacities are those of the functions themselves, which
  // AddDepths takes from tables.
  double GetDepth(const glm::dvec3& from, const glm::dvec3& to) const;

private:
  bool SetPlace(const glm::dmat4& toWorld, const glm::dmat4& indexToData);

  template <typename T, typename Real>
  Real GetScalar(const T* values, int component, const glm::vec<3, Real>& place) const;
  template <typename T>
  float GetExtinction(
    const vtkRelievoVolumeChannel& channel, const T* values, const glm::vec3& place) const;
  template <typename T>
  glm::vec4 GetAll(const T* values, const glm::vec3& place, bool tinted) const;
  template <typename T>
  double GetExact(const T* values, const glm::dvec3& place) const;
  template <typename T>
  void March(const T* values, const glm::dvec3& from, const glm::dvec3& step, double first,
    double last, int samples, std::vector<float>& depths, std::vector<glm::vec3>& tints) const;
  template <typename T>
  double Integrate(const T* values, const glm::dvec3& from, const glm::dvec3& along, double first,
    double last) const;
  std::vector<double> GetBorders(
    const glm::dvec3& from, const glm::dvec3& along, double first, double last) const;
  bool Clip(const glm::dvec3& from, const glm::dvec3& step, double& first, double& last) const;

  vtkSmartPointer<vtkDataArray> Array;
  std::vector<vtkRelievoVolumeChannel> Channels;
  int Size[3] = { 1, 1, 1 };   // samples
  double Low[3] = { 0, 0, 0 }; // of the box, in indices of samples
  double High[3] = { 0, 0, 0 };
  bool Nearest = false;
  glm::dmat4 WorldToIndex{ 1.0 };
  glm::dmat3 IndexToData{ 1.0 }; // of directions: lengths count in the volume's own coordinates
  glm::dmat3 Axes{ 1.0 };
  std::vector<glm::dvec3> Corners;
  vtkRelievoVolumeCuts Cuts;
};

#endif
