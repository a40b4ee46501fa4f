// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Props that write no layers: volumes, translucent actors, axes, texts, images, skyboxes,
// backgrounds. The picture with them stays as it is, bit for bit, and the layers stay as they are
// without them.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkAnnotatedCubeActor.h>
#include <vtkAxesActor.h>
#include <vtkAxisActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkColorTransferFunction.h>
#include <vtkCornerAnnotation.h>
#include <vtkCubeAxesActor.h>
#include <vtkFollower.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkLegendBoxActor.h>
#include <vtkLegendScaleActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3DFollower.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkScalarBarActor.h>
#include <vtkSkybox.h>
#include <vtkTextActor.h>
#include <vtkTextActor3D.h>
#include <vtkTexture.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#if __has_include(<vtkLeaderActor2D.h>)
#include <vtkLeaderActor2D.h>
#endif

namespace testForeignProps
{
namespace
{
using relievoTest::Layers;
using relievoTest::Picture;
using relievoTest::Stage;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "normal", "albedo", "actor", "cell" };

// The first two actors: with whatever is added later they keep their places.
void Fill(vtkRenderer* renderer)
{
  const auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.7));
  ball->SetPosition(0., 0.7, 0.);
  ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
  const auto box = relievoTest::AddActor(renderer, relievoTest::MakeBox(2., 0.2, 2.));
  box->GetProperty()->SetColor(0.3, 0.5, 0.8);
  renderer->SetBackground(0.1, 0.2, 0.3);
}

vtkSmartPointer<vtkImageData> MakeImage(int dimension, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 8, dimension == 3 ? 8 : 1);
  image->SetSpacing(0.15, 0.15, 0.15);
  image->SetOrigin(-0.5, 0.6, 0.8);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int z = 0; z < (dimension == 3 ? 8 : 1); ++z)
  {
    for (int y = 0; y < 8; ++y)
    {
      for (int x = 0; x < 8; ++x)
      {
        for (int c = 0; c < components; ++c)
        {
          image->SetScalarComponentFromDouble(
            x, y, z, c, (x * 30 + y * 20 + z * 10 + c * 40) % 256);
        }
      }
    }
  }
  return image;
}

void AddVolume(vtkRenderer* renderer)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(MakeImage(3, 1));
  mapper->UseJitteringOff();
  mapper->AutoAdjustSampleDistancesOff();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0., 0., 0., 1.);
  color->AddRGBPoint(255., 1., 1., 0.);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0., 0.1);
  opacity->AddPoint(255., 0.6);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  renderer->AddVolume(volume);
}

void AddGlass(vtkRenderer* renderer)
{
  const auto glass = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.5));
  glass->SetPosition(0.5, 0.8, 1.2);
  glass->GetProperty()->SetOpacity(0.4);
}

void AddForcedOpaque(vtkRenderer* renderer)
{
  // Nothing of it is translucent but its wish.
  const auto ball = relievoTest::AddActor(renderer, relievoTest::MakeBall(0.3));
  ball->SetPosition(0.5, 0.8, 1.2);
  ball->ForceTranslucentOn();
}

void AddAxes(vtkRenderer* renderer)
{
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(1.5, 1.5, 1.5);
  axes->AxisLabelsOff();
  renderer->AddActor(axes);
}

void AddCubeAxes(vtkRenderer* renderer)
{
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(-1., 1., -0.1, 1.4, -1., 1.);
  axes->SetCamera(renderer->GetActiveCamera());
  axes->DrawXGridlinesOn();
  renderer->AddActor(axes);
}

void AddScalarBar(vtkRenderer* renderer)
{
  vtkNew<vtkLookupTable> table;
  table->Build();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetTitle("bar");
  renderer->AddViewProp(bar);
}

// Its leader is a line among the opaque geometry.
void AddCaption(vtkRenderer* renderer)
{
  vtkNew<vtkCaptionActor2D> caption;
  caption->SetCaption("caption");
  caption->SetAttachmentPoint(0., 0.7, 0.75);
  caption->LeaderOn();
  caption->ThreeDimensionalLeaderOn();
  caption->GetProperty()->SetColor(1., 0., 0.);
  renderer->AddActor(caption);
}

// Drawn before the surfaces behind it.
void AddCaptionFirst(vtkRenderer* renderer)
{
  vtkSmartPointer<vtkProp> box = renderer->GetViewProps()->GetLastProp();
  renderer->RemoveViewProp(box);
  vtkSmartPointer<vtkProp> ball = renderer->GetViewProps()->GetLastProp();
  renderer->RemoveViewProp(ball);
  AddCaption(renderer);
  renderer->AddViewProp(ball);
  renderer->AddViewProp(box);
}

void AddAxis(vtkRenderer* renderer)
{
  vtkNew<vtkAxisActor> axis;
  axis->SetPoint1(-1., 0.5, 0.9);
  axis->SetPoint2(1., 0.9, 0.9);
  axis->SetBounds(-1., 1., -0.1, 1.4, -1., 1.);
  axis->SetCamera(renderer->GetActiveCamera());
  axis->SetTickLocationToBoth();
  renderer->AddActor(axis);
}

void AddBox2D(vtkRenderer* renderer)
{
  vtkNew<vtkLegendBoxActor> legend;
  legend->SetNumberOfEntries(1);
  legend->SetEntryString(0, "box");
  renderer->AddViewProp(legend);
  vtkNew<vtkCornerAnnotation> corner;
  corner->SetText(0, "corner");
  renderer->AddViewProp(corner);
#if __has_include(<vtkLeaderActor2D.h>)
  vtkNew<vtkLeaderActor2D> leader;
  leader->SetLabel("leader");
  renderer->AddViewProp(leader);
#endif
}

void AddTexts(vtkRenderer* renderer)
{
  vtkNew<vtkTextActor> text;
  text->SetInput("text");
  text->SetPosition(20, 20);
  renderer->AddViewProp(text);
  vtkNew<vtkTextActor3D> text3D;
  text3D->SetInput("3D");
  text3D->SetScale(0.02);
  text3D->SetPosition(-0.6, 0.8, 0.9);
  renderer->AddActor(text3D);
}

void AddBillboard(vtkRenderer* renderer)
{
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("billboard");
  text->SetPosition(0.3, 0.9, 0.9);
  renderer->AddActor(text);
}

void AddImage(vtkRenderer* renderer)
{
  vtkNew<vtkImageActor> actor;
  actor->SetInputData(MakeImage(2, 3));
  renderer->AddActor(actor);
}

void AddSkybox(vtkRenderer* renderer)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputData(MakeImage(2, 3));
  texture->MipmapOn();
  texture->InterpolateOn();
  vtkNew<vtkSkybox> sky;
  sky->SetProjectionToSphere();
  sky->SetTexture(texture);
  renderer->AddActor(sky);
}

void AddFollower(vtkRenderer* renderer)
{
  vtkNew<vtkProp3DFollower> follower;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(relievoTest::MakeBox(0.3, 0.3, 0.1));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  follower->SetProp3D(actor);
  follower->SetCamera(renderer->GetActiveCamera());
  follower->SetPosition(-0.8, 0.9, 0.5);
  renderer->AddViewProp(follower);
}

void SetGradient(vtkRenderer* renderer)
{
  renderer->GradientBackgroundOn();
  renderer->SetBackground2(0.9, 0.8, 0.7);
}

void SetTexturedBackground(vtkRenderer* renderer)
{
  renderer->SetBackgroundTexture(relievoTest::MakeChecker(false));
  renderer->TexturedBackgroundOn();
}

struct Case
{
  const char* Name;
  void (*Add)(vtkRenderer*);
  bool Shares; // nothing of it is opaque geometry without layers
};

const Case Cases[] = {
  { "volume", AddVolume, true },
  { "translucent actor", AddGlass, true },
  { "actor forced translucent", AddForcedOpaque, true },
  { "axes", AddAxes, false },
  { "cube axes", AddCubeAxes, false },
  { "scalar bar", AddScalarBar, true },
  { "caption with a leader", AddCaption, false },
  { "caption with a leader, first", AddCaptionFirst, false },
  { "annotated cube", [](vtkRenderer* r) { r->AddActor(vtkNew<vtkAnnotatedCubeActor>()); }, false },
  { "axis", AddAxis, false },
  { "legend scale", [](vtkRenderer* r) { r->AddActor(vtkNew<vtkLegendScaleActor>()); }, false },
  { "legend box, corners, leader", AddBox2D, true },
  { "texts", AddTexts, false },
  { "billboard text", AddBillboard, false },
  { "image", AddImage, false },
  { "skybox", AddSkybox, false },
  { "prop follower", AddFollower, false },
  { "gradient background", SetGradient, true },
  { "textured background", SetTexturedBackground, true },
};

void Test(const Case& c, bool peeling)
{
  const Stage stage(200, 140);
  Fill(stage.Renderer);
  stage.Renderer->SetUseDepthPeeling(peeling);
  const Layers plain(stage.Renderer, Names);
  c.Add(stage.Renderer);
  const std::string what = std::string(c.Name) + (peeling ? ", depth peeling" : "");
  const auto before = Picture(stage.Window);
  const relievoTest::GLCheck gl(stage.Window);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", drawn twice");
  const Layers alone(stage.Renderer, Names);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", after a capture");
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  for (int i = 0; i < 2; ++i)
  {
    relievoTest::SamePicture(before, Picture(stage.Window), what + ", with layers");
    RELIEVO_CHECK_THAT(frame->GetLayersStage()->GetShared() == c.Shares,
      what + ": not made as expected: " + frame->GetFrameReport());
    vtkNew<vtkImageData> image;
    for (const std::string& name : Names)
    {
      RELIEVO_CHECK(frame->ReadLayer(name, image));
    }
    const Layers beside(image);
    for (const std::string& name : Names)
    {
      const std::string layer = what + ": pixels of " + name;
      RELIEVO_CHECK_AT_MOST(
        relievoTest::CountDifferent(plain, beside, name), 0, layer + " beside the picture");
      RELIEVO_CHECK_AT_MOST(
        relievoTest::CountDifferent(plain, alone, name), 0, layer + " without the picture");
    }
  }
  vtkRelievoPass::Detach(stage.Renderer);
  relievoTest::SamePicture(before, Picture(stage.Window), what + ", detached");
}

// A vtkFollower is an actor, and turns to the eye in the layers as in the picture.
void TestFollower()
{
  const Stage stage(160, 120);
  vtkNew<vtkFollower> follower;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(relievoTest::MakeSquare());
  follower->SetMapper(mapper);
  follower->SetCamera(stage.Renderer->GetActiveCamera());
  follower->SetPosition(0., 0.5, 0.);
  stage.Renderer->AddActor(follower);
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "normal", "actor" }, way);
    // It faces the eye: one depth, one normal along the line of sight.
    double low = 1e9;
    double high = 0.;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const double depth = layers.Value("depth", x, y);
        if (std::isfinite(depth))
        {
          low = std::min(low, depth);
          high = std::max(high, depth);
        }
      }
    }
    RELIEVO_CHECK(layers.Covered() > 1000 && layers.CountId("actor", 0) == layers.Covered());
    RELIEVO_CHECK_AT_MOST(high - low, 1e-5, "follower: spread of the depth");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testForeignProps)
{
  relievoTest::Session session;
  for (const Case& c : Cases)
  {
    Test(c, false);
  }
  for (int i = 0; i < 3; ++i)
  {
    Test(Cases[i], true);
  }
  TestFollower();
  return session.Result();
}
}
