// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of shadows per frame: ratios to the plain frame and to vtkShadowMapPass with maps of the
// same size, drawn in turn in one process: a still scene, a moving light, a moving camera.
#include "RelievoBench.h"

#include "FrameBench.h"
#include "ShadowWays.h"
#include "Table.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;

constexpr int MapSize = 2048;
constexpr int Pixels = 600;
constexpr int Rounds = 21;

struct Way
{
  const char* Name;
  std::function<void(vtkRenderer*)> SetUp;
};

void Attach(vtkRenderer* renderer)
{
  vtkRelievoPass::Attach(renderer);
}

void UseMap(vtkRenderer* renderer)
{
  UseShadowMap(renderer, MapSize);
}

void UseExact(vtkRenderer* renderer)
{
  UseShadowExact(renderer, MapSize);
}

void UsePeer(vtkRenderer* renderer)
{
  UseShadowPeer(renderer, MapSize);
}

constexpr std::size_t Map = 2; // index of the method map
const Way Ways[] = {
  { "plain", nullptr },
  { "attached, shadows off", Attach },
  { "map", UseMap },
  { "exact", UseExact },
  { "vtkShadowMapPass", UsePeer },
};

// A change from frame to frame.
struct Motion
{
  const char* Name;
  std::function<void(const relievoTest::ReferenceScene&, int frame)> Step;
};

const Motion Motions[] = {
  { "still", nullptr },
  { "light moves",
    [](const relievoTest::ReferenceScene& scene, int frame) {
      scene.Light->SetPosition(3. + 0.02 * (frame % 50), 5., 2.);
    } },
  { "camera moves",
    [](const relievoTest::ReferenceScene& scene, int frame) {
      scene.Renderer->GetActiveCamera()->SetPosition(
        2.5 + 2. * std::sin(0.02 * frame), 3., 6. - 2. * (1. - std::cos(0.02 * frame)));
    } },
};

// Cost of each casting light: frame time must not grow faster than their number.
void MeasureLights(const std::string& name, vtkPolyData* mesh, Table& table)
{
  std::vector<std::unique_ptr<SceneWindow>> windows;
  std::vector<Timed> frames;
  const int counts[] = { 0, 1, 2, 4, 8 };
  for (const int count : counts)
  {
    windows.emplace_back(new SceneWindow(mesh, Pixels, Pixels));
    vtkRenderer* renderer = windows.back()->Scene.Renderer;
    UseMap(renderer);
    vtkRelievoShadowStage* shadows = vtkRelievoPass::Attach(renderer)->GetShadowStage();
    shadows->SetLightCasts(windows.back()->Scene.Light, count > 0);
    // Eight lights shine in every frame; `count` of them cast.
    for (int i = 1; i < 8; ++i)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPosition(3. * std::cos(i), 5., 3. * std::sin(i));
      light->SetFocalPoint(0., 0., 0.);
      light->SetIntensity(0.1);
      renderer->AddLight(light);
      shadows->SetLightCasts(light, i < count);
    }
    frames.push_back(windows.back()->Frame());
  }
  std::vector<Timing> times; // by the processor: other work on the machine hardly changes it
  TimeInTurn(frames, Rounds, times);
  std::cout << name << ", eight lights:" << std::endl;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const auto none = PairOf(times[i], times[0]);
    std::cout << "  " << counts[i] << " cast: " << Number(1e3 * times[i].Median(), 3) << " ms, "
              << Number(none.Ratio(), 3) << " +- " << Number(none.RatioSpread(), 1) << " x none"
              << std::endl;
    table.AddRow({ name, "still, eight lights", std::to_string(counts[i]) + " cast",
      Number(1e3 * times[i].Median(), 4), Number(none.Ratio(), 4), Number(none.RatioSpread(), 2),
      "", "", "", "", Number(LoadAverage(), 2) });
  }
}

bool Measure(const std::string& name, vtkPolyData* mesh, const Motion& motion, Table& table)
{
  std::vector<std::unique_ptr<SceneWindow>> windows;
  std::vector<Timed> frames;
  for (const Way& way : Ways)
  {
    windows.emplace_back(new SceneWindow(mesh, Pixels, Pixels));
    SceneWindow* window = windows.back().get();
    if (way.SetUp)
    {
      way.SetUp(window->Scene.Renderer);
    }
    Timed frame = window->Frame();
    if (motion.Step)
    {
      auto count = std::make_shared<int>(0);
      frame.Prepare = [window, &motion, count]() { motion.Step(window->Scene, (*count)++); };
    }
    frames.push_back(frame);
  }
  std::vector<Timing> times; // by the processor: other work on the machine hardly changes it
  TimeInTurn(frames, Rounds, times);
  std::cout << name << ", " << motion.Name << ", plain frame " << Number(1e3 * times[0].Median(), 3)
            << " ms of the processor:" << std::endl;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const auto plain = PairOf(times[i], times[0]);
    const auto map = PairOf(times[i], times[Map]);
    const auto peer = PairOf(times[i], times.back());
    std::cout << "  " << Ways[i].Name << ": " << Number(1e3 * times[i].Median(), 3) << " ms, "
              << Number(plain.Ratio(), 3) << " +- " << Number(plain.RatioSpread(), 1)
              << " x plain, " << Number(peer.Ratio(), 3) << " +- " << Number(peer.RatioSpread(), 1)
              << " x vtkShadowMapPass, " << Number(map.Ratio(), 3) << " +- "
              << Number(map.RatioSpread(), 1) << " x map" << std::endl;
    table.AddRow({ name, motion.Name, Ways[i].Name, Number(1e3 * times[i].Median(), 4),
      Number(plain.Ratio(), 4), Number(plain.RatioSpread(), 2), Number(peer.Ratio(), 4),
      Number(peer.RatioSpread(), 2), Number(map.Ratio(), 4), Number(map.RatioSpread(), 2),
      Number(LoadAverage(), 2) });
  }
  return true;
}
}

//------------------------------------------------------------------------------
int RelievoBenchShadowFrames(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "motion", "frame", "processor ms", "times a plain frame", "+-",
    "times vtkShadowMapPass", "+- of it", "times map", "+- of that", "load" });
  for (const std::string& name : relievoTest::ReferenceMeshes())
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const Motion& motion : Motions)
    {
      if (!Measure(name, mesh, motion, table))
      {
        return 1;
      }
    }
    MeasureLights(name, mesh, table);
  }
  return table.WriteCsv(outDir + "/shadow-frames.csv") ? 0 : 1;
}
