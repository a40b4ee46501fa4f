// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMarkerList.h"

#include "vtkRelievoMarkers.h"
#include "vtkRelievoView.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double EdgePixels = 1.0;     // beyond the outline, that edges are filtered over
constexpr double Largest = 1e30;       // that is safe in floats
constexpr double ShadowOnset = 0.25;   // radii below a point, over which its shadow begins
constexpr double BoxTolerance = 0.001; // of a box's height, above its bottom

// What the value lacks as a float.
double Lacks(double value)
{
  return value - static_cast<double>(static_cast<float>(value));
}
}

// A point or a box with the values of a row, in the world.
struct vtkRelievoMarkerList::Body
{
  glm::dvec3 Center;
  glm::dmat3 Axes; // columns
  glm::dvec3 Half;
  const double* Values; // radius, width, reach, opacity, color
  int Shape;
  glm::dvec3 Up;
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
  const vtkRelievoView& view, const std::vector<vtkRelievoMarkers*>& sets, bool shared)
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
void vtkRelievoMarkerList::AddBody(const vtkRelievoSphereRays& rays, const Body& body)
{
  ++this->Given;
  const double radius = body.Values[0];
  const bool shadow = body.Shape == vtkRelievoMarkers::SHADOW;
  glm::dvec3 center = body.Center;
  double unit = glm::length(body.Half) + radius;
  double edges[4] = { 0.0, 0.0, 0.0, 0.0 };
  double axes[3][4];
  if (shadow)
  {
    // The ellipse around the box as seen from above, grown by the radius.
    glm::dmat3 spread(0.0);
    double bottom = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double along = glm::dot(body.Axes[i], body.Up);
      const glm::dvec3 across = body.Half[i] * (body.Axes[i] - along * body.Up);
      spread += 2.0 * glm::outerProduct(across, across);
      bottom += body.Half[i] * std::abs(along);
    }
    const glm::dmat3 up = glm::outerProduct(body.Up, body.Up);
    const glm::dmat3 level = glm::dmat3(1.0) - up;
    const double size = std::sqrt(0.5 * (spread[0][0] + spread[1][1] + spread[2][2])) + radius;
    // What is flat in a direction still has a little.
    const double grown = std::max(radius * radius, 1e-8 * size * size);
    const double rim2 = spread[0][0] + spread[1][1] + spread[2][2] + grown; // or more
    spread += grown * level;
    const glm::dmat3 square = glm::inverse(spread + size * size * up) - up / (size * size);
    const bool isPoint = body.Half == glm::dvec3(0.0);
    const double fade = body.Values[2] * size;
    const double end = bottom + fade;
    const double onset = isPoint ? ShadowOnset * radius : BoxTolerance * (bottom + size);
    const double start = isPoint ? 0.0 : bottom - 2.0 * onset;
    // Its middle is halfway down.
    const double down = 0.5 * end;
    center -= down * body.Up;
    unit = std::sqrt(rim2 + down * down);
    const double heights[4] = { (start - down) / unit, unit / onset, (end - down) / unit,
      unit / fade };
    std::copy_n(heights, 4, edges);
    const glm::dmat3 turned =
      unit * unit * (this->WorldToView * square * glm::transpose(this->WorldToView));
    const glm::dvec3 upVC = this->WorldToView * body.Up;
    const double rows[3][4] = { { turned[0][0], turned[1][1], turned[2][2], 0.0 },
      { turned[1][2], turned[2][0], turned[0][1], 0.0 }, { upVC.x, upVC.y, upVC.z, 0.0 } };
    std::copy_n(&rows[0][0], 12, &axes[0][0]);
  }
  else
  {
    edges[0] = radius / unit;
    edges[1] = edges[0] * std::max(0.0, 1.0 - body.Values[1]);
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 axis = this->WorldToView * body.Axes[i];
      const double row[4] = { axis.x, axis.y, axis.z, body.Half[i] / unit };
      std::copy_n(row, 4, axes[i]);
    }
  }
  vtkRelievoSphereRays::Sphere sphere;
  if (!(unit > 0.0) || !rays.Find(center, unit, sphere, EdgePixels))
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
    Lacks(depth), 1.0 / unit, double(body.Shape),   //
    edges[0], edges[1], edges[2], edges[3],         //
    axes[0][0], axes[0][1], axes[0][2], axes[0][3], //
    axes[1][0], axes[1][1], axes[1][2], axes[1][3], //
    axes[2][0], axes[2][1], axes[2][2], axes[2][3] };
  if (!std::all_of(texels, texels + 36, [](double v) { return std::abs(v) < Largest; }))
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
