// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of the first of each effect per frame, alone and in pairs: ratios to the plain frame, drawn
// in turn in one process, beside VTK's passes. On a GPU, its own time is also measured.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "FrameBench.h"
#include "LampWindows.h"
#include "Rounds.h"
#include "ShadowWays.h"
#include "Table.h"
#include "vtkRelievoSoftwareOpenGL.h"

#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkOpenGLError.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoToneStage.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#if __has_include(<vtkToneMappingPass.h>) // missing in cvista
#include <vtkToneMappingPass.h>
#endif

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
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

// One sphere of fog around the focal point that covers a tenth of the picture.
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

// Measures frames by a GPU's own clock. That clock also runs while the GPU waits for commands; so
// the GPU gets other work first, during which the processor sends the whole frame.
class GpuClock
{
public:
  explicit GpuClock(vtkRenderWindow* window)
    : Window(window)
  {
    window->MakeCurrent();
    glCreateTextures(GL_TEXTURE_2D, 1, &this->Texture);
    glTextureStorage2D(this->Texture, 1, GL_RGBA32F, Side, Side);
    glCreateQueries(GL_TIMESTAMP, 2, this->Queries);
  }
  GpuClock(const GpuClock&) = delete;
  void operator=(const GpuClock&) = delete;
  ~GpuClock()
  {
    this->Window->MakeCurrent();
    glDeleteTextures(1, &this->Texture);
    glDeleteQueries(2, this->Queries);
  }

  double SecondsOfFrame()
  {
    this->Window->MakeCurrent();
    for (int i = 0; i < Clears; ++i)
    {
      glClearTexImage(this->Texture, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    glQueryCounter(this->Queries[0], GL_TIMESTAMP);
    this->Window->Render();
    glQueryCounter(this->Queries[1], GL_TIMESTAMP);
    GLuint64 times[2];
    glGetQueryObjectui64v(this->Queries[0], GL_QUERY_RESULT, &times[0]);
    glGetQueryObjectui64v(this->Queries[1], GL_QUERY_RESULT, &times[1]);
    return 1e-9 * static_cast<double>(times[1] - times[0]);
  }

private:
  static constexpr int Side = 4096; // 256 MiB
  static constexpr int Clears = 5;  // some twenty milliseconds on an H100
  vtkRenderWindow* Window;
  GLuint Texture = 0;
  GLuint Queries[2] = {};
};

// Medians of the GPU's own frame times, in milliseconds; NaN for software OpenGL: llvmpipe takes
// timestamps when it draws tiles, not in the order of commands.
std::vector<double> GpuMilliseconds(
  const std::vector<std::unique_ptr<SceneWindow>>& windows, int rounds)
{
  std::vector<double> medians(windows.size(), std::numeric_limits<double>::quiet_NaN());
  windows.front()->Window->MakeCurrent();
  if (vtkRelievoIsSoftwareOpenGL())
  {
    return medians;
  }
  for (std::size_t i = 0; i < windows.size(); ++i) // already drawn once
  {
    GpuClock clock(windows[i]->Window);
    Timing timing;
    for (int round = 0; round < rounds; ++round)
    {
      timing.Seconds.push_back(clock.SecondsOfFrame());
    }
    medians[i] = 1e3 * timing.Median();
  }
  return medians;
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
  Table table(
    { "scene", "pixels", "frame", "milliseconds", "times a plain frame", "+-", "processor ms",
      "times the plain frame's", "processor +-", "GPU ms", "bytes per pixel", "load" });
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
    std::vector<Timing> processors;
    const std::vector<Timing> times = TimeInTurn(frames, sizes.Rounds, processors);
    const std::vector<double> gpu = GpuMilliseconds(windows, GetRounds(sizes.Rounds));
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
        std::isnan(gpu[i]) ? "" : Number(gpu[i], 4),
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
