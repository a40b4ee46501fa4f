// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth formulas: float against double, double against the projection matrix, packed words against
// their closed-form error bounds, far / near from 10 to 1e7, and the background (infinite depth).
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace testFormulasDepth
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

constexpr double Near = 0.5;
const double Ratios[] = { 10., 1e2, 1e3, 1e4, 1e5, 1e6, 1e7 };

// Window z through the matrices of OpenGL's glFrustum and glOrtho.
double MatrixWindowZ(double depth, double zNear, double zFar, bool perspective)
{
  const double size = zFar - zNear;
  const double clipZ = perspective ? ((zFar + zNear) * depth - 2. * zFar * zNear) / size
                                   : (2. * depth - (zFar + zNear)) / size;
  return 0.5 * (perspective ? clipZ / depth : clipZ) + 0.5;
}

// Window z through projection matrices with a clip range from 0 to 1, near and far exchanged.
double MatrixReversedZ(double depth, double zNear, double zFar, bool perspective)
{
  const double size = zFar - zNear;
  return perspective ? (zNear * zFar - zNear * depth) / (size * depth) : (zFar - depth) / size;
}

void TestAgainstMatrices()
{
  for (double ratio : Ratios)
  {
    const double zFar = Near * ratio;
    for (double depth : Depths(2001, Near, zFar))
    {
      const double windowZ = f64::relievoPerspectiveWindowZ(depth, Near, zFar);
      const double reversed = f64::relievoPerspectiveReversedZ(depth, Near, zFar);
      const double parallel = f64::relievoParallelWindowZ(depth, Near, zFar);
      const double parallelReversed = f64::relievoParallelReversedZ(depth, Near, zFar);
      RELIEVO_CHECK_NEAR(windowZ, MatrixWindowZ(depth, Near, zFar, true), 1e-14, "window z");
      RELIEVO_CHECK_NEAR(reversed, MatrixReversedZ(depth, Near, zFar, true), 1e-14, "reversed z");
      RELIEVO_CHECK_NEAR(parallel, MatrixWindowZ(depth, Near, zFar, false), 1e-14, "parallel z");
      RELIEVO_CHECK_NEAR(
        parallelReversed, MatrixReversedZ(depth, Near, zFar, false), 1e-14, "parallel reversed z");
      const double step = 1e-15 * depth;
      RELIEVO_CHECK_NEAR(f64::relievoPerspectiveDepth(windowZ, Near, zFar), depth,
        step * (4. + depth / Near), "depth of window z");
      RELIEVO_CHECK_NEAR(f64::relievoPerspectiveDepthFromReversed(reversed, Near, zFar), depth,
        8. * step, "depth of reversed z");
      RELIEVO_CHECK_NEAR(
        f64::relievoParallelDepth(parallel, Near, zFar), depth, 1e-15 * zFar, "parallel depth");
      RELIEVO_CHECK_NEAR(f64::relievoParallelDepthFromReversed(parallelReversed, Near, zFar), depth,
        1e-15 * zFar, "parallel depth of reversed z");
      const double normalized = f64::relievoNormalizedDepth(depth, Near, zFar);
      RELIEVO_CHECK_NEAR(normalized, (depth - Near) / (zFar - Near), 1e-15, "normalised depth");
      RELIEVO_CHECK_NEAR(
        f64::relievoDepthFromNormalized(normalized, Near, zFar), depth, 1e-15 * zFar, "depth");
    }
  }
}

// In float, reversed z keeps a depth to its last bits at any far / near; window z does not.
void TestFloatAgainstDouble()
{
  for (double ratio : Ratios)
  {
    const float zNear = static_cast<float>(Near);
    const float zFar = static_cast<float>(Near * ratio);
    double reversedError = 0.;
    double windowError = 0.;
    double windowZ = 0.;
    for (double exact : Depths(20001, Near, Near * ratio))
    {
      const float depth = static_cast<float>(exact);
      const float z = f32::relievoPerspectiveWindowZ(depth, zNear, zFar);
      const float r = f32::relievoPerspectiveReversedZ(depth, zNear, zFar);
      const float back = f32::relievoPerspectiveDepthFromReversed(r, zNear, zFar);
      const float lost = f32::relievoPerspectiveDepth(z, zNear, zFar);
      windowZ = std::max(
        windowZ, std::abs(z - f64::relievoPerspectiveWindowZ(double(depth), Near, Near * ratio)));
      reversedError = std::max(reversedError, std::abs(double(back) - depth) / depth);
      windowError = std::max(windowError, std::abs(double(lost) - depth) / depth);
    }
    const std::string at = " at far / near " + std::to_string(static_cast<int>(ratio));
    RELIEVO_CHECK_AT_MOST(windowZ, 3e-7, "window z, float against double" + at);
    RELIEVO_CHECK_AT_MOST(reversedError, 6e-7, "depth through reversed z, relative" + at);
    // Half a step of window z near 1, 2^-25, times depth / near, and the formula's own rounding.
    RELIEVO_CHECK_AT_MOST(windowError, 6e-7 + 0x1p-25 * ratio, "through window z" + at);
    RELIEVO_CHECK(ratio < 1e3 || windowError > reversedError);
  }
}

void TestWords()
{
  for (double ratio : Ratios)
  {
    const float zNear = static_cast<float>(Near);
    const float zFar = static_cast<float>(Near * ratio);
    const float scale = f32::relievoDepth16FScale(zFar);
    RELIEVO_CHECK(zFar * scale <= 65504.f && zFar * scale * 2.f > 65504.f);
    int exponent = 0;
    RELIEVO_CHECK(std::frexp(scale, &exponent) == 0.5f);
    double halfError = 0.;
    double codeError = 0.;
    double alphaError = 0.;
    for (double exact : Depths(20001, Near, Near * ratio))
    {
      const float depth = static_cast<float>(exact);
      RELIEVO_CHECK(f32::relievoUnpackDepth32F(f32::relievoPackDepth32F(depth)) == depth);
      const float half = f32::relievoUnpackDepth16F(f32::relievoPackDepth16F(depth, scale), scale);
      halfError = std::max(halfError, std::abs(double(half) - depth) / depth);
      const float z = f32::relievoPerspectiveWindowZ(depth, zNear, zFar);
      const std::uint32_t code = f32::relievoPackWindowZ24(z);
      RELIEVO_CHECK(code <= 0xffffffu);
      codeError =
        std::max(codeError, std::abs(double(f32::relievoUnpackWindowZ24(code)) - double(z)));
      const std::uint32_t word =
        f32::relievoPackNormalDepth8(glm::vec3(0.f, 0.f, 1.f), depth, zNear, zFar);
      alphaError = std::max(
        alphaError, std::abs(double(f32::relievoUnpackNormalDepth8(word, zNear, zFar).w) - depth));
    }
    // A half has 11 significant bits: half a step is 2^-11 at most, 2^-11 / (1 + 2^-11) of it.
    RELIEVO_CHECK_AT_MOST(halfError, 0x1p-11, "half, relative");
    RELIEVO_CHECK_AT_MOST(codeError, 0.5001 / 16777215. + 3.1e-8, "24-bit window z");
    RELIEVO_CHECK_AT_MOST(alphaError, (zFar - zNear) / 510. * 1.00001, "8-bit depth in alpha");
  }
  // Every code of 24 bits comes back: a step is a float's step near 1.
  for (std::uint32_t code = 0; code <= 0xffffffu; code += code < 0xff0000u ? 251u : 1u)
  {
    if (f32::relievoPackWindowZ24(f32::relievoUnpackWindowZ24(code)) != code)
    {
      Fail(__FILE__, __LINE__, "24-bit code " + std::to_string(code) + " does not come back");
      break;
    }
  }
  RELIEVO_CHECK(f32::relievoPackWindowZ24(1.f) == 0xffffffu);
  RELIEVO_CHECK(f32::relievoPackWindowZ24(0.f) == 0u && f32::relievoPackWindowZ24(-1.f) == 0u);
  RELIEVO_CHECK(f32::relievoPackWindowZ24(0.5f) == 0x800000u);
}

void TestNothingThere()
{
  const float inf = std::numeric_limits<float>::infinity();
  const glm::vec3 none(0.f);
  RELIEVO_CHECK(f32::relievoInfinity() == inf && f64::relievoInfinity() == Infinity);
  RELIEVO_CHECK(f32::relievoPackDepth32F(inf) == f32::relievoDepth32FNone);
  RELIEVO_CHECK(f32::relievoPackDepth16F(inf, 0.25f) == f32::relievoDepth16FNone);
  const float z = f32::relievoPerspectiveWindowZ(inf, 1.f, 100.f);
  const float r = f32::relievoPerspectiveReversedZ(inf, 1.f, 100.f);
  RELIEVO_CHECK(f32::relievoPackWindowZ24(z) == f32::relievoDepth24None);
  RELIEVO_CHECK(f32::relievoPackDepth32F(z) == f32::relievoDepth32FNone);
  RELIEVO_CHECK(f32::relievoPackDepth32F(r) == f32::relievoReversed32FNone);
  RELIEVO_CHECK(f32::relievoParallelWindowZ(inf, 1.f, 100.f) == inf);
  RELIEVO_CHECK(f32::relievoParallelReversedZ(inf, 1.f, 100.f) == -inf);
  RELIEVO_CHECK(f32::relievoUnpackDepth32F(f32::relievoDepth32FNone) == inf);
  RELIEVO_CHECK(f32::relievoUnpackDepth16F(f32::relievoDepth16FNone, 4.f) == inf);
  RELIEVO_CHECK(f32::relievoUnpackWindowZ24(f32::relievoDepth24None) == inf);
  for (float found : { f32::relievoPerspectiveDepth(z, 1.f, 100.f),
         f32::relievoPerspectiveDepthFromReversed(r, 1.f, 100.f),
         f32::relievoParallelDepth(inf, 1.f, 100.f),
         f32::relievoParallelDepthFromReversed(-inf, 1.f, 100.f) })
  {
    RELIEVO_CHECK(found == inf);
  }
  RELIEVO_CHECK(f32::relievoPackNormalDepth8(none, inf, 1.f, 9.f) == f32::relievoNormalDepth8None);
  RELIEVO_CHECK(f32::relievoPackNormalDepth16F(none, inf, 1.f) == f32::relievoNormalDepth16FNone);
  RELIEVO_CHECK(f32::relievoPackNormalDepth32F(none, inf) == f32::relievoNormalDepth32FNone);
  const glm::vec4 nothing(0.f, 0.f, 0.f, inf);
  RELIEVO_CHECK(f32::relievoUnpackNormalDepth8(f32::relievoNormalDepth8None, 1.f, 9.f) == nothing);
  RELIEVO_CHECK(f32::relievoUnpackNormalDepth16F(f32::relievoNormalDepth16FNone, 1.f) == nothing);
  RELIEVO_CHECK(f32::relievoUnpackNormalDepth32F(f32::relievoNormalDepth32FNone) == nothing);

  // Surfaces never read as background: without a normal on the far plane, and beyond half.
  const std::uint32_t word = f32::relievoPackNormalDepth8(none, 9.f, 1.f, 9.f);
  const glm::vec4 drawn = f32::relievoUnpackNormalDepth8(word, 1.f, 9.f);
  RELIEVO_CHECK(drawn.x == 0.f && drawn.y == 0.f && drawn.z == 0.f);
  RELIEVO_CHECK_NEAR(drawn.w, 9. - 8. / 255., 1e-5, "far plane without a normal");
  RELIEVO_CHECK(f32::relievoUnpackDepth16F(f32::relievoPackDepth16F(1e6f, 1.f), 1.f) == 65504.f);
  RELIEVO_CHECK(f32::relievoUnpackDepth16F(f32::relievoPackDepth16F(65519.f, 1.f), 1.f) == 65504.f);
}

void TestNormalDepth()
{
  const glm::vec3 n(0.6f, -0.48f, 0.64f);
  const glm::vec4 a =
    f32::relievoUnpackNormalDepth8(f32::relievoPackNormalDepth8(n, 3.f, 1.f, 9.f), 1.f, 9.f);
  RELIEVO_CHECK(Degrees(n, glm::vec3(a)) < 0.3892);
  RELIEVO_CHECK_NEAR(a.w, 3., 4. / 255., "depth of RGBA8");
  const glm::vec4 b =
    f32::relievoUnpackNormalDepth16F(f32::relievoPackNormalDepth16F(n, 3.f, 1.f), 1.f);
  RELIEVO_CHECK(Degrees(n, glm::vec3(b)) < 0.0228 && b.w == 3.f);
  const glm::vec4 c = f32::relievoUnpackNormalDepth32F(f32::relievoPackNormalDepth32F(n, 3.1f));
  RELIEVO_CHECK(glm::vec3(c) == n && c.w == 3.1f);
}

// An infinite far plane, as some projections have.
void TestInfiniteFar()
{
  for (double depth : { 1., 2., 1e3, 1e9 })
  {
    const double z = f64::relievoPerspectiveWindowZ(depth, 1., Infinity);
    const double r = f64::relievoPerspectiveReversedZ(depth, 1., Infinity);
    RELIEVO_CHECK_NEAR(z, 1. - 1. / depth, 1e-15, "window z, infinite far plane");
    RELIEVO_CHECK_NEAR(r, 1. / depth, 1e-16, "reversed z, infinite far plane");
    const double back = f64::relievoPerspectiveDepthFromReversed(r, 1., Infinity);
    RELIEVO_CHECK_NEAR(back, depth, 1e-15 * depth, "depth, infinite far plane");
  }
}

// Halves: every one comes back, and floats between two round to the nearer, ties to the even one.
void TestHalves()
{
  using namespace relievo::bits;
  int mismatches = 0;
  for (std::uint32_t half = 0; half < 0x7c00u; ++half)
  {
    const float low = FromHalf(half);
    mismatches += ToHalf(low) == half && ToHalf(-low) == (half | 0x8000u) ? 0 : 1;
    if (half == 0x7bffu)
    {
      break;
    }
    const float high = FromHalf(half + 1);
    const float middle = 0.5f * (low + high);
    const std::uint32_t even = half & 1u ? half + 1 : half;
    mismatches += low < high && ToHalf(middle) == even ? 0 : 1;
    mismatches += ToHalf(std::nextafter(middle, low)) == half ? 0 : 1;
    mismatches += ToHalf(std::nextafter(middle, high)) == half + 1 ? 0 : 1;
  }
  RELIEVO_CHECK_THAT(mismatches == 0, std::to_string(mismatches) + " halves round wrongly");
  RELIEVO_CHECK(FromHalf(0x3c00u) == 1.f && FromHalf(0x7bffu) == 65504.f);
  RELIEVO_CHECK(FromHalf(1u) == 0x1p-24f && FromHalf(0x8001u) == -0x1p-24f);
  RELIEVO_CHECK(ToHalf(65520.f) == 0x7c00u && ToHalf(-1e30f) == 0xfc00u);
  RELIEVO_CHECK(std::isnan(FromHalf(ToHalf(std::numeric_limits<float>::quiet_NaN()))));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasDepth)
{
  relievoTest::Session session;
  TestHalves();
  TestAgainstMatrices();
  TestFloatAgainstDouble();
  TestWords();
  TestNothingThere();
  TestNormalDepth();
  TestInfiniteFar();
  return session.Result();
}
}
