// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCellGeometry.h"

#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoCell.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoPolygonCut.h"

#include <algorithm>
#include <cmath>

namespace
{
// Positions of the corners of primitive k of a cell, cut as by VTK's mappers. Returns their number.
int GetCorners(const vtkRelievoDrawTable::Hit& hit, const vtkRelievoCell& cell,
  vtkRelievoPolygonCut& cut, vtkIdType corners[3])
{
  // Most cells are triangles, with one primitive.
  const int representation = hit.Representation;
  const bool polygon = cell.Kind == vtkRelievoCell::Polys;
  const bool whole = polygon && cell.Count == 3 && representation == VTK_SURFACE;
  const vtkIdType k = whole ? 0 : hit.GetPrimitiveInCell();
  if (representation == VTK_POINTS || cell.Kind == vtkRelievoCell::Verts)
  {
    corners[0] = k;
    return 1;
  }
  if (cell.Kind == vtkRelievoCell::Lines || representation == VTK_WIREFRAME)
  {
    corners[0] = k;
    corners[1] = polygon ? (k + 1) % cell.Count : k + 1;
    if (cell.Kind == vtkRelievoCell::Strips && k > 0)
    {
      // The first edge, then two for every further point.
      corners[0] = k / 2;
      corners[1] = (k - 1) / 2 + 2;
    }
    return 2;
  }
  corners[0] = polygon ? 0 : k;
  corners[1] = k + 1;
  corners[2] = k + 2;
  if (polygon && cell.Count > 3)
  {
    const auto& triangles = cut.Cut(hit.Mesh, cell.Points, cell.Count);
    if (k < static_cast<vtkIdType>(triangles.size()))
    {
      std::copy_n(triangles[static_cast<std::size_t>(k)].begin(), 3, corners);
    }
  }
  return 3;
}
}

//------------------------------------------------------------------------------
vtkRelievoCellGeometry::vtkRelievoCellGeometry(
  const vtkRelievoDrawTable::Hit& hit, vtkIdList* scratch)
{
  if (!hit.Mesh || hit.Cell < 0 || hit.Changed)
  {
    return;
  }
  const vtkRelievoCell cell(hit.Mesh, hit.Cell, scratch);
  vtkIdType corners[3] = { 0, 0, 0 };
  vtkRelievoPolygonCut cut;
  const int count = GetCorners(hit, cell, cut, corners);
  for (int i = 0; i < count; ++i)
  {
    if (corners[i] >= cell.Count)
    {
      return;
    }
    this->Points[i] = cell.Points[corners[i]];
    hit.Mesh->GetPoint(this->Points[i], &this->Corners[i][0]);
  }
  this->Count = count;
}

//------------------------------------------------------------------------------
bool vtkRelievoCellGeometry::Intersect(
  const glm::dvec3& from, const glm::dvec3& along, double& t) const
{
  const glm::dvec3 normal =
    glm::cross(this->Corners[1] - this->Corners[0], this->Corners[2] - this->Corners[0]);
  t = glm::dot(normal, this->Corners[0] - from) / glm::dot(normal, along);
  return std::isfinite(t);
}

//------------------------------------------------------------------------------
void vtkRelievoCellGeometry::GetWeights(
  const glm::dvec3& from, const glm::dvec3& along, double weights[3]) const
{
  const glm::dvec3* p = this->Corners;
  double t = 0.0;
  weights[0] = 1.0;
  weights[1] = weights[2] = 0.0;
  if (this->Count == 2)
  {
    const glm::dvec3 segment = p[1] - p[0];
    const glm::dvec3 across = glm::cross(along, glm::cross(along, segment));
    const double slope = glm::dot(across, segment);
    t = std::abs(slope) > 0.0 ? glm::dot(across, from - p[0]) / slope : 0.5;
    weights[1] = std::min(1.0, std::max(0.0, t));
    weights[0] = 1.0 - weights[1];
  }
  else if (this->Count == 3)
  {
    weights[0] = weights[1] = weights[2] = 1.0 / 3.0;
    if (!this->Intersect(from, along, t))
    {
      return;
    }
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const glm::dvec3 hit = from + t * along;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3& a = p[(i + 1) % 3];
      const glm::dvec3& b = p[(i + 2) % 3];
      weights[i] = std::max(0.0, glm::dot(glm::cross(b - a, hit - a), normal));
      sum += weights[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      weights[i] = sum > 0.0 ? weights[i] / sum : 1.0 / 3.0;
    }
  }
}

//------------------------------------------------------------------------------
vtkRelievoPixelRay::vtkRelievoPixelRay(
  const vtkRelievoFrameCamera& view, const glm::dmat4& viewToModel, int x, int y)
{
  using namespace relievo::f64;
  const glm::dvec2 ndc =
    relievoNdcFromPixel(glm::dvec2(x, y), glm::dvec2(view.Viewport[2], view.Viewport[3]));
  const glm::dvec3 eye = relievoEyePosition(ndc, 0.0, view.ViewToNDC);
  const glm::dvec3 ahead = relievoEyePosition(ndc, 1.0, view.ViewToNDC);
  this->From = glm::dvec3(viewToModel * glm::dvec4(eye, 1.0));
  this->Along = glm::dvec3(viewToModel * glm::dvec4(ahead - eye, 0.0));
}
