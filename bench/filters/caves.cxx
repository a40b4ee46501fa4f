// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Caves: evaluations of noise per sample and their time, for three orders that make the same mask;
// share of air, number of components and loops; and measured against requested width of tunnels.
#include "BenchSizes.h"
#include "RelievoBench.h"

#include "CaveShape.h"
#include "FrameBench.h"
#include "Table.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRelievoCaveFunction.h>
#include <vtkRelievoCaves.h>
#include <vtkRelievoFormulas.h>
#include <vtkSMPTools.h>

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;

// Evaluates both noises at every sample.
void MakeNaive(vtkRelievoCaves* caves, std::vector<unsigned char>& mask)
{
  double shell[2];
  caves->GetFunction()->GetThresholds(shell);
  const int* size = caves->GetSize();
  const auto seed = 2u * static_cast<unsigned int>(caves->GetSeed());
  const auto isIn = [&](const glm::dvec3& place, unsigned int which) {
    const glm::dvec3 cell = glm::floor(place);
    const double noise =
      relievo::f64::relievoSimplexNoise(glm::ivec3(cell), place - cell, seed + which);
    return noise > shell[0] && noise < shell[1];
  };
  std::size_t sample = 0;
  const glm::dvec3 step = glm::dvec3(1., 1., caves->GetVerticalScale()) * (1. / caves->GetScale());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const glm::dvec3 place = glm::dvec3(i, j, k) * step;
        const bool both[] = { isIn(place, 0u), isIn(place + glm::dvec3(0.5, 0.25, 0.125), 1u) };
        mask[sample++] = both[0] && both[1];
      }
    }
  }
}

void MeasureScale(double scale, double width, const CaveSizes& sizes, Table& table)
{
  vtkNew<vtkRelievoCaves> caves;
  const std::array<int, 3> size = { sizes.Side, sizes.Side, sizes.Side / 2 };
  caves->SetSize(size[0], size[1], size[2]);
  caves->SetScale(scale);
  caves->SetTunnelWidth(width);
  caves->SetSeed(7);
  const double samples = static_cast<double>(size[0]) * size[1] * size[2];
  std::vector<unsigned char> naive(static_cast<std::size_t>(samples));
  std::vector<relievoTest::Timed> ways(3);
  ways[0].Work = [&]() { MakeNaive(caves, naive); };
  std::array<double, 3> evaluations = { 2., 0., 0. };
  for (int way = 1; way < 3; ++way)
  {
    ways[way].Prepare = [&caves, way]() {
      caves->SetSkipping(way == 2);
      caves->Modified();
    };
    ways[way].Work = [&caves, &evaluations, samples, way]() {
      caves->Update();
      evaluations[way] = static_cast<double>(caves->GetNumberOfEvaluations()) / samples;
    };
  }
  const std::vector<relievoTest::Timing> times = TimeInTurn(ways, sizes.Rounds, 0);
  const auto* mask = static_cast<unsigned char*>(caves->GetOutput()->GetScalarPointer());
  long different = 0;
  for (std::size_t i = 0; i < naive.size(); ++i)
  {
    different += mask[i] != naive[i];
  }
  const CaveShape shape = MeasureCaves(naive, size);
  static const char* const names[] = { "naive", "classic", "skipping" };
  for (int way = 0; way < 3; ++way)
  {
    const double nanoseconds = 1e9 * times[way].Median() / samples;
    table.AddRow({ Number(scale), Number(width), names[way], Number(samples, 9),
      Number(evaluations[way]), Number(nanoseconds), Number(shape.Air),
      std::to_string(shape.Components), Number(shape.Largest), std::to_string(shape.Euler),
      std::to_string(way == 0 ? 0 : different), Number(LoadAverage(), 2) });
    std::cout << "scale " << Number(scale) << ", width " << Number(width) << ", " << names[way]
              << ": " << Number(evaluations[way]) << " evaluations and " << Number(nanoseconds)
              << " ns a sample" << std::endl;
  }
  std::cout << "  " << Number(100. * shape.Air) << " % air in " << shape.Components
            << " parts, the largest with " << Number(100. * shape.Largest) << " %; Euler number "
            << shape.Euler << "; " << different << " samples differ" << std::endl;
}

// Samples are small against the tunnels; the result is the mean over several seeds.
void MeasureWidth(double width, const CaveSizes& sizes, Table& table)
{
  constexpr double Scale = 1.;
  const double spacing = width / sizes.Across;
  const std::array<int, 3> size = { sizes.Side, sizes.Side, sizes.Side };
  double level = 0.;
  double upright = 0.;
  double air = 0.;
  for (int seed = 0; seed < sizes.Seeds; ++seed)
  {
    vtkNew<vtkRelievoCaves> caves;
    caves->SetSize(size[0], size[1], size[2]);
    caves->SetSpacing(spacing, spacing, 0.5 * spacing);
    caves->SetOrigin(1000. * seed, 0., 0.);
    caves->SetScale(Scale);
    caves->SetTunnelWidth(width);
    caves->SetSeed(seed);
    caves->Update();
    const auto* mask = static_cast<unsigned char*>(caves->GetOutput()->GetScalarPointer());
    const CaveShape shape =
      MeasureCaves({ mask, mask + caves->GetOutput()->GetNumberOfPoints() }, size);
    // Lengths are means over all air: the sum of air over the sum of walls.
    air += shape.Air;
    level += shape.Air > 0. ? shape.Air / shape.LevelWidth : 0.;
    upright += shape.Air > 0. ? shape.Air / shape.UprightWidth : 0.;
  }
  const double levelWidth = spacing * air / level;
  const double uprightWidth = 0.5 * spacing * air / upright;
  table.AddRow({ Number(width), Number(levelWidth), Number(uprightWidth),
    Number(levelWidth / width), Number(2. * uprightWidth / width), Number(air / sizes.Seeds) });
  std::cout << "width asked " << Number(width) << " of Scale, level " << Number(levelWidth)
            << ", upwards " << Number(uprightWidth) << std::endl;
}
}

//------------------------------------------------------------------------------
int relievoBench::BenchCaves(const std::string& outDir, const CaveSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  vtkSMPTools::Initialize(1);
  Table orders({ "scale samples", "width samples", "method", "samples", "evaluations per sample",
    "ns per sample", "air", "components", "share of largest", "euler number", "different",
    "load" });
  for (const double scale : sizes.Scales)
  {
    MeasureScale(scale, 0.1 * scale, sizes, orders);
  }
  vtkSMPTools::Initialize(0);
  Table widths({ "width asked", "width level", "width upright", "level over asked",
    "twice upright over asked", "air" });
  for (const double width : sizes.Widths)
  {
    MeasureWidth(width, sizes, widths);
  }
  const bool written =
    orders.WriteCsv(outDir + "/caves.csv") && widths.WriteCsv(outDir + "/caves-width.csv");
  return written ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchCaves(const std::string& outDir)
{
  return relievoBench::BenchCaves(outDir, {});
}
