// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent props receive shadows, and cast as set; unlit volumes, sky, images and texts stay
// unchanged. With testShadowProps these cases are the rows of docs/shadow-matrix.md about props.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkSkybox.h>
#include <vtkTextActor.h>
#include <vtkTexture.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <string>

namespace testShadowTranslucent
{
namespace
{
using relievoTest::CheckPictures;
using relievoTest::EmbreeScene;
using relievoTest::Picture;
using relievoTest::ShadowPictures;
using relievoTest::ShadowStage;

// Ground or box of glass, with VTK's ways to draw it.
void TestTranslucent()
{
  for (const bool peeling : { false, true })
  {
    const std::string way = peeling ? ", peeled" : ", blended";
    ShadowStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    stage.Renderer->SetUseDepthPeeling(peeling);
    const auto ground = stage.AddGround();
    const auto box = stage.AddBox({ 0.2, 0.8, -0.1 }, { 1.2, 1.6, 0.5 });
    const auto light = relievoTest::AddTwoSuns(stage);
    auto truth = relievoTest::TraceStage(stage, 0);
    vtkRelievoShadowStage* shadows = stage.GetShadows();

    ground->GetProperty()->SetOpacity(0.6);
    CheckPictures("translucent ground" + way, ShadowPictures(stage, light), truth, 3e-4);
    shadows->SetPropCasts(box, vtkRelievoShadowStage::CASTS_NEVER);
    relievoTest::SamePicture(
      ShadowPictures(stage, light).Off, Picture(stage.Window), "a box that casts nothing" + way);
    shadows->SetPropCasts(box, vtkRelievoShadowStage::CASTS_IF_OPAQUE);
    shadows->SetPropReceives(ground, false);
    relievoTest::SamePicture(ShadowPictures(stage, light).Off, Picture(stage.Window),
      "a ground that receives nothing" + way);
    shadows->SetPropReceives(ground, true);
    ground->GetProperty()->SetOpacity(1.);

    box->GetProperty()->SetOpacity(0.5);
    const ShadowPictures glass(stage, light);
    relievoTest::SamePicture(glass.Off, glass.On, "a box of glass" + way);
    shadows->SetPropCasts(box, vtkRelievoShadowStage::CASTS_ALWAYS);
    RELIEVO_CHECK(shadows->GetPropCasts(box) == vtkRelievoShadowStage::CASTS_ALWAYS);
    // Through the box the ground's shadow is seen: only the ground's own pixels are judged.
    EmbreeScene scene;
    scene.AddActors(stage.Renderer);
    const auto view = scene.Trace(relievoTest::View(stage.Renderer));
    for (std::size_t i = 0; i < view.Pixels.size(); ++i)
    {
      if (view.Pixels[i].Actor != 0)
      {
        truth.Verdicts[i] = relievoTest::ShadowTruth::Unjudged;
      }
    }
    CheckPictures("a box of glass that casts" + way, ShadowPictures(stage, light), truth, 3e-4);
  }
}

void AddVolume(ShadowStage& stage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 8);
  image->SetSpacing(0.2, 0.2, 0.2);
  image->SetOrigin(-2.4, 0.6, -0.4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int i = 0; i < 512; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(i * 7 % 256);
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->UseJitteringOff();
  mapper->AutoAdjustSampleDistancesOff();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0., 0., 0., 1.);
  color->AddRGBPoint(255., 1., 1., 0.);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0., 0.);
  opacity->AddPoint(255., 0.2);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  stage.Renderer->AddVolume(volume);
  stage.GetShadows()->SetPropCasts(volume, vtkRelievoShadowStage::CASTS_NEVER);
}

vtkSmartPointer<vtkImageData> MakeSky()
{
  auto sky = vtkSmartPointer<vtkImageData>::New();
  sky->SetDimensions(32, 16, 1);
  sky->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 32 * 16 * 3; ++i)
  {
    static_cast<unsigned char*>(sky->GetScalarPointer())[i] =
      static_cast<unsigned char>(i * 11 % 256);
  }
  return sky;
}

// Props that neither cast nor receive stay unchanged, in front of shadows and beside them.
void TestOthers()
{
  struct
  {
    const char* Name;
    void (*Add)(ShadowStage&);
  } const cases[] = {
    { "a volume without shading, chosen not to cast", AddVolume },
    { "a sky",
      [](ShadowStage& s) {
        vtkNew<vtkTexture> texture;
        texture->SetInputData(MakeSky());
        vtkNew<vtkSkybox> sky;
        sky->SetProjectionToSphere();
        sky->SetTexture(texture);
        s.Renderer->AddActor(sky);
      } },
    { "an image",
      [](ShadowStage& s) {
        vtkNew<vtkImageActor> image;
        image->SetInputData(MakeSky());
        image->SetScale(0.03);
        image->SetPosition(-2., 1.3, 0.5);
        s.Renderer->AddActor(image);
      } },
    { "a text",
      [](ShadowStage& s) {
        vtkNew<vtkTextActor> text;
        text->SetInput("Shadows");
        text->SetPosition(10, 140);
        s.Renderer->AddViewProp(text);
      } },
  };
  for (const auto& test : cases)
  {
    ShadowStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    stage.AddThings();
    const auto light = relievoTest::AddTwoSuns(stage);
    const auto truth = relievoTest::TraceStage(stage, 0);
    const auto without = Picture(stage.Window);
    test.Add(stage);
    const ShadowPictures pictures(stage, light);
    RELIEVO_CHECK_THAT(relievoTest::CountUnlike(without, pictures.Off) > 100,
      std::string(test.Name) + " is not seen");
    CheckPictures(test.Name, pictures, truth, 3e-4);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowTranslucent)
{
  relievoTest::Session session;
  TestTranslucent();
  TestOthers();
  return session.Result();
}
}
