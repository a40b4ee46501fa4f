// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The verdicts of exact shadows on the real meshes against Embree: every kind of light, any window
// shape, Phong and PBR.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowPass.h>

#include <chrono>
#include <iostream>

namespace
{
using relievoTest::Layers;
using relievoTest::SceneLight;

constexpr double Limit = 2e-5;
const int Sizes[][2] = { { 600, 600 }, { 800, 450 }, { 400, 1600 } };

const float* Visibility(const Layers& layers)
{
  return vtkFloatArray::SafeDownCast(layers.Image->GetPointData()->GetArray("shadow_0"))
    ->GetPointer(0);
}

double Time(vtkRenderWindow* window)
{
  window->Render();
  double best = 1e9;
  for (int i = 0; i < 5; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    window->Render();
    window->WaitForCompletion();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return 1e3 * best;
}

void Test(const std::string& mesh, SceneLight kind, const std::string& name)
{
  const auto scene = relievoTest::MakeReferenceScene(mesh, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(600, 600, scene.Renderer);
  relievoTest::GLCheck gl(window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->GetShadowPass()->SetMethodToExact();
  const auto truth = scene.MakeTruth();
  for (const auto& size : Sizes)
  {
    window->SetSize(size[0], size[1]);
    window->Render();
    const auto view = truth->Trace(relievoTest::View(scene.Renderer));
    const auto shadow = relievoTest::TraceShadow(*truth, view, scene.Light);
    const std::string what =
      mesh + ", " + name + ", " + std::to_string(size[0]) + " x " + std::to_string(size[1]);
    const Layers phong(scene.Renderer, { "shadow_0" });
    const auto errors = relievoTest::CompareShadow(shadow, Visibility(phong));
    std::cout << what << ": " << errors.ToString() << std::endl;
    RELIEVO_CHECK_THAT(errors.Compared > 10000 && errors.Dark > 1000, what + ": what is compared");
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), Limit, what + ": share of wrong verdicts");
    if (getenv("TIMES"))
    {
      const double plain = Time(window);
      frame->ShadowsOn();
      const double exact = Time(window);
      frame->GetShadowPass()->SetMethodToMap();
      const double map = Time(window);
      frame->GetShadowPass()->SetMethodToExact();
      std::cout << "   plain " << plain << " ms, map " << map << ", exact " << exact << ", bytes " << frame->GetShadowPass()->GetBytesHeld() << " " << frame->GetShadowPass()->GetReason() << "\n";
      frame->ShadowsOff();
      continue;
    }
  }
  gl.Poll(mesh);
  vtkRelievoPass::Detach(scene.Renderer);
}
}

//------------------------------------------------------------------------------
int main()
{
  relievoTest::Session session;
  for (const std::string& mesh : relievoTest::ReferenceMeshes())
  {
    Test(mesh, SceneLight::Sun, "sun");
    Test(mesh, SceneLight::Spot, "spot");
    Test(mesh, SceneLight::Point, "point");
  }
  return session.Result();
}
