// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tone mapping against its definitions, written out here in double: the curves, white, hue and
// luminance, invalid light, and values rounded by thresholds.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace testFormulasTone
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

double GetLuminance(const glm::dvec3& c)
{
  return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722));
}

// The middle component's place between the smallest and the largest: the same for all of one hue.
double GetMiddlePlace(const glm::dvec3& c)
{
  const double least = std::min({ c.x, c.y, c.z });
  const double most = std::max({ c.x, c.y, c.z });
  const double middle = c.x + c.y + c.z - least - most;
  return (middle - least) / (most - least);
}

std::vector<glm::dvec3> GetLights()
{
  std::vector<glm::dvec3> lights = { glm::dvec3(0.), glm::dvec3(1.), glm::dvec3(4., 0., 0.),
    glm::dvec3(0., 4., 0.), glm::dvec3(0., 0., 60.), glm::dvec3(65504.) };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> stops(-12., 12.);
  for (int i = 0; i < 20000; ++i)
  {
    lights.emplace_back(
      std::exp2(stops(random)), std::exp2(stops(random)), std::exp2(stops(random)));
  }
  for (glm::dvec3& light : lights)
  {
    light = glm::dvec3(glm::vec3(light)); // as float has them
  }
  return lights;
}

void TestCurves()
{
  // By hand: 2 (1 + 2 / 16) / 3 = 0.75; 1 / 2; 0.18 / 1.18.
  RELIEVO_CHECK_NEAR(f64::relievoToneCurve(2., 4.), 0.75, 1e-15, "Reinhard's curve");
  RELIEVO_CHECK_NEAR(f64::relievoToneSimple(glm::dvec3(1.)).y, 0.5, 1e-15, "simple");
  RELIEVO_CHECK_NEAR(f64::relievoToneSimple(glm::dvec3(0.18)).z, 0.18 / 1.18, 1e-15, "simple");
  double apart[2] = { 0., 0. };
  for (const double white : { 0.01, 0.5, 1., 4., 16., 65504. })
  {
    // Exactly, in float as well.
    RELIEVO_CHECK(f64::relievoToneCurve(white, white) == 1.);
    RELIEVO_CHECK(
      f32::relievoToneCurve(static_cast<float>(white), static_cast<float>(white)) == 1.f);
    double last = -1.;
    for (int i = 0; i <= 2000; ++i)
    {
      const double x = white * std::exp2((i - 2000) / 100.);
      const double value = f64::relievoToneCurve(x, white);
      RELIEVO_CHECK(value > last && value <= 1.);
      last = value;
      const double defined = x * (1. + x / (white * white)) / (1. + x);
      apart[0] = std::max(apart[0], std::abs(value / defined - 1.));
      const double rounded =
        f32::relievoToneCurve(static_cast<float>(x), static_cast<float>(white));
      apart[1] = std::max(apart[1], std::abs(rounded / defined - 1.));
    }
  }
  RELIEVO_CHECK_AT_MOST(apart[0], 1e-14, "curve against its definition, double");
  RELIEVO_CHECK_AT_MOST(apart[1], 6e-7, "curve against its definition, float");
}

void TestOperators()
{
  double apart[4] = { 0., 0., 0., 0. };
  double luminance = 0.;
  double hue = 0.;
  for (const glm::dvec3& c : GetLights())
  {
    const double l = GetLuminance(c);
    const double shown = l * (1. + l / 16.) / (1. + l);
    glm::dvec3 expected[4] = { glm::min(c, 1.), c / (1. + c),
      l > 0. ? c * (1. + l / 16.) / (1. + l) : c, glm::min(c * (1. + c / 16.) / (1. + c), 1.) };
    const glm::dvec3 exact = f64::relievoTone(2, c, 4.);
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec3 rounded(f32::relievoTone(i, glm::vec3(c), 4.f));
      const glm::dvec3 want = i == 2 ? exact : expected[i];
      const glm::dvec3 off = glm::abs(rounded - want);
      apart[i] = std::max({ apart[i], off.x, off.y, off.z });
      RELIEVO_CHECK(std::min({ rounded.x, rounded.y, rounded.z }) >= 0.);
      RELIEVO_CHECK(std::max({ rounded.x, rounded.y, rounded.z }) <= 1.);
    }
    // Luminance follows the curve, and the hue is the light's, in range or brought into it.
    luminance = std::max(luminance, std::abs(GetLuminance(exact) - std::min(shown, 1.)));
    if (std::max({ expected[2].x, expected[2].y, expected[2].z }) <= 1.)
    {
      RELIEVO_CHECK(glm::length(exact - expected[2]) <= 1e-14);
    }
    if (l > 0. && shown < 0.99 && GetMiddlePlace(c) >= 0.)
    {
      hue = std::max(hue, std::abs(GetMiddlePlace(exact) - GetMiddlePlace(c)));
    }
  }
  RELIEVO_CHECK_AT_MOST(luminance, 1e-13, "luminance after Reinhard");
  RELIEVO_CHECK_AT_MOST(hue, 1e-10, "hue after Reinhard");
  for (int i = 0; i < 4; ++i)
  {
    // A bright yellow is moved to white by its distance from blue, 1 / 0.0722 of the rounded value.
    const double limit = i == 2 ? std::exp2(-23.) / 0.0722 : 2e-7;
    RELIEVO_CHECK_AT_MOST(apart[i], limit, "operator " + std::to_string(i) + ", float");
  }
  // Black stays black; light as bright as white is white, whatever its colour.
  RELIEVO_CHECK(f64::relievoTone(2, glm::dvec3(0.), 4.) == glm::dvec3(0.));
  RELIEVO_CHECK_NEAR(glm::length(f64::relievoTone(2, glm::dvec3(4.), 4.) - 1.), 0., 1e-15, "white");
  const glm::dvec3 red = f64::relievoTone(2, glm::dvec3(4. / 0.2126, 0., 0.), 4.);
  RELIEVO_CHECK_NEAR(glm::length(red - 1.), 0., 1e-12, "red as bright as white");
  // By hand: red of 4 has the luminance 0.8504; 0.8504 (1 + 0.05315) / 1.8504 = 0.484004; the ratio
  // gives it a red of 2.2766; towards the grey 0.484004 by (1 - 0.484004) / (2.2766 - 0.484004).
  const glm::dvec3 bright = f64::relievoTone(2, glm::dvec3(4., 0., 0.), 4.);
  RELIEVO_CHECK_NEAR(bright.x, 1., 1e-15, "red of 4, red");
  RELIEVO_CHECK_NEAR(bright.y, 0.344686, 1e-5, "red of 4, green");
  RELIEVO_CHECK(bright.y == bright.z);
}

// The inverse that the Khronos Group publishes.
glm::dvec3 GetNeutralInverse(glm::dvec3 c)
{
  const double start = 0.76;
  const double peak = std::max({ c.x, c.y, c.z });
  if (peak > start)
  {
    const double rest = 1. - start;
    const double before = rest * rest / (1. - peak) - rest + start;
    const double kept = 1. / (0.15 * (before - peak) + 1.);
    c = (c + (kept - 1.) * peak) / kept * (before / peak);
  }
  const double least = std::min({ c.x, c.y, c.z });
  const double root = std::sqrt(least / 6.25);
  return c + (least < 0.04 ? root - 6.25 * root * root : 0.04);
}

void TestNeutral()
{
  // By hand: 0.5 - 0.04; 1 - 0.24^2 / (2 - 0.04 + 0.24 - 0.76); 6.25 0.04^2.
  RELIEVO_CHECK_NEAR(f64::relievoTone(4, glm::dvec3(0.5), 4.).x, 0.46, 1e-15, "neutral of 0.5");
  RELIEVO_CHECK_NEAR(f64::relievoTone(4, glm::dvec3(2.), 4.).y, 0.96, 1e-15, "neutral of 2");
  RELIEVO_CHECK_NEAR(f64::relievoTone(4, glm::dvec3(0.04), 4.).z, 0.01, 1e-15, "neutral of 0.04");
  double hue = 0.;
  double inverse = 0.;
  double rounding = 0.;
  for (const glm::dvec3& c : GetLights())
  {
    const glm::dvec3 shown = f64::relievoTone(4, c, 4.);
    const glm::dvec3 off = glm::abs(glm::dvec3(f32::relievoTone(4, glm::vec3(c), 4.F)) - shown);
    rounding = std::max({ rounding, off.x, off.y, off.z });
    const double most = std::max({ c.x, c.y, c.z });
    RELIEVO_CHECK(std::min({ shown.x, shown.y, shown.z }) >= 0.);
    RELIEVO_CHECK(std::max({ shown.x, shown.y, shown.z }) <= 1.);
    if (most < 100. && most > 0.) // beyond, white's neighbours in double become coarse
    {
      const glm::dvec3 again = GetNeutralInverse(shown);
      inverse = std::max(inverse, glm::length(again - c) / most);
      hue = std::max(hue,
        most - std::min({ c.x, c.y, c.z }) < 1e-3 * most
          ? 0.
          : std::abs(GetMiddlePlace(shown) - GetMiddlePlace(c)));
    }
  }
  RELIEVO_CHECK_AT_MOST(inverse, 1e-7, "neutral, inverse");
  RELIEVO_CHECK_AT_MOST(hue, 1e-9, "hue after neutral");
  RELIEVO_CHECK_AT_MOST(rounding, 4e-7, "neutral, float");
}

void TestNoLight()
{
  const float nan = static_cast<float>(NaN);
  const float infinity = static_cast<float>(Infinity);
  const glm::vec3 clean = f32::relievoToneClean(glm::vec3(nan, -1.f, infinity));
  RELIEVO_CHECK(clean == glm::vec3(0.f, 0.f, 65504.f));
  RELIEVO_CHECK(
    f32::relievoToneClean(glm::vec3(-infinity, 0.5f, -0.f)) == glm::vec3(0.f, 0.5f, 0.f));
  for (int i = 0; i < 5; ++i)
  {
    const glm::vec3 shown = f32::relievoTone(i, clean * 1048576.f, 0.01f);
    RELIEVO_CHECK(shown.z <= 1.f && shown.z > 0.99f && shown.x >= 0.f && shown.y >= 0.f);
  }
  for (const double bad : { NaN, Infinity, -Infinity, -1e-3 })
  {
    RELIEVO_CHECK(!f64::relievoToneIsLight(glm::dvec3(bad, 1., 1.)));
    RELIEVO_CHECK(!f64::relievoToneIsLight(glm::dvec3(1., bad, 1.)));
    RELIEVO_CHECK(!f64::relievoToneIsLight(glm::dvec3(1., 1., bad)));
  }
  RELIEVO_CHECK(f64::relievoToneIsLight(glm::dvec3(0., 65504., 1.)));
}

void TestAutoExposure()
{
  for (const double light : { 0.002, 0.18, 1., 90. })
  {
    const double factor =
      f64::relievoToneAutoExposure(f64::relievoToneLogLuminance(glm::dvec3(light)));
    RELIEVO_CHECK_NEAR(factor * light, 0.18, 1e-12, "middle grey");
  }
  // Black is the first step of 8 bits.
  const double least = f64::relievoLinearFromSrgb(1. / 255.);
  RELIEVO_CHECK_NEAR(
    std::exp2(f64::relievoToneLogLuminance(glm::dvec3(0.))), least, 1e-9, "luminance of black");
}

void TestDithering()
{
  std::set<double> thresholds;
  for (std::uint32_t y = 0; y < 8; ++y)
  {
    for (std::uint32_t x = 0; x < 8; ++x)
    {
      thresholds.insert(f64::relievoToneBayer(x, y));
      RELIEVO_CHECK(f64::relievoToneBayer(x, y) == f64::relievoToneBayer(x + 8, y + 64));
    }
  }
  RELIEVO_CHECK(thresholds.size() == 64);
  RELIEVO_CHECK(*thresholds.begin() == 0.5 / 64. && *thresholds.rbegin() == 63.5 / 64.);
  // Bayer's matrix of 2 x 2 by quarters: 0 2 / 3 1.
  const auto quarter = [](std::uint32_t x, std::uint32_t y) {
    return std::floor(4. * f64::relievoToneBayer(x, y));
  };
  RELIEVO_CHECK(
    quarter(0, 0) == 0. && quarter(1, 1) == 1. && quarter(1, 0) == 2. && quarter(0, 1) == 3.);
  double mean = 0.;
  for (int i = 0; i <= 5000; ++i)
  {
    const double value = i / 5000.;
    double sum = 0.;
    for (const double threshold : thresholds)
    {
      const double step = 255. * f64::relievoToneDither(value, threshold);
      RELIEVO_CHECK(std::abs(step - 255. * value) < 1. && std::abs(step - std::round(step)) < 1e-9);
      sum += step;
    }
    mean = std::max(mean, std::abs(sum / 64. - 255. * value));
  }
  RELIEVO_CHECK_AT_MOST(mean, 1. / 128. + 1e-9, "mean of ordered thresholds, steps of 255");
  RELIEVO_CHECK(f64::relievoToneDither(0., 63.5 / 64.) == 0.);
  RELIEVO_CHECK(f64::relievoToneDither(1., 63.5 / 64.) == 1.);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasTone)
{
  relievoTest::Session session;
  TestCurves();
  TestOperators();
  TestNeutral();
  TestNoLight();
  TestAutoExposure();
  TestDithering();
  return session.Result();
}
}
