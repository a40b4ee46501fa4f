// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every format of normal and depth through the whole chain, from the mesh to the array: within the
// format's bound of the full floats, the background exact, the bytes as many as expected.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Truth.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>

#include <cmath>

namespace testFormats
{
namespace
{
using relievoTest::Layers;
using relievoTest::Way;
using G = vtkRelievoLayersStage;

const double Near = 2.;
const double Far = 14.;

struct Fixture : relievoTest::Stage
{
  explicit Fixture(bool parallel)
    : Stage(200, 150)
  {
    auto ball = relievoTest::AddActor(this->Renderer, relievoTest::MakeBall(1.2));
    ball->SetPosition(0., 0.6, 0.);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(2.);
    camera->SetClippingRange(Near, Far);
  }
};

struct Errors
{
  double Normal = 0.; // degrees
  double Depth = 0.;  // world units, at the depth At
  double At = 0.;
  long Seen = 0;
};

Errors Compare(const Layers& a, const Layers& exact, bool normals)
{
  Errors errors;
  for (int y = 0; y < exact.Height; ++y)
  {
    for (int x = 0; x < exact.Width; ++x)
    {
      const double depth = exact.Value("depth", x, y);
      const double other = a.Value("depth", x, y);
      if (std::isinf(depth))
      {
        RELIEVO_CHECK(std::isinf(other) && other > 0.);
        RELIEVO_CHECK(!normals || a.Vector("normal", x, y) == glm::dvec3(0.));
        continue;
      }
      ++errors.Seen;
      if (std::abs(other - depth) > errors.Depth || !std::isfinite(other))
      {
        errors.Depth = std::abs(other - depth);
        errors.At = depth;
      }
      if (normals)
      {
        errors.Normal = std::max(errors.Normal,
          relievoTest::AngleDegrees(a.Vector("normal", x, y), exact.Vector("normal", x, y)));
      }
    }
  }
  RELIEVO_CHECK(errors.Seen > 3000);
  return errors;
}

void TestNormals()
{
  const struct
  {
    int Format;
    const char* Name;
    double Bound; // degrees; docs/charts has the measured ones
  } formats[] = {
    { G::NORMAL_FLOAT32, "FLOAT32", 1e-4 },
    { G::NORMAL_FLOAT16, "FLOAT16", 0.024 },
    { G::NORMAL_OCT16, "OCT16", 0.0038 },
    { G::NORMAL_OCT16_PRECISE, "OCT16_PRECISE", 0.0026 },
    { G::NORMAL_OCT8, "OCT8", 0.96 },
    { G::NORMAL_OCT8_PRECISE, "OCT8_PRECISE", 0.64 },
    { G::NORMAL_RGB10A2, "RGB10A2", 0.098 },
    { G::NORMAL_RGB8, "RGB8", 0.39 },
  };
  Fixture fixture(false);
  const Layers exact(fixture.Renderer, { "depth", "normal" }, Way::Own,
    [](G* g) { g->SetNormalFormat(G::NORMAL_FLOAT32); });
  double coarsest = 0.;
  for (const auto& format : formats)
  {
    for (const Way way : relievoTest::BothWays)
    {
      const Layers layers(fixture.Renderer, { "depth", "normal" }, way,
        [&](G* g) { g->SetNormalFormat(format.Format); });
      const Errors errors = Compare(layers, exact, true);
      RELIEVO_CHECK_AT_MOST(errors.Normal, format.Bound, format.Name);
      RELIEVO_CHECK_AT_MOST(errors.Depth, 0., std::string(format.Name) + ": depth");
      coarsest = std::max(coarsest, errors.Normal);
    }
  }
  RELIEVO_CHECK_THAT(coarsest > 0.3, "no format is coarse: the formats are not in use");
  // Normals in view space are those in world space, turned as the camera turns.
  const Layers view(fixture.Renderer, { "normal", "depth" }, Way::Own, [](G* g) {
    g->SetNormalFormat(G::NORMAL_FLOAT32);
    g->SetNormalSpace(G::VIEW);
  });
  vtkMatrix4x4* toView = fixture.Renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  for (int y = 0; y < exact.Height; y += 7)
  {
    for (int x = 0; x < exact.Width; x += 7)
    {
      const glm::dvec3 n = exact.Vector("normal", x, y);
      glm::dvec3 turned(0.);
      for (int i = 0; i < 3; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          turned[i] += toView->GetElement(i, k) * n[k];
        }
      }
      RELIEVO_CHECK(glm::length(turned - view.Vector("normal", x, y)) < 1e-5);
    }
  }
}

// The largest error that a depth format may make at a depth, in world units.
double GetDepthBound(int format, bool parallel, double depth)
{
  const double window24 = 0.5 / 16777215.;
  switch (format)
  {
    case G::DEPTH_16F:
      return depth / 2048.;
    case G::DEPTH_WINDOW_Z24:
      // dz/dd of the window's z; one half step, and the float's own rounding.
      return parallel ? (window24 + 2e-7) * (Far - Near)
                      : (window24 + 2e-7) * depth * depth * (Far - Near) / (Near * Far);
    default:
      return 4e-7 * depth;
  }
}

void TestDepths()
{
  const struct
  {
    int Format;
    const char* Name;
  } formats[] = { { G::DEPTH_32F, "32F" }, { G::DEPTH_16F, "16F" },
    { G::DEPTH_WINDOW_Z24, "window z, 24 bits" }, { G::DEPTH_REVERSED_32F, "reversed 32F" } };
  for (const bool parallel : { false, true })
  {
    Fixture fixture(parallel);
    // The GPU's result in float: measures the formats' own loss, not the rasteriser's.
    const Layers exact(fixture.Renderer, { "depth" }, Way::Own, [](G* g) { g->RefineDepthOff(); });
    for (const auto& format : formats)
    {
      for (const Way way : relievoTest::BothWays)
      {
        const Layers layers(fixture.Renderer, { "depth" }, way, [&](G* g) {
          g->RefineDepthOff();
          g->SetDepthFormat(format.Format);
        });
        const Errors errors = Compare(layers, exact, false);
        RELIEVO_CHECK_AT_MOST(errors.Depth,
          GetDepthBound(format.Format, parallel, errors.At) + 5e-6,
          std::string(format.Name) + (parallel ? ", parallel" : ""));
        RELIEVO_CHECK(format.Format != G::DEPTH_16F || errors.Depth > 1e-4);
      }
    }
  }
}

void TestTogether()
{
  const struct
  {
    int Format;
    const char* Name;
    double Degrees;
    double Depth;
  } formats[] = {
    { G::NORMAL_DEPTH_RGBA8, "RGBA8", 0.39, 0.51 * (Far - Near) / 255. },
    { G::NORMAL_DEPTH_RGBA16F, "RGBA16F", 0.024, Far / 2048. },
    { G::NORMAL_DEPTH_RGBA32F, "RGBA32F", 1e-4, 1e-5 },
  };
  Fixture fixture(false);
  const Layers exact(fixture.Renderer, { "depth", "normal" }, Way::Own, [](G* g) {
    g->RefineDepthOff();
    g->SetNormalFormat(G::NORMAL_FLOAT32);
  });
  for (const auto& format : formats)
  {
    for (const Way way : relievoTest::BothWays)
    {
      const Layers layers(fixture.Renderer, { "depth", "normal" }, way,
        [&](G* g) { g->SetNormalDepthFormat(format.Format); });
      const Errors errors = Compare(layers, exact, true);
      RELIEVO_CHECK_AT_MOST(errors.Normal, format.Degrees, format.Name);
      RELIEVO_CHECK_AT_MOST(errors.Depth, format.Depth, std::string(format.Name) + ": depth");
    }
  }
}

// RefineDepthOff returns the drawn depth, whatever else is requested; the frame's setting counts,
// not that of the read.
void TestRefineDepth()
{
  for (const Way way : relievoTest::BothWays)
  {
    Fixture fixture(false);
    auto off = [](G* g) { g->RefineDepthOff(); };
    const std::vector<std::string> names = { "depth", "range", "position", "cell", "actor" };
    const Layers plain(fixture.Renderer, { "depth", "range", "position" }, way, off);
    const Layers withIds(fixture.Renderer, names, way, off);
    const Layers refined(fixture.Renderer, names, way);
    for (const char* name : { "depth", "range", "position" })
    {
      RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(plain, withIds, name), 0, name);
      RELIEVO_CHECK_THAT(relievoTest::CountDifferent(refined, withIds, name) > 100, name);
    }
    RELIEVO_CHECK(relievoTest::CountDifferent(refined, withIds, "cell") == 0);
  }
  Fixture fixture(false);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  frame->GetLayersStage()->RefineDepthOff();
  frame->RequestLayer("depth");
  frame->RequestLayer("cell");
  fixture.Window->Render();
  vtkNew<vtkImageData> before;
  vtkNew<vtkImageData> after;
  frame->ReadLayer("depth", before);
  frame->GetLayersStage()->RefineDepthOn();
  frame->ReadLayer("depth", after);
  RELIEVO_CHECK(relievoTest::CountDifferent(Layers(before), Layers(after), "depth") == 0);
  vtkRelievoPass::Detach(fixture.Renderer);
}

// Bytes held for the requested layers, 4 for each word of a pixel.
void TestBytes()
{
  Fixture fixture(false);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  frame->GetLayersStage()->RefineDepthOff();
  auto words = [&](const std::vector<std::string>& layers) {
    frame->ReleaseLayers();
    for (const std::string& layer : layers)
    {
      frame->RequestLayer(layer);
    }
    fixture.Window->Render();
    RELIEVO_CHECK(frame->GetLayersStage()->GetShared());
    return static_cast<double>(frame->GetBytesHeld()) / (4. * 200. * 150.);
  };
  RELIEVO_CHECK(words({ "depth" }) == 1.);
  RELIEVO_CHECK(words({ "depth", "range", "position" }) == 1.);
  // Three floats, which cost no more than one word in attachments of four words, as on GPUs.
  RELIEVO_CHECK(words({ "normal", "depth" }) == 4.);
  RELIEVO_CHECK(words({ "normal", "depth", "albedo", "actor", "block", "cell" }) == 4.);
  frame->GetLayersStage()->SetNormalFormat(G::NORMAL_OCT16);
  RELIEVO_CHECK(words({ "normal", "depth" }) == 2.);
  frame->GetLayersStage()->SetNormalDepthFormat(G::NORMAL_DEPTH_RGBA8);
  RELIEVO_CHECK(words({ "normal", "depth" }) == 1.);
  frame->GetLayersStage()->SetNormalDepthFormat(G::NORMAL_DEPTH_RGBA32F);
  RELIEVO_CHECK(words({ "normal", "depth" }) == 4.);
  RELIEVO_CHECK(words({}) == 0.);
  vtkRelievoPass::Detach(fixture.Renderer);
}

// Every structure that the layout can have compiles, spliced and shown; or each format with each
// channel there and absent.
void TestVariants(bool all)
{
  Fixture fixture(false);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  fixture.Window->SetSize(16, 12);
  const char* const channels[] = { "depth", "normal", "geometric_normal", "albedo", "cell" };
  for (int asked = 1; asked < 32; ++asked)
  {
    frame->ReleaseLayers();
    for (int i = 0; i < 5; ++i)
    {
      if (asked & (1 << i))
      {
        frame->RequestLayer(channels[i]);
      }
    }
    for (int format = G::NORMAL_AUTO; format <= G::NORMAL_RGB8; ++format)
    {
      const bool some =
        asked == 3 || asked == 4 || asked == 24 || asked == 31 || format == asked % 9;
      if ((format > G::NORMAL_FLOAT32 && (asked & 6) == 0) || !(all || some))
      {
        continue;
      }
      frame->GetLayersStage()->SetNormalFormat(format);
      frame->GetLayersStage()->SetDepthFormat((asked + format) % 4);
      frame->GetLayersStage()->SetNormalDepthFormat(format % 4);
      frame->SetDisplayLayer(channels[(asked + format) % 5]);
      fixture.Window->Render();
      vtkNew<vtkImageData> image;
      for (int i = 0; i < 5; ++i)
      {
        RELIEVO_CHECK((asked & (1 << i)) == 0 || frame->ReadLayer(channels[i], image));
      }
    }
  }
  vtkRelievoPass::Detach(fixture.Renderer);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormats)
{
  relievoTest::Session session;
  {
    Fixture watched(false);
    relievoTest::GLCheck gl(watched.Window);
    TestNormals();
    TestDepths();
    TestTogether();
    TestBytes();
    TestRefineDepth();
    TestVariants(relievoTest::IsLong(argc, argv));
  }
  return session.Result();
}
}
