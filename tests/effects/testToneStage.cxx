// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoToneStage against the formulas in double, on known light: operators, exposure, white,
// invalid pixels, alpha, and the automatic exposure against the log-average of the pixels.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "ToneScene.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkRelievoLayerSource.h>

#include <limits>
#include <string>

namespace testToneStage
{
namespace
{
using relievoTest::IsSame;
using relievoTest::PaintStage;
using relievoTest::SrgbFromLinear;
using relievoTest::ToneScene;

// The nearest step, but for the last bits of float.
constexpr double Rounding = 0.501;

void TestOperators()
{
  ToneScene scene(64, 48);
  relievoTest::GLCheck gl(scene.Window);
  scene.PaintLight();
  for (int which = 0; which <= vtkRelievoToneStage::NEUTRAL; ++which)
  {
    for (const double white : { 0.5, 4. })
    {
      for (const double stops : { -3., 0.5 })
      {
        scene.Tone->SetOperator(which);
        scene.Tone->SetWhite(white);
        scene.Tone->SetExposure(stops);
        const auto picture = scene.Picture();
        RELIEVO_CHECK(scene.Tone->GetReasonCode() == "ran");
        RELIEVO_CHECK_AT_MOST(scene.GetError(picture), Rounding,
          scene.Tone->GetParameter("operator") + ", white " + std::to_string(white) + ", stops " +
            std::to_string(stops) + ", steps of 255");
      }
    }
  }
  gl.Poll("operators");
}

// Light as bright as white is white; colours keep their hue; the layer is unchanged.
void TestWhiteAndLayer()
{
  ToneScene scene(4, 2);
  scene.Tone->SetOperatorToReinhard();
  scene.Tone->SetWhite(8.0);
  auto& pixels = scene.Paint->Pixels;
  pixels = { { 8, 8, 8, 1 }, { 9, 9, 9, 1 }, { 7.5, 7.5, 7.5, 1 }, { 65504, 65504, 65504, 1 },
    { 2, 1, 0, 1 }, { 6, 3, 0, 1 }, { 0, 0, 40, 1 }, { 0, 0, 0, 1 } };
  scene.Frame->RequestLayer("color");
  const auto picture = scene.Picture();
  const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  const auto isGrey = [bytes](int i, int value) {
    return bytes[4 * i] == value && bytes[4 * i + 1] == value && bytes[4 * i + 2] == value;
  };
  RELIEVO_CHECK(isGrey(0, 255) && isGrey(1, 255) && isGrey(3, 255) && isGrey(7, 0));
  RELIEVO_CHECK(bytes[8] < 255);
  // Orange: the middle component stays in the middle, in linear light.
  for (const int i : { 4, 5 })
  {
    const auto linear = [bytes, i](int c) {
      return relievo::f64::relievoLinearFromSrgb(bytes[4 * i + c] / 255.);
    };
    RELIEVO_CHECK_NEAR(
      (linear(1) - linear(2)) / (linear(0) - linear(2)), 0.5, 0.01, "hue of orange");
  }
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(scene.Frame->ReadLayer("color", image));
  for (vtkIdType i = 0; i < 8; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      RELIEVO_CHECK(image->GetPointData()->GetArray("color")->GetComponent(i, c) == pixels[i][c]);
    }
  }
  // So it is for captures that are not of HDR, which have the window's picture otherwise.
  scene.Frame->ReleaseLayers();
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(scene.Renderer);
  source->AddLayer("color");
  source->Update();
  vtkDataArray* color = source->GetOutput()->GetPointData()->GetArray("color");
  RELIEVO_CHECK(color && color->GetComponent(0, 0) == 8. && color->GetComponent(6, 2) == 40.);
  RELIEVO_CHECK(!scene.Frame->IsLayerRequested("color"));
  RELIEVO_CHECK(IsSame(picture, scene.Picture()));
  scene.Tone->EnabledOff();
  source->Update();
  color = source->GetOutput()->GetPointData()->GetArray("color");
  RELIEVO_CHECK(color && color->GetComponent(0, 0) == 1.);
}

// Invalid light stays a single pixel, not a stain.
// The colour before tone, as the picture: by the sRGB curve alone, clamped, or brought into range.
void TestShownColor()
{
  ToneScene scene(64, 48);
  relievoTest::GLCheck gl(scene.Window);
  scene.PaintLight();
  scene.Paint->Pixels[5] = glm::vec4(0.f, 0.f, 0.f, 1.f);
  scene.Renderer->SetBackground(1., 0., 1.);
  scene.Tone->SetExposure(-2.);
  scene.Frame->SetDisplayLayer("color");
  for (const double most : { 1., 16. })
  {
    scene.Frame->SetDisplayRange(0., most);
    const auto picture = scene.Picture();
    RELIEVO_CHECK(scene.Tone->GetReasonCode() == "hidden");
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    double error = 0.;
    for (std::size_t i = 0; i < scene.Paint->Pixels.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double light = std::min(1., PaintStage::GetHalf(scene.Paint->Pixels[i][c]) / most);
        error = std::max(error, std::abs(bytes[4 * i + c] - 255. * SrgbFromLinear(light)));
      }
    }
    RELIEVO_CHECK_AT_MOST(error, Rounding, "the colour before tone");
  }
}

void TestBadPixels()
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  ToneScene scene(40, 30);
  relievoTest::GLCheck gl(scene.Window);
  scene.Paint->Fill(40, 30, glm::vec4(0.3f, 0.2f, 0.7f, 1.f));
  for (const bool automatic : { false, true })
  {
    for (const int dither : { 0, 1, 2 })
    {
      scene.Tone->SetAutoExposure(automatic);
      scene.Tone->SetDither(dither);
      glm::vec4& pixel = scene.Paint->Pixels[17 * 40 + 21];
      const glm::vec4 good = pixel;
      const auto clean = scene.Picture();
      const double exposure = scene.Tone->GetUsedExposure();
      const auto* before = static_cast<unsigned char*>(clean->GetScalarPointer());
      for (const float bad : { nan, infinity, -infinity, -0.5f })
      {
        for (const int c : { 0, 1, 2, 3 })
        {
          const std::string what = std::to_string(bad) + ", component " + std::to_string(c);
          pixel[c] = bad;
          const auto picture = scene.Picture();
          const auto* after = static_cast<unsigned char*>(picture->GetScalarPointer());
          int apart = 0;
          for (int i = 0; i < 40 * 30; ++i)
          {
            apart += std::memcmp(before + 4 * i, after + 4 * i, 4) != 0 && i != 17 * 40 + 21;
          }
          RELIEVO_CHECK_THAT(apart == 0, what + ": " + std::to_string(apart) + " other pixels");
          RELIEVO_CHECK_NEAR(scene.Tone->GetUsedExposure(), exposure, 1e-6, what + ", exposure");
          if (c < 3)
          {
            const int shown = after[4 * (17 * 40 + 21) + c];
            // An infinity is bright, and so are values mixed with it; NaN is black.
            RELIEVO_CHECK_THAT(bad == infinity ? shown == 255 : shown == 0, what);
          }
          pixel = good;
        }
      }
    }
  }
  gl.Poll("bad pixels");
}

void TestAlpha()
{
  ToneScene scene(32, 32);
  scene.PaintLight();
  std::mt19937 random(8);
  std::uniform_real_distribution<float> unit(0.f, 1.f);
  for (glm::vec4& pixel : scene.Paint->Pixels)
  {
    const float alpha = unit(random);
    pixel = glm::vec4(alpha * pixel.r, alpha * pixel.g, alpha * pixel.b, alpha);
  }
  scene.Paint->Pixels[0] = glm::vec4(0.f);
  const auto checkAlpha = [&scene](vtkImageData* picture) {
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    double most = 0.;
    for (std::size_t i = 0; i < scene.Paint->Pixels.size(); ++i)
    {
      most = std::max(
        most, std::abs(bytes[4 * i + 3] - 255. * PaintStage::GetHalf(scene.Paint->Pixels[i].a)));
    }
    RELIEVO_CHECK_AT_MOST(most, Rounding, "alpha, steps of 255");
  };
  for (const int which : { 1, 2, 3, 4 })
  {
    scene.Tone->SetOperator(which);
    // Over black the colour is premultiplied; over white of alpha 0 it is the visible colour.
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    auto picture = scene.Picture();
    RELIEVO_CHECK_AT_MOST(scene.GetError(picture, true), Rounding, "over black");
    RELIEVO_CHECK(scene.GetError(picture, false) > 10.);
    checkAlpha(picture);
    scene.Renderer->SetBackground(1.0, 1.0, 1.0);
    picture = scene.Picture();
    RELIEVO_CHECK_AT_MOST(scene.GetError(picture, false), Rounding, "over white");
    RELIEVO_CHECK(scene.GetError(picture, true) > 10.);
    checkAlpha(picture);
  }
}

void TestAutoExposure()
{
  const int sizes[][2] = { { 1, 1 }, { 3, 1 }, { 61, 47 }, { 64, 64 }, { 65, 513 } };
  for (const auto& size : sizes)
  {
    ToneScene scene(size[0], size[1]);
    relievoTest::GLCheck gl(scene.Window);
    const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]);
    scene.PaintLight();
    scene.Tone->AutoExposureOn();
    scene.Tone->SetExposure(0.5);
    auto& pixels = scene.Paint->Pixels;
    for (const bool half : { false, true })
    {
      // Every other pixel has nothing, and every third is black: that counts as little light.
      double sum = 0.;
      int count = 0;
      for (std::size_t i = 0; i < pixels.size(); ++i)
      {
        pixels[i].a = half && i % 2 == 1 ? 0.f : 1.f;
        const float light = i % 3 == 2 ? 0.f : 1.f;
        pixels[i] =
          glm::vec4(light * pixels[i].r, light * pixels[i].g, light * pixels[i].b, pixels[i].a);
        if (pixels[i].a > 0.f)
        {
          const double luminance = 0.2126 * PaintStage::GetHalf(pixels[i].r) +
            0.7152 * PaintStage::GetHalf(pixels[i].g) + 0.0722 * PaintStage::GetHalf(pixels[i].b);
          sum += std::log2(std::max(luminance, 1. / 255. / 12.92));
          ++count;
        }
      }
      const auto picture = scene.Picture();
      const double expected = 0.5 + std::log2(0.18) - sum / count;
      RELIEVO_CHECK_NEAR(scene.Tone->GetUsedExposure(), expected, 2e-5, what + ", stops");
      RELIEVO_CHECK_AT_MOST(scene.GetError(picture), Rounding, what + ", steps of 255");
      RELIEVO_CHECK(scene.Frame->GetBytesHeld() > 0);
    }
    gl.Poll(what);
  }
}

// Auto exposure does not depend on earlier frames; in an empty picture, it is of all pixels.
void TestAutoExposureIsOfThisFrame()
{
  ToneScene scene(50, 40);
  scene.Tone->AutoExposureOn();
  scene.PaintLight(3);
  const auto first = scene.Picture();
  scene.Paint->Fill(50, 40, glm::vec4(900.f, 900.f, 900.f, 1.f));
  scene.Picture();
  RELIEVO_CHECK_NEAR(scene.Tone->GetUsedExposure(), std::log2(0.18 / 900.), 1e-5, "bright");
  scene.PaintLight(3);
  RELIEVO_CHECK(IsSame(first, scene.Picture()));
  scene.Paint->Fill(50, 40, glm::vec4(0.02f, 0.02f, 0.02f, 0.f));
  scene.Picture();
  const double light = PaintStage::GetHalf(0.02);
  RELIEVO_CHECK_NEAR(scene.Tone->GetUsedExposure(), std::log2(0.18 / light), 1e-5, "nothing drawn");
  // A capture that needs no tone leaves the picture's.
  vtkNew<vtkRelievoLayerSource> layers;
  layers->SetRenderer(scene.Renderer);
  layers->AddLayer("depth");
  layers->Update();
  RELIEVO_CHECK_NEAR(scene.Tone->GetUsedExposure(), std::log2(0.18 / light), 1e-5, "captured");
  scene.Tone->EnabledOff();
  scene.Picture();
  RELIEVO_CHECK(std::isnan(scene.Tone->GetUsedExposure()));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testToneStage)
{
  relievoTest::Session session;
  TestOperators();
  TestWhiteAndLayer();
  TestShownColor();
  TestBadPixels();
  TestAlpha();
  TestAutoExposure();
  TestAutoExposureIsOfThisFrame();
  return session.Result();
}
}
