// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ToneScene.h
 * @brief A frame with the stage `tone` whose linear colour is painted, and its expected picture by
 * the formulas in double.
 */
#ifndef relievoTestToneScene_h
#define relievoTestToneScene_h

#include "ImageCompare.h"
#include "PaintStage.h"
#include "Window.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoToneStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace relievoTest
{
struct ToneScene
{
  int Size[2];
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkRelievoPass* Frame;
  vtkNew<PaintStage> Paint;
  vtkRelievoToneStage* Tone;

  ToneScene(int width, int height)
    : Size{ width, height }
  {
    this->Window = MakeWindow(width, height, this->Renderer);
    this->Window->SetAlphaBitPlanes(1);
    this->Frame = vtkRelievoPass::Attach(this->Renderer);
    this->Frame->AddStage(this->Paint);
    this->Paint->Fill(width, height, glm::vec4(0.5f, 0.5f, 0.5f, 1.f));
    this->Tone = vtkRelievoToneStage::SafeDownCast(this->Frame->GetStage("tone"));
    this->Tone->EnabledOn();
  }

  /** Light from 2^-12 to 2^10, independent for each component. */
  void PaintLight(unsigned int seed = 3)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> stops(-12.f, 10.f);
    for (glm::vec4& pixel : this->Paint->Pixels)
    {
      pixel = glm::vec4(
        std::exp2(stops(random)), std::exp2(stops(random)), std::exp2(stops(random)), 1.f);
    }
  }

  vtkSmartPointer<vtkImageData> Picture() { return relievoTest::Picture(this->Window, true); }

  /** The expected value of a component of the picture, in steps of 255 before rounding. */
  glm::dvec3 GetExpected(const glm::vec4& painted, bool premultiplied = true)
  {
    const double alpha = PaintStage::GetHalf(painted.a);
    const double cover = premultiplied && alpha > 0. && alpha < 1. ? alpha : 1.;
    const glm::dvec3 half(PaintStage::GetHalf(painted.r), PaintStage::GetHalf(painted.g),
      PaintStage::GetHalf(painted.b));
    const glm::dvec3 light = relievo::f64::relievoToneClean(half / cover);
    const double factor = std::exp2(this->Tone->GetUsedExposure());
    const glm::dvec3 shown =
      relievo::f64::relievoTone(this->Tone->GetOperator(), factor * light, this->Tone->GetWhite());
    return 255. * relievo::f64::relievoSrgbColorFromLinear(cover * shown);
  }

  /** The largest error of a component, in steps of 255. */
  double GetError(vtkImageData* picture, bool premultiplied = true)
  {
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    double most = 0.;
    for (std::size_t i = 0; i < this->Paint->Pixels.size(); ++i)
    {
      const glm::dvec3 expected = this->GetExpected(this->Paint->Pixels[i], premultiplied);
      for (int c = 0; c < 3; ++c)
      {
        most = std::max(most, std::abs(bytes[4 * i + c] - expected[c]));
      }
    }
    return most;
  }
};
}

#endif
