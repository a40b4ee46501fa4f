// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"

#include "ChartLayout.h"
#include "ChartPng.h"
#include "ChartSvg.h"

#include <fstream>
#include <iostream>

namespace relievoBench
{
namespace
{
bool WriteSvg(const ChartDrawing& drawing, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file << SvgOf(drawing);
  file.close();
  return static_cast<bool>(file);
}
}

//------------------------------------------------------------------------------
bool WriteChart(const Chart& chart, const std::string& stem)
{
  for (const ChartPanel& panel : chart.Panels)
  {
    for (const ChartSeries& series : panel.Series)
    {
      if (!FindChartMethod(series.Method))
      {
        std::cerr << "relievo: bench: " << stem << ": no method '" << series.Method
                  << "' in bench/charts/ChartMethods.cxx: add it there\n";
        return false;
      }
    }
  }
  const ChartDrawing drawing = DrawChart(chart);
  const bool written = WriteSvg(drawing, stem + ".svg") && WritePng(drawing, stem + ".png");
  if (!written)
  {
    std::cerr << "relievo: bench: cannot write " << stem
              << ".svg and .png: is the folder writable?\n";
  }
  return written;
}
}
