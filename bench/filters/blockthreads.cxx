// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles per second of smooth blocks, on one thread and on all, for a surface in a small part of
// the blocks and for one everywhere.
#include "BenchSizes.h"

#include "BlockShapes.h"
#include "FrameBench.h"
#include "Table.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoFormulas.h>
#include <vtkRelievoSmoothBlocks.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace
{
// Solid where noise is positive: cells of the noise have 12 blocks.
vtkSmartPointer<vtkImageData> Sponge(int size)
{
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("labels");
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        const glm::dvec3 place = glm::dvec3(i, j, k) / 12.;
        const glm::dvec3 cell = glm::floor(place);
        labels->InsertNextValue(
          relievo::f64::relievoSimplexNoise(glm::ivec3(cell), place - cell, 1u) > 0.);
      }
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->GetPointData()->SetScalars(labels);
  return image;
}
}

//------------------------------------------------------------------------------
bool relievoBench::BenchBlockThreads(const std::string& outDir, const BlockSizes& sizes)
{
  const int size = sizes.Sizes.back();
  const std::vector<std::pair<std::string, vtkSmartPointer<vtkImageData>>> inputs = {
    { "ball", BlockShapes(size).front().Labels() }, { "sponge", Sponge(size) }
  };
  const int cores = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
  Table table({ "labels", "blocks", "threads", "triangles", "milliseconds", "core milliseconds",
    "million triangles per second", "million triangles per second of a core", "load" });
  for (const auto& input : inputs)
  {
    vtkNew<vtkRelievoSmoothBlocks> filter;
    filter->SetInputData(input.second);
    filter->SetSeams(false);
    std::vector<relievoTest::Timed> ways;
    // Core time, which other work on a busy machine changes little.
    std::array<double, 2> worked = { 1e9, 1e9 };
    for (const int threads : { 1, cores })
    {
      double& least = worked[ways.size()];
      ways.push_back({ [&filter, &least]() {
                        const std::clock_t begin = std::clock();
                        filter->Modified();
                        filter->Update();
                        least = std::min(
                          least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
                      },
        [threads]() { vtkSMPTools::Initialize(threads); } });
    }
    const std::vector<relievoTest::Timing> times = TimeInTurn(ways, sizes.Rounds, 1);
    const auto triangles = static_cast<double>(filter->GetOutput()->GetNumberOfPolys());
    for (int way = 0; way < 2; ++way)
    {
      const double median = times[way].Median();
      table.AddRow({ input.first, std::to_string(size), std::to_string(way == 0 ? 1 : cores),
        Number(triangles, 8), Number(1e3 * median), Number(1e3 * worked[way]),
        Number(1e-6 * triangles / median, 3), Number(1e-6 * triangles / worked[way], 3),
        Number(LoadAverage(), 2) });
      std::cout << input.first << ' ' << size << ", " << (way == 0 ? 1 : cores)
                << " threads: " << Number(1e3 * median) << " ms, of a core "
                << Number(1e3 * worked[way]) << "; " << Number(1e-6 * triangles / median, 3)
                << " M triangles/s, of a core " << Number(1e-6 * triangles / worked[way], 3)
                << std::endl;
    }
  }
  vtkSMPTools::Initialize(0);
  return table.WriteCsv(outDir + "/blocks-threads.csv");
}
