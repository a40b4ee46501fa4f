// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkerScene.h"

#include "FogTruth.h"
#include "PointArrays.h"
#include "Props.h"
#include "Stage.h"

#include <vtkMapper.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
namespace
{
// A pixel's point in the world, and its changes by pixels on the plane that the depths around say.
struct Place
{
  glm::dvec3 Point;
  glm::dvec3 Along[2];
  glm::dvec3 Normal; // 0: none
};

Place FindPlace(const vtkRelievoFrameCamera& view, const Layers& layers, int x, int y)
{
  const double depth = layers.Value("depth", x, y);
  const glm::dmat4 toWorld = glm::inverse(view.WorldToView);
  const auto at = [&](double px, double py, double z) {
    return glm::dvec3(toWorld * glm::dvec4(glm::dvec3(PointAt(view, px, py, z)), 1.));
  };
  Place place;
  place.Point = at(x + 0.5, y + 0.5, depth);
  for (int axis = 0; axis < 2; ++axis)
  {
    double steps[2] = { 0., 0. };
    bool there[2];
    for (int side = 0; side < 2; ++side)
    {
      const int away = side == 0 ? -1 : 1;
      const int nx = x + (axis == 0 ? away : 0);
      const int ny = y + (axis == 1 ? away : 0);
      there[side] = nx >= 0 && ny >= 0 && nx < layers.Width && ny < layers.Height;
      if (there[side])
      {
        const double other = layers.Value("depth", nx, ny);
        steps[side] = away * (view.Parallel ? other - depth : depth - depth * depth / other);
      }
    }
    if (!there[0] || !there[1])
    {
      steps[0] = steps[1] = there[0] ? steps[0] : steps[1];
    }
    const bool alike = steps[0] * steps[1] > 0.;
    const double slope =
      alike ? std::copysign(std::min(std::abs(steps[0]), std::abs(steps[1])), steps[0]) : 0.;
    const double h = 1e-3;
    const double dx = axis == 0 ? h : 0.;
    const double dy = axis == 1 ? h : 0.;
    place.Along[axis] = (at(x + 0.5 + dx, y + 0.5 + dy, depth + slope * h) -
                          at(x + 0.5 - dx, y + 0.5 - dy, depth - slope * h)) /
      (2. * h);
  }
  place.Normal = glm::dvec3(0.);
  if (layers.Image->GetPointData()->HasArray("normal"))
  {
    place.Normal = layers.Vector("normal", x, y);
  }
  return place;
}

// From the actor's box to the point, through the coordinates of its mesh.
glm::dvec3 WayFromBox(vtkActor* actor, const glm::dvec3& point)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(actor->GetMatrix(), inverse);
  double mesh[4] = { point.x, point.y, point.z, 1. };
  inverse->MultiplyPoint(mesh, mesh);
  const double* bounds = actor->GetMapper()->GetBounds();
  for (int i = 0; i < 3; ++i)
  {
    mesh[i] = std::min(std::max(mesh[i], bounds[2 * i]), bounds[2 * i + 1]);
  }
  actor->GetMatrix()->MultiplyPoint(mesh, mesh);
  return point - glm::dvec3(mesh[0], mesh[1], mesh[2]);
}

// The heights of the corners of the actor's box along a direction, and the matrix of the ellipse
// around it as seen along that: twice the sum of the squares of its half edges.
struct Footing
{
  glm::dvec3 Center;
  double Bottom = 0.;
  glm::dmat3 Spread{ 0. };
};

Footing FindFooting(vtkActor* actor, const glm::dvec3& up)
{
  const double* b = actor->GetMapper()->GetBounds();
  const auto at = [actor](double x, double y, double z) {
    double p[4] = { x, y, z, 1. };
    actor->GetMatrix()->MultiplyPoint(p, p);
    return glm::dvec3(p[0], p[1], p[2]);
  };
  const double m[3] = { (b[0] + b[1]) / 2., (b[2] + b[3]) / 2., (b[4] + b[5]) / 2. };
  Footing footing;
  footing.Center = at(m[0], m[1], m[2]);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 p = at(b[corner & 1], b[2 + (corner >> 1 & 1)], b[4 + (corner >> 2)]);
    footing.Bottom = std::max(footing.Bottom, glm::dot(footing.Center - p, up));
  }
  const glm::dvec3 ends[3] = { at(b[1], m[1], m[2]), at(m[0], b[3], m[2]), at(m[0], m[1], b[5]) };
  for (const glm::dvec3& end : ends)
  {
    const glm::dvec3 edge = end - footing.Center;
    const glm::dvec3 level = edge - glm::dot(edge, up) * up;
    footing.Spread += 2. * glm::outerProduct(level, level);
  }
  return footing;
}

double ShadowShare(const Mark& mark, const Place& place, const glm::dvec3& up)
{
  const double facing = place.Normal == glm::dvec3(0.) ? 1. : glm::dot(place.Normal, up);
  Footing footing;
  footing.Center = mark.Center;
  if (mark.Actor)
  {
    footing = FindFooting(mark.Actor, up);
  }
  const glm::dvec3 to = place.Point - footing.Center;
  const double down = -glm::dot(to, up);
  const glm::dvec3 level = to + down * up;
  const double r = mark.Radius;
  double square = glm::dot(level, level) / (r * r);
  double onset = down / (0.25 * r);
  double fade = 1. - down / (mark.Reach * r);
  if (mark.Actor)
  {
    const glm::dmat3& s = footing.Spread;
    const double size = std::sqrt((s[0][0] + s[1][1] + s[2][2]) / 2.) + r;
    const glm::dmat3 level3 = glm::dmat3(1.) - glm::outerProduct(up, up);
    const glm::dmat3 grown =
      s + std::max(r * r, 1e-4 * size * size) * level3 + glm::outerProduct(up, up);
    square = glm::dot(level, glm::inverse(grown) * level);
    const double tolerance = 0.001 * (footing.Bottom + size);
    onset = (down - footing.Bottom + 2. * tolerance) / tolerance;
    fade = 1. - (down - footing.Bottom) / (mark.Reach * size);
  }
  const double soft = std::max(0., 1. - square);
  return soft * soft * glm::clamp(onset, 0., 1.) * glm::clamp(fade, 0., 1.) *
    glm::clamp(4. * facing, 0., 1.);
}

// How much of [from, to] lies in [-radius, radius].
double Overlap(double from, double to, double radius)
{
  return std::max(0., std::min(to, radius) - std::max(from, -radius));
}

// How much of a pixel lies within the radius: along the way, and across it by three chords. `box`
// is the width of the box across the way, `pixel` the area that the pixel shows.
double Cover(double from, double to, double radius, double pixel, double box)
{
  const double length = Overlap(from, to, radius);
  if (!(length > 0.))
  {
    return 0.;
  }
  const double across = pixel / (to - from);
  double sum = 0.;
  for (const int node : { -1, 0, 1 }) // of Gauss and Legendre
  {
    const double at = std::max(from, -radius) + length * (0.5 + node * std::sqrt(0.15));
    const double chord = 2. * std::sqrt(std::max(0., radius * radius - at * at)) + box;
    sum += (node == 0 ? 8. : 5.) / 18. * std::min(1., chord / across);
  }
  return sum * length / (to - from);
}

// The extent of the actor's box across the way, on the plane around the pixel; its diagonal where
// there is no way.
double GetBoxWidth(vtkActor* actor, const Place& place, const glm::dvec3& way)
{
  const double* b = actor->GetMapper()->GetBounds();
  const glm::dvec3 across = glm::cross(glm::cross(place.Along[0], place.Along[1]), way);
  double squares = 0.;
  double width = 0.;
  for (int axis = 0; axis < 3; ++axis)
  {
    double edge[4] = { 0., 0., 0., 0. };
    edge[axis] = b[2 * axis + 1] - b[2 * axis];
    actor->GetMatrix()->MultiplyPoint(edge, edge);
    const glm::dvec3 side(edge[0], edge[1], edge[2]);
    squares += glm::dot(side, side);
    width += std::abs(glm::dot(side, across));
  }
  return way == glm::dvec3(0.) ? std::sqrt(squares) : width / glm::length(across);
}

double Share(const Mark& mark, int shape, const Place& place, const glm::dvec3& up)
{
  if (shape == vtkRelievoMarkers::SHADOW)
  {
    return ShadowShare(mark, place, up);
  }
  const glm::dvec3 way =
    mark.Actor ? WayFromBox(mark.Actor, place.Point) : place.Point - mark.Center;
  const double range = glm::length(way);
  const double steps[2] = { glm::dot(way, place.Along[0]), glm::dot(way, place.Along[1]) };
  const double across =
    (glm::dot(place.Along[0], place.Along[0]) + glm::dot(place.Along[1], place.Along[1])) / 2.;
  // From the middle of the pixel to half a pixel up the slope, twice.
  const double edge = std::sqrt(range * range + std::hypot(steps[0], steps[1]) + across / 4.);
  const double footprint = 2. * (edge - range);
  const double r = mark.Radius;
  if (shape == vtkRelievoMarkers::GLOW)
  {
    const double wider = r * r + footprint * footprint / 4.;
    const double left = std::max(0., 1. - range * range / wider);
    return r * r / wider * left * left;
  }
  const double from = range - footprint / 2.;
  const double to = range + footprint / 2.;
  const double inner = shape == vtkRelievoMarkers::RING ? r * std::max(0., 1. - mark.Width) : 0.;
  const double pixel = glm::length(glm::cross(place.Along[0], place.Along[1]));
  const double box = mark.Actor ? GetBoxWidth(mark.Actor, place, way) : 0.;
  return Cover(from, to, r, pixel, box) - Cover(from, to, inner, pixel, box);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMarkerPoints(const std::vector<Mark>& marks)
{
  return MakePoints(marks, &Mark::Center,
    { { "radius", &Mark::Radius }, { "width", &Mark::Width }, { "reach", &Mark::Reach },
      { "opacity", &Mark::Opacity } },
    &Mark::Color);
}

//------------------------------------------------------------------------------
MarkerScene::MarkerScene(int width, int height, const glm::dvec3& origin)
  : EffectScene(width, height, origin)
  , Stage(this->Frame->GetMarkersStage())
{
  this->Add(MakeBox(6., 0.1, 6.), { 0., -0.05, 0. }, 0.5, 0.55, 0.5);
  this->Ball = this->Add(MakeBall(0.5), { 0., 0.5, 0. }, 0.9, 0.4, 0.2);
  this->Wall = this->Add(MakeBox(3., 2., 0.1), { -0.5, 1., -1.6 }, 0.6, 0.6, 0.7);
  this->Wall->RotateY(30.);
  this->LookFrom({ 0.3, 1.6, 4.5 }, { 0., 0.4, 0. });
  this->Stage->AddPoints(this->Markers);
}

//------------------------------------------------------------------------------
void MarkerScene::Set(int shape, const std::vector<Mark>& marks)
{
  this->Marks = marks;
  this->Markers->SetShape(shape);
  this->Markers->RemoveAllActors();
  std::vector<Mark> points;
  for (Mark& mark : this->Marks)
  {
    mark.Center += this->Origin;
    if (!mark.Actor)
    {
      points.push_back(mark);
      continue;
    }
    this->Markers->AddActor(mark.Actor);
    this->Markers->SetRadius(mark.Radius);
    this->Markers->SetWidth(mark.Width);
    this->Markers->SetReach(mark.Reach);
    this->Markers->SetOpacity(mark.Opacity);
    this->Markers->SetColor(mark.Color.x, mark.Color.y, mark.Color.z);
  }
  this->Markers->SetInputData(MakeMarkerPoints(points));
}

//------------------------------------------------------------------------------
MarkerErrors MarkerScene::Compare()
{
  const int shape = this->Markers->GetShape();
  const bool shadow = shape == vtkRelievoMarkers::SHADOW;
  const EffectPictures pictures = this->Draw(this->Stage);
  std::vector<std::string> names{ "depth", "marker" };
  if (shadow)
  {
    names.emplace_back("normal");
  }
  const Layers layers = this->Read(names);
  vtkRelievoFrameCamera view;
  view.Take(this->Renderer, nullptr);
  const double* given = this->Markers->GetUp();
  const glm::dvec3 up = glm::normalize(glm::dvec3(given[0], given[1], given[2]));
  MarkerErrors errors;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      double passes = 1.;
      glm::dvec3 color(0.);
      if (std::isfinite(layers.Value("depth", x, y)))
      {
        const Place place = FindPlace(view, layers, x, y);
        for (const Mark& mark : this->Marks)
        {
          const double share = mark.Opacity * Share(mark, shape, place, up);
          color = (1. - share) * color + share * (shadow ? glm::dvec3(0.) : mark.Color);
          passes *= 1. - share;
        }
      }
      const double error = std::abs(1. - passes - layers.Value("marker", x, y));
      errors.Covered = error > errors.Covered || std::isnan(error) ? error : errors.Covered;
      errors.Marked += passes < 0.99 ? 1 : 0;
      errors.Edges += passes < 0.99 && passes > 0.25 ? 1 : 0;
      // The picture is to be as the layer says, whatever that is.
      const double covered = layers.Value("marker", x, y);
      const glm::dvec3 own = passes < 1. ? color / (1. - passes)
        : shadow                         ? glm::dvec3(0.)
                                         : this->Marks[0].Color;
      errors.Picture =
        std::max(errors.Picture, pictures.GetError(x, y, 1. - covered, covered * own));
    }
  }
  return errors;
}
}
