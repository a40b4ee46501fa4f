// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth maps from several sides as one surface. A position belongs to the map that sees it best,
// and passes to another when its own sees it at a grazing angle or no longer.
#ifndef vtkRelievoParticleMaps_h
#define vtkRelievoParticleMaps_h

#include "vtkRelievoParticleView.h"

#include "vtkRelievoVoxelGrid.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;

class vtkRelievoParticleMaps
{
public:
  // Makes six views of a surface, with the texels of a grid of cubic cells.
  void SetSurface(vtkDataObject* data, const vtkRelievoVoxelGrid& grid);

  // Sets depth images of parallel projections, as captures provide them. Returns the error, or an
  // empty text.
  std::string SetImages(const std::vector<vtkImageData*>& images);

  std::vector<vtkRelievoParticleView> Views;
  std::vector<vtkSmartPointer<vtkPolyData>> Surfaces; // the viewed surfaces; none for depth images
  // Whether the views are pairs that face each other, with equal texels in each pair.
  bool Pairs = false;

  // The side of the largest texel, in world units; 0 without views.
  double GetTexelSize() const;
  std::size_t GetNumberOfSeenTexels() const;

  // Holds a position that was on the surface at `from` in `view` and has moved: in that view, or in
  // another one, to which `view` is then set. False if no view sees a surface within 1.5 texels.
  bool Hold(const glm::dvec3& position, const vtkRelievoParticlePlace& from, int& view,
    vtkRelievoParticlePlace& place) const;

  // Whether no view sees the position in front of its surface or beside it.
  bool IsInside(const glm::dvec3& position) const;

  // Moves a position inside by pushing it against the normals of surfaces in front of it, by at
  // most `farthest` in world units. If that fails, returns false and leaves the position unchanged.
  bool PushInside(glm::dvec3& position, double farthest) const;

  // Moves the position to the nearest visible one and sets its view. False if no view sees a
  // surface within a texel.
  bool FindNearest(glm::dvec3& position, int& view) const;

  // Whether another view sees this position at a better angle, or at an equal one and comes
  // earlier.
  bool IsSeenBetter(int view, const vtkRelievoParticlePlace& place) const;

private:
  bool GoOver(const glm::dvec3& position, const vtkRelievoParticlePlace& from, int& view,
    vtkRelievoParticlePlace& place) const;
};

#endif
