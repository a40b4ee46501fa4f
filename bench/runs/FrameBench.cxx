// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameBench.h"

#include "Rounds.h"
#include "Window.h"

#include <vtksys/SystemInformation.hxx>
#include <vtksys/SystemTools.hxx>

#include <chrono>
#include <cstddef>
#include <ctime>
#include <iostream>
#include <limits>

namespace relievoBench
{
//------------------------------------------------------------------------------
SceneWindow::SceneWindow(vtkPolyData* mesh, int width, int height)
  : Scene(relievoTest::MakeReferenceScene(mesh))
  , Window(relievoTest::MakeWindow(width, height, this->Scene.Renderer))
{
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SceneMesh(const std::string& name)
{
  std::string folder;
  if (!vtksys::SystemTools::GetEnv("RELIEVO_DATA", folder) || folder.empty())
  {
    std::cerr
      << "relievo: bench: the environment variable RELIEVO_DATA does not say where the meshes are; "
         "run tools/unpack-data FOLDER and set it to FOLDER\n";
    return nullptr;
  }
  return relievoTest::MakeReferenceScene(name).Mesh;
}

//------------------------------------------------------------------------------
std::vector<relievoTest::Timing> TimeInTurn(
  const std::vector<relievoTest::Timed>& ways, int rounds, int warmUp)
{
  std::vector<relievoTest::Timing> timings(ways.size());
  rounds = GetRounds(rounds);
  warmUp = GetWarmUp(warmUp);
  for (int round = -warmUp; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      const std::size_t which = (i + static_cast<std::size_t>(round + warmUp)) % ways.size();
      if (ways[which].Prepare)
      {
        ways[which].Prepare();
      }
      const auto begin = std::chrono::steady_clock::now();
      ways[which].Work();
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
      if (round >= 0)
      {
        timings[which].Seconds.push_back(time.count());
      }
    }
  }
  return timings;
}

//------------------------------------------------------------------------------
std::vector<relievoTest::Timing> TimeInTurn(
  std::vector<relievoTest::Timed> ways, int rounds, std::vector<relievoTest::Timing>& processor)
{
  processor.assign(ways.size(), {});
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    ways[i].Work = [work = ways[i].Work, &taken = processor[i].Seconds]() {
      const std::clock_t begin = std::clock();
      work();
      taken.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    };
  }
  std::vector<relievoTest::Timing> times = TimeInTurn(ways, rounds);
  for (std::size_t i = 0; i < ways.size(); ++i) // no warm-up rounds
  {
    std::vector<double>& taken = processor[i].Seconds;
    const auto counted = static_cast<std::ptrdiff_t>(times[i].Seconds.size());
    taken.erase(taken.begin(), taken.end() - counted);
  }
  return times;
}

//------------------------------------------------------------------------------
relievoTest::TimingPair PairOf(const relievoTest::Timing& a, const relievoTest::Timing& b)
{
  relievoTest::TimingPair pair;
  pair.A = a;
  pair.B = b;
  return pair;
}

//------------------------------------------------------------------------------
double LoadAverage()
{
  vtksys::SystemInformation machine;
  const double load = machine.GetLoadAverage();
  return load >= 0. ? load : std::numeric_limits<double>::quiet_NaN();
}
}
