// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words behind the layers: every format holds its stated number of bytes and leaves the
// background exact for all layers, also with a far plane 1e7 times as far as the near one; and the
// choice of AUTO.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoSoftwareOpenGL.h>

#include <cmath>
#include <limits>

namespace testFormatWords
{
namespace
{
using Pass = vtkRelievoLayersStage;
using relievoTest::Layers;
using relievoTest::Stage;
using relievoTest::Way;

const int Width = 150;
const int Height = 110;

// A ball and a long floor, which runs through all depths, and nothing behind.
void Fill(vtkRenderer* renderer)
{
  relievoTest::AddActor(renderer, relievoTest::MakeBall(1.));
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-4., -0.5, 4.);
  floor->SetPoint1(4., -0.5, 4.);
  floor->SetPoint2(-4., -0.5, -6.);
  floor->SetResolution(4, 40);
  floor->Update();
  relievoTest::AddActor(renderer, floor->GetOutput());
}

struct Format
{
  const char* Name;
  int Value;
  int Words;
};

const Format Normals[] = {
  { "FLOAT32", Pass::NORMAL_FLOAT32, 3 },
  { "FLOAT16", Pass::NORMAL_FLOAT16, 2 },
  { "OCT16", Pass::NORMAL_OCT16, 1 },
  { "OCT16_PRECISE", Pass::NORMAL_OCT16_PRECISE, 1 },
  { "OCT8", Pass::NORMAL_OCT8, 1 },
  { "OCT8_PRECISE", Pass::NORMAL_OCT8_PRECISE, 1 },
  { "RGB10A2", Pass::NORMAL_RGB10A2, 1 },
  { "RGB8", Pass::NORMAL_RGB8, 1 },
};

// Bytes of so many words per pixel: textures have one, two or four channels, in software OpenGL at
// most two.
long long Bytes(int words)
{
  const bool filled = words % 4 == 3 && !vtkRelievoIsSoftwareOpenGL();
  return 4LL * (words + (filled ? 1 : 0)) * Width * Height;
}

// Renders with the requested layers, shared or not, and returns the bytes held.
long long BytesHeld(
  vtkRenderer* renderer, const std::vector<std::string>& names, Way way, Pass* settings)
{
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  Pass* gbuffer = frame->GetLayersStage();
  gbuffer->SetNormalFormat(settings->GetNormalFormat());
  gbuffer->SetDepthFormat(settings->GetDepthFormat());
  gbuffer->SetNormalDepthFormat(settings->GetNormalDepthFormat());
  gbuffer->SetRefineDepth(settings->GetRefineDepth());
  gbuffer->SetShareGeometryPass(way == Way::Shared);
  for (const std::string& name : names)
  {
    frame->RequestLayer(name);
  }
  renderer->GetRenderWindow()->Render();
  const long long bytes = frame->GetBytesHeld();
  vtkRelievoPass::Detach(renderer);
  return bytes;
}

void CheckBackground(const std::string& what, const Layers& layers)
{
  long long mismatches = 0;
  long long there = 0;
  const glm::dvec3 zero(0.);
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (layers.Id("actor", x, y) >= 0)
      {
        mismatches += std::isfinite(layers.Value("depth", x, y)) ? 0 : 1;
        mismatches += std::abs(glm::length(layers.Vector("normal", x, y)) - 1.) < 1e-5 ? 0 : 1;
        ++there;
        continue;
      }
      const double infinity = std::numeric_limits<double>::infinity();
      mismatches += layers.Value("depth", x, y) == infinity &&
          layers.Value("range", x, y) == infinity && layers.Vector("normal", x, y) == zero &&
          layers.Vector("geometric_normal", x, y) == zero &&
          layers.Vector("position", x, y) == zero && layers.Id("block", x, y) == -1 &&
          layers.Id("cell", x, y) == -1 && std::isnan(layers.Value("Normals", x, y)) &&
          layers.Vector("albedo", x, y) == zero && layers.Value("albedo", x, y, 3) == 0.
        ? 0
        : 1;
    }
  }
  RELIEVO_CHECK(there > 3000 && there < Width * Height - 1000);
  RELIEVO_CHECK_AT_MOST(mismatches, 0, what + ": pixels of the background, or with holes");
}

const std::vector<std::string> All = { "depth", "range", "normal", "geometric_normal", "position",
  "albedo", "actor", "block", "cell", "Normals" };

void TestNormals(const Stage& stage)
{
  for (const Way way : relievoTest::BothWays)
  {
    for (const Format& format : Normals)
    {
      const std::string what =
        std::string("normals as ") + format.Name + ", " + relievoTest::ToString(way);
      vtkNew<Pass> settings;
      settings->SetNormalFormat(format.Value);
      const long long own = way == Way::Own ? 4LL * Width * Height : 0;
      RELIEVO_CHECK(
        BytesHeld(stage.Renderer, { "normal" }, way, settings) == Bytes(format.Words) + own);
      CheckBackground(what,
        Layers(stage.Renderer, All, way, [&](Pass* pass) { pass->SetNormalFormat(format.Value); }));
    }
  }
}

// The depths that the shader packed, of which every format makes its own.
void TestDepths(const Stage& stage, double zNear, double zFar, bool parallel)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetClippingRange(zNear, zFar);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(2.);
  const Layers whole(stage.Renderer, { "depth" }, Way::Own, [](Pass* p) { p->RefineDepthOff(); });
  const double half = std::ldexp(1., -11);
  const double single = std::ldexp(1., -23);
  for (const int format :
    { Pass::DEPTH_32F, Pass::DEPTH_16F, Pass::DEPTH_WINDOW_Z24, Pass::DEPTH_REVERSED_32F })
  {
    auto set = [format](Pass* pass) {
      pass->SetDepthFormat(format);
      pass->RefineDepthOff();
    };
    const Layers layers(stage.Renderer, { "depth" }, Way::Own, set);
    double worst = 0.;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const double d = whole.Value("depth", x, y);
        const double drawn = layers.Value("depth", x, y);
        if (!std::isfinite(d))
        {
          worst = drawn == d ? worst : 1e9;
          continue;
        }
        // Half a step of window z, and the rounding of the float that it is made of.
        const double step = parallel ? zFar - zNear : d * d * (zFar - zNear) / (zFar * zNear);
        const double scale = parallel ? std::max(d, zFar - zNear) : d;
        const double bound = format == Pass::DEPTH_16F ? half * d
          : format == Pass::DEPTH_WINDOW_Z24           ? 2.5 * std::ldexp(step, -24)
          : format == Pass::DEPTH_REVERSED_32F         ? 4. * single * scale
                                                       : 0.;
        worst = std::max(worst, drawn == d ? 0. : std::abs(drawn - d) / bound);
      }
    }
    const std::string what = "depth format " + std::to_string(format) + ", far / near " +
      std::to_string(zFar / zNear) + (parallel ? ", parallel" : "");
    RELIEVO_CHECK(layers.Covered() > 3000);
    RELIEVO_CHECK_AT_MOST(worst, 1., what + ": error, of its bound");
    vtkNew<Pass> settings;
    settings->SetDepthFormat(format);
    settings->RefineDepthOff();
    RELIEVO_CHECK(BytesHeld(stage.Renderer, { "depth" }, Way::Own, settings) == 2 * Bytes(1));
    for (const Way way : relievoTest::BothWays)
    {
      if (way == Way::Own || zFar <= 1e4 * zNear || parallel)
      {
        CheckBackground(what + ", " + relievoTest::ToString(way),
          Layers(stage.Renderer, All, way, [format](Pass* p) { p->SetDepthFormat(format); }));
      }
    }
  }
}

void TestTogether(const Stage& stage)
{
  double range[2] = { 2., 14. };
  stage.Renderer->GetActiveCamera()->ParallelProjectionOff();
  stage.Renderer->GetActiveCamera()->SetClippingRange(range);
  const std::vector<std::string> names = { "depth", "normal" };
  const Format together[] = {
    { "RGBA8", Pass::NORMAL_DEPTH_RGBA8, 1 },
    { "RGBA16F", Pass::NORMAL_DEPTH_RGBA16F, 2 },
    { "RGBA32F", Pass::NORMAL_DEPTH_RGBA32F, 4 },
  };
  for (const Way way : relievoTest::BothWays)
  {
    for (const Format& format : together)
    {
      const std::string what =
        std::string("normal and depth as ") + format.Name + ", " + relievoTest::ToString(way);
      vtkNew<Pass> settings;
      settings->SetNormalDepthFormat(format.Value);
      const long long own = way == Way::Own ? 4LL * Width * Height : 0;
      RELIEVO_CHECK_THAT(
        BytesHeld(stage.Renderer, names, way, settings) == Bytes(format.Words) + own,
        what + ": not the bytes that it says");
      CheckBackground(what, Layers(stage.Renderer, All, way, [&](Pass* pass) {
        pass->SetNormalDepthFormat(format.Value);
      }));
    }
  }
}

// Full floats where they cost no further texture, one word elsewhere.
void TestAuto(const Stage& stage)
{
  struct Case
  {
    std::vector<std::string> Names;
    int Words;
    bool Whole;
  };
  const Case cases[] = {
    { { "normal" }, 3, true },
    { { "normal", "actor" }, 4, true },
    { { "normal", "actor", "albedo" }, 3, false },
    { { "normal", "geometric_normal" }, 2, false },
    { { "normal", "geometric_normal", "actor", "albedo" }, 4, false },
  };
  for (const Case& c : cases)
  {
    const Layers chosen(stage.Renderer, c.Names, Way::Shared);
    const Layers whole(stage.Renderer, c.Names, Way::Shared,
      [](Pass* pass) { pass->SetNormalFormat(Pass::NORMAL_FLOAT32); });
    const long long different = relievoTest::CountDifferent(chosen, whole, "normal");
    RELIEVO_CHECK_THAT(c.Whole ? different == 0 : different > 1000,
      "NORMAL_AUTO did not take the expected format beside " + c.Names.back());
    vtkNew<Pass> settings;
    RELIEVO_CHECK(BytesHeld(stage.Renderer, c.Names, Way::Shared, settings) == Bytes(c.Words));
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormatWords)
{
  relievoTest::Session session;
  {
    const Stage stage(Width, Height);
    Fill(stage.Renderer);
    const relievoTest::GLCheck gl(stage.Window);
    TestNormals(stage);
    TestAuto(stage);
    TestDepths(stage, 2., 14., false);
    TestDepths(stage, 1e-3, 1e4, false);
    TestDepths(stage, 2., 14., true);
    TestTogether(stage);
  }
  return session.Result();
}
}
