// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point, line or triangle of a mesh shown at a pixel, and the pixel's ray to it, in double.
#ifndef vtkRelievoCellGeometry_h
#define vtkRelievoCellGeometry_h

#include "vtkRelievoDrawTable.h"

class vtkIdList;
struct vtkRelievoFrameCamera;

struct vtkRelievoCellGeometry
{
  int Count = 0; // 1 point, 2 line, 3 triangle; 0: unknown
  vtkIdType Points[3] = { -1, -1, -1 };
  glm::dvec3 Corners[3]; // model coordinates

  vtkRelievoCellGeometry() = default;

  // The hit's primitive, cut as by VTK's mappers.
  vtkRelievoCellGeometry(const vtkRelievoDrawTable::Hit& hit, vtkIdList* scratch);

  // Weights of the corners at the point where the ray hits the primitive, or comes nearest to it.
  void GetWeights(const glm::dvec3& from, const glm::dvec3& along, double weights[3]) const;

  // Intersects the ray with the triangle's plane, at from + t along. False if they are parallel.
  bool Intersect(const glm::dvec3& from, const glm::dvec3& along, double& t) const;
};

// The ray of a pixel's centre in model coordinates; from + t along is at depth t.
struct vtkRelievoPixelRay
{
  glm::dvec3 From;
  glm::dvec3 Along;

  vtkRelievoPixelRay(
    const vtkRelievoFrameCamera& view, const glm::dmat4& viewToModel, int x, int y);
};

#endif
