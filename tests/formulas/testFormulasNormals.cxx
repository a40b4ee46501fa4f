// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normal formats: float against double and against closed forms, over many directions and those
// where encodings fail: axes, poles, seams, -z, signed zeros, lengths near the ends of float, none.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace testFormulasNormals
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

constexpr double DegreesPerRadian = 57.295779513082320877;

// Closed forms of the largest angle, degrees. Around (1, 1, 1), where the octahedron is nearest to
// the sphere's centre (1 / sqrt(3)), codes in steps of h = 1 / maxCode lie on its face in triangles
// of side sqrt(2) h. Rounding each coordinate is off by sqrt(6) / 2 h there, the nearest corner by
// sqrt(2 / 3) h; times sqrt(3) is the angle. Three components of steps 2 / maxCode are off by half
// a step each, sqrt(3) / maxCode together.
double OctLimit(int bits)
{
  return 3. / std::sqrt(2.) / ((1 << (bits - 1)) - 1) * DegreesPerRadian;
}

double OctPreciseLimit(int bits)
{
  return std::sqrt(2.) / ((1 << (bits - 1)) - 1) * DegreesPerRadian;
}

double BiasedLimit(int bits)
{
  return std::sqrt(3.) / ((1 << bits) - 1) * DegreesPerRadian;
}

// The float formulas' own rounding, degrees.
constexpr double Rounding = 1e-5;

// One packed format in both number types, its code width and the largest angle that it may turn a
// direction by.
struct Format
{
  const char* Name;
  std::uint32_t (*PackFloat)(glm::vec3);
  glm::vec3 (*UnpackFloat)(std::uint32_t);
  std::uint32_t (*PackDouble)(glm::dvec3);
  glm::dvec3 (*UnpackDouble)(std::uint32_t);
  int Bits;
  double MaxDegrees;
};

const Format Formats[] = {
  { "oct 2x8", f32::relievoPackNormalOct8, f32::relievoUnpackNormalOct8, f64::relievoPackNormalOct8,
    f64::relievoUnpackNormalOct8, 8, OctLimit(8) },
  { "oct 2x8 precise", f32::relievoPackNormalOct8Precise, f32::relievoUnpackNormalOct8,
    f64::relievoPackNormalOct8Precise, f64::relievoUnpackNormalOct8, 8, OctPreciseLimit(8) },
  { "oct 2x16", f32::relievoPackNormalOct16, f32::relievoUnpackNormalOct16,
    f64::relievoPackNormalOct16, f64::relievoUnpackNormalOct16, 16, OctLimit(16) },
  { "oct 2x16 precise", f32::relievoPackNormalOct16Precise, f32::relievoUnpackNormalOct16,
    f64::relievoPackNormalOct16Precise, f64::relievoUnpackNormalOct16, 16, OctPreciseLimit(16) },
  { "unorm8", f32::relievoPackNormalUnorm8, f32::relievoUnpackNormalUnorm8,
    f64::relievoPackNormalUnorm8, f64::relievoUnpackNormalUnorm8, 8, BiasedLimit(8) },
  { "unorm10", f32::relievoPackNormalUnorm10, f32::relievoUnpackNormalUnorm10,
    f64::relievoPackNormalUnorm10, f64::relievoUnpackNormalUnorm10, 10, BiasedLimit(10) },
};

bool WithinOneCode(std::uint32_t a, std::uint32_t b, int bits)
{
  const std::int64_t mask = (std::int64_t(1) << bits) - 1;
  bool within = true;
  for (int shift = 0; shift < 32; shift += bits)
  {
    within = within && std::abs(((a >> shift) & mask) - ((b >> shift) & mask)) <= 1;
  }
  return within;
}

void TestErrors(const Format& format, const std::vector<glm::dvec3>& directions)
{
  double worstFloat = 0.;
  double worstDouble = 0.;
  double worstDecode = 0.;
  int differing = 0;
  int apart = 0;
  for (const glm::dvec3& n : directions)
  {
    const std::uint32_t word = format.PackFloat(glm::vec3(n));
    const std::uint32_t truth = format.PackDouble(n);
    const glm::dvec3 decoded = glm::dvec3(format.UnpackFloat(word));
    worstFloat = std::max(worstFloat, Degrees(n, decoded));
    worstDouble = std::max(worstDouble, Degrees(n, format.UnpackDouble(truth)));
    worstDecode = std::max(worstDecode, Degrees(decoded, format.UnpackDouble(word)));
    differing += word != truth ? 1 : 0;
    apart += WithinOneCode(word, truth, format.Bits) ? 0 : 1;
  }
  const std::string name = format.Name;
  RELIEVO_CHECK_AT_MOST(worstFloat, format.MaxDegrees + Rounding, name + ", float, max degrees");
  RELIEVO_CHECK_AT_MOST(worstDouble, format.MaxDegrees + 1e-12, name + ", double, max degrees");
  RELIEVO_CHECK_AT_MOST(worstDecode, 1e-5, name + ", decoded in float and double, max degrees");
  RELIEVO_CHECK_AT_MOST(double(differing) / double(directions.size()), 0.01,
    name + ", share of words that differ between float and double");
  RELIEVO_CHECK_THAT(apart == 0, name + ": float and double words more than a code apart");
}

// For no direction is a precise word worse than the plain one.
void TestPreciseIsBetter(const std::vector<glm::dvec3>& directions)
{
  for (int first : { 0, 2 })
  {
    int worse = 0;
    for (const glm::dvec3& n : directions)
    {
      const Format& plain = Formats[first];
      const Format& precise = Formats[first + 1];
      const glm::vec3 v(n);
      const double a = Degrees(v, plain.UnpackFloat(plain.PackFloat(v)));
      const double b = Degrees(v, precise.UnpackFloat(precise.PackFloat(v)));
      worse += b > a + 1e-5 ? 1 : 0;
    }
    RELIEVO_CHECK_THAT(worse == 0, "a precise word is farther off than the plain one");
  }
}

// Words decode to the encoded direction: every code of 2 x 8 except those of the seam, where two
// words denote one direction.
void TestEveryWord()
{
  int mismatches = 0;
  for (std::uint32_t y = 1; y < 256; ++y)
  {
    for (std::uint32_t x = 1; x < 256; ++x)
    {
      const std::uint32_t word = x | (y << 8);
      const glm::vec3 n = f32::relievoUnpackNormalOct8(word);
      const std::uint32_t plain = f32::relievoPackNormalOct8(n);
      const std::uint32_t precise = f32::relievoPackNormalOct8Precise(n);
      const bool rim = x == 1 || x == 255 || y == 1 || y == 255;
      const glm::vec3 back = f32::relievoUnpackNormalOct8(plain);
      const glm::vec3 backPrecise = f32::relievoUnpackNormalOct8(precise);
      mismatches += (plain == word || rim) && (precise == word || rim) ? 0 : 1;
      mismatches += Degrees(n, back) < 1e-4 && Degrees(n, backPrecise) < 1e-4 ? 0 : 1;
      mismatches += std::abs(glm::length(glm::dvec3(n)) - 1.) < 2e-7 ? 0 : 1;
    }
  }
  RELIEVO_CHECK_THAT(
    mismatches == 0, std::to_string(mismatches) + " words of 2 x 8 do not come back");
}

void TestClosedForms()
{
  const double third = 1. / 3.;
  const struct
  {
    glm::dvec3 N;
    glm::dvec2 E;
  } known[] = {
    { { 0., 0., 1. }, { 0., 0. } },
    { { 0., 0., -1. }, { 1., 1. } },
    { { -0., -0., -1. }, { 1., 1. } },
    { { 1., 0., 0. }, { 1., 0. } },
    { { -1., 0., 0. }, { -1., 0. } },
    { { 0., -1., 0. }, { 0., -1. } },
    { { 1., 1., 1. }, { third, third } },
    { { -1., 1., 1. }, { -third, third } },
    { { 1., 1., -1. }, { 2. * third, 2. * third } },
    { { -1., -1., -1. }, { -2. * third, -2. * third } },
    { { 0., 3., -1. }, { 0.25, 1. } },
    { { 2., 1., 1. }, { 0.5, 0.25 } },
  };
  for (const auto& one : known)
  {
    const glm::dvec2 e = f64::relievoOctEncode(one.N);
    const glm::vec2 s = f32::relievoOctEncode(glm::vec3(one.N));
    RELIEVO_CHECK_NEAR(e.x, one.E.x, 1e-15, "octahedral x");
    RELIEVO_CHECK_NEAR(e.y, one.E.y, 1e-15, "octahedral y");
    RELIEVO_CHECK_NEAR(s.x, one.E.x, 1e-7, "octahedral x in float");
    RELIEVO_CHECK_NEAR(s.y, one.E.y, 1e-7, "octahedral y in float");
    RELIEVO_CHECK(Degrees(one.N, f64::relievoOctDecode(one.E)) < 1e-13);
  }
  // The four corners of the square are the same pole.
  for (double x : { -1., 1. })
  {
    for (double y : { -1., 1. })
    {
      RELIEVO_CHECK(f64::relievoOctDecode(glm::dvec2(x, y)) == glm::dvec3(0., 0., -1.));
    }
  }
  RELIEVO_CHECK(f32::relievoSignNotZero(0.f) == 1.f && f32::relievoSignNotZero(-0.f) == 1.f);
  RELIEVO_CHECK(f32::relievoSignNotZero(-1e-30f) == -1.f);
  // Bit layouts: +x, +y, +z by hand.
  RELIEVO_CHECK(f32::relievoPackNormalUnorm8(glm::vec3(1.f, 0.f, 0.f)) == 0x8080ffu);
  RELIEVO_CHECK(f32::relievoPackNormalUnorm8(glm::vec3(0.f, 0.f, -1.f)) == 0x008080u);
  RELIEVO_CHECK(f32::relievoPackNormalUnorm10(glm::vec3(0.f, 1.f, 0.f)) == 0x200ffe00u);
  RELIEVO_CHECK(f32::relievoPackNormalOct8(glm::vec3(0.f, 0.f, 1.f)) == 0x8080u);
  RELIEVO_CHECK(f32::relievoPackNormalOct16(glm::vec3(1.f, 0.f, 0.f)) == 0x8000ffffu);
  RELIEVO_CHECK(
    f32::relievoPackNormalHalf(glm::vec3(1.f, -1.f, 0.5f)) == glm::uvec2(0xbc003c00u, 0x3800u));
  RELIEVO_CHECK(f32::relievoPackNormalFloat(glm::vec3(1.f, -2.f, 0.f)) ==
    glm::uvec3(0x3f800000u, 0xc0000000u, 0u));
}

// Axes come back bit for bit where a code stands for 0: not in the biased formats.
void TestAxes()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (float sign : { -1.f, 1.f })
    {
      glm::vec3 n(0.f);
      n[axis] = sign;
      for (int i = 0; i < 4; ++i)
      {
        RELIEVO_CHECK(Formats[i].UnpackFloat(Formats[i].PackFloat(n)) == n);
      }
      RELIEVO_CHECK(f32::relievoUnpackNormalHalf(f32::relievoPackNormalHalf(n)) == n);
      RELIEVO_CHECK(f32::relievoUnpackNormalFloat(f32::relievoPackNormalFloat(n)) == n);
    }
  }
}

void TestNoDirection()
{
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const glm::vec3 none[] = { glm::vec3(0.f), glm::vec3(-0.f), glm::vec3(nan, 0.f, 1.f),
    glm::vec3(0.f, 1.f, nan), glm::vec3(nan), glm::vec3(inf, 0.f, 0.f), glm::vec3(0.f, -inf, 1.f),
    glm::vec3(inf, -inf, nan) };
  for (const glm::vec3& n : none)
  {
    RELIEVO_CHECK(!f32::relievoIsDirection(n));
    for (const Format& format : Formats)
    {
      RELIEVO_CHECK_THAT(format.PackFloat(n) == 0u, std::string(format.Name) + " of no direction");
      RELIEVO_CHECK(format.PackDouble(glm::dvec3(n)) == 0u);
      RELIEVO_CHECK(format.UnpackFloat(0u) == glm::vec3(0.f));
      RELIEVO_CHECK(format.UnpackDouble(0u) == glm::dvec3(0.));
    }
    RELIEVO_CHECK(f32::relievoPackNormalHalf(n) == glm::uvec2(0u));
    RELIEVO_CHECK(f32::relievoPackNormalFloat(n) == glm::uvec3(0u));
    RELIEVO_CHECK(f32::relievoUnpackNormalHalf(glm::uvec2(0u)) == glm::vec3(0.f));
  }
  for (const glm::dvec3& n : SpecialDirections())
  {
    for (const Format& format : Formats)
    {
      RELIEVO_CHECK(format.PackFloat(glm::vec3(n)) != 0u);
    }
  }
}

// The octahedral words take any length, the other formats unit vectors.
void TestLengths()
{
  for (const glm::dvec3& n : Directions(2000))
  {
    for (double length : { 1e-30, 1e-6, 1., 1e6, 1e30 })
    {
      const glm::vec3 v(n * length);
      for (int i = 0; i < 4; ++i)
      {
        const Format& format = Formats[i];
        const double angle = Degrees(n, format.UnpackFloat(format.PackFloat(v)));
        RELIEVO_CHECK_THAT(angle <= format.MaxDegrees + Rounding,
          std::string(format.Name) + " of a vector of length " + std::to_string(length));
      }
    }
  }
}

void TestFloats(const std::vector<glm::dvec3>& directions)
{
  double worstHalf = 0.;
  double worstFloat = 0.;
  for (const glm::dvec3& n : directions)
  {
    const glm::vec3 v(n);
    worstHalf =
      std::max(worstHalf, Degrees(n, f32::relievoUnpackNormalHalf(f32::relievoPackNormalHalf(v))));
    worstFloat = std::max(
      worstFloat, Degrees(n, f32::relievoUnpackNormalFloat(f32::relievoPackNormalFloat(v))));
  }
  // Half a step of each component, below 1: 2^-12.
  RELIEVO_CHECK_AT_MOST(worstHalf, std::sqrt(3.) * 0x1p-12 * DegreesPerRadian, "half, max degrees");
  RELIEVO_CHECK_AT_MOST(worstFloat, 4e-6, "float, max degrees");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasNormals)
{
  relievoTest::Session session;
  const std::vector<glm::dvec3> directions = Directions(1000000);
  for (const Format& format : Formats)
  {
    TestErrors(format, directions);
  }
  TestFloats(directions);
  TestPreciseIsBetter(directions);
  TestEveryWord();
  TestClosedForms();
  TestAxes();
  TestNoDirection();
  TestLengths();
  return session.Result();
}
}
