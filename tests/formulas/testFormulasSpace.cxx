// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Eye and world positions from a pixel and its depth: back to where they were projected from, for
// both projections, off-centre and sheared windows; float against double; window transforms.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace testFormulasSpace
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

constexpr double Near = 0.5;
constexpr double Far = 500.;
const glm::dvec2 Size(1920., 1081.);

// glFrustum and glOrtho of a window from (left, bottom) to (right, top).
glm::dmat4 Frustum(double left, double right, double bottom, double top)
{
  glm::dmat4 p(0.);
  p[0][0] = 2. * Near / (right - left);
  p[1][1] = 2. * Near / (top - bottom);
  p[2][0] = (right + left) / (right - left);
  p[2][1] = (top + bottom) / (top - bottom);
  p[2][2] = -(Far + Near) / (Far - Near);
  p[2][3] = -1.;
  p[3][2] = -2. * Far * Near / (Far - Near);
  return p;
}

glm::dmat4 Ortho(double left, double right, double bottom, double top)
{
  glm::dmat4 p(1.);
  p[0][0] = 2. / (right - left);
  p[1][1] = 2. / (top - bottom);
  p[2][2] = -2. / (Far - Near);
  p[3][0] = -(right + left) / (right - left);
  p[3][1] = -(top + bottom) / (top - bottom);
  p[3][2] = -(Far + Near) / (Far - Near);
  return p;
}

// x and y moved with z, as in an oblique projection.
glm::dmat4 Shear()
{
  glm::dmat4 s(1.);
  s[2][0] = 0.35;
  s[2][1] = -0.2;
  s[3][0] = 1.5;
  s[1][0] = 0.1;
  return s;
}

struct View
{
  const char* Name;
  glm::dmat4 Projection;
  bool Perspective;
  bool Sheared;
};

std::vector<View> Views()
{
  return {
    { "perspective", Frustum(-0.3, 0.3, -0.2, 0.2), true, false },
    { "off-centre perspective", Frustum(-0.1, 0.5, -0.35, 0.05), true, false },
    { "window beside the axis", Frustum(0.4, 0.9, 0.2, 0.5), true, false },
    { "parallel", Ortho(-30., 30., -20., 20.), false, false },
    { "off-centre parallel", Ortho(-10., 50., -35., 5.), false, false },
    { "sheared perspective", Frustum(-0.1, 0.5, -0.35, 0.05) * Shear(), true, true },
    { "sheared parallel", Ortho(-10., 50., -35., 5.) * Shear(), false, true },
  };
}

template <typename Vec3, typename Vec2, typename Mat>
Vec3 ByEntries(const View& view, const Vec2& ndc, typename Vec3::value_type depth, const Mat& p);

template <>
glm::dvec3 ByEntries(const View& view, const glm::dvec2& ndc, double depth, const glm::dmat4& p)
{
  return view.Perspective
    ? f64::relievoPerspectiveEyePosition(ndc, depth, p[0][0], p[1][1], p[2][0], p[2][1])
    : f64::relievoParallelEyePosition(ndc, depth, p[0][0], p[1][1], p[3][0], p[3][1]);
}

template <>
glm::vec3 ByEntries(const View& view, const glm::vec2& ndc, float depth, const glm::mat4& p)
{
  return view.Perspective
    ? f32::relievoPerspectiveEyePosition(ndc, depth, p[0][0], p[1][1], p[2][0], p[2][1])
    : f32::relievoParallelEyePosition(ndc, depth, p[0][0], p[1][1], p[3][0], p[3][1]);
}

// Pixels between a pixel's centre and the place where a reconstructed position falls.
double PixelError(const View& view, const glm::dvec3& eye, const glm::dvec2& pixel)
{
  const glm::dvec3 ndc = f64::relievoNdcFromClip(view.Projection * glm::dvec4(eye, 1.));
  const glm::dvec3 window = f64::relievoWindowFromNdc(ndc, glm::dvec4(0., 0., Size.x, Size.y));
  return glm::length(glm::dvec2(window.x, window.y) - (pixel + 0.5));
}

void TestView(const View& view)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> column(0, static_cast<int>(Size.x) - 1);
  std::uniform_int_distribution<int> row(0, static_cast<int>(Size.y) - 1);
  const glm::mat4 projection(view.Projection);
  double exact = 0.;
  double rounded = 0.;
  double apart = 0.;
  for (double depth : Depths(20000, Near, Far))
  {
    const glm::dvec2 pixel(column(random), row(random));
    const glm::dvec2 ndc = f64::relievoNdcFromPixel(pixel, Size);
    const glm::dvec3 eye = f64::relievoEyePosition(ndc, depth, view.Projection);
    exact = std::max(exact, PixelError(view, eye, pixel));
    RELIEVO_CHECK(f64::relievoDepthFromEyePosition(eye) == depth);
    const glm::vec2 ndcFloat = f32::relievoNdcFromPixel(glm::vec2(pixel), glm::vec2(Size));
    const float depthFloat = static_cast<float>(depth);
    const glm::vec3 eyeFloat = f32::relievoEyePosition(ndcFloat, depthFloat, projection);
    rounded = std::max(rounded, PixelError(view, eyeFloat, pixel));
    if (!view.Sheared)
    {
      const glm::dvec3 entries = ByEntries<glm::dvec3>(view, ndc, depth, view.Projection);
      const glm::vec3 entriesFloat = ByEntries<glm::vec3>(view, ndcFloat, depthFloat, projection);
      apart = std::max(apart, glm::length(entries - eye) / depth);
      rounded = std::max(rounded, PixelError(view, entriesFloat, pixel));
    }
  }
  const std::string name = view.Name;
  RELIEVO_CHECK_AT_MOST(exact, 1e-9, name + ", double, pixels");
  RELIEVO_CHECK_AT_MOST(rounded, 0.002, name + ", float, pixels");
  RELIEVO_CHECK_AT_MOST(apart, 1e-12, name + ", two formulas, relative");
}

void TestWorld()
{
  // A camera far from the origin, turned about z then x.
  const double c = 0.8;
  const double s = 0.6;
  const glm::dmat4 cameraToWorld(
    c, s, 0., 0., -s * c, c * c, s, 0., s * s, -s * c, c, 0., 5e5, 5e6, 12.5, 1.);
  const glm::dvec3 world = f64::relievoWorldPosition(glm::dvec3(1., 2., -3.), cameraToWorld);
  RELIEVO_CHECK_NEAR(world.x, 5e5 + c - 2. * s * c - 3. * s * s, 1e-9, "world x");
  RELIEVO_CHECK_NEAR(world.y, 5e6 + s + 2. * c * c + 3. * s * c, 2e-9, "world y");
  RELIEVO_CHECK_NEAR(world.z, 12.5 + 2. * s - 3. * c, 1e-14, "world z");
}

void TestRange()
{
  const double range = f64::relievoRange(glm::dvec3(2., 3., -6.));
  RELIEVO_CHECK_NEAR(range, 7., 1e-15, "range of an eye position");
  const glm::dvec2 ndc(0.3, -0.7);
  const glm::dvec3 direction = f64::relievoEyeDirection(ndc, 1.5, 2.5, 0.1, 0.2);
  const glm::dvec3 eye = f64::relievoPerspectiveEyePosition(ndc, 40., 1.5, 2.5, 0.1, 0.2);
  RELIEVO_CHECK_NEAR(direction.z, -1., 0., "direction at depth 1");
  RELIEVO_CHECK_NEAR(f64::relievoRangeFromDepth(40., direction), f64::relievoRange(eye), 1e-13,
    "range from depth and direction");
  const glm::dvec3 onAxis = f64::relievoEyeDirection(glm::dvec2(0.), 1.5, 2.5, 0., 0.);
  RELIEVO_CHECK(f64::relievoRangeFromDepth(40., onAxis) == 40.);
  RELIEVO_CHECK(f64::relievoRangeFromDepth(Infinity, direction) == Infinity);
}

void TestWindow()
{
  const glm::dvec4 viewport(30., 50., 640., 480.);
  const glm::dvec3 corner = f64::relievoWindowFromNdc(glm::dvec3(-1., -1., -1.), viewport);
  const glm::dvec3 opposite = f64::relievoWindowFromNdc(glm::dvec3(1., 1., 1.), viewport);
  RELIEVO_CHECK(corner == glm::dvec3(30., 50., 0.));
  RELIEVO_CHECK(opposite == glm::dvec3(670., 530., 1.));
  RELIEVO_CHECK(f64::relievoNdcFromClip(glm::dvec4(2., -4., 6., 2.)) == glm::dvec3(1., -2., 3.));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 ndc(uniform(random), uniform(random), uniform(random));
    const glm::dvec3 back =
      f64::relievoNdcFromWindow(f64::relievoWindowFromNdc(ndc, viewport), viewport);
    RELIEVO_CHECK_NEAR(glm::length(back - ndc), 0., 1e-14, "NDC through the window");
  }
  // Pixel centres are the window coordinates half a pixel in, and lie symmetrically.
  for (int i = 0; i < 640; ++i)
  {
    const double x = f64::relievoNdcFromPixel(glm::dvec2(i, 0.), glm::dvec2(640., 480.)).x;
    RELIEVO_CHECK(x == f64::relievoNdcFromWindow(glm::dvec3(30.5 + i, 50.5, 0.), viewport).x);
    RELIEVO_CHECK(x == -f64::relievoNdcFromPixel(glm::dvec2(639 - i, 0.), glm::dvec2(640.)).x);
  }
  RELIEVO_CHECK(f64::relievoNdcFromPixel(glm::dvec2(0.), glm::dvec2(1.)) == glm::dvec2(0.));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasSpace)
{
  relievoTest::Session session;
  for (const View& view : Views())
  {
    TestView(view);
  }
  TestWorld();
  TestRange();
  TestWindow();
  return session.Result();
}
}
