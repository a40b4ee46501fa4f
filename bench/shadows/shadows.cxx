// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 4: share of wrong shadow verdicts, against the size of the map and the time of the frame,
// for every method and kind of light, with vtkShadowMapPass in the same run.
//
// Verdicts are taken from the picture for all methods: a pixel is in shadow if it is nearer to
// black than to the picture without shadows. Truth is Embree on the same triangles. Times are of
// whole frames, still and with a moving light, drawn in turn with the plain frame.
#include "RelievoBench.h"

#include "FrameBench.h"
#include "ShadowVerdicts.h"
#include "Table.h"
#include "Window.h"

#include <vtkLight.h>
#include <vtkRelievoPass.h>
#include <vtkRenderer.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::SceneLight;
using relievoTest::Timed;
using relievoTest::Timing;

const int MapSizes[] = { 512, 1024, 2048, 4096 };
constexpr int DefaultSize = 2048;
constexpr int Rounds = 9;
constexpr int SlowRounds = 3;
constexpr double None = std::numeric_limits<double>::quiet_NaN();

const ShadowLight Lights[] = {
  { "sun", SceneLight::Sun, 0. },
  { "sun at 10 degrees", SceneLight::Sun, 10. },
  { "spot", SceneLight::Spot, 0. },
  { "point", SceneLight::Point, 0. },
};

// The timed cases: timing takes longest.
struct TimedCase
{
  const char* Scene;
  const ShadowLight& Light;
};
const TimedCase TimedCases[] = {
  { "bunny", Lights[0] },
  { "bunny", Lights[3] },
  { "motorBike", Lights[0] },
  { HorizonScene, Lights[0] },
  { HorizonScene, Lights[1] },
};

struct Size
{
  int Width;
  int Height;

  std::string Name() const
  {
    return std::to_string(this->Width) + "x" + std::to_string(this->Height);
  }
};
const Size Square = { 600, 600 };
const Size OtherShapes[] = { { 800, 450 }, { 400, 1600 } };

// A motion's frame time: in milliseconds, and relative to the plain frame and the peer's.
struct Time
{
  double Milliseconds = None;
  double Plain = None;
  double PlainSpread = None;
  double Peer = None;
  double PeerSpread = None;
};

struct Result
{
  std::string Scene;
  std::string Light;
  std::string Window;
  std::string Shading;
  std::string Way;
  int MapSize;
  relievoTest::ShadowErrors Errors;
  Time Still;
  Time Moving;
  double Load = None;

  double Wrong() const { return 100. * this->Errors.Wrong(); }
};

void Measure(
  ShadowVerdicts& verdicts, const Result& about, int mapSize, std::vector<Result>& results)
{
  for (const ShadowWay& way : ShadowWays())
  {
    if (mapSize > way.LargestMap)
    {
      continue;
    }
    results.push_back(about);
    Result& result = results.back();
    result.Way = way.Name;
    result.MapSize = mapSize;
    result.Errors = verdicts.Measure(way, mapSize);
    std::cout << about.Scene << ", " << about.Light << ", " << about.Window << ", " << about.Shading
              << ", " << way.Name << " " << mapSize << ": " << result.Errors.ToString()
              << std::endl;
  }
}

// Every light and map size in a square window; for meshes at the default size, also the sun in
// windows of other shapes, and sun and spot with physically based shading.
void MeasureScene(
  const std::string& name, vtkPolyData* mesh, bool isReal, std::vector<Result>& results)
{
  relievoTest::TruthImage view;
  for (const ShadowLight& light : Lights)
  {
    ShadowVerdicts verdicts(
      name, mesh, light, Square.Width, Square.Height, view.Pixels.empty() ? nullptr : &view);
    view = verdicts.View;
    Result about{ name, light.Name, Square.Name(), "flat", "", 0, {}, {}, {}, None };
    for (int mapSize : MapSizes)
    {
      Measure(verdicts, about, mapSize, results);
    }
    if (isReal && light.Elevation == 0. && light.Kind != SceneLight::Point)
    {
      verdicts.UsePBR();
      about.Shading = "PBR";
      Measure(verdicts, about, DefaultSize, results);
    }
  }
  for (const Size& size : OtherShapes)
  {
    if (isReal)
    {
      ShadowVerdicts verdicts(name, mesh, Lights[0], size.Width, size.Height);
      Measure(verdicts, { name, Lights[0].Name, size.Name(), "flat", "", 0, {}, {}, {}, None },
        DefaultSize, results);
    }
  }
}

// A scene in its own window, drawn by one method.
struct WayWindow
{
  relievoTest::ReferenceScene Scene;
  vtkSmartPointer<vtkRenderWindow> Window;
  int Frames = 0;

  WayWindow(const std::string& name, vtkPolyData* mesh, const ShadowLight& light)
    : Scene(MakeShadowScene(name, mesh, light))
    , Window(relievoTest::MakeWindow(Square.Width, Square.Height, this->Scene.Renderer))
  {
  }

  void MoveLight()
  {
    double at[3];
    this->Scene.Light->GetPosition(at);
    this->Scene.Light->SetPosition(at[0] + (++this->Frames % 2 ? 0.02 : -0.02), at[1], at[2]);
  }
};

// Frame times of some methods in turn with the plain frame and the peer, the last two.
void TimeWays(const Result& about, bool moving, int rounds, WayWindow& plain,
  const std::vector<const ShadowWay*>& ways, const std::vector<WayWindow*>& windows,
  std::vector<Result>& results)
{
  std::vector<WayWindow*> drawn(1, &plain);
  drawn.insert(drawn.end(), windows.begin(), windows.end());
  std::vector<Timed> frames;
  for (WayWindow* window : drawn)
  {
    frames.push_back(relievoTest::Frame(window->Window));
    if (moving)
    {
      frames.back().Prepare = [window]() { window->MoveLight(); };
    }
  }
  const std::vector<Timing> times = TimeInTurn(frames, rounds, 1);
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const auto pair = PairOf(times[i + 1], times[0]);
    const auto peer = PairOf(times[i + 1], times.back());
    const Time time{ 1e3 * times[i + 1].Median(), pair.Ratio(), pair.RatioSpread(), peer.Ratio(),
      peer.RatioSpread() };
    for (Result& result : results)
    {
      if (result.Scene == about.Scene && result.Light == about.Light &&
        result.MapSize == about.MapSize && result.Window == Square.Name() &&
        result.Shading == "flat" && result.Way == ways[i]->Name)
      {
        (moving ? result.Moving : result.Still) = time;
        result.Load = LoadAverage();
      }
    }
    std::cout << about.Scene << ", " << about.Light << ", " << (moving ? "light moves" : "still")
              << ", " << ways[i]->Name << " " << about.MapSize << ": "
              << Number(time.Milliseconds, 3) << " ms, " << Number(time.Plain, 3) << " +- "
              << Number(time.PlainSpread, 1) << " x plain, " << Number(time.Peer, 3) << " +- "
              << Number(time.PeerSpread, 1) << " x vtkShadowMapPass" << std::endl;
  }
}

// Frame times of every method at every size, added to the results. Slow methods are timed
// separately and first, so that the peer's recorded time is that of the longer run.
void TimeScene(const std::string& name, vtkPolyData* mesh, const ShadowLight& light,
  std::vector<Result>& results)
{
  WayWindow plain(name, mesh, light);
  std::vector<std::unique_ptr<WayWindow>> windows;
  for (std::size_t w = 0; w < ShadowWays().size(); ++w)
  {
    windows.emplace_back(new WayWindow(name, mesh, light));
  }
  Result about{ name, light.Name, "", "", "", 0, {}, {}, {}, None };
  for (int mapSize : MapSizes)
  {
    about.MapSize = mapSize;
    for (const bool slow : { true, false })
    {
      std::vector<const ShadowWay*> ways;
      std::vector<WayWindow*> drawn;
      for (std::size_t w = 0; w < windows.size(); ++w)
      {
        const ShadowWay& way = ShadowWays()[w];
        const bool isPeer = way.SetUp == UseShadowPeer;
        if (mapSize <= way.LargestMap && (isPeer || way.IsSlow == slow))
        {
          UseNoShadows(windows[w]->Window, windows[w]->Scene.Renderer);
          way.SetUp(windows[w]->Scene.Renderer, mapSize);
          drawn.push_back(windows[w].get());
          ways.push_back(&way);
        }
      }
      for (const bool moving : { false, true })
      {
        if (ways.size() > 1) // not only the peer
        {
          const int rounds = slow ? SlowRounds : Rounds;
          TimeWays(about, moving, rounds, plain, ways, drawn, results);
        }
      }
    }
  }
}

std::string Field(double value, int digits)
{
  return std::isnan(value) ? std::string() : Number(value, digits);
}

Table MakeTable(const std::vector<Result>& results)
{
  Table table({ "scene", "light", "window", "shading", "method", "map", "pixels", "dark %",
    "wrong %", "false shadow %", "false light %", "leak % of dark", "left out, flipping",
    "still ms", "still x plain", "+-", "still x vtkShadowMapPass", "+- of it", "moving ms",
    "moving x plain", "+- of moving", "moving x vtkShadowMapPass", "+- of that", "load" });
  for (const Result& r : results)
  {
    const auto& e = r.Errors;
    std::vector<std::string> row = { r.Scene, r.Light, r.Window, r.Shading, r.Way,
      std::to_string(r.MapSize), std::to_string(e.Compared), Number(Percent(e.Dark, e.Compared)),
      Number(r.Wrong()), Number(Percent(e.FalseShadow, e.Compared)),
      Number(Percent(e.FalseLight, e.Compared)), Number(Percent(e.FalseLight, e.Dark)),
      std::to_string(e.Flipping) };
    for (const Time& time : { r.Still, r.Moving })
    {
      row.insert(row.end(),
        { Field(time.Milliseconds, 4), Field(time.Plain, 4), Field(time.PlainSpread, 2),
          Field(time.Peer, 4), Field(time.PeerSpread, 2) });
    }
    row.push_back(Field(r.Load, 2));
    table.AddRow(row);
  }
  return table;
}

}

//------------------------------------------------------------------------------
int RelievoBenchShadows(const std::string& outDir)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  std::vector<std::string> names = relievoTest::ReferenceMeshes();
  const std::size_t real = names.size();
  names.insert(names.end(), { SpheresScene, HorizonScene });
  std::vector<Result> results;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const vtkSmartPointer<vtkPolyData> mesh = ShadowSceneMesh(names[i]);
    if (!mesh)
    {
      return 1;
    }
    MeasureScene(names[i], mesh, i < real, results);
    for (const TimedCase& timed : TimedCases)
    {
      if (names[i] == timed.Scene)
      {
        TimeScene(names[i], mesh, timed.Light, results);
      }
    }
  }
  const bool written = MakeTable(results).WriteCsv(outDir + "/shadows.csv");
  return written ? 0 : 1;
}
