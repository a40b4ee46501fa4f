// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef relievoTestSmallChart_h
#define relievoTestSmallChart_h

#include "Chart.h"

#include <fstream>
#include <sstream>
#include <string>

namespace relievoTest
{
inline std::string Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline int Count(const std::string& text, const std::string& part)
{
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

/** Two methods, one with the ring of the default. */
inline relievoBench::Chart SmallChart()
{
  relievoBench::Chart chart;
  chart.Title = "a < b & c";
  chart.X.Title = "bytes";
  chart.X.Ticks = { { 1., "one" }, { 4., "four" } };
  chart.Y.Title = "error";
  chart.Y.Log = true;
  chart.Panels.resize(1);
  // Zero has no place on a logarithmic axis.
  chart.Panels[0].Series.push_back({ "map", "", { 1., 2., 4. }, { 1e-3, 0., 1e-6 }, true, 2 });
  chart.Panels[0].Series.push_back({ "forward", "one point", { 3. }, { 1e-4 }, true, -1 });
  return chart;
}
}

#endif
