// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reference scenes are as documented, and VTK's drawing agrees with their truth.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "ImageCompare.h"
#include "Scenes.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace testScenes
{
namespace
{
using relievoTest::PixelTruth;
using relievoTest::TruthImage;
using relievoTest::View;

const int Size = 600;

void TestPlacing(const std::string& name, const relievoTest::ReferenceScene& scene)
{
  double b[6];
  // Only points used by polygons count: cells have bounds, stray points do not.
  scene.Mesh->GetCellsBounds(b);
  const double longest = std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] });
  std::cout << name << ": " << scene.Mesh->GetNumberOfPolys() << " cells, " << b[1] - b[0] << " x "
            << b[3] - b[2] << " x " << b[5] - b[4] << "\n";
  RELIEVO_CHECK_NEAR(longest, 2., 1e-6, name + ": longest side");
  RELIEVO_CHECK_NEAR(b[2], 0., 1e-6, name + ": lowest point");
  RELIEVO_CHECK_NEAR(b[0] + b[1], 0., 1e-6, name + ": centred on x");
  RELIEVO_CHECK_NEAR(b[4] + b[5], 0., 1e-6, name + ": centred on z");
  scene.Ground->GetBounds(b);
  RELIEVO_CHECK(b[0] == -3. && b[1] == 3. && b[2] == 0. && b[3] == 0. && b[4] == -3. && b[5] == 3.);
  const double* range = scene.Renderer->GetActiveCamera()->GetClippingRange();
  RELIEVO_CHECK(range[0] == 2. && range[1] == 14.);
  RELIEVO_CHECK(scene.Renderer->GetActiveCamera()->GetViewAngle() == 30.);
  RELIEVO_CHECK(scene.MeshActor->GetProperty()->GetInterpolation() == VTK_FLAT);
}

/*
 * VTK's own depth buffer and pure colours against the truth. The depth buffer rounds to 24 bits (or
 * finer), so the limit for z is that rounding: z^2 (far - near) / (near far) / 2^24, twice.
 */
void TestAgainstDrawn(const std::string& name, const relievoTest::ReferenceScene& scene,
  vtkRenderWindow* window, const TruthImage& truth)
{
  for (vtkActor* actor : { scene.MeshActor.Get(), scene.GroundActor.Get() })
  {
    actor->GetProperty()->LightingOff();
  }
  scene.MeshActor->GetProperty()->SetColor(1., 0., 0.);
  scene.GroundActor->GetProperty()->SetColor(0., 1., 0.);
  scene.Renderer->SetBackground(0., 0., 0.);
  const auto picture = relievoTest::Picture(window);
  vtkNew<vtkFloatArray> buffer;
  window->GetZbufferData(0, 0, Size - 1, Size - 1, buffer);
  const double near = 2.;
  const double far = 14.;
  long long other = 0;
  long long otherInner = 0;
  double worst = 0.;
  std::vector<double> errors;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      const auto* rgb = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      const int drawn = rgb[0] > 127 ? 0 : (rgb[1] > 127 ? 1 : -1);
      if (drawn != pixel.Actor)
      {
        ++other;
        otherInner += pixel.Inner ? 1 : 0;
        continue;
      }
      if (!pixel.Inner || pixel.EdgeDistance < 0.01)
      {
        continue;
      }
      const double window01 = buffer->GetValue(y * Size + x);
      const double depth = near * far / (far - window01 * (far - near));
      const double rounding = depth * depth * (far - near) / (near * far) / std::pow(2., 24.) * 2.;
      worst = std::max(worst, std::abs(depth - pixel.Depth) / rounding);
      errors.push_back(std::abs(depth / pixel.Depth - 1.));
    }
  }
  std::sort(errors.begin(), errors.end());
  std::cout << name << ": " << truth.NumberOfHits() << " pixels hit, " << truth.NumberOfInner()
            << " inner, " << errors.size() << " compared, " << other << " show another actor ("
            << otherInner << " of them inner); relative depth error of VTK's buffer: median "
            << errors[errors.size() / 2] << ", p99 " << errors[errors.size() * 99 / 100] << ", max "
            << errors.back() << "\n";
  RELIEVO_CHECK(errors.size() > 0.5 * truth.NumberOfHits());
  RELIEVO_CHECK(otherInner == 0);
  RELIEVO_CHECK_AT_MOST(
    static_cast<double>(other) / (Size * Size), 0.001, name + ": share of another actor");
  RELIEVO_CHECK_AT_MOST(errors[errors.size() * 99 / 100], 2e-6, name + ": depth, p99");
  RELIEVO_CHECK_AT_MOST(worst, 10., name + ": depth in units of the buffer's rounding");
}

// Share of dark pixels among those that face the light, against earlier measurements.
void TestShadowShare(const std::string& name, const relievoTest::EmbreeScene& scene,
  const TruthImage& truth, bool sun, double expected)
{
  const glm::dvec3 light(3., 5., 2.);
  long long counted = 0;
  long long dark = 0;
  long long unstable = 0;
  for (const PixelTruth& pixel : truth.Pixels)
  {
    const glm::dvec3 way = sun ? light : light - pixel.Position;
    if (!pixel.Hit || glm::dot(pixel.Normal, glm::normalize(way)) <= 0.05)
    {
      continue;
    }
    const auto verdict =
      scene.Shadow(pixel, way, sun ? std::numeric_limits<double>::infinity() : 1., 1e-4);
    ++counted;
    unstable += verdict.Stable ? 0 : 1;
    dark += verdict.Occluded ? 1 : 0;
  }
  const double share = 100. * dark / counted;
  std::cout << name << (sun ? ", sun: " : ", spot: ") << share << " % dark, "
            << 100. * unstable / counted << " % unstable\n";
  RELIEVO_CHECK_NEAR(share, expected, 0.1, name + ": share of dark pixels, percent");
}

struct Expected
{
  const char* Name;
  double DarkBySun;
  double DarkBySpot;
};

void TestScene(const Expected& expected)
{
  const std::string name = expected.Name;
  const relievoTest::ReferenceScene scene = relievoTest::MakeReferenceScene(name);
  if (!RELIEVO_CHECK(scene.IsValid()))
  {
    return;
  }
  TestPlacing(name, scene);
  const auto window = relievoTest::MakeWindow(Size, Size, scene.Renderer);
  relievoTest::GLCheck gl(window);
  relievoTest::WriteImage(
    relievoTest::OutputFolder() + "/" + name + ".png", relievoTest::Picture(window));
  const auto scenery = scene.MakeTruth();
  const TruthImage truth = scenery->Trace(View(scene.Renderer));
  TestAgainstDrawn(name, scene, window, truth);
  if (expected.DarkBySun > 0.)
  {
    TestShadowShare(name, *scenery, truth, true, expected.DarkBySun);
    TestShadowShare(name, *scenery, truth, false, expected.DarkBySpot);
  }
}

void TestMistakes()
{
  RELIEVO_CHECK(relievoTest::FailuresOf([] {
    RELIEVO_CHECK(!relievoTest::MakeReferenceScene("teapot").IsValid());
  }) == 1);
  RELIEVO_CHECK(relievoTest::ReferenceMeshes().size() == 3);
  RELIEVO_CHECK(relievoTest::OtherMeshes().size() == 2);
  const auto spot =
    relievoTest::MakeReferenceScene(relievoTest::MakeGround(1.), relievoTest::SceneLight::Spot);
  RELIEVO_CHECK(spot.Light->GetPositional() && spot.Light->GetConeAngle() == 60.);
  const auto point =
    relievoTest::MakeReferenceScene(relievoTest::MakeGround(1.), relievoTest::SceneLight::Point);
  RELIEVO_CHECK(point.Light->GetPositional() && point.Light->GetConeAngle() >= 90.);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testScenes)
{
  relievoTest::Session session;
  // The shares of the design, measured before this code was written.
  for (const Expected& expected : { Expected{ "bunny", 4.9, 9.9 },
         Expected{ "motorBike", 7.9, 8.9 }, Expected{ "buildings", 1.6, 1.9 },
         Expected{ "armadillo", 0., 0. }, Expected{ "elephant", 0., 0. } })
  {
    TestScene(expected);
  }
  TestMistakes();
  return session.Result();
}
}
