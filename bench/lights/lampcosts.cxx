// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps against as many VTK lights, whose shaders are compiled for their number: the first frame,
// and later frames. And the cost of lamps' shadows, moving and still.
#include "RelievoBench.h"

#include "BenchSizes.h"
#include "LampWindows.h"
#include "Table.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Timed;
using relievoTest::Timing;

// The number of lamps that reach a point in the middle of the box, on average.
constexpr double Few = 4.;

double SecondsOf(const Timed& frame)
{
  const auto begin = std::chrono::steady_clock::now();
  frame.Work();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  return time.count();
}

// VTK's shader of many lights may exceed OpenGL's limits: the mesh is then missing.
bool ShowsMesh(vtkRenderWindow* window, int pixels)
{
  vtkNew<vtkUnsignedCharArray> colors;
  window->GetPixelData(0, 0, pixels - 1, pixels - 1, 1, colors);
  const unsigned char* first = colors->GetPointer(0);
  return !std::equal(first + 3, first + colors->GetNumberOfValues(), first);
}

void MeasurePeer(
  const std::string& scene, vtkPolyData* mesh, int count, const LightSizes& sizes, Table& table)
{
  const vtkSmartPointer<vtkPolyData> lamps = MakeLamps(count);
  LitWindow lit(mesh, sizes.Pixels, lamps, RadiusFor(count, Few), vtkRelievoLampsStage::AUTOMATIC);
  const std::unique_ptr<SceneWindow> peer = MakePeer(mesh, sizes.Pixels, lamps);
  std::vector<Timed> frames = { lit.Frame(), peer->Frame() };
  const char* const names[] = { "lamps", "VTK's lights" };
  const double first[] = { SecondsOf(frames[0]), SecondsOf(frames[1]) };
  if (!ShowsMesh(peer->Window, sizes.Pixels))
  {
    std::cout << scene << ", " << count << " VTK's lights: VTK draws no mesh with them here\n";
    frames.pop_back();
  }
  const std::vector<Timing> times = TimeInTurn(frames, sizes.Rounds);
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const auto ratio = PairOf(times[i], times[0]);
    std::cout << scene << ", " << count << " " << names[i] << ": first frame "
              << Number(first[i], 3) << " s, then " << Number(1e3 * times[i].Median(), 3) << " ms, "
              << Number(ratio.Ratio(), 3) << " +- " << Number(ratio.RatioSpread(), 1) << " x lamps"
              << std::endl;
    table.AddRow({ scene, std::to_string(count), names[i], Number(first[i], 3),
      Number(1e3 * times[i].Median(), 4), Number(ratio.Ratio(), 4), Number(ratio.RatioSpread(), 2),
      Number(LoadAverage(), 2) });
  }
}

void Shift(vtkPolyData* lamps, double by)
{
  for (vtkIdType i = 0; i < lamps->GetNumberOfPoints(); ++i)
  {
    const double* p = lamps->GetPoint(i);
    lamps->GetPoints()->SetPoint(i, p[0] + by, p[1], p[2]);
  }
  lamps->Modified();
}

// Eight lamps, of which `casting` cast shadows; all of them move, or none.
void MeasureShadows(
  const std::string& scene, vtkPolyData* mesh, const LightSizes& sizes, Table& table)
{
  constexpr int Count = 8;
  const vtkSmartPointer<vtkPolyData> lamps = MakeLamps(Count);
  for (const bool moving : { false, true })
  {
    std::vector<std::unique_ptr<LitWindow>> windows;
    std::vector<Timed> frames;
    for (const int casting : sizes.Casting)
    {
      windows.emplace_back(new LitWindow(
        mesh, sizes.Pixels, lamps, RadiusFor(Count, Few), vtkRelievoLampsStage::AUTOMATIC));
      LitWindow* window = windows.back().get();
      window->Stage->SetCasting(casting);
      frames.push_back(window->Window->Frame());
      if (moving)
      {
        auto to = vtkSmartPointer<vtkPolyData>::New();
        to->DeepCopy(lamps);
        window->Lamps->SetInputData(to);
        frames.back().Prepare = [to]() { Shift(to, 0.01); };
      }
    }
    const std::vector<Timing> times = TimeInTurn(frames, sizes.Rounds);
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      const auto ratio = PairOf(times[i], times[0]);
      const char* const motion = moving ? "moving" : "still";
      std::cout << scene << ", " << sizes.Casting[i] << " of " << Count << " lamps cast, " << motion
                << ": " << Number(1e3 * times[i].Median(), 3) << " ms, " << Number(ratio.Ratio(), 3)
                << " +- " << Number(ratio.RatioSpread(), 1) << " x without" << std::endl;
      table.AddRow(
        { scene, std::to_string(sizes.Casting[i]), motion, Number(1e3 * times[i].Median(), 4),
          Number(ratio.Ratio(), 4), Number(ratio.RatioSpread(), 2), Number(LoadAverage(), 2) });
    }
  }
}
}

//------------------------------------------------------------------------------
namespace relievoBench
{
int BenchLightsPeer(const std::string& outDir, const LightSizes& sizes)
{
  Table table(
    { "scene", "lamps", "way", "first frame s", "milliseconds", "times lamps", "+-", "load" });
  for (const std::string& name : sizes.Scenes)
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    for (const int lamps : sizes.Lamps)
    {
      MeasurePeer(name, mesh, lamps, sizes, table);
    }
  }
  return MakeFolder(outDir) && table.WriteCsv(outDir + "/lights-peer.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int BenchLampShadows(const std::string& outDir, const LightSizes& sizes)
{
  Table table({ "scene", "casting", "lamps", "milliseconds", "times without", "+-", "load" });
  for (const std::string& name : sizes.Scenes)
  {
    const vtkSmartPointer<vtkPolyData> mesh = SceneMesh(name);
    if (!mesh)
    {
      return 1;
    }
    MeasureShadows(name, mesh, sizes, table);
  }
  return MakeFolder(outDir) && table.WriteCsv(outDir + "/lamp-shadows.csv") ? 0 : 1;
}
}

//------------------------------------------------------------------------------
int RelievoBenchLightsPeer(const std::string& outDir)
{
  relievoBench::LightSizes sizes;
  sizes.Scenes = { "bunny" };
  sizes.Lamps = { 100, 300 };
  sizes.Rounds = 5;
  return relievoBench::BenchLightsPeer(outDir, sizes);
}

//------------------------------------------------------------------------------
int RelievoBenchLampShadows(const std::string& outDir)
{
  return relievoBench::BenchLampShadows(outDir, {});
}
