// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A frame's markers as seen by its camera: the input of shaders/marker/markerFS.glsl, computed in
// double.
#ifndef vtkRelievoMarkerList_h
#define vtkRelievoMarkerList_h

#include "vtkRelievoSphereRays.h"

#include <glm/mat3x3.hpp>

#include <vector>

class vtkRelievoMarkers;
struct vtkRelievoFrameCamera;

class vtkRelievoMarkerList
{
public:
  // Takes the markers in view, in order, shadows first since they lie below all others; those of
  // all processes if `shared`.
  void Take(
    const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoMarkers*>& sets, bool shared);
  void Clear();

  // The markers as shaders/marker/markerVS.glsl reads them: 9 texels each.
  const std::vector<float>& GetTexels() const { return this->Texels; }

  int GetNumberDrawn() const { return static_cast<int>(this->Texels.size() / 36); }
  int GetNumberGiven() const { return this->Given; }

  // Whether any marker is a shadow.
  bool GetShadows() const { return this->Shadows; }

  // The viewport's rectangle with markers: x, y, width, height.
  const int* GetPart() const { return this->Part; }

private:
  struct Body;
  struct Fit;

  void Add(const vtkRelievoSphereRays& rays, vtkRelievoMarkers* markers, bool shared);
  Fit FitMarker(const Body& body) const;
  Fit FitShadow(const Body& body) const;
  void AddBody(const vtkRelievoSphereRays& rays, const Body& body);

  glm::dmat3 WorldToView{ 1.0 };
  std::vector<float> Texels;
  int Part[4] = { 0, 0, 0, 0 };
  int Given = 0;
  bool Shadows = false;
};

#endif
