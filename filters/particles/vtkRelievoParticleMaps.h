// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth maps from several sides as one surface: a place is held by the map that sees it best, and
// goes over to another where its own sees it at a grazing angle or no more.
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
  // Six views of a surface, with the texels of a grid of cubic cells.
  void SetSurface(vtkDataObject* data, const vtkRelievoVoxelGrid& grid);

  // Depth images of parallel projections, as captures have them. Returns what is wrong, or an empty
  // text.
  std::string SetImages(const std::vector<vtkImageData*>& images);

  std::vector<vtkRelievoParticleView> Views;
  std::vector<vtkSmartPointer<vtkPolyData>> Surfaces; // that the views see; none for depth images
  // Whether the views are pairs that look at each other, each pair with the same texels.
  bool Pairs = false;

  // The side of the largest texel, in world units; 0 without views.
  double GetTexelSize() const;
  std::size_t GetNumberOfSeenTexels() const;

  // Where a place is held that was on the surface at `from`, seen by `view`, and has moved: by that
  // view, or by another, which view then is. False if no view sees a surface within 1.5 texels.
  bool Hold(const glm::dvec3& position, const vtkRelievoParticlePlace& from, int& view,
    vtkRelievoParticlePlace& place) const;

  // Whether no view sees the place before its surface or beside it.
  bool IsInside(const glm::dvec3& position) const;

  // Moves a place inside by pushing it against the normals of what it is before; at most so far, in
  // world units. False, and the place as it was, if that does not bring it inside.
  bool PushInside(glm::dvec3& position, double farthest) const;

  // Moves the position to the nearest place that is seen, and says by which view. False if none
  // sees a place within a texel.
  bool FindNearest(glm::dvec3& position, int& view) const;

  // Whether another view sees the same place at a better angle, or as good and earlier in order.
  bool IsSeenBetter(int view, const vtkRelievoParticlePlace& place) const;

private:
  bool GoOver(const glm::dvec3& position, const vtkRelievoParticlePlace& from, int& view,
    vtkRelievoParticlePlace& place) const;
};

#endif
