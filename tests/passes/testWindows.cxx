// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Unusual windows and projections: multisampled, tiled, stereo, with renderers one over the other
// or of the same actors, without area, larger than OpenGL; sheared, explicit and moved projections.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPerspectiveTransform.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkTransform.h>
#include <vtkWindowToImageFilter.h>

#include <functional>

namespace testWindows
{
namespace
{
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "normal", "geometric_normal", "position",
  "albedo", "actor", "cell" };

void Fill(vtkRenderer* renderer)
{
  const auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(1.));
  ball->SetPosition(0., 0.4, 0.);
  ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
  const auto box = relievoTest::AddActor(renderer, relievoTest::MakeBox(3., 0.2, 3.));
  box->GetProperty()->SetColor(0.3, 0.5, 0.8);
  box->GetProperty()->EdgeVisibilityOn();
  renderer->SetBackground(0.1, 0.2, 0.3);
}

void Request(vtkRenderer* renderer)
{
  for (const std::string& name : Names)
  {
    vtkRelievoPass::Attach(renderer)->RequestLayer(name);
  }
}

// Layers have one sample at the pixel's centre, whatever the picture has.
void TestMultisampled()
{
  const Stage single(150, 100);
  Fill(single.Renderer);
  const Layers expected(single.Renderer, Names);
  const Stage multi(150, 100);
  multi.Window->SetMultiSamples(8);
  Fill(multi.Renderer);
  const relievoTest::GLCheck gl(multi.Window);
  const auto before = Picture(multi.Window);
  const Layers alone(multi.Renderer, Names);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(multi.Renderer);
  Request(multi.Renderer);
  relievoTest::SamePicture(before, Picture(multi.Window), "multisampled, with layers");
  vtkNew<vtkImageData> image;
  for (const std::string& name : Names)
  {
    RELIEVO_CHECK(frame->ReadLayer(name, image));
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(expected, Layers(image), name), 0,
      "multisampled: pixels of " + name);
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(expected, alone, name), 0,
      "multisampled, captured: pixels of " + name);
  }
  vtkRelievoPass::Detach(multi.Renderer);
}

vtkSmartPointer<vtkImageData> Tiled(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(2);
  filter->ReadFrontBufferOff();
  filter->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->DeepCopy(filter->GetOutput());
  return image;
}

// Tiles of a picture larger than its window: drawn, and shown, as if it were one.
void TestTiled()
{
  const Stage stage(90, 60);
  Fill(stage.Renderer);
  const relievoTest::GLCheck gl(stage.Window);
  const auto plain = Tiled(stage.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  Request(stage.Renderer);
  relievoTest::SamePicture(plain, Tiled(stage.Window), "tiled, with layers");
  frame->SetDisplayLayer("geometric_normal");
  const auto shown = Tiled(stage.Window);
  vtkRelievoPass::Detach(stage.Renderer);
  // The whole picture at once, in a window of its size.
  const Stage large(180, 120);
  Fill(large.Renderer);
  vtkRelievoPass::Attach(large.Renderer)->SetDisplayLayer("geometric_normal");
  const auto whole = Picture(large.Window);
  long long other = 0;
  vtkDataArray* a = shown->GetPointData()->GetScalars();
  vtkDataArray* b = whole->GetPointData()->GetScalars();
  if (RELIEVO_CHECK(a->GetNumberOfTuples() == b->GetNumberOfTuples()))
  {
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
    {
      bool same = true;
      for (int c = 0; c < 3; ++c)
      {
        same = same && std::abs(a->GetComponent(i, c) - b->GetComponent(i, c)) <= 2.;
      }
      other += same ? 0 : 1;
    }
    RELIEVO_CHECK_AT_MOST(static_cast<double>(other) / static_cast<double>(a->GetNumberOfTuples()),
      0.01, "tiled: share of pixels that are not those of the whole");
  }
  vtkRelievoPass::Detach(large.Renderer);
}

void TestStereo()
{
  for (const int type : { VTK_STEREO_RED_BLUE, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    const Stage stage(160, 100);
    Fill(stage.Renderer);
    stage.Window->SetStereoType(type);
    stage.Window->StereoRenderOn();
    const relievoTest::GLCheck gl(stage.Window);
    const auto before = Picture(stage.Window);
    Request(stage.Renderer);
    relievoTest::SamePicture(before, Picture(stage.Window), "stereo, with layers");
    vtkRelievoPass::Detach(stage.Renderer);
  }
}

// A renderer in a layer above, and one that keeps the existing colours.
void TestRendererLayers()
{
  for (const bool keep : { false, true })
  {
    const Stage stage(150, 100);
    Fill(stage.Renderer);
    vtkNew<vtkRenderer> above;
    const auto small = relievoTest::AddActor(above, relievoTest::MakeBall(0.4));
    above->SetActiveCamera(stage.Renderer->GetActiveCamera());
    stage.Window->SetNumberOfLayers(2);
    above->SetLayer(keep ? 0 : 1);
    above->SetPreserveColorBuffer(keep);
    stage.Window->AddRenderer(above);
    const relievoTest::GLCheck gl(stage.Window);
    const auto before = Picture(stage.Window);
    const Layers below(stage.Renderer, Names);
    const Layers over(above, Names);
    RELIEVO_CHECK(over.Covered() > 100 && over.Covered() < below.Covered());
    Request(stage.Renderer);
    Request(above);
    const std::string what = keep ? "colours kept" : "one layer over another";
    relievoTest::SamePicture(before, Picture(stage.Window), what);
    vtkNew<vtkImageData> images[2];
    vtkRenderer* renderers[2] = { stage.Renderer, above };
    for (int i = 0; i < 2; ++i)
    {
      vtkRelievoPass* frame = vtkRelievoPass::SafeDownCast(renderers[i]->GetPass());
      for (const std::string& name : Names)
      {
        RELIEVO_CHECK(frame->ReadLayer(name, images[i]));
        RELIEVO_CHECK_AT_MOST(
          relievoTest::CountDifferent(i == 0 ? below : over, Layers(images[i]), name), 0,
          what + ": pixels of " + name);
      }
      vtkRelievoPass::Detach(renderers[i]);
    }
  }
}

// Actors that two renderers share, of which one makes layers.
void TestSharedActors()
{
  const Stage stage(200, 100);
  Fill(stage.Renderer);
  stage.Renderer->SetViewport(0., 0., 0.5, 1.);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0., 1., 1.);
  other->SetActiveCamera(stage.Renderer->GetActiveCamera());
  for (vtkActor* actor : { stage.Renderer->GetActors()->GetLastActor(),
         static_cast<vtkActor*>(stage.Renderer->GetActors()->GetItemAsObject(0)) })
  {
    other->AddActor(actor);
  }
  stage.Window->AddRenderer(other);
  const relievoTest::GLCheck gl(stage.Window);
  const auto before = Picture(stage.Window);
  Request(other);
  for (int i = 0; i < 3; ++i)
  {
    relievoTest::SamePicture(before, Picture(stage.Window), "actors of two renderers");
  }
  vtkRelievoPass::Detach(other);
  relievoTest::SamePicture(before, Picture(stage.Window), "actors of two renderers, detached");
}

// No pixels, or more than there can be: said once, nothing half-made, nothing left behind.
void TestImpossibleSizes()
{
  struct Size
  {
    int Width;
    int Height;
    const char* Says;
  };
  for (const Size& size :
    { Size{ 200000, 4, "200000" }, Size{ 4, 200000, "200000" }, Size{ 200001, 4, "200001" } })
  {
    const Stage stage(40, 30);
    Fill(stage.Renderer);
    if (size.Width != 200001)
    {
      stage.Window->Render();
    }
    stage.Window->SetSize(size.Width, size.Height);
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(stage.Renderer);
    source->AddLayer("depth");
    {
      const relievoTest::ExpectMessage expected(size.Says);
      const relievoTest::ExpectMessage pipeline("Algorithm vtkRelievoLayerSource");
      source->Update();
      RELIEVO_CHECK(expected.Count() == 1);
    }
    RELIEVO_CHECK(source->GetOutput()->GetNumberOfPoints() == 0);
    stage.Window->SetSize(40, 30);
    RELIEVO_CHECK(Layers(stage.Renderer, { "depth" }).Covered() > 100);
  }
  // A viewport of no area beside another.
  const Stage stage(60, 40);
  Fill(stage.Renderer);
  vtkNew<vtkRenderer> flat;
  relievoTest::AddActor(flat, relievoTest::MakeBall(1.));
  flat->SetViewport(0.5, 0., 0.5, 1.);
  stage.Window->AddRenderer(flat);
  const relievoTest::GLCheck gl(stage.Window);
  Request(stage.Renderer);
  Request(flat);
  for (int i = 0; i < 3; ++i)
  {
    stage.Window->Render();
  }
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(vtkRelievoPass::SafeDownCast(stage.Renderer->GetPass())->ReadLayer("depth", image));
  vtkRelievoPass::Detach(stage.Renderer);
  vtkRelievoPass::Detach(flat);
}

// Whatever the projection: the position is at the depth that the view's matrix says, is drawn at
// its pixel, and is on a facet of the ball.
void TestProjection(const char* what, const std::function<void(vtkCamera*)>& set)
{
  for (const Way way : relievoTest::BothWays)
  {
    const Stage stage(150, 100);
    relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(1.));
    set(stage.Renderer->GetActiveCamera());
    const Layers layers(stage.Renderer, { "depth", "position", "cell" }, way);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    vtkMatrix4x4* toView = camera->GetModelViewTransformMatrix();
    vtkNew<vtkMatrix4x4> toClip;
    toClip->DeepCopy(camera->GetCompositeProjectionTransformMatrix(
      stage.Renderer->GetTiledAspectRatio(), -1., 1.));
    double depth = 0.;
    double pixel = 0.;
    double radius = 0.;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const double d = layers.Value("depth", x, y);
        if (!std::isfinite(d))
        {
          continue;
        }
        const glm::dvec3 p = layers.Vector("position", x, y);
        const double in[4] = { p.x, p.y, p.z, 1. };
        double view[4];
        double clip[4];
        toView->MultiplyPoint(in, view);
        toClip->MultiplyPoint(in, clip);
        depth = std::max(depth, std::abs(-view[2] - d) / d);
        pixel = std::max({ pixel, std::abs((clip[0] / clip[3] + 1.) / 2. * layers.Width - x - 0.5),
          std::abs((clip[1] / clip[3] + 1.) / 2. * layers.Height - y - 0.5) });
        radius = std::max(radius, std::abs(glm::length(p) - 0.945));
      }
    }
    const std::string name = std::string(what) + ", " + relievoTest::ToString(way);
    RELIEVO_CHECK_THAT(layers.Covered() > 400, name + ": the ball is not in the picture");
    RELIEVO_CHECK_AT_MOST(depth, 1e-6, name + ": depth");
    RELIEVO_CHECK_AT_MOST(pixel, 0.01, name + ": position, in pixels");
    RELIEVO_CHECK_AT_MOST(radius, 0.056, name + ": off the ball's facets");
  }
}

void TestProjections()
{
  TestProjection("plain", [](vtkCamera*) {});
  TestProjection("sheared", [](vtkCamera* c) { c->SetViewShear(0.3, -0.2, 1.); });
  TestProjection("sheared, parallel", [](vtkCamera* c) {
    c->ParallelProjectionOn();
    c->SetParallelScale(1.6);
    c->SetViewShear(0.3, -0.2, 1.);
  });
  TestProjection("explicit projection", [](vtkCamera* c) {
    vtkNew<vtkPerspectiveTransform> transform;
    transform->Frustum(-0.6, 0.8, -0.5, 0.4, 2., 14.);
    c->SetExplicitProjectionTransformMatrix(transform->GetMatrix());
    c->UseExplicitProjectionTransformMatrixOn();
  });
  TestProjection("user's view transform", [](vtkCamera* c) {
    vtkNew<vtkTransform> transform;
    transform->Translate(0.3, 0., 0.);
    transform->RotateZ(25.);
    c->SetUserViewTransform(transform);
  });
  TestProjection("user's projection", [](vtkCamera* c) {
    vtkNew<vtkTransform> transform;
    transform->Scale(1.3, 0.8, 1.);
    c->SetUserTransform(transform);
  });
  TestProjection("model transform", [](vtkCamera* c) {
    vtkNew<vtkTransform> transform;
    transform->RotateY(30.);
    c->SetModelTransformMatrix(transform->GetMatrix());
  });
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testWindows)
{
  relievoTest::Session session;
  TestMultisampled();
  TestTiled();
  TestStereo();
  TestRendererLayers();
  TestSharedActors();
  TestImpossibleSizes();
  TestProjections();
  return session.Result();
}
}
