// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the first of each effect costs a frame, alone and in pairs: ratios to the plain frame, drawn
// in turn in one process, with VTK's passes beside them.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "FrameBench.h"
#include "LampWindows.h"
#include "ShadowWays.h"
#include "Table.h"

#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoToneStage.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#if __has_include(<vtkToneMappingPass.h>) // PyVista's VTK leaves the class out
#include <vtkToneMappingPass.h>
#endif

#include <cmath>
#include <cstddef>
#include <ctime>
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

void AddTone(vtkRenderer* renderer)
{
  vtkRelievoPass::Attach(renderer)->GetToneStage()->EnabledOn();
}

// One sphere of fog about the focal point that covers a tenth of the picture.
void AddFog(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double pi = std::acos(-1.);
  const double height =
    2. * camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * pi / 180.);
  const double aspect = renderer->GetTiledAspectRatio();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(camera->GetFocalPoint());
  vtkNew<vtkDoubleArray> radius;
  radius->SetName("radius");
  radius->InsertNextValue(height * std::sqrt(0.1 * aspect / pi));
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(radius);
  vtkNew<vtkRelievoFogSpheres> fog;
  fog->SetInputData(data);
  fog->SetDensity(0.5);
  vtkRelievoPass::Attach(renderer)->GetFogStage()->AddPoints(fog);
}

void AddLamps(vtkRenderer* renderer, int count, double reaching)
{
  vtkNew<vtkRelievoLamps> lamps;
  lamps->SetInputData(MakeLamps(count));
  lamps->SetRadius(RadiusFor(count, reaching));
  auto* stage =
    vtkRelievoLampsStage::SafeDownCast(vtkRelievoPass::Attach(renderer)->GetStage("lamps"));
  stage->AddPoints(lamps);
}

void AddLamp(vtkRenderer* renderer)
{
  AddLamps(renderer, 1, 1.);
}

void AddShadows(vtkRenderer* renderer)
{
  UseShadowMap(renderer, MapSize);
}

void AddLayers(vtkRenderer* renderer)
{
  for (const char* layer : { "depth", "normal", "albedo", "actor", "cell" })
  {
    vtkRelievoPass::Attach(renderer)->RequestLayer(layer);
  }
}

struct Way
{
  const char* Name;
  std::vector<std::function<void(vtkRenderer*)>> SetUp;
};

const std::vector<Way>& Ways()
{
  static const std::vector<Way> ways = {
    { "plain", {} },
    { "attached, nothing asked", { [](vtkRenderer* r) { vtkRelievoPass::Attach(r); } } },
    { "tone", { AddTone } },
    { "fog over a tenth", { AddFog } },
    { "the first lamp", { AddLamp } },
    { "1000 lamps, 1.5 reaching", { [](vtkRenderer* r) { AddLamps(r, 1000, 1.5); } } },
    { "five layers", { AddLayers } },
    { "shadows, still", { AddShadows } },
    { "tone and fog", { AddTone, AddFog } },
    { "tone and a lamp", { AddTone, AddLamp } },
    { "fog and a lamp", { AddFog, AddLamp } },
    { "shadows and tone", { AddShadows, AddTone } },
    { "shadows, tone, fog, a lamp", { AddShadows, AddTone, AddFog, AddLamp } },
#if __has_include(<vtkToneMappingPass.h>)
    { "vtkToneMappingPass", { [](vtkRenderer* renderer) {
       vtkNew<vtkToneMappingPass> tone;
       tone->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
       renderer->SetPass(tone);
     } } },
#endif
    { "vtkShadowMapPass", { [](vtkRenderer* r) { UseShadowPeer(r, MapSize); } } },
  };
  return ways;
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchEffects(const std::string& outDir, const EffectSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "pixels", "frame", "milliseconds", "times a plain frame", "+-",
    "processor ms", "times the plain frame's", "processor +-", "bytes per pixel", "load" });
  for (const std::string& name : sizes.Meshes)
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    std::vector<std::unique_ptr<SceneWindow>> windows;
    std::vector<Timed> frames;
    for (const Way& way : Ways())
    {
      windows.emplace_back(new SceneWindow(mesh, sizes.Width, sizes.Height));
      for (const auto& setUp : way.SetUp)
      {
        setUp(windows.back()->Scene.Renderer);
      }
      frames.push_back(windows.back()->Frame());
    }
    // Processor time as well, of all threads: other work on the machine hardly changes it.
    std::vector<std::vector<double>> processor(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      frames[i].Work = [work = frames[i].Work, &taken = processor[i]]() {
        const std::clock_t begin = std::clock();
        work();
        taken.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      };
    }
    const std::vector<Timing> times = TimeInTurn(frames, sizes.Rounds);
    std::vector<Timing> processors(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      const auto counted = static_cast<std::ptrdiff_t>(times[i].Seconds.size());
      processors[i].Seconds.assign(processor[i].end() - counted, processor[i].end());
    }
    const double pixels = static_cast<double>(sizes.Width) * sizes.Height;
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      const auto pair = PairOf(times[i], times[0]);
      const auto cpu = PairOf(processors[i], processors[0]);
      std::cout << name << ", " << Ways()[i].Name << ": " << pair.ToString("frame", "plain")
                << "; of processor time " << Number(1e3 * processors[i].Median(), 4) << " ms, "
                << Number(cpu.Ratio(), 3) << " +- " << Number(cpu.RatioSpread(), 1) << std::endl;
      auto* pass = vtkRelievoPass::SafeDownCast(windows[i]->Scene.Renderer->GetPass());
      table.AddRow({ name, std::to_string(sizes.Width) + "x" + std::to_string(sizes.Height),
        Ways()[i].Name, Number(1e3 * times[i].Median(), 4), Number(pair.Ratio(), 4),
        Number(pair.RatioSpread(), 2), Number(1e3 * processors[i].Median(), 4),
        Number(cpu.Ratio(), 4), Number(cpu.RatioSpread(), 2),
        Number(pass ? static_cast<double>(pass->GetBytesHeld()) / pixels : 0., 3),
        Number(LoadAverage(), 2) });
    }
  }
  return table.WriteCsv(outDir + "/effects.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchEffects(const std::string& outDir)
{
  return relievoBench::BenchEffects(outDir, {});
}
