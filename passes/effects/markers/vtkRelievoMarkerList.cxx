// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkerList.h"

#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoMarkers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double EdgePixels = 1.0;    // beyond the outline, for filtered edges
constexpr double LargestTexel = 1e30; // greatest value that is safe in floats
constexpr double ShadowOnset = 0.25;  // radii below a point over which its shadow fades in
// Least squared width of a shadow, over its mean squared width.
constexpr double Thinnest = 1e-4;
constexpr double BoxTolerance = 0.001; // share of a box's height above its bottom

// A direction perpendicular to this one.
glm::dvec3 GetAcross(const glm::dvec3& direction)
{
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 least = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
    : size.y <= size.z                                          ? glm::dvec3(0.0, 1.0, 0.0)
                                                                : glm::dvec3(0.0, 0.0, 1.0);
  return glm::normalize(glm::cross(direction, least));
}

// The remainder of the value after rounding to float.
double Remainder(double value)
{
  return value - static_cast<double>(static_cast<float>(value));
}
}

// A point or a box in the world, with the values of its row.
struct vtkRelievoMarkerList::Body
{
  glm::dvec3 Center;
  glm::dmat3 Axes; // columns: the box's axes
  glm::dvec3 Half;
  const double* Values; // radius, width, reach, opacity, color
  int Shape;
  glm::dvec3 Up;
};

// Input of the shader: lengths in units of Unit, the radius of a bounding sphere.
struct vtkRelievoMarkerList::Fit
{
  glm::dvec3 Center; // of the bounding sphere, in the world
  double Unit;
  glm::dvec4 Edges{ 0.0 };
  glm::dvec3 Axes[3]; // eye space
  glm::dvec3 Half{ 0.0 };
};

//------------------------------------------------------------------------------
void vtkRelievoMarkerList::Clear()
{
  this->Texels.clear();
  std::fill_n(this->Part, 4, 0);
  this->Given = 0;
  this->Shadows = false;
}

//------------------------------------------------------------------------------
void vtkRelievoMarkerList::Take(
  const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoMarkers*>& sets, bool shared)
{
  this->Clear();
  const vtkRelievoSphereRays rays(view);
  if (!rays.IsUsual())
  {
    return;
  }
  this->WorldToView = glm::dmat3(view.WorldToView);
  for (const bool shadows : { true, false })
  {
    for (vtkRelievoMarkers* markers : sets)
    {
      if (shadows == (markers->GetShape() == vtkRelievoMarkers::SHADOW))
      {
        this->Add(rays, markers, shared);
      }
    }
    this->Shadows = shadows ? !this->Texels.empty() : this->Shadows;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMarkerList::Add(
  const vtkRelievoSphereRays& rays, vtkRelievoMarkers* markers, bool shared)
{
  Body body;
  body.Shape = markers->GetShape();
  const double* up = markers->GetUp();
  body.Up = glm::normalize(glm::dvec3(up[0], up[1], up[2]));
  body.Axes = glm::dmat3(1.0);
  body.Half = glm::dvec3(0.0);
  if (!shared)
  {
    markers->GetNumberOfPoints();
  }
  const std::vector<double>& rows = shared ? markers->GetSharedRows() : markers->GetRows();
  const auto width = static_cast<std::size_t>(markers->GetRowWidth());
  for (std::size_t i = 0; i + width <= rows.size(); i += width)
  {
    body.Center = glm::dvec3(rows[i], rows[i + 1], rows[i + 2]);
    body.Values = rows.data() + i + 3;
    this->AddBody(rays, body);
  }
  double values[7];
  if (!markers->GetValuesForActors(values))
  {
    return;
  }
  body.Values = values;
  for (const vtkRelievoMarkers::Box& box : markers->GetBoxes())
  {
    body.Center = glm::dvec3(box.Center[0], box.Center[1], box.Center[2]);
    body.Half = glm::dvec3(box.Half[0], box.Half[1], box.Half[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      body.Axes[axis] = glm::dvec3(box.Axes[axis][0], box.Axes[axis][1], box.Axes[axis][2]);
    }
    this->AddBody(rays, body);
  }
}

//------------------------------------------------------------------------------
vtkRelievoMarkerList::Fit vtkRelievoMarkerList::FitMarker(const Body& body) const
{
  const double radius = body.Values[0];
  Fit fit;
  fit.Center = body.Center;
  fit.Unit = glm::length(body.Half) + radius;
  fit.Edges[0] = radius / fit.Unit;
  fit.Edges[1] = fit.Edges[0] * std::max(0.0, 1.0 - body.Values[1]);
  fit.Half = body.Half / fit.Unit;
  for (int i = 0; i < 3; ++i)
  {
    fit.Axes[i] = this->WorldToView * body.Axes[i];
  }
  return fit;
}

//------------------------------------------------------------------------------
vtkRelievoMarkerList::Fit vtkRelievoMarkerList::FitShadow(const Body& body) const
{
  const double radius = body.Values[0];
  // The ellipse around the box seen from above, grown by the radius.
  glm::dmat3 spread(0.0);
  double bottom = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double along = glm::dot(body.Axes[i], body.Up);
    const glm::dvec3 across = body.Half[i] * (body.Axes[i] - along * body.Up);
    spread += 2.0 * glm::outerProduct(across, across);
    bottom += body.Half[i] * std::abs(along);
  }
  const double squares = spread[0][0] + spread[1][1] + spread[2][2];
  const double size = std::sqrt(0.5 * squares) + radius;
  // A flat box still gets a small extent.
  const double grown = std::max(radius * radius, Thinnest * size * size);
  const glm::dvec3 first = GetAcross(body.Up);
  const glm::dvec3 second = glm::cross(body.Up, first);
  const double angle = 0.5 *
    std::atan2(2.0 * glm::dot(first, spread * second),
      glm::dot(first, spread * first) - glm::dot(second, spread * second));
  const glm::dvec3 along[2] = { std::cos(angle) * first + std::sin(angle) * second,
    std::cos(angle) * second - std::sin(angle) * first };

  const bool isPoint = body.Half == glm::dvec3(0.0);
  const double fade = body.Values[2] * size;
  const double end = bottom + fade;
  const double onset = isPoint ? ShadowOnset * radius : BoxTolerance * (bottom + size);
  const double start = isPoint ? 0.0 : bottom - 2.0 * onset;
  const double down = 0.5 * end; // to the middle of the shadow's column
  Fit fit;
  fit.Center = body.Center - down * body.Up;
  fit.Unit = std::sqrt(squares + grown + down * down);
  const double unit = fit.Unit;
  fit.Edges = { (start - down) / unit, unit / onset, (end - down) / unit, unit / fade };
  for (int i = 0; i < 2; ++i)
  {
    const double half = std::sqrt(glm::dot(along[i], spread * along[i]) + grown);
    fit.Axes[i] = unit / half * (this->WorldToView * along[i]);
  }
  fit.Axes[2] = this->WorldToView * body.Up;
  return fit;
}

//------------------------------------------------------------------------------
void vtkRelievoMarkerList::AddBody(const vtkRelievoSphereRays& rays, const Body& body)
{
  ++this->Given;
  const bool shadow = body.Shape == vtkRelievoMarkers::SHADOW;
  const Fit fit = shadow ? this->FitShadow(body) : this->FitMarker(body);
  vtkRelievoSphereRays::Sphere sphere;
  if (!(fit.Unit > 0.0) || !rays.Find(fit.Center, fit.Unit, sphere, EdgePixels))
  {
    return;
  }
  const double depth = sphere.MiddleDepth + rays.GetBegin();
  const int* r = sphere.Rectangle;
  const double alpha = std::min(body.Values[3], 1.0);
  const double tint = shadow ? 0.0 : 1.0;
  const double texels[36] = { double(r[0]), double(r[1]), double(r[2]), double(r[3]), //
    tint * body.Values[4], tint * body.Values[5], tint * body.Values[6], alpha,       //
    sphere.Offset.x, sphere.Offset.y, sphere.Pixel.x, sphere.Pixel.y,                 //
    sphere.Offsets[0].x, sphere.Offsets[0].y, sphere.Offsets[1].x, sphere.Offsets[1].y, depth,
    Remainder(depth), 1.0 / fit.Unit, double(body.Shape),    //
    fit.Edges.x, fit.Edges.y, fit.Edges.z, fit.Edges.w,      //
    fit.Axes[0].x, fit.Axes[0].y, fit.Axes[0].z, fit.Half.x, //
    fit.Axes[1].x, fit.Axes[1].y, fit.Axes[1].z, fit.Half.y, //
    fit.Axes[2].x, fit.Axes[2].y, fit.Axes[2].z, fit.Half.z };
  if (!std::all_of(texels, texels + 36, [](double v) { return std::abs(v) < LargestTexel; }))
  {
    return;
  }
  const bool first = this->Texels.empty();
  this->Texels.insert(this->Texels.end(), texels, texels + 36);
  for (int axis = 0; axis < 2; ++axis)
  {
    const int begin = first ? r[axis] : std::min(this->Part[axis], r[axis]);
    const int end =
      first ? r[axis + 2] : std::max(this->Part[axis] + this->Part[axis + 2], r[axis + 2]);
    this->Part[axis] = begin;
    this->Part[axis + 2] = end - begin;
  }
}
