// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticScene.h"

#include <algorithm>
#include <cmath>

namespace relievoTest
{
namespace
{
double Evaluate(const double* c, int degree, double t)
{
  double value = c[degree];
  for (int i = degree - 1; i >= 0; --i)
  {
    value = value * t + c[i];
  }
  return value;
}

// The root in [a, b], where the polynomial has opposite signs at the ends.
double Bisect(const double* c, int degree, double a, double b)
{
  const bool rising = Evaluate(c, degree, a) < 0.;
  for (;;)
  {
    const double middle = a + 0.5 * (b - a);
    if (middle <= a || middle >= b)
    {
      return middle;
    }
    ((Evaluate(c, degree, middle) < 0.) == rising ? a : b) = middle;
  }
}

int Roots(const double* c, int degree, double tMin, double tMax, double* roots)
{
  if (degree == 0)
  {
    return 0;
  }
  double derivative[4];
  for (int i = 0; i < degree; ++i)
  {
    derivative[i] = (i + 1) * c[i + 1];
  }
  double ends[6];
  ends[0] = tMin;
  const int turns = Roots(derivative, degree - 1, tMin, tMax, ends + 1);
  ends[turns + 1] = tMax;
  int count = 0;
  for (int i = 0; i <= turns; ++i)
  {
    const double a = Evaluate(c, degree, ends[i]);
    const double b = Evaluate(c, degree, ends[i + 1]);
    if ((a < 0.) != (b < 0.))
    {
      roots[count++] = Bisect(c, degree, ends[i], ends[i + 1]);
    }
  }
  return count;
}

// Where a line enters and leaves a ball about the origin; false if it misses.
bool CastBall(const Ray& ray, double radius, double& enter, double& leave)
{
  const double a = glm::dot(ray.Direction, ray.Direction);
  const double closest = -glm::dot(ray.Origin, ray.Direction) / a;
  // From the closest point: no cancellation, even for a distant eye.
  const glm::dvec3 foot = ray.At(closest);
  const double left = radius * radius - glm::dot(foot, foot);
  if (left < 0.)
  {
    return false;
  }
  const double half = std::sqrt(left / a);
  enter = closest - half;
  leave = closest + half;
  return true;
}

// Takes the first of two crossings within the range.
bool First(double enter, double leave, double tMin, double tMax, double& t)
{
  t = enter >= tMin ? enter : leave;
  return t >= tMin && t <= tMax;
}

bool CastBox(
  const Ray& ray, const glm::dvec3& half, double tMin, double tMax, double& t, glm::dvec3& normal)
{
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  int enterAxis = 0;
  int leaveAxis = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double along = ray.Direction[axis];
    if (along == 0.)
    {
      if (std::abs(ray.Origin[axis]) > half[axis])
      {
        return false;
      }
      continue;
    }
    const double side = along > 0. ? half[axis] : -half[axis];
    const double in = (-side - ray.Origin[axis]) / along;
    const double out = (side - ray.Origin[axis]) / along;
    enterAxis = in > enter ? axis : enterAxis;
    enter = std::max(enter, in);
    leaveAxis = out < leave ? axis : leaveAxis;
    leave = std::min(leave, out);
  }
  if (enter > leave || !First(enter, leave, tMin, tMax, t))
  {
    return false;
  }
  normal = glm::dvec3(0.);
  const bool entering = enter >= tMin;
  const int axis = entering ? enterAxis : leaveAxis;
  normal[axis] = (ray.Direction[axis] > 0.) == entering ? -1. : 1.;
  return true;
}

bool CastTorus(
  const Ray& ray, double ring, double tube, double tMin, double tMax, double& t, glm::dvec3& normal)
{
  double enter = 0.;
  double leave = 0.;
  if (!CastBall(ray, ring + tube, enter, leave))
  {
    return false;
  }
  const double first = std::max(tMin, enter);
  const double last = std::min(tMax, leave);
  if (first > last)
  {
    return false;
  }
  // Measured from the middle of the chord in units of the ball, so that the coefficients of
  // (x.x + ring^2 - tube^2)^2 = 4 ring^2 (x^2 + y^2) are of one size.
  const double middle = 0.5 * (enter + leave);
  const double unit = 1. / glm::length(ray.Direction);
  const glm::dvec3 o = ray.At(middle) / (ring + tube);
  const glm::dvec3 d = ray.Direction * unit;
  const double r = ring / (ring + tube);
  const double q = tube / (ring + tube);
  const double od = glm::dot(o, d);
  const double k = glm::dot(o, o) + r * r - q * q;
  const double f = 4. * r * r;
  const double c[5] = { k * k - f * (o.x * o.x + o.y * o.y),
    4. * k * od - 2. * f * (o.x * d.x + o.y * d.y),
    4. * od * od + 2. * k - f * (d.x * d.x + d.y * d.y), 4. * od, 1. };
  const double scale = unit * (ring + tube);
  double roots[4];
  const int count = QuarticRoots(c, (first - middle) / scale, (last - middle) / scale, roots);
  if (count == 0)
  {
    return false;
  }
  t = middle + scale * roots[0];
  // Newton on the distance to the tube, which is better conditioned than the quartic.
  for (int step = 0; step < 3; ++step)
  {
    const glm::dvec3 p = ray.At(t);
    const double across = std::hypot(p.x, p.y);
    const glm::dvec3 center = ring / across * glm::dvec3(p.x, p.y, 0.);
    normal = glm::normalize(p - center);
    const double slope = glm::dot(normal, ray.Direction);
    const double move = (glm::length(p - center) - tube) / slope;
    if (!(std::abs(move) < 1e-6 * scale))
    {
      break; // grazing: keeps the result of bisection
    }
    t -= move;
  }
  return t >= tMin && t <= tMax;
}
}

//------------------------------------------------------------------------------
int QuarticRoots(const double c[5], double tMin, double tMax, double roots[4])
{
  return Roots(c, 4, tMin, tMax, roots);
}

//------------------------------------------------------------------------------
int AnalyticScene::Add(Kind what, const glm::dvec3& size, const glm::dmat4& place)
{
  this->Shapes.push_back(Shape{ what, size, place, glm::inverse(place) });
  return static_cast<int>(this->Shapes.size()) - 1;
}

//------------------------------------------------------------------------------
int AnalyticScene::AddPlane(double halfX, double halfY, const glm::dmat4& place)
{
  return this->Add(Kind::Plane, glm::dvec3(halfX, halfY, 0.), place);
}

//------------------------------------------------------------------------------
int AnalyticScene::AddSphere(double radius, const glm::dmat4& place)
{
  return this->Add(Kind::Sphere, glm::dvec3(radius), place);
}

//------------------------------------------------------------------------------
int AnalyticScene::AddBox(const glm::dvec3& half, const glm::dmat4& place)
{
  return this->Add(Kind::Box, half, place);
}

//------------------------------------------------------------------------------
int AnalyticScene::AddTorus(double ring, double tube, const glm::dmat4& place)
{
  return this->Add(Kind::Torus, glm::dvec3(ring, tube, 0.), place);
}

//------------------------------------------------------------------------------
bool AnalyticScene::CastShape(
  const Shape& shape, const Ray& local, double tMin, double tMax, double& t, glm::dvec3& normal)
{
  switch (shape.What)
  {
    case Kind::Plane:
    {
      t = -local.Origin.z / local.Direction.z;
      const glm::dvec3 p = local.At(t);
      normal = glm::dvec3(0., 0., 1.);
      // Written so that NaN, from a ray in the plane, gives false.
      return t >= tMin && t <= tMax && std::abs(p.x) <= shape.Size.x &&
        std::abs(p.y) <= shape.Size.y;
    }
    case Kind::Sphere:
    {
      double enter = 0.;
      double leave = 0.;
      if (!CastBall(local, shape.Size.x, enter, leave) || !First(enter, leave, tMin, tMax, t))
      {
        return false;
      }
      normal = local.At(t);
      return true;
    }
    case Kind::Box:
      return CastBox(local, shape.Size, tMin, tMax, t, normal);
    case Kind::Torus:
      return CastTorus(local, shape.Size.x, shape.Size.y, tMin, tMax, t, normal);
  }
  return false;
}

//------------------------------------------------------------------------------
SurfacePoint AnalyticScene::Cast(const Ray& ray, double tMin, double tMax) const
{
  SurfacePoint point;
  for (size_t i = 0; i < this->Shapes.size(); ++i)
  {
    const Shape& shape = this->Shapes[i];
    // An affine map keeps the parameter t.
    const Ray local{ glm::dvec3(shape.ToLocal * glm::dvec4(ray.Origin, 1.)),
      glm::dvec3(shape.ToLocal * glm::dvec4(ray.Direction, 0.)) };
    double t = 0.;
    glm::dvec3 normal;
    if (!CastShape(shape, local, tMin, tMax, t, normal) || t >= point.Depth)
    {
      continue;
    }
    normal = glm::normalize(glm::transpose(glm::dmat3(shape.ToLocal)) * normal);
    point.Hit = true;
    point.Depth = t;
    point.Position = ray.At(t);
    point.FrontFacing = glm::dot(normal, ray.Direction) < 0.;
    point.Normal = point.FrontFacing ? normal : -normal;
    point.Actor = static_cast<int>(i);
  }
  return point;
}

//------------------------------------------------------------------------------
bool AnalyticScene::Occluded(const Ray& ray, double tMin, double tMax) const
{
  return this->Cast(ray, tMin, tMax).Hit;
}

//------------------------------------------------------------------------------
TruthImage AnalyticScene::Trace(const View& view) const
{
  return TraceView(
    view, [this](const Ray& ray, double tMin, double tMax) { return this->Cast(ray, tMin, tMax); });
}

//------------------------------------------------------------------------------
glm::dmat4 AnalyticScene::ToMatrix(const double* rowMajor)
{
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix[column][row] = rowMajor[4 * row + column];
    }
  }
  return matrix;
}
}
