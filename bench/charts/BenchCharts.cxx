// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCharts.h"

#include "Renderer.h"

#include <iostream>
#include <stdexcept>

namespace relievoBench
{
namespace
{
struct Entry
{
  const char* Bench;
  std::vector<std::string> Files;
  std::vector<NamedChart> (*Make)(const std::vector<CsvRows>& files);
};

const std::vector<Entry>& Entries()
{
  static const std::vector<Entry> entries = {
    { "normals", { "normals.csv" }, NormalsCharts },
    { "depth", { "depth.csv" }, DepthCharts },
    { "position", { "position.csv" }, PositionCharts },
    { "gbuffer", { "gbuffer.csv" }, GBufferCharts },
    { "shadows", { "shadows.csv" }, ShadowsCharts },
    { "soft-shadows", { "soft-shadows.csv" }, SoftShadowCharts },
    { "planner",
      { "planner.csv", "planner-choices.csv", "planner-times.csv", "planner-budgets.csv" },
      PlannerCharts },
    { "bias", { "bias.csv" }, BiasCharts },
    { "lights", { "lights.csv" }, LightsCharts },
    { "deferred", { "deferred.csv" }, DeferredCharts },
    { "relief", { "relief.csv" }, ReliefCharts },
    { "environment", { "environment.csv", "environment-angle.csv" }, EnvironmentCharts },
    { "tone", { "tone-curves.csv", "tone-bands.csv" }, ToneCharts },
    { "blocks", { "blocks.csv" }, BlockCharts },
    { "caves", { "caves.csv", "caves-width.csv" }, CaveCharts },
    { "voxels", { "voxels.csv" }, VoxelCharts },
    { "skin", { "skin-keys.csv", "skin-volume.csv", "skin.csv" }, SkinCharts },
    { "particles", { "particles.csv", "particles-drift.csv" }, ParticleCharts },
    { "fog", { "fog.csv", "fog-frames.csv" }, FogCharts },
  };
  return entries;
}

// Where the charts say what has drawn.
void NameRenderer(Chart& chart, const std::string& renderer)
{
  for (std::string* text : { &chart.Title, &chart.Note, &chart.X.Title, &chart.Y.Title })
  {
    *text = relievoBench::NameRenderer(*text, renderer);
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::string> BenchesWithCharts()
{
  std::vector<std::string> names;
  for (const Entry& entry : Entries())
  {
    names.emplace_back(entry.Bench);
  }
  return names;
}

//------------------------------------------------------------------------------
bool ChartsOfBench(
  const std::string& bench, const std::string& csvFolder, std::vector<NamedChart>& charts)
{
  for (const Entry& entry : Entries())
  {
    if (bench != entry.Bench)
    {
      continue;
    }
    std::vector<CsvRows> files;
    for (const std::string& file : entry.Files)
    {
      if (!ReadCsv(csvFolder + "/" + file, files.emplace_back()))
      {
        return false;
      }
    }
    try
    {
      charts = entry.Make(files);
      for (NamedChart& chart : charts)
      {
        NameRenderer(chart.What, ReadRenderer(csvFolder));
      }
    }
    catch (const std::out_of_range&)
    {
      std::cerr << "relievo: bench: " << csvFolder << ":";
      for (const std::string& file : entry.Files)
      {
        std::cerr << " " << file;
      }
      std::cerr << " without a column that the charts of " << bench << " show; measure it again\n";
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool DrawBenchCharts(
  const std::string& bench, const std::string& csvFolder, const std::string& outFolder)
{
  std::vector<NamedChart> charts;
  bool written = ChartsOfBench(bench, csvFolder, charts);
  for (const NamedChart& chart : charts)
  {
    written = written && WriteChart(chart.What, outFolder + "/" + chart.Stem);
  }
  return written;
}
}
