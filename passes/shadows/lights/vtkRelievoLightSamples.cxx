// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLightSamples.h"

#include "vtkMath.h"
#include "vtkRelievoShadowLight.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
const double GoldenAngle = vtkMath::Pi() * (3.0 - std::sqrt(5.0));

// The fractional parts of its multiples are far apart, and not aligned with the golden angle.
constexpr double Spread = 0.5698402909980532;      // of the root of x^3 = x + 1, to the power of -2
constexpr double OtherSpread = 0.6180339887498949; // the golden ratio's

// Closer to a spot than this number of radii, the rim of its cone may be lit wrongly.
constexpr double RadiiOff = 8.0;

// A permutation of the samples, in the order of these multiples, starting from one of them.
std::vector<int> GetOrder(int samples, double spread, int first = 0)
{
  std::vector<int> order(static_cast<std::size_t>(samples));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [spread, first](int i) {
    const double multiple = (i - first) * spread;
    return multiple - std::floor(multiple);
  };
  std::stable_sort(order.begin(), order.end(), [&key](int a, int b) { return key(a) < key(b); });
  return order;
}

// The radius sin t of the disc with this share of a glowing ball: t - sin t cos t = share * pi / 2.
double GetBallRadius(double share)
{
  double low = 0.0;
  double high = 0.5 * vtkMath::Pi();
  for (int i = 0; i < 50; ++i)
  {
    const double t = 0.5 * (low + high);
    (t - std::sin(t) * std::cos(t) < share * 0.5 * vtkMath::Pi() ? low : high) = t;
  }
  return std::sin(low);
}
}

//------------------------------------------------------------------------------
glm::dvec2 vtkRelievoLightSamples::OnDisc(int sample, int samples)
{
  const int i = GetOrder(samples, Spread)[static_cast<std::size_t>(sample)];
  const double r = i == 0 ? 0.0 : std::sqrt((i + 0.5) / samples);
  return r * glm::dvec2(std::cos(i * GoldenAngle), std::sin(i * GoldenAngle));
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoLightSamples::InBall(int sample, int samples)
{
  // Directions of a spiral from pole to pole; the radii are distributed over them.
  const int i = GetOrder(samples, OtherSpread)[static_cast<std::size_t>(sample)];
  const std::vector<int> order = GetOrder(samples, Spread);
  const auto rank = std::find(order.begin(), order.end(), i) - order.begin();
  const double r = rank == 0 ? 0.0 : GetBallRadius((static_cast<double>(rank) + 0.5) / samples);
  const double z = 1.0 - 2.0 * (i + 0.5) / samples;
  const double s = std::sqrt(1.0 - z * z);
  return r * glm::dvec3(s * std::cos(i * GoldenAngle), s * std::sin(i * GoldenAngle), z);
}

//------------------------------------------------------------------------------
glm::dvec2 vtkRelievoLightSamples::OnSquare(int sample, int samples)
{
  const int middle = samples / 2;
  const int i = GetOrder(samples, OtherSpread, middle)[static_cast<std::size_t>(sample)];
  const double y = (i - middle) * Spread + 0.5;
  return glm::dvec2(2.0 * (i + 0.5) / samples - 1.0, 2.0 * (y - std::floor(y)) - 1.0);
}

//------------------------------------------------------------------------------
vtkRelievoLightSizes::Shape& vtkRelievoLightSizes::GetShape(vtkLight* light)
{
  auto& shapes = this->Shapes;
  shapes.erase(
    std::remove_if(shapes.begin(), shapes.end(), [](const Shape& shape) { return !shape.Light; }),
    shapes.end());
  for (Shape& shape : shapes)
  {
    if (shape.Light == light)
    {
      return shape;
    }
  }
  shapes.emplace_back();
  shapes.back().Light = light;
  return shapes.back();
}

//------------------------------------------------------------------------------
const vtkRelievoLightSizes::Shape* vtkRelievoLightSizes::Find(vtkLight* light) const
{
  const auto found = std::find_if(this->Shapes.begin(), this->Shapes.end(),
    [light](const Shape& shape) { return shape.Light == light; });
  return found == this->Shapes.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void vtkRelievoLightSizes::Set(vtkLight* light, double size)
{
  this->GetShape(light).Size = size;
}

//------------------------------------------------------------------------------
double vtkRelievoLightSizes::Get(vtkLight* light) const
{
  const Shape* shape = this->Find(light);
  return shape && shape->Size >= 0.0 ? shape->Size
    : light->GetPositional()         ? this->LampRadius
                                     : this->SunAngle;
}

//------------------------------------------------------------------------------
void vtkRelievoLightSizes::SetEdges(
  vtkLight* light, const glm::dvec3& first, const glm::dvec3& second)
{
  Shape& shape = this->GetShape(light);
  shape.Edges[0] = first;
  shape.Edges[1] = second;
}

//------------------------------------------------------------------------------
bool vtkRelievoLightSizes::IsSized(vtkLight* light) const
{
  const Shape* shape = this->Find(light);
  return (shape && shape->IsFlat() && light->GetPositional()) || this->Get(light) > 0.0;
}

//------------------------------------------------------------------------------
void vtkRelievoLightSizes::Move(vtkRelievoShadowLight& light, int sample, int samples) const
{
  using namespace vtkRelievoLightSamples;
  const Shape* shape = this->Find(light.Light);
  const double size = this->Get(light.Light);
  const glm::dvec3 right = vtkRelievoShadowLight::AnySquareTo(light.Direction);
  const glm::dvec3 up = glm::cross(light.Direction, right);
  glm::dvec3 offset(0.0);
  if (!light.Positional)
  {
    // Uniform over the solid angle of the sun's cone.
    const glm::dvec2 place = OnDisc(sample, samples);
    const double r = glm::length(place);
    const double half = std::sin(0.25 * vtkMath::RadiansFromDegrees(size));
    const double off = 2.0 * half * half * r * r; // 1 - cosine
    const double sine = 2.0 * half * std::sqrt(1.0 - half * half * r * r);
    light.Direction =
      glm::normalize((1.0 - off) * light.Direction + sine * (place.x * right + place.y * up));
    return;
  }
  if (shape && shape->IsFlat())
  {
    const glm::dvec2 place = OnSquare(sample, samples);
    offset = 0.5 * (place.x * shape->Edges[0] + place.y * shape->Edges[1]);
  }
  else if (light.IsSpot())
  {
    const glm::dvec2 place = size * OnDisc(sample, samples);
    offset = place.x * right + place.y * up;
  }
  else
  {
    offset = size * InBall(sample, samples);
  }
  light.Position += offset;
  if (light.IsSpot())
  {
    // The cone of the light itself, which does not move, is within that of its map.
    const double tangent = std::tan(vtkMath::RadiansFromDegrees(light.ConeAngle));
    light.ConeAngle = vtkMath::DegreesFromRadians(std::atan(tangent + 1.0 / RadiiOff));
  }
}
