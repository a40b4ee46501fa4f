// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Expected and measured error and time of each shadow method, and the planner's choice for a
// tolerance or a time budget against the best possible choice.
//
// Errors against Embree, as in the bench of shadows. Times are of whole frames in which the light
// moves, so that maps are drawn again, with all methods in turn.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "FrameBench.h"
#include "Rounds.h"
#include "ShadowVerdicts.h"
#include "Table.h"
#include "Window.h"

#include <vtkLight.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::SceneLight;
using Pass = vtkRelievoShadowStage;

const double Tolerances[] = { 2e-3, 1e-3, 5e-4, 2e-4, 5e-5 };
constexpr double TimedTolerance = 5e-4;
const double Budgets[] = { 1.2, 2., 4. }; // times the fastest method's time
constexpr int FramesBefore = 10;          // from which the planner learns

const ShadowLight Lights[] = {
  { "sun", SceneLight::Sun, 0. },
  { "sun at 10 degrees", SceneLight::Sun, 10. },
  { "spot", SceneLight::Spot, 0. },
  { "point", SceneLight::Point, 0. },
};

struct Way
{
  int Method;
  int Size;
  double Expected = 0.; // share of wrong pixels
  double Wrong = 0.;
  double Milliseconds = 0.;

  std::string Name() const
  {
    return this->Method == Pass::METHOD_MAP ? "map"
      : this->Method == Pass::METHOD_WARPED ? "warped"
                                            : "exact";
  }
};

std::vector<Way> MakeWays(bool sun, const std::vector<int>& maps)
{
  std::vector<Way> ways;
  for (const int method : { Pass::METHOD_MAP, Pass::METHOD_WARPED })
  {
    for (const int size : maps)
    {
      if (method == Pass::METHOD_MAP || sun)
      {
        ways.push_back({ method, size });
      }
    }
  }
  ways.push_back({ Pass::METHOD_EXACT, 0 });
  return ways;
}

Pass* Attach(vtkRenderer* renderer)
{
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  frame->ShadowsOn();
  return frame->GetShadowStage();
}

void Use(Pass* shadows, const Way& way)
{
  shadows->SetMethod(way.Method);
  if (way.Size > 0)
  {
    shadows->SetMapSize(way.Size);
  }
}

// One measured case.
struct Case
{
  std::string Scene;
  vtkPolyData* Mesh;
  ShadowLight Light;
  int Width;
  int Height;
  int Rounds;

  std::string Window() const
  {
    return std::to_string(this->Width) + "x" + std::to_string(this->Height);
  }
};

// A scene in its own window whose light moves from frame to frame.
struct MovingWindow
{
  relievoTest::ReferenceScene Scene;
  vtkSmartPointer<vtkRenderWindow> Window;
  Pass* Shadows;
  int Frames = 0;

  explicit MovingWindow(const Case& of)
    : Scene(MakeShadowScene(of.Scene, of.Mesh, of.Light))
    , Window(relievoTest::MakeWindow(of.Width, of.Height, this->Scene.Renderer))
    , Shadows(Attach(this->Scene.Renderer))
  {
  }

  relievoTest::Timed Frame()
  {
    relievoTest::Timed frame = relievoTest::Frame(this->Window);
    frame.Prepare = [this]() {
      double at[3];
      this->Scene.Light->GetPosition(at);
      this->Scene.Light->SetPosition(at[0] + (++this->Frames % 2 ? 0.02 : -0.02), at[1], at[2]);
    };
    return frame;
  }

  // Draws the frames from which the planner learns; then its expected time and the measured median.
  double Learn(double& expected, int rounds)
  {
    relievoTest::Timed frame = this->Frame();
    rounds = GetRounds(rounds);
    std::vector<double> taken;
    for (int i = 0; i < FramesBefore + rounds; ++i)
    {
      frame.Prepare();
      frame.Work();
      expected = i == FramesBefore ? this->Shadows->GetExpectedMilliseconds() : expected;
      if (i >= FramesBefore)
      {
        taken.push_back(this->Shadows->GetMillisecondsTaken());
      }
    }
    std::sort(taken.begin(), taken.end());
    return taken[taken.size() / 2];
  }
};

struct Tables
{
  Table Ways{ { "scene", "light", "window", "method", "map", "expected wrong %", "wrong %",
    "frame ms", "load" } };
  Table Choices{ { "scene", "light", "window", "tolerance %", "method", "map", "expected wrong %",
    "wrong %", "wrong / tolerance", "frame ms", "best method", "best map", "best ms", "regret" } };
  Table Budgets{ { "scene", "light", "window", "budget ms", "method", "map", "taken ms",
    "taken / budget", "wrong %", "best method", "best map", "best ms", "best wrong %" } };
  Table Times{ { "scene", "light", "window", "method", "map", "expected ms", "taken ms",
    "taken / expected" } };
};

std::string SizeWords(const Way& way)
{
  return way.Size > 0 ? std::to_string(way.Size) : std::string();
}

const Way* FindUsed(const std::vector<Way>& ways, Pass* shadows)
{
  const int method = shadows->GetMethodUsed();
  const int size = method == Pass::METHOD_EXACT ? 0 : shadows->GetMapSizeUsed();
  const auto used = std::find_if(ways.begin(), ways.end(),
    [=](const Way& way) { return way.Method == method && way.Size == size; });
  if (used == ways.end())
  {
    std::cerr << "relievo: bench: " << shadows->GetPlan() << " is no way that was measured\n";
    return nullptr;
  }
  return &*used;
}

// The choice for a time budget, against the most accurate method whose measured time fits.
void MeasureBudget(const Case& of, double times, const std::vector<Way>& ways, Table& table)
{
  const auto sooner = [](const Way& a, const Way& b) { return a.Milliseconds < b.Milliseconds; };
  const double budget = times * std::min_element(ways.begin(), ways.end(), sooner)->Milliseconds;
  MovingWindow moving(of);
  moving.Shadows->SetTimeBudget(budget);
  double expected = 0.;
  const double taken = moving.Learn(expected, of.Rounds);
  const Way* used = FindUsed(ways, moving.Shadows);
  const Way* best = nullptr;
  for (const Way& way : ways)
  {
    if (way.Milliseconds <= budget && (!best || way.Wrong < best->Wrong))
    {
      best = &way;
    }
  }
  if (!used)
  {
    return;
  }
  table.AddRow({ of.Scene, of.Light.Name, of.Window(), Number(budget), used->Name(),
    SizeWords(*used), Number(taken), Number(taken / budget), Number(100. * used->Wrong),
    best->Name(), SizeWords(*best), Number(best->Milliseconds), Number(100. * best->Wrong) });
  std::cout << "  " << Number(budget, 3) << " ms: " << used->Name() << " " << SizeWords(*used)
            << ", " << Number(taken, 3) << " ms, " << Number(100. * used->Wrong, 3)
            << " % wrong; best " << best->Name() << " " << SizeWords(*best) << ", "
            << Number(100. * best->Wrong, 3) << " %" << std::endl;
}

void Measure(const Case& of, const std::vector<int>& maps, Tables& tables)
{
  const std::string& name = of.Scene;
  const ShadowLight& light = of.Light;
  const std::string window = of.Window();
  std::vector<Way> ways = MakeWays(light.Kind == SceneLight::Sun, maps);
  ShadowVerdicts verdicts(name, of.Mesh, light, of.Width, of.Height);
  Pass* shadows = Attach(verdicts.Scene.Renderer);
  for (Way& way : ways)
  {
    Use(shadows, way);
    way.Wrong = verdicts.MeasureAsItIs().Wrong();
    way.Expected = shadows->EstimateWrongShareInView(way.Method, std::max(1, way.Size));
  }
  {
    std::vector<std::unique_ptr<MovingWindow>> windows;
    std::vector<relievoTest::Timed> frames;
    for (const Way& way : ways)
    {
      windows.push_back(std::make_unique<MovingWindow>(of));
      Use(windows.back()->Shadows, way);
      frames.push_back(windows.back()->Frame());
    }
    const std::vector<relievoTest::Timing> times = TimeInTurn(frames, of.Rounds, 1);
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      ways[i].Milliseconds = 1e3 * times[i].Median();
    }
  }
  for (const Way& way : ways)
  {
    tables.Ways.AddRow(
      { name, light.Name, window, way.Name(), SizeWords(way), Number(100. * way.Expected),
        Number(100. * way.Wrong), Number(way.Milliseconds), Number(LoadAverage(), 2) });
    std::cout << name << ", " << light.Name << ", " << window << ", " << way.Name() << " "
              << SizeWords(way) << ": " << Number(100. * way.Expected, 3) << " % expected, "
              << Number(100. * way.Wrong, 3) << " % wrong, " << Number(way.Milliseconds, 3) << " ms"
              << std::endl;
  }
  for (const double tolerance : Tolerances)
  {
    shadows->SetTolerance(tolerance);
    verdicts.Window->Render();
    const Way* chosen = FindUsed(ways, shadows);
    const Way* best = nullptr;
    for (const Way& way : ways)
    {
      if (way.Wrong <= tolerance && (!best || way.Milliseconds < best->Milliseconds))
      {
        best = &way;
      }
    }
    if (!chosen)
    {
      continue;
    }
    // If no method meets the tolerance, there is no best.
    const std::string bestName = best ? best->Name() : "none";
    const std::string bestSize = best ? SizeWords(*best) : "-";
    const std::string bestTime = best ? Number(best->Milliseconds) : "-";
    const std::string regret = best ? Number(chosen->Milliseconds / best->Milliseconds) : "-";
    tables.Choices.AddRow({ name, light.Name, window, Number(100. * tolerance), chosen->Name(),
      SizeWords(*chosen), Number(100. * chosen->Expected), Number(100. * chosen->Wrong),
      Number(chosen->Wrong / tolerance), Number(chosen->Milliseconds), bestName, bestSize, bestTime,
      regret });
    std::cout << "  " << Number(100. * tolerance, 2) << " %: " << chosen->Name() << " "
              << SizeWords(*chosen) << ", " << Number(chosen->Wrong / tolerance, 3)
              << " of the tolerance; best " << bestName << " " << bestSize << ", regret " << regret
              << std::endl;
  }
  for (const double times : Budgets)
  {
    MeasureBudget(of, times, ways, tables.Budgets);
  }
  MovingWindow moving(of);
  moving.Shadows->SetTolerance(TimedTolerance);
  double expected = 0.;
  const double median = moving.Learn(expected, of.Rounds);
  tables.Times.AddRow({ name, light.Name, window, Way{ moving.Shadows->GetMethodUsed(), 0 }.Name(),
    std::to_string(moving.Shadows->GetMapSizeUsed()), Number(expected), Number(median),
    Number(median / expected) });
  std::cout << "  expected " << Number(expected, 3) << " ms, taken " << Number(median, 3) << " ms"
            << std::endl;
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchPlanner(const std::string& outDir, const PlannerSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  std::vector<std::string> names = sizes.Scenes;
  if (names.empty())
  {
    names = relievoTest::ReferenceMeshes();
    for (const std::string& other : relievoTest::OtherMeshes())
    {
      names.push_back(other);
    }
    names.insert(names.end(), { SpheresScene, HorizonScene });
  }
  std::vector<vtkSmartPointer<vtkPolyData>> meshes;
  for (const std::string& name : names)
  {
    meshes.push_back(ShadowSceneMesh(name));
    if (!meshes.back())
    {
      return 1;
    }
  }
  // Lights differ in each scene. Results are written immediately.
  Tables tables;
  bool written = true;
  for (int light = 0; light < sizes.Lights; ++light)
  {
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      const auto& window =
        sizes.Windows[(static_cast<std::size_t>(light) + i) % sizes.Windows.size()];
      Measure({ names[i], meshes[i], Lights[light], window.first, window.second, sizes.Rounds },
        sizes.Maps, tables);
      written = written && tables.Ways.WriteCsv(outDir + "/planner.csv") &&
        tables.Choices.WriteCsv(outDir + "/planner-choices.csv") &&
        tables.Budgets.WriteCsv(outDir + "/planner-budgets.csv") &&
        tables.Times.WriteCsv(outDir + "/planner-times.csv");
    }
  }
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchPlanner(const std::string& outDir)
{
  return relievoBench::BenchPlanner(outDir, {});
}
