// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sRGB curve against its definition, the colours of ids, the colour map of debug views, and
// layers over one another.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <unordered_set>

namespace testFormulasColor
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

void TestSrgb()
{
  const double known[][2] = { { 0., 0. }, { 1., 1. }, { 0.001, 0.01292 },
    { 0.18, 0.46135612950044164 }, { 0.5, 0.7353569830524495 }, { 4., 1.8247962952761159 } };
  for (const auto& pair : known)
  {
    RELIEVO_CHECK_NEAR(f64::relievoSrgbFromLinear(pair[0]), pair[1], 1e-12, "to sRGB");
    RELIEVO_CHECK_NEAR(f64::relievoLinearFromSrgb(pair[1]), pair[0], 1e-12, "from sRGB");
  }
  // The two parts meet, as well as the standard's rounded constants let them.
  const double below = f64::relievoSrgbFromLinear(0.0031308);
  const double above = f64::relievoSrgbFromLinear(std::nextafter(0.0031308, 1.));
  RELIEVO_CHECK_NEAR(above, below, 3e-8, "joint of the curve");
  double apart = 0.;
  double back = 0.;
  float last = -1.f;
  for (int i = 0; i <= 100000; ++i)
  {
    const double linear = i / 100000.;
    const float srgb = f32::relievoSrgbFromLinear(static_cast<float>(linear));
    RELIEVO_CHECK(srgb > last);
    last = srgb;
    apart = std::max(apart, std::abs(srgb - f64::relievoSrgbFromLinear(linear)));
    back = std::max(
      back, std::abs(f64::relievoLinearFromSrgb(f64::relievoSrgbFromLinear(linear)) - linear));
  }
  RELIEVO_CHECK_AT_MOST(apart, 3e-7, "to sRGB, float against double");
  RELIEVO_CHECK_AT_MOST(back, 1e-8, "to sRGB and back, double");
  for (int code = 0; code < 256; ++code)
  {
    const float linear = f32::relievoLinearFromSrgb(static_cast<float>(code) / 255.f);
    const float again = f32::relievoSrgbFromLinear(linear) * 255.f;
    RELIEVO_CHECK_NEAR(again, code, 1e-3, "8-bit sRGB code");
  }
  // By roots: over the light of all halves.
  double fromShown = 0.;
  double shown = 0.;
  for (int i = 0; i <= 100000; ++i)
  {
    const double value = 107.2 * std::pow(i / 100000., 3.);
    const double linear = f64::relievoLinearFromSrgb(value);
    const double off = f32::relievoApproximateLinearFromSrgb(static_cast<float>(value)) - linear;
    fromShown = std::max(fromShown, std::abs(off) / std::max(linear, 1e-3));
    for (const double most : { 1., 65536. })
    {
      const double light = most * std::pow(i / 100000., 3.);
      const double srgb = f64::relievoSrgbFromLinear(light);
      const double error = f32::relievoApproximateSrgbFromLinear(static_cast<float>(light)) - srgb;
      shown = std::max(shown, std::abs(error) / std::max(srgb, 1.));
    }
  }
  RELIEVO_CHECK_AT_MOST(fromShown, 2.5e-6, "from approximate sRGB, relative");
  RELIEVO_CHECK_AT_MOST(shown, 1.2e-6, "to approximate sRGB, relative above 1");
  RELIEVO_CHECK(f64::relievoLinearFromSrgb(107.2) > 65504.);
  const float most = f32::relievoApproximateSrgbFromLinear(65536.f);
  RELIEVO_CHECK(
    f32::relievoApproximateSrgbFromLinear(std::numeric_limits<float>::infinity()) == most);
  const float none = std::numeric_limits<float>::quiet_NaN();
  RELIEVO_CHECK(std::isnan(f32::relievoApproximateSrgbFromLinear(none)));
  RELIEVO_CHECK(std::isnan(f32::relievoApproximateLinearFromSrgb(none)));
  RELIEVO_CHECK(f32::relievoApproximateSrgbFromLinear(-1.f) < 0.f &&
    f32::relievoApproximateLinearFromSrgb(-1.f) < 0.f);
  const glm::dvec3 color = f64::relievoSrgbColorFromLinear(glm::dvec3(0., 0.18, 1.));
  RELIEVO_CHECK(color.x == 0. && color.y == f64::relievoSrgbFromLinear(0.18));
  RELIEVO_CHECK_NEAR(color.z, 1., 1e-15, "white");
  const glm::dvec3 linear = f64::relievoLinearColorFromSrgb(color);
  RELIEVO_CHECK_NEAR(linear.y, 0.18, 1e-15, "colour from sRGB");
}

void TestHashColor()
{
  std::unordered_set<std::uint32_t> hashes;
  int dark = 0;
  int alike = 0;
  glm::vec3 last(0.f);
  constexpr std::uint32_t Count = 1u << 18;
  for (std::uint32_t id = 0; id < Count; ++id)
  {
    hashes.insert(f32::relievoHash(id));
    const glm::vec3 color = f32::relievoHashColor(id);
    const float most = std::max({ color.x, color.y, color.z });
    const float least = std::min({ color.x, color.y, color.z });
    RELIEVO_CHECK(least >= 0.f && most <= 1.f);
    dark += most < 0.699f ? 1 : 0;
    alike += glm::length(color - last) < 0.05f ? 1 : 0;
    last = color;
  }
  RELIEVO_CHECK_THAT(hashes.size() == Count, "ids share a hash");
  RELIEVO_CHECK(dark == 0);
  RELIEVO_CHECK_AT_MOST(double(alike) / Count, 0.01, "share of neighbours with like colours");
  RELIEVO_CHECK(f32::relievoHashColor(0xffffffffu) == glm::vec3(0.f));
  const glm::dvec3 exact = f64::relievoHashColor(12345u);
  RELIEVO_CHECK(glm::length(exact - glm::dvec3(f32::relievoHashColor(12345u))) < 1e-6);
}

// Relative luminance of a display colour.
double Luminance(const glm::dvec3& display)
{
  return glm::dot(f64::relievoLinearColorFromSrgb(display), glm::dvec3(0.2126, 0.7152, 0.0722));
}

void TestColormap()
{
  // Viridis at quarters.
  const double known[][4] = { { 0., 68.1, 1.2, 84. }, { 0.25, 58.7, 81.9, 139.1 },
    { 0.5, 32.7, 144.1, 140.5 }, { 0.75, 92.5, 200.6, 98.6 }, { 1., 253.3, 231.1, 36.7 } };
  for (const auto& entry : known)
  {
    const glm::dvec3 color = 255. * f64::relievoColormap(entry[0]);
    RELIEVO_CHECK_NEAR(color.x, entry[1], 3., "red");
    RELIEVO_CHECK_NEAR(color.y, entry[2], 3., "green");
    RELIEVO_CHECK_NEAR(color.z, entry[3], 3., "blue");
  }
  double last = -1.;
  for (int i = 0; i <= 1000; ++i)
  {
    const double luminance = Luminance(f64::relievoColormap(i / 1000.));
    RELIEVO_CHECK(luminance > last);
    last = luminance;
    const glm::dvec3 rounded(f32::relievoColormap(static_cast<float>(i / 1000.)));
    RELIEVO_CHECK(glm::length(rounded - f64::relievoColormap(i / 1000.)) < 1e-5);
  }
  RELIEVO_CHECK(f64::relievoColormap(-3.) == f64::relievoColormap(0.));
  RELIEVO_CHECK(f64::relievoColormap(Infinity) == f64::relievoColormap(1.));
  RELIEVO_CHECK(f64::relievoColormap(NaN) == glm::dvec3(0.));
}

// Layers over one another: by transmittance; in any grouping; in linear light like a single layer's
// colour, and never brighter than by its own light.
void TestLayers()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0., 1.);
  const auto layer = [&]() {
    const double a = share(random);
    return glm::dvec4(a * share(random), a * share(random), a * share(random), a);
  };
  double apart = 0.;
  for (int i = 0; i < 10000; ++i)
  {
    const glm::dvec4 a = layer();
    const glm::dvec4 b = layer();
    const glm::dvec4 c = layer();
    const glm::dvec4 all = f64::relievoOver(f64::relievoOver(a, b), c);
    apart = std::max(apart, glm::length(all - f64::relievoOver(a, f64::relievoOver(b, c))));
    RELIEVO_CHECK_NEAR(1. - all.w, (1. - a.w) * (1. - b.w) * (1. - c.w), 1e-14, "let through");
    const glm::dvec4 linear = f64::relievoLinearLayerFromSrgb(a, i % 2 != 0);
    RELIEVO_CHECK_NEAR(
      linear.y, a.w * f64::relievoLinearFromSrgb(a.y / a.w), 1e-14, "linear layer");
    RELIEVO_CHECK(linear.w == a.w);
    const float cover = f32::relievoAveragedCover(static_cast<float>(-a.w * a.w));
    RELIEVO_CHECK_NEAR(cover, 1. - a.w, 1e-6, "cover by alpha");
  }
  RELIEVO_CHECK_AT_MOST(apart, 1e-15, "another grouping");
  for (const bool shines : { false, true })
  {
    RELIEVO_CHECK(f64::relievoLinearLayerFromSrgb(glm::dvec4(0.), shines) == glm::dvec4(0.));
  }
  // Brighter than white under a cover: the curve goes on.
  const glm::dvec4 bright(2., 1., 0.2, 0.5);
  RELIEVO_CHECK_NEAR(f64::relievoLinearLayerFromSrgb(bright, false).x,
    0.5 * std::pow((4. + 0.055) / 1.055, 2.4), 1e-12, "bright");
  // Light that covers little or nothing: as bright as it shines.
  for (const double a : { 0., 1e-4, 0.1, 0.3 })
  {
    const glm::dvec4 shines = f64::relievoLinearLayerFromSrgb(glm::dvec4(0.3, 0.15, 0., a), true);
    RELIEVO_CHECK_NEAR(shines.x, 0.3, 1e-15, "shines");
    RELIEVO_CHECK(shines.y < 0.15 && shines.z == 0. && shines.w == a);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasColor)
{
  relievoTest::Session session;
  TestSrgb();
  TestHashColor();
  TestColormap();
  TestLayers();
  return session.Result();
}
}
