// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost of lamps per frame, by their number, size and method: ratios to the plain frame and to as
// many VTK lights, drawn in turn in one process; the number of lamps computed for a pixel against
// those that reach it; and the time to list lamps in clusters.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "LampWindows.h"
#include "Table.h"

#include <vtkPolyData.h>
#include <vtkRelievoLampClusters.h>
#include <vtkRelievoLampList.h>
#include <vtkRelievoLamps.h>
#include <vtkRelievoLampsStage.h>
#include <vtkRelievoThreads.h>
#include <vtkRenderer.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;

const char* const Peer = "VTK's lights";

// The number of these that reach a point in the middle of the box, on average.
constexpr double Few = 4.;
constexpr double Many = 40.;

// Milliseconds to read and list the lamps, the median of some runs.
double ListMilliseconds(const SceneWindow& window, vtkRelievoLamps* lamps, int rounds)
{
  vtkRelievoFrameCamera view;
  view.Take(window.Scene.Renderer, nullptr);
  lamps->GetNumberOfPoints();
  vtkRelievoLampList list;
  vtkRelievoLampClusters clusters;
  Timed build;
  build.Work = [&]() {
    vtkRelievoWithThreads([&]() {
      list.Take(view, { lamps });
      clusters.Build(view, list);
    });
  };
  return 1e3 * TimeInTurn({ build }, rounds).front().Median();
}

struct Case
{
  std::string Scene;
  std::string Size; // "few" or "many" reach a point
  int Lamps;
  double Radius;
};

void Measure(vtkPolyData* mesh, const Case& what, const LightSizes& sizes, Table& table)
{
  const vtkSmartPointer<vtkPolyData> lamps = MakeLamps(what.Lamps);
  const bool all = what.Lamps <= sizes.MostAll;
  const bool peer = what.Lamps <= sizes.MostPeer;
  struct Way
  {
    const char* Name;
    int Code;
  };
  std::vector<Way> ways = { { "quads", vtkRelievoLampsStage::QUADS },
    { "clusters", vtkRelievoLampsStage::CLUSTERS } };
  if (all)
  {
    ways.push_back({ "every lamp", vtkRelievoLampsStage::ALL });
  }
  const SceneWindow plain(mesh, sizes.Pixels, sizes.Pixels);
  std::vector<Timed> frames = { plain.Frame() };
  std::vector<std::unique_ptr<LitWindow>> windows;
  for (const Way& way : ways)
  {
    windows.emplace_back(new LitWindow(mesh, sizes.Pixels, lamps, what.Radius, way.Code));
    frames.push_back(windows.back()->Frame());
  }
  std::unique_ptr<SceneWindow> peers;
  if (peer)
  {
    peers = MakePeer(mesh, sizes.Pixels, lamps);
    frames.push_back(peers->Frame());
    ways.push_back({ Peer, -1 });
  }
  const std::vector<Timing> times = TimeInTurn(frames, sizes.Rounds);
  std::cout << what.Scene << ", " << what.Lamps << " lamps of radius " << Number(what.Radius, 3)
            << ", plain frame " << Number(1e3 * times[0].Median(), 3) << " ms:" << std::endl;
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    double computed = std::nan("");
    double reaching = std::nan("");
    double listing = std::nan("");
    if (i < windows.size())
    {
      windows[i]->Count(computed, reaching);
    }
    if (ways[i].Code == vtkRelievoLampsStage::CLUSTERS)
    {
      listing = ListMilliseconds(*windows[i]->Window, windows[i]->Lamps, sizes.Rounds);
    }
    const auto ratio = PairOf(times[i + 1], times[0]);
    const auto text = [](double value) {
      return std::isnan(value) ? std::string() : Number(value, 4);
    };
    std::cout << "  " << ways[i].Name << ": " << Number(1e3 * times[i + 1].Median(), 3) << " ms, "
              << Number(ratio.Ratio(), 3) << " +- " << Number(ratio.RatioSpread(), 1) << " x plain";
    if (!std::isnan(computed))
    {
      std::cout << ", " << Number(computed, 3) << " computed a pixel, " << Number(reaching, 3)
                << " reach it";
    }
    std::cout << (std::isnan(listing) ? "" : ", lists in " + Number(listing, 3) + " ms")
              << std::endl;
    table.AddRow({ what.Scene, what.Size, std::to_string(what.Lamps), Number(what.Radius, 4),
      ways[i].Name, Number(1e3 * times[i + 1].Median(), 4), Number(ratio.Ratio(), 4),
      Number(ratio.RatioSpread(), 2), text(computed), text(reaching), text(computed / reaching),
      text(listing), Number(LoadAverage(), 2) });
  }
}
}

//------------------------------------------------------------------------------
namespace relievoBench
{
int BenchLights(const std::string& outDir, const LightSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "scene", "size", "lamps", "radius", "way", "milliseconds", "times a plain frame",
    "+-", "computed", "reaching", "computed / reaching", "list ms", "load" });
  for (const std::string& name : sizes.Scenes)
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const int lamps : sizes.Lamps)
    {
      Measure(mesh, { name, "few", lamps, RadiusFor(lamps, Few) }, sizes, table);
      if (lamps > 10 && lamps < 100000)
      {
        Measure(mesh, { name, "many", lamps, RadiusFor(lamps, Many) }, sizes, table);
      }
    }
  }
  return table.WriteCsv(outDir + "/lights.csv") ? 0 : 1;
}
}

//------------------------------------------------------------------------------
int RelievoBenchLights(const std::string& outDir)
{
  return relievoBench::BenchLights(outDir, {});
}
