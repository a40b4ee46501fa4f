// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Charts 1 to 3: formats of normals, of depth, and of positions.
#include "BenchCharts.h"
#include "ChartMethods.h"

#include <algorithm>

namespace relievoBench
{
namespace
{
void TickAt(ChartAxis& axis, const std::vector<double>& values)
{
  for (double value : values)
  {
    axis.Ticks.emplace_back(value, Number(value));
  }
}

// The format without its bits: "octahedral precise 2x16".
std::string NormalFamily(const std::string& format)
{
  return format.substr(0, format.find_last_of(' '));
}

ChartPanel NormalsPanel(const CsvRows& rows, bool mean, bool overTime)
{
  ChartPanel panel;
  panel.Title = overTime ? "" : mean ? "mean error" : "largest error";
  for (const CsvRow& row : rows)
  {
    ChartSeries& series = SeriesOf(panel, NormalFamily(row.at("format")));
    const double bits = NumberIn(row, "bits");
    series.Default = series.Method == "octahedral" && bits == 32.
      ? static_cast<int>(series.X.size())
      : series.Default;
    series.X.push_back(overTime ? NumberIn(row, "encode ns") + NumberIn(row, "decode ns") : bits);
    series.Y.push_back(mean
        ? NumberIn(row, "mean degrees")
        : std::max(NumberIn(row, "max"), NumberIn(row, "max at axes and seams")));
  }
  return panel;
}

const char* const PeerNote = "Ring: the default. Grey: not offered.";

// Formats as CSV files of positions name them: a star marks what is not offered.
std::string DepthMethod(std::string format)
{
  if (format.size() > 2 && format.substr(format.size() - 2) == " *")
  {
    format.resize(format.size() - 2);
  }
  return format == "depth R16F"            ? "R16F, scaled by 2^k"
    : format == "depth R32F"               ? "R32F, linear"
    : format == "depth R32F + id, refined" ? "R32F and id, refined"
                                           : format;
}

std::string WithBytes(const std::string& method, const std::string& bytes)
{
  const ChartMethod* found = FindChartMethod(method);
  return (found ? found->Label : method) + ", " + bytes + " B";
}

Chart PositionChart(const CsvRows& rows, bool overTime)
{
  Chart chart;
  chart.Kind = overTime ? Chart::Curves : Chart::Dots;
  chart.Title = overTime ? "Positions: largest error against frame time"
                         : "Positions: largest error by what a pixel keeps";
  chart.Note = std::string(PeerNote) +
    (overTime ? " Their frames are timed with layers of as many bytes." : " Perspective.");
  chart.Columns = overTime ? 1 : 2;
  for (const char* place : { "origin", "(5e5, 5e6, 0)" })
  {
    ChartPanel panel;
    panel.Title = std::string("scene at ") + (chart.Panels.empty() ? "the origin" : place);
    for (const CsvRow& row : rows)
    {
      if (row.at("projection") != "perspective" || row.at("scene at") != place)
      {
        continue;
      }
      ChartSeries series;
      series.Method = DepthMethod(row.at("format"));
      const double error = NumberIn(row, "max");
      series.X.push_back(overTime ? NumberIn(row, "times a plain frame") : error);
      series.Y.push_back(error);
      series.Default = series.Method == "R32F and id, refined" ? 0 : -1;
      series.Name = overTime ? "" : WithBytes(series.Method, row.at("bytes"));
      panel.Series.push_back(series);
    }
    chart.Panels.push_back(panel);
  }
  ChartAxis& errors = overTime ? chart.Y : chart.X;
  errors.Title = "pixels";
  errors.Log = true;
  if (overTime)
  {
    chart.X.Title = "times a plain frame, software OpenGL";
  }
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> NormalsCharts(const std::vector<CsvRows>& files)
{
  Chart bits;
  bits.Title = "Normals: error against bits";
  bits.Note = std::string(PeerNote);
  bits.Columns = 2;
  bits.X.Title = "bits per normal";
  bits.X.Log = true;
  TickAt(bits.X, { 16., 20., 24., 32., 48., 96. });
  bits.Y.Title = "degrees";
  bits.Y.Log = true;
  bits.Panels = { NormalsPanel(files[0], false, false), NormalsPanel(files[0], true, false) };
  Chart time;
  time.Title = "Normals: largest error against time on the CPU";
  time.Note = bits.Note;
  time.X.Title = "nanoseconds to encode and decode, one core";
  time.X.Log = true;
  TickAt(time.X, { 2., 5., 10., 20., 50., 100., 200. });
  time.Y = bits.Y;
  time.Panels = { NormalsPanel(files[0], false, true) };
  return { { "normals-bits", bits }, { "normals-time", time } };
}

//------------------------------------------------------------------------------
std::vector<NamedChart> DepthCharts(const std::vector<CsvRows>& files)
{
  Chart ratio;
  ratio.Title = "Depth: largest relative error against far / near";
  ratio.Note = PeerNote;
  ratio.X.Title = "far / near";
  ratio.X.Log = true;
  ratio.Y.Title = "largest relative error";
  ratio.Y.Log = true;
  ratio.Panels.resize(1);
  Chart bytes;
  bytes.Kind = Chart::Dots;
  bytes.Title = "Depth: largest relative error, by format and bytes per pixel";
  bytes.Note = std::string(PeerNote) + " Marks: far / near = 1e2, 1e3, 1e4, 1e5, 1e6.";
  bytes.X = ratio.Y;
  bytes.Panels.resize(1);
  for (const CsvRow& row : files[0])
  {
    ChartSeries& over = SeriesOf(ratio.Panels[0], row.at("format"));
    over.X.push_back(NumberIn(row, "far/near"));
    over.Y.push_back(NumberIn(row, "max"));
    ChartSeries& of = SeriesOf(bytes.Panels[0], row.at("format"));
    of.Name = WithBytes(of.Method, row.at("bytes"));
    of.X.push_back(NumberIn(row, "max"));
    const bool isDefault = of.Method == "R32F, linear";
    over.Default = isDefault ? static_cast<int>(over.X.size()) - 1 : -1;
    of.Default = isDefault ? static_cast<int>(of.X.size()) - 1 : -1;
  }
  return { { "depth-bytes", bytes }, { "depth-ratio", ratio } };
}

//------------------------------------------------------------------------------
std::vector<NamedChart> PositionCharts(const std::vector<CsvRows>& files)
{
  return { { "position-bytes", PositionChart(files[0], false) },
    { "position-time", PositionChart(files[0], true) } };
}

//------------------------------------------------------------------------------
std::vector<NamedChart> GBufferCharts(const std::vector<CsvRows>& files)
{
  Chart chart;
  chart.Kind = Chart::Bars;
  chart.Title = "Frames of 1920 x 1080 pixels with layers";
  chart.Note = "Software OpenGL. Grey: the peer, with a kernel of one sample.";
  chart.X.Title = "times a plain frame";
  for (const CsvRow& row : files[0])
  {
    if (row.at("pixels") != "1920x1080" || row.at("frame") == "plain")
    {
      continue;
    }
    ChartPanel& panel = PanelOf(chart, row.at("scene"));
    SeriesOf(panel, row.at("frame")).X = { NumberIn(row, "times a plain frame") };
  }
  chart.Columns = static_cast<int>(chart.Panels.size());
  TickAt(chart.X, { 0., 1., 2., 3. });
  return { { "gbuffer", chart } };
}
}
