// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simplex noise: its mean and range, no jumps, also where lattice cells meet; other seeds give
// other noise; the same values in float and double, near the origin and half a thousand million
// cells away; and no repetition after the periods that other noises have.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

namespace testFormulasNoise
{
namespace
{
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

constexpr int Samples = 200000;

struct Points
{
  std::mt19937 Random{ 3 };
  std::uniform_real_distribution<double> Part{ 0., 1. };
  std::uniform_int_distribution<int> Cell{ -1000, 1000 };

  glm::ivec3 NextCell()
  {
    const int x = this->Cell(this->Random);
    const int y = this->Cell(this->Random);
    return glm::ivec3(x, y, this->Cell(this->Random));
  }
  // A float in [0, 1), so that float and double mean the same.
  double NextPart() { return std::floor(16777216. * this->Part(this->Random)) / 16777216.; }
  glm::dvec3 NextParts()
  {
    const double x = this->NextPart();
    const double y = this->NextPart();
    return glm::dvec3(x, y, this->NextPart());
  }
};

double NoiseAt(const glm::dvec3& place, unsigned int seed)
{
  const glm::dvec3 cell = glm::floor(place);
  return f64::relievoSimplexNoise(glm::ivec3(cell), place - cell, seed);
}

void TestValues()
{
  Points points;
  double sum = 0.;
  double squares = 0.;
  double product = 0.;
  double largest = 0.;
  double rounding = 0.;
  double far = 0.;
  for (int i = 0; i < Samples; ++i)
  {
    const glm::ivec3 cell = points.NextCell();
    const glm::dvec3 part = points.NextParts();
    const double value = f64::relievoSimplexNoise(cell, part, 5u);
    sum += value;
    squares += value * value;
    product += value * f64::relievoSimplexNoise(cell, part, 6u);
    largest = std::max(largest, std::abs(value));
    rounding =
      std::max(rounding, std::abs(value - f32::relievoSimplexNoise(cell, glm::vec3(part), 5u)));
    const glm::ivec3 away = cell * 500000;
    far = std::max(far,
      std::abs(f64::relievoSimplexNoise(away, part, 5u) -
        f32::relievoSimplexNoise(away, glm::vec3(part), 5u)));
  }
  RELIEVO_CHECK_AT_MOST(largest, 1., "largest value");
  RELIEVO_CHECK_AT_MOST(-largest, -0.9, "largest value, negative");
  RELIEVO_CHECK_NEAR(sum / Samples, 0., 0.005, "mean");
  // Correlation of two seeds, of 200,000 independent values: its standard error is 0.0022.
  RELIEVO_CHECK_NEAR(product / squares, 0., 0.01, "correlation of two seeds");
  RELIEVO_CHECK_AT_MOST(rounding, 5e-6, "float against double");
  RELIEVO_CHECK_AT_MOST(far, 5e-6, "float against double, far away");
}

// Steps of 2e-7 of a cell over the places where it could jump: coordinates that are whole, or equal
// but for whole cells.
void TestJumps()
{
  Points points;
  double steepest = 0.;
  for (int i = 0; i < Samples; ++i)
  {
    glm::dvec3 place = glm::dvec3(points.NextCell()) + points.NextParts();
    if (i & 1)
    {
      place.y = place.x + (points.Cell(points.Random) % 4);
    }
    if (i & 2)
    {
      place.z = place.y + (points.Cell(points.Random) % 3);
    }
    if (i & 4)
    {
      place.x = std::floor(place.x);
    }
    if (i & 8)
    {
      // Where the coordinates add up to a multiple of three, lattice cells meet at their ends.
      place.z = std::round(place.x + place.y) - place.x - place.y;
    }
    const glm::dvec3 step = 1e-7 * glm::normalize(points.NextParts() - 0.5);
    steepest =
      std::max(steepest, std::abs(NoiseAt(place + step, 9u) - NoiseAt(place - step, 9u)) / 2e-7);
  }
  RELIEVO_CHECK_AT_MOST(steepest, 7., "steepest slope");
}

// The farthest cells, whose coordinates' sum is more than an int holds: there, too, the lattice is
// that of its neighbours, so that nothing jumps.
void TestFarthest()
{
  Points points;
  constexpr int Far = 1 << 29;
  double steepest = 0.;
  for (int i = 0; i < Samples / 10; ++i)
  {
    glm::ivec3 cell(Far - 2, Far - 2, Far - 2);
    cell *= (i & 1) ? -1 : 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 before = cell;
      before[axis] -= 1;
      glm::dvec3 part = points.NextParts();
      part[axis] = 0.;
      const double there = f64::relievoSimplexNoise(cell, part, 9u);
      part[axis] = 1. - 1e-7;
      steepest =
        std::max(steepest, std::abs(there - f64::relievoSimplexNoise(before, part, 9u)) / 1e-7);
    }
  }
  RELIEVO_CHECK_AT_MOST(steepest, 7., "steepest slope between the farthest cells");
}

// The gradient against differences of the noise.
void TestGradient()
{
  Points points;
  double worst = 0.;
  double rounding = 0.;
  for (int i = 0; i < Samples / 10; ++i)
  {
    const glm::ivec3 cell = points.NextCell();
    const glm::dvec3 part = points.NextParts();
    const glm::dvec3 gradient =
      f64::relievoSimplexNoiseGradientIn(f64::relievoSimplexAt(cell, part), 4u);
    glm::dvec3 difference;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 step(0.);
      step[axis] = 1e-6;
      const glm::dvec3 place = glm::dvec3(cell) + part;
      difference[axis] = (NoiseAt(place + step, 4u) - NoiseAt(place - step, 4u)) / 2e-6;
    }
    worst = std::max(worst, glm::length(gradient - difference));
    rounding = std::max(rounding,
      glm::length(gradient -
        glm::dvec3(
          f32::relievoSimplexNoiseGradientIn(f32::relievoSimplexAt(cell, glm::vec3(part)), 4u))));
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-5, "gradient against differences");
  RELIEVO_CHECK_AT_MOST(rounding, 5e-5, "gradient in float against double");
}

// B of relievoSimplexNoiseSlope's comment, where r^2 is `square`. It falls to 1/10, rises to 1/6
// and falls from there on, so over an interval it is largest at an end or at 1/6.
double LongestGradient(double square)
{
  const double t = std::max(0.5 - square, 0.);
  return t * t * t * std::max(t, 9. * square - 0.5);
}

double LongestGradient(double low, double high)
{
  const double ends = std::max(LongestGradient(low), LongestGradient(high));
  return low < 1. / 6. && high > 1. / 6. ? std::max(ends, 1. / 27.) : ends;
}

// Whether the sum over the simplex's corners is at most `limit` all over a tetrahedron.
bool IsBelow(
  const std::array<glm::dvec3, 4>& simplex, std::array<glm::dvec3, 4> part, double limit, int depth)
{
  glm::dvec3 middle = 0.25 * (part[0] + part[1] + part[2] + part[3]);
  double radius = 0.;
  for (const glm::dvec3& corner : part)
  {
    radius = std::max(radius, glm::length(corner - middle));
  }
  double sum = 0.;
  for (const glm::dvec3& corner : simplex)
  {
    const double away = glm::length(corner - middle);
    const double near = std::max(away - radius, 0.);
    sum += LongestGradient(near * near, (away + radius) * (away + radius));
  }
  if (sum <= limit || depth == 0)
  {
    return sum <= limit;
  }
  // Halved at its longest edge.
  int a = 0;
  int b = 1;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      if (glm::length(part[i] - part[j]) > glm::length(part[a] - part[b]))
      {
        a = i;
        b = j;
      }
    }
  }
  middle = 0.5 * (part[a] + part[b]);
  std::array<glm::dvec3, 4> other = part;
  part[a] = middle;
  other[b] = middle;
  return IsBelow(simplex, part, limit, depth - 1) && IsBelow(simplex, other, limit, depth - 1);
}

// The proof of the steepest slope, for one simplex: the others are its mirror images.
void TestSlope()
{
  const std::array<glm::dvec3, 4> simplex = { glm::dvec3(0.), glm::dvec3(5., -1., -1.) / 6.,
    glm::dvec3(2., 2., -1.) / 3., glm::dvec3(0.5) };
  const double limit = f64::relievoSimplexNoiseSlope / (76. * std::sqrt(2.));
  RELIEVO_CHECK_AT_MOST(limit, 0.0726, "sum of the longest gradients");
  RELIEVO_CHECK(IsBelow(simplex, simplex, limit, 60));
  // The bound has not much room: half way between two corners it is nearly reached.
  RELIEVO_CHECK(!IsBelow(simplex, simplex, 0.0724, 60));
}

void TestPeriods()
{
  Points points;
  for (const int period : { 256, 289, 4096, 65536, 1 << 20, 1 << 24, 1 << 27 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      int equal = 0;
      for (int i = 0; i < 200; ++i)
      {
        const glm::ivec3 cell = points.NextCell();
        const glm::dvec3 part = points.NextParts();
        glm::ivec3 shifted = cell;
        shifted[axis] += period;
        equal +=
          f64::relievoSimplexNoise(cell, part, 1u) == f64::relievoSimplexNoise(shifted, part, 1u);
      }
      RELIEVO_CHECK_THAT(equal < 10, "repeats after " + std::to_string(period) + " cells");
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasNoise)
{
  relievoTest::Session session;
  TestValues();
  TestJumps();
  TestFarthest();
  TestGradient();
  TestSlope();
  TestPeriods();
  return session.Result();
}
}
