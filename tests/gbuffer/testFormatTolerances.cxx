// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Formats by tolerance: values read are within it of the full floats, and no smaller format would
// be.
#include "Check.h"
#include "EmbreeScene.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace testFormatTolerances
{
namespace
{
using relievoTest::Layers;
using G = vtkRelievoLayersStage;

struct Errors
{
  double Normal = 0.; // degrees
  double Depth = 0.;  // of the depth
};

Errors Compare(const Layers& a, const Layers& exact)
{
  Errors errors;
  for (int y = 0; y < exact.Height; ++y)
  {
    for (int x = 0; x < exact.Width; ++x)
    {
      const double depth = exact.Value("depth", x, y);
      if (std::isfinite(depth))
      {
        const glm::dvec3 n = glm::normalize(exact.Vector("normal", x, y));
        const glm::dvec3 m = glm::normalize(a.Vector("normal", x, y));
        errors.Normal = std::max(
          errors.Normal, glm::degrees(std::atan2(glm::length(glm::cross(n, m)), glm::dot(n, m))));
        errors.Depth = std::max(errors.Depth, std::abs(a.Value("depth", x, y) - depth) / depth);
      }
    }
  }
  return errors;
}

void TestTolerances()
{
  relievoTest::Stage stage(160, 120);
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(1.4));
  const std::vector<std::string> names = { "normal", "depth" };
  const Layers exact(stage.Renderer, names, relievoTest::Way::Own, [](G* gbuffer) {
    gbuffer->SetNormalFormat(G::NORMAL_FLOAT32);
    gbuffer->SetRefineDepth(false);
  });
  RELIEVO_CHECK(exact.Covered() > 3000);
  // The full floats are those of the mesh.
  relievoTest::EmbreeScene mesh;
  mesh.AddActors(stage.Renderer);
  const relievoTest::TruthImage truth = mesh.Trace(relievoTest::View(stage.Renderer));
  double off = 0.;
  long long compared = 0;
  for (int y = 0; y < exact.Height; ++y)
  {
    for (int x = 0; x < exact.Width; ++x)
    {
      const relievoTest::PixelTruth& pixel = truth.At(x, y);
      if (pixel.Inner)
      {
        ++compared;
        off = std::max(off, std::abs(exact.Value("depth", x, y) / pixel.Depth - 1.));
      }
    }
  }
  RELIEVO_CHECK(compared > 2000);
  RELIEVO_CHECK_AT_MOST(off, 1e-5, "full floats");
  double before = 0.; // the error of the next smaller format
  for (const double tolerance : { 2., 0.7, 0.5, 0.2, 0.01, 0.003, 1e-4 })
  {
    const Layers layers(stage.Renderer, names, relievoTest::Way::Own, [tolerance](G* gbuffer) {
      gbuffer->SetNormalTolerance(tolerance);
      gbuffer->SetDepthTolerance(1e-3 * tolerance);
      gbuffer->SetRefineDepth(false);
      gbuffer->SetNormalDepthFormat(G::NORMAL_DEPTH_RGBA8); // void with a tolerance
    });
    const Errors errors = Compare(layers, exact);
    const std::string what = "tolerance " + std::to_string(tolerance);
    std::cout << what << ": " << errors.Normal << " degrees, " << errors.Depth << "\n";
    RELIEVO_CHECK_AT_MOST(errors.Normal, tolerance, what);
    RELIEVO_CHECK_AT_MOST(errors.Depth, 1e-3 * tolerance, what);
    // The smaller format is taken as long as it may be: this ball has nearly all directions.
    RELIEVO_CHECK_THAT(before == 0. || before > 0.5 * tolerance, what + ": a smaller one would do");
    before = errors.Normal;
  }
}

void TestChoices()
{
  relievoTest::Stage stage(40, 30);
  G* gbuffer = vtkRelievoPass::Attach(stage.Renderer)->GetLayersStage();
  gbuffer->SetDepthFormat(G::DEPTH_REVERSED_32F);
  RELIEVO_CHECK(gbuffer->GetNormalFormatUsed() == G::NORMAL_AUTO);
  RELIEVO_CHECK(gbuffer->GetDepthFormatUsed() == G::DEPTH_REVERSED_32F);
  gbuffer->SetNormalTolerance(1.);
  gbuffer->SetDepthTolerance(0.01);
  RELIEVO_CHECK(gbuffer->GetNormalFormatUsed() == G::NORMAL_OCT8);
  RELIEVO_CHECK(gbuffer->GetDepthFormatUsed() == G::DEPTH_16F);
  gbuffer->SetDepthTolerance(1e-4);
  RELIEVO_CHECK(gbuffer->GetDepthFormatUsed() == G::DEPTH_32F);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  {
    const relievoTest::ExpectMessage expected("SetNormalTolerance was given");
    for (const double invalid : { -1., 1e-6, 200., nan })
    {
      gbuffer->SetNormalTolerance(invalid);
    }
  }
  {
    const relievoTest::ExpectMessage expected("SetDepthTolerance was given");
    for (const double invalid : { -1., 1e-9, 2., nan })
    {
      gbuffer->SetDepthTolerance(invalid);
    }
  }
  RELIEVO_CHECK(gbuffer->GetNormalTolerance() == 1. && gbuffer->GetDepthTolerance() == 1e-4);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormatTolerances)
{
  relievoTest::Session session;
  TestChoices();
  TestTolerances();
  return session.Result();
}
}
