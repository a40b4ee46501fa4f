// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Layers shown as the picture: each colour follows from the layer's value, by the formula files.

// First, since GLM's own packing functions would compete with its.
#include <vtkRelievoFormulas.h>

#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoDisplayStage.h>
#include <vtkRelievoLamps.h>
#include <vtkRelievoLampsStage.h>
#include <vtkRelievoLinearDepthPass.h>
#include <vtkRelievoPass.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace testDisplay
{
namespace
{
using relievoTest::Layers;
using relievoTest::Way;

const double Near = 4.;
const double Far = 10.;
const glm::dvec3 Background(0.1, 0.2, 0.3);

struct Fixture : relievoTest::Stage
{
  Fixture()
    : Stage(160, 120)
  {
    auto mesh = relievoTest::MakeBall(1.2);
    vtkNew<vtkFloatArray> heights;
    heights->SetName("height");
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      heights->InsertNextValue(static_cast<float>(mesh->GetPoint(i)[1]));
    }
    mesh->GetPointData()->AddArray(heights);
    relievoTest::AddActor(this->Renderer, mesh)->GetProperty()->SetColor(0.8, 0.4, 0.2);
    auto box = relievoTest::AddActor(this->Renderer, relievoTest::MakeBox(3., 0.1, 3.));
    box->GetProperty()->SetColor(0.2, 0.6, 0.4);
    this->Renderer->SetBackground(Background.x, Background.y, Background.z);
    this->Renderer->GetActiveCamera()->SetClippingRange(Near, Far);
  }
};

// Expected colour, 0 to 1, of a pixel.
using Color = std::function<glm::dvec3(const Layers&, int, int)>;

// Share of pixels that are off by more than 1.5 / 255.
double GetShareOff(vtkImageData* picture, const Layers& layers, const Color& color)
{
  long off = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const auto* rgb = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      const glm::dvec3 expected = glm::clamp(color(layers, x, y), 0., 1.) * 255.;
      off += std::abs(rgb[0] - expected.x) > 1.5 || std::abs(rgb[1] - expected.y) > 1.5 ||
        std::abs(rgb[2] - expected.z) > 1.5;
    }
  }
  return static_cast<double>(off) / (layers.Width * layers.Height);
}

bool IsThere(const Layers& layers, int x, int y)
{
  return std::isfinite(layers.Value("depth", x, y));
}

glm::dvec3 GetMapped(double value, double from, double to)
{
  return glm::dvec3(relievo::f32::relievoColormap(
    static_cast<float>(glm::clamp((value - from) / (to - from), 0., 1.))));
}

// The least and the greatest value that is there.
glm::dvec2 GetSeen(const Layers& layers, const char* name)
{
  glm::dvec2 seen(VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX);
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (IsThere(layers, x, y))
      {
        const double value = layers.Value(name, x, y);
        seen = glm::dvec2(glm::min(seen.x, value), glm::max(seen.y, value));
      }
    }
  }
  return seen;
}

void TestLayers()
{
  Fixture fixture;
  relievoTest::GLCheck gl(fixture.Window);
  const Layers layers(fixture.Renderer,
    { "depth", "range", "normal", "geometric_normal", "albedo", "actor", "block", "cell",
      "height" },
    Way::Own);
  const auto vectors = [](const char* name) {
    return [name](const Layers& l, int x, int y) {
      return IsThere(l, x, y) ? 0.5 * l.Vector(name, x, y) + 0.5 : Background;
    };
  };
  const auto ids = [](const char* name) {
    return [name](const Layers& l, int x, int y) {
      const int id = l.Id(name, x, y);
      return id < 0 ? Background
                    : glm::dvec3(relievo::f32::relievoHashColor(static_cast<glm::uint>(id)));
    };
  };
  const auto scalars = [](const char* name, const glm::dvec2& range) {
    return [=](const Layers& l, int x, int y) {
      return IsThere(l, x, y) ? GetMapped(l.Value(name, x, y), range.x, range.y) : Background;
    };
  };
  const struct
  {
    const char* Name;
    Color Expected;
    double Range[2];
  } shown[] = {
    { "depth", scalars("depth", GetSeen(layers, "depth")), { 0., 0. } },
    { "depth", scalars("depth", { 5., 7. }), { 5., 7. } },
    { "range", scalars("range", GetSeen(layers, "range")), { 0., 0. } },
    { "normal", vectors("normal"), { 0., 0. } },
    { "geometric_normal", vectors("geometric_normal"), { 0., 0. } },
    { "albedo",
      [](const Layers& l, int x, int y) {
        return IsThere(l, x, y) ? l.Vector("albedo", x, y) / 255. : Background;
      },
      { 0., 0. } },
    { "actor", ids("actor"), { 0., 0. } },
    { "block", ids("block"), { 0., 0. } },
    { "cell", ids("cell"), { 0., 0. } },
    { "height",
      [](const Layers& l, int x, int y) {
        const double value = l.Value("height", x, y);
        return std::isnan(value) ? Background : GetMapped(value, -1.2, 1.2);
      },
      { -1.2, 1.2 } },
  };
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  for (const auto& one : shown)
  {
    frame->SetDisplayLayer(one.Name);
    frame->SetDisplayRange(one.Range[0], one.Range[1]);
    const auto picture = relievoTest::Picture(fixture.Window);
    RELIEVO_CHECK_AT_MOST(
      GetShareOff(picture, layers, one.Expected), 0.001, std::string(one.Name) + " shown");
    // The comparison can fail: the picture of another layer does.
    RELIEVO_CHECK(GetShareOff(picture, layers,
                    [](const Layers&, int x, int) { return glm::dvec3(x % 2); }) > 0.5);
  }
  frame->SetDisplayLayer("no such array");
  {
    relievoTest::ExpectMessage expect("no such array");
    fixture.Window->Render();
  }
  fixture.Window->Render(); // told once: a second message would fail the session
  frame->SetDisplayLayer("position");
  const auto position = relievoTest::Picture(fixture.Window);
  RELIEVO_CHECK(GetShareOff(position, layers, [](const Layers& l, int x, int y) {
    return IsThere(l, x, y) ? glm::dvec3(2.) : Background;
  }) > 0.1);
  vtkRelievoPass::Detach(fixture.Renderer);
  gl.Poll("layers");
}

const double* GetShownRange(vtkRelievoPass* frame)
{
  return vtkRelievoDisplayStage::SafeDownCast(frame->GetStage("display"))->GetShownRange();
}

// A ground to the horizon does not flatten objects on it; a picture in tiles has one range.
void TestGround()
{
  Fixture fixture;
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  vtkActor* ground =
    relievoTest::AddActor(fixture.Renderer, relievoTest::MakeBox(1000., 0., 1000.));
  ground->SetPosition(0., -1.3, 0.);
  vtkCamera* camera = fixture.Renderer->GetActiveCamera();
  camera->Elevation(8.);
  camera->SetClippingRange(0.5, 2000.);
  const Layers layers(fixture.Renderer, { "depth", "range" }, Way::Own);
  double position[3];
  double along[3];
  camera->GetPosition(position);
  camera->GetDirectionOfProjection(along);
  // The ball of radius 1.2 and the box of 3 x 0.1 x 3.
  glm::dvec2 depths(VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX);
  double farthest = 0.;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 away(((corner & 1) ? 1.5 : -1.5) - position[0],
      ((corner & 2) ? 1.2 : -1.2) - position[1], ((corner & 4) ? 1.5 : -1.5) - position[2]);
    const double depth = glm::dot(away, glm::dvec3(along[0], along[1], along[2]));
    depths = glm::dvec2(glm::min(depths.x, depth), glm::max(depths.y, depth));
    farthest = glm::max(farthest, glm::length(away));
  }
  const glm::dvec2 seen = GetSeen(layers, "depth");
  RELIEVO_CHECK(seen.y > 2. * depths.y); // the ground's
  frame->SetDisplayLayer("depth");
  fixture.Window->Render();
  RELIEVO_CHECK_AT_MOST(
    std::abs(GetShownRange(frame)[0] - glm::max(seen.x, depths.x)), 1e-4, "near");
  RELIEVO_CHECK_AT_MOST(std::abs(GetShownRange(frame)[1] - depths.y), 1e-4, "far");
  fixture.Window->SetTileScale(2, 1);
  for (int tile = 0; tile < 2; ++tile)
  {
    fixture.Window->SetTileViewport(0.5 * tile, 0., 0.5 * tile + 0.5, 1.);
    fixture.Window->Render();
    RELIEVO_CHECK_AT_MOST(std::abs(GetShownRange(frame)[0] - depths.x), 1e-4, "near, in tiles");
    RELIEVO_CHECK_AT_MOST(std::abs(GetShownRange(frame)[1] - depths.y), 1e-4, "far, in tiles");
  }
  fixture.Window->SetTileScale(1, 1);
  fixture.Window->SetTileViewport(0., 0., 1., 1.);
  frame->SetDisplayLayer("range");
  fixture.Window->Render();
  RELIEVO_CHECK_AT_MOST(std::abs(GetShownRange(frame)[1] - farthest), 1e-4, "farthest");
  // Without anything else, it is visible.
  for (int i = 0; i < 2; ++i)
  {
    vtkActor::SafeDownCast(fixture.Renderer->GetActors()->GetItemAsObject(i))->VisibilityOff();
  }
  frame->SetDisplayLayer("depth");
  fixture.Window->Render();
  RELIEVO_CHECK(GetShownRange(frame)[1] > 2. * depths.y);
  ground->VisibilityOff();
  fixture.Window->Render();
  RELIEVO_CHECK(std::isinf(GetShownRange(frame)[0]));
  vtkRelievoPass::Detach(fixture.Renderer);
}

// The named maps, turned round or not, of values on the GPU (depth) and of arrays.
void TestColormaps()
{
  Fixture fixture;
  const Layers layers(fixture.Renderer, { "depth", "height" }, Way::Own);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  auto* stage = vtkRelievoDisplayStage::SafeDownCast(frame->GetStage("display"));
  stage->SetColormap(vtkRelievoDisplayStage::HOT);
  for (const char* name : { "depth", "height" })
  {
    for (const bool reversed : { false, true })
    {
      stage->SetReversed(reversed);
      frame->SetDisplayLayer(name);
      frame->SetDisplayRange(name[0] == 'd' ? 4. : -1.2, name[0] == 'd' ? 9. : 1.2);
      const double* range = frame->GetDisplayRange();
      const auto expected = [&](const Layers& l, int x, int y) {
        const double value = l.Value(name, x, y);
        const double t = glm::clamp((value - range[0]) / (range[1] - range[0]), 0., 1.);
        const double u = reversed ? 1. - t : t;
        // Black, red at 0.4, yellow at 0.8, white.
        return std::isfinite(value)
          ? glm::dvec3(u < 0.8 ? glm::min(0.9, u / 0.4 * 0.9) : 0.9 + (u - 0.8) / 0.2 * 0.1,
              u < 0.8 ? glm::max(0., (u - 0.4) / 0.4 * 0.9) : 0.9 + (u - 0.8) / 0.2 * 0.1,
              glm::max(0., (u - 0.8) / 0.2))
          : Background;
      };
      RELIEVO_CHECK_AT_MOST(GetShareOff(relievoTest::Picture(fixture.Window), layers, expected),
        0.001, std::string(name) + (reversed ? " reversed" : " in hot"));
    }
  }
  vtkRelievoPass::Detach(fixture.Renderer);
}

// A slider moves values, not structure: no program is compiled anew.
void TestNoRecompile()
{
  Fixture fixture;
  vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
  frame->SetDisplayLayer("depth");
  fixture.Window->Render();
  fixture.Window->Render();
  const int programs = relievoTest::CountGLObjects(fixture.Window).Programs;
  for (int i = 0; i < 5; ++i)
  {
    frame->SetDisplayRange(4. + 0.1 * i, 9.);
    frame->SetDisplayGrey(i % 2 == 0);
    fixture.Renderer->GetActiveCamera()->Azimuth(3.);
    fixture.Renderer->GetActiveCamera()->SetClippingRange(Near + 0.1 * i, Far);
    fixture.Window->Render();
  }
  RELIEVO_CHECK(relievoTest::CountGLObjects(fixture.Window).Programs == programs);
  vtkRelievoPass::Detach(fixture.Renderer);
}

void TestLinearDepth()
{
  Fixture fixture;
  const Layers layers(fixture.Renderer, { "depth" }, Way::Own);
  const auto expect = [&](double from, double to) {
    return [=](const Layers& l, int x, int y) {
      const double depth = l.Value("depth", x, y);
      return glm::dvec3(std::isinf(depth) ? 1. : (depth - from) / (to - from));
    };
  };
  vtkNew<vtkRelievoLinearDepthPass> pass;
  fixture.Renderer->SetPass(pass);
  RELIEVO_CHECK_AT_MOST(
    GetShareOff(relievoTest::Picture(fixture.Window), layers, expect(Near, Far)), 0.001,
    "normalised");
  pass->NormalizedOff();
  RELIEVO_CHECK_AT_MOST(GetShareOff(relievoTest::Picture(fixture.Window), layers, expect(0., 1.)),
    0.001, "world units");
  pass->SetRange(5., 8.);
  RELIEVO_CHECK_AT_MOST(
    GetShareOff(relievoTest::Picture(fixture.Window), layers, expect(5., 8.)), 0.001, "a range");
  RELIEVO_CHECK(GetShareOff(relievoTest::Picture(fixture.Window), layers, expect(Near, Far)) > 0.1);
  pass->ReleaseGraphicsResources(fixture.Window);
  fixture.Renderer->SetPass(nullptr);
}
}

//------------------------------------------------------------------------------
// The linear colour, shown through the sRGB curve, is the picture, whatever else is in the frame.
void TestColor()
{
  for (const bool lit : { false, true })
  {
    Fixture fixture;
    vtkNew<vtkPoints> place;
    place->InsertNextPoint(fixture.Renderer->GetActiveCamera()->GetFocalPoint());
    vtkNew<vtkPolyData> points;
    points->SetPoints(place);
    vtkNew<vtkRelievoLamps> lamps;
    lamps->SetInputData(points);
    vtkRelievoPass* frame = vtkRelievoPass::Attach(fixture.Renderer);
    if (lit)
    {
      vtkRelievoLampsStage::SafeDownCast(frame->GetStage("lamps"))->AddPoints(lamps);
    }
    const auto picture = relievoTest::Picture(fixture.Window);
    frame->SetDisplayLayer("color");
    const auto shown = relievoTest::Picture(fixture.Window);
    double most = 0.0;
    for (vtkIdType i = 0; i < shown->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        most = std::max(most,
          std::abs(shown->GetPointData()->GetScalars()->GetComponent(i, c) -
            picture->GetPointData()->GetScalars()->GetComponent(i, c)));
      }
    }
    RELIEVO_CHECK_AT_MOST(most, 1.0, "the colour, levels of 255");
  }
}

RELIEVO_TEST_CASE(testDisplay)
{
  relievoTest::Session session;
  TestColor();
  TestLayers();
  TestGround();
  TestColormaps();
  TestNoRecompile();
  TestLinearDepth();
  return session.Result();
}
}
