// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner's promise over many cases: scenes, lights, windows and tolerances. In at least 95 %
// of them the share of wrong pixels, against Embree, is at most 1.5 times the tolerance; in none is
// it more than 3 times. The windows are small, so that this takes half a minute.
#include "Check.h"
#include "EmbreeScene.h"
#include "Layers.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPointData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace testShadowPlannerCases
{
namespace
{
using Pass = vtkRelievoShadowStage;
using relievoTest::SceneLight;
using relievoTest::ShadowStage;

const double Tolerances[] = { 4e-3, 2e-3, 1e-3, 4e-4, 5e-5 };
const std::array<int, 2> Windows[] = { { 560, 420 }, { 700, 394 }, { 350, 630 } };

struct Cases
{
  int Count = 0;
  int Over = 0; // 1.5 times
  double Worst = 0.;
  std::map<int, int> Methods;

  void Judge(vtkRenderer* renderer, const std::string& what)
  {
    vtkRenderWindow* window = renderer->GetRenderWindow();
    auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
    vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
    Pass* shadows = frame->GetShadowStage();
    frame->ShadowsOn();
    relievoTest::EmbreeScene scene;
    scene.AddActors(renderer);
    const relievoTest::ShadowTruth truth =
      relievoTest::TraceShadow(scene, scene.Trace(relievoTest::View(renderer)), light);
    for (const double tolerance : Tolerances)
    {
      shadows->SetTolerance(tolerance);
      window->Render();
      const relievoTest::Layers layers(renderer, { "shadow_0" });
      auto* drawn = vtkFloatArray::SafeDownCast(layers.Image->GetPointData()->GetArray("shadow_0"));
      const auto errors = relievoTest::CompareShadow(truth, drawn->GetPointer(0));
      const double times = errors.Wrong() / tolerance;
      std::cout << what << ": " << shadows->GetPlan() << "; " << times << " times; "
                << errors.ToString() << std::endl;
      RELIEVO_CHECK_THAT(errors.Compared > 5000, what + ": too little is compared");
      RELIEVO_CHECK_THAT(
        shadows->GetPlan().find("not met") == std::string::npos, what + ": " + shadows->GetPlan());
      ++this->Count;
      this->Over += times > 1.5 ? 1 : 0;
      this->Worst = std::max(this->Worst, times);
      ++this->Methods[shadows->GetMethodUsed()];
    }
    vtkRelievoPass::Detach(renderer);
  }
};

void JudgeMeshes(Cases& cases)
{
  std::vector<std::string> names = relievoTest::ReferenceMeshes();
  for (const std::string& other : relievoTest::OtherMeshes())
  {
    names.push_back(other);
  }
  const SceneLight kinds[] = { SceneLight::Sun, SceneLight::Spot, SceneLight::Point };
  const char* words[] = { "sun", "spot", "point" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      const std::size_t kind = (i + k) % 3;
      const auto scene = relievoTest::MakeReferenceScene(names[i], kinds[kind]);
      if (!scene.IsValid())
      {
        return;
      }
      const auto& size = Windows[(i + 2 * k) % 3];
      const auto window = relievoTest::MakeWindow(size[0], size[1], scene.Renderer);
      cases.Judge(scene.Renderer, names[i] + ", " + words[kind]);
    }
  }
}

void JudgeStages(Cases& cases)
{
  for (int light = 0; light < 4; ++light)
  {
    const auto& size = Windows[light % 3];
    ShadowStage stage(size[0], size[1]);
    stage.AddThings();
    stage.AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
    switch (light)
    {
      case 0:
        stage.AddSun(-3., 4., -2.);
        break;
      case 1:
        stage.AddSun(-3., 0.6, -2.);
        break;
      case 2:
        stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 40.);
        break;
      default:
        stage.AddLamp({ -1., 2.5, -1.5 }, { 0., 0., 0. }, 90.);
    }
    cases.Judge(stage.Renderer, "things, light " + std::to_string(light));
  }
  ShadowStage poles(700, 394);
  poles.AddPolesToHorizon();
  cases.Judge(poles.Renderer, "poles");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowPlannerCases)
{
  relievoTest::Session session;
  Cases cases;
  JudgeStages(cases);
  JudgeMeshes(cases);
  std::cout << cases.Count << " cases: " << cases.Methods[Pass::METHOD_MAP] << " map, "
            << cases.Methods[Pass::METHOD_WARPED] << " warped, "
            << cases.Methods[Pass::METHOD_EXACT] << " exact\n";
  RELIEVO_CHECK_THAT(cases.Count >= 50, std::to_string(cases.Count) + " cases");
  RELIEVO_CHECK_THAT(4 * cases.Methods[Pass::METHOD_EXACT] < 3 * cases.Count &&
      cases.Methods[Pass::METHOD_EXACT] > 0,
    "one method for nearly all");
  RELIEVO_CHECK_AT_MOST(
    static_cast<double>(cases.Over) / cases.Count, 0.05, "share of cases over 1.5 times");
  RELIEVO_CHECK_AT_MOST(cases.Worst, 3., "the worst, times the tolerance");
  return session.Result();
}
}
