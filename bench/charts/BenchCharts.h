// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchCharts.h
 * @brief The charts of each bench, from the CSV files that it wrote and from nothing else.
 */
#ifndef relievoBenchBenchCharts_h
#define relievoBenchBenchCharts_h

#include "Chart.h"
#include "Table.h"

#include <string>
#include <vector>

namespace relievoBench
{
/** A chart and the name of its files. */
struct NamedChart
{
  std::string Stem;
  Chart What;
};

/** The benches that have charts. */
std::vector<std::string> BenchesWithCharts();

/**
 * The charts of a bench, from NAME.csv in the folder and what else it writes; none of a bench
 * without charts. They name what has drawn (Renderer.h). False, with a message on the standard
 * error, when a file cannot be read.
 */
bool ChartsOfBench(
  const std::string& bench, const std::string& csvFolder, std::vector<NamedChart>& charts);

/** Writes them. False, with a message on the standard error, when one cannot be written. */
bool DrawBenchCharts(
  const std::string& bench, const std::string& csvFolder, const std::string& outFolder);

/** From the rows of the CSV files. */
using CsvRows = std::vector<CsvRow>;
std::vector<NamedChart> NormalsCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> DepthCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> PositionCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> GBufferCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> ShadowsCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> SoftShadowCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> BiasCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> LightsCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> DeferredCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> ReliefCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> EnvironmentCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> ToneCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> BlockCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> CaveCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> VoxelCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> ParticleCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> PlannerCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> SkinCharts(const std::vector<CsvRows>& files);
std::vector<NamedChart> FogCharts(const std::vector<CsvRows>& files);
}

#endif
