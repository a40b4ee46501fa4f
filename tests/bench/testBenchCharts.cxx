// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables and charts of the benches hold what was put in, and say when they cannot be written.
#include "BenchCharts.h"
#include "Chart.h"
#include "ChartLayout.h"
#include "ChartScale.h"
#include "ChartSvg.h"
#include "Check.h"
#include "RelievoBench.h"
#include "Renderer.h"
#include "Session.h"
#include "SmallChart.h"
#include "Table.h"
#include "TextTools.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Count;
using relievoTest::Read;
using relievoTest::SmallChart;

void TestTable()
{
  Table table({ "format", "max" });
  table.AddRow({ "a, b", Number(1. / 3.) });
  table.AddRow({ "with \"quotes\"", Number(1e-7, 2) });
  const std::string path = relievoTest::OutputFolder() + "/table.csv";
  RELIEVO_CHECK(table.WriteCsv(path));
  RELIEVO_CHECK(Read(path) == "format,max\n\"a, b\",0.3333\n\"with \"\"quotes\"\"\",1e-07\n");
  std::vector<CsvRow> rows;
  RELIEVO_CHECK(ReadCsv(path, rows) && rows.size() == 2);
  RELIEVO_CHECK(rows[0].at("format") == "a, b" && NumberIn(rows[0], "max") == 0.3333);
  RELIEVO_CHECK(rows[1].at("format") == "with \"quotes\"" && NumberIn(rows[1], "max") == 1e-7);
  RELIEVO_CHECK(std::isnan(NumberIn(rows[0], "format of old")));
  std::ofstream(path, std::ios::app) << "too,many,fields\n";
  RELIEVO_CHECK(!ReadCsv(path, rows) && !ReadCsv(path + ".not", rows));
  RELIEVO_CHECK(!table.WriteCsv(relievoTest::OutputFolder() + "/no-such-folder/table.csv"));
}

void TestScales()
{
  const Chart chart = SmallChart();
  const ChartScale x = FitX(chart);
  const ChartScale y = FitY(chart);
  RELIEVO_CHECK(x.Low < 1. && x.High > 4. && x.Ticks.size() == 2 && x.Ticks[1].second == "four");
  RELIEVO_CHECK(y.Low < -6. && y.High > -3. && y.Ticks.size() == 4);
  RELIEVO_CHECK(y.Ticks.front().second == "1e-6" && y.Ticks.back().first == -3.);
  RELIEVO_CHECK(!y.Has(0.) && x.Has(0.) && !x.Has(std::strtod("nan", nullptr)));
  RELIEVO_CHECK_NEAR(x.Share(x.Low), 0., 1e-12, "the low end");
  // The same scales in all panels: fitted to all of them.
  Chart even;
  even.Panels.resize(2);
  even.Panels[0].Series.push_back({ "map", "", { 0., 4. }, { -1., 1. } });
  even.Panels[1].Series.push_back({ "map", "", { 2., 12. }, { -1., 1. } });
  const ChartScale evenX = FitX(even);
  RELIEVO_CHECK(evenX.Ticks.size() == 7 && evenX.Ticks[1].second == "2");
  RELIEVO_CHECK(evenX.Low < 0. && evenX.High > 12.);
}

void TestSvg()
{
  const ChartDrawing drawing = DrawChart(SmallChart());
  const std::string svg = SvgOf(drawing);
  RELIEVO_CHECK(svg == SvgOf(DrawChart(SmallChart())));
  // Two discs of the first series and its ring; the square of the second.
  RELIEVO_CHECK(Count(svg, "<circle fill=\"#0072b2\"") == 2);
  RELIEVO_CHECK(Count(svg, "<circle fill=\"none\"") == 1);
  RELIEVO_CHECK(Count(svg, "<path fill=\"#d55e00\"") == 1);
  RELIEVO_CHECK(Count(svg, "a &lt; b &amp; c") == 2);
  RELIEVO_CHECK(Count(svg, ">four<") == 1 && Count(svg, ">1e-5<") == 1);
  RELIEVO_CHECK(Count(svg, ">map<") == 1 && Count(svg, ">one point<") == 1);
}

void TestFiles()
{
  const std::string stem = relievoTest::OutputFolder() + "/small";
  const ChartDrawing drawing = DrawChart(SmallChart());
  RELIEVO_CHECK(WriteChart(SmallChart(), stem));
  RELIEVO_CHECK(Read(stem + ".svg") == SvgOf(drawing));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((stem + ".png").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int* size = image->GetDimensions();
  RELIEVO_CHECK(size[0] == std::lround(drawing.Width) && size[1] == std::lround(drawing.Height));
  // In the middle of each marker is its colour, of each ring its marker's; white is in most places.
  const auto isColor = [&](double x, double y, const std::string& color) {
    const unsigned char* pixel = static_cast<unsigned char*>(
      image->GetScalarPointer(static_cast<int>(x), static_cast<int>(drawing.Height - y), 0));
    const long wanted = std::strtol(color.c_str() + 1, nullptr, 16);
    return std::abs(pixel[0] - (wanted >> 16)) + std::abs(pixel[1] - (wanted >> 8 & 255)) +
      std::abs(pixel[2] - (wanted & 255)) <
      12;
  };
  int markers = 0;
  for (const ChartMark& mark : drawing.Marks)
  {
    if (mark.Kind == ChartMark::Disc || mark.Kind == ChartMark::Area)
    {
      ChartPoint middle;
      for (const ChartPoint& point : mark.Points)
      {
        middle.X += point.X / static_cast<double>(mark.Points.size());
        middle.Y += point.Y / static_cast<double>(mark.Points.size());
      }
      RELIEVO_CHECK_THAT(isColor(middle.X, middle.Y, mark.Color), mark.Method);
      ++markers;
    }
    else if (mark.Kind == ChartMark::Ring)
    {
      // Thinner than two pixels: none need be all black.
      RELIEVO_CHECK(!isColor(mark.Points[0].X + mark.Radius, mark.Points[0].Y, "#ffffff"));
      RELIEVO_CHECK(isColor(mark.Points[0].X + mark.Radius + 3., mark.Points[0].Y - 6., "#ffffff"));
    }
  }
  RELIEVO_CHECK(markers == 3);
  int white = 0;
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    white += isColor(i % size[0], drawing.Height - i / size[0], "#ffffff") ? 1 : 0;
  }
  RELIEVO_CHECK(white > size[0] * size[1] / 2);
  RELIEVO_CHECK(!WriteChart(SmallChart(), relievoTest::OutputFolder() + "/no-such-folder/small"));
}

void TestBars()
{
  Chart chart;
  chart.Kind = Chart::Bars;
  chart.Panels.resize(2);
  chart.Columns = 2;
  for (const double value : { 1., 2. })
  {
    const std::string method = value == 1. ? "plain" : "depth";
    chart.Panels[0].Series.push_back({ method, "", { value }, {} });
    chart.Panels[1].Series.push_back({ method, "", { 2. * value }, {} });
  }
  RELIEVO_CHECK(FitX(chart).Low == 0. && FitX(chart).High > 4.);
  const ChartDrawing drawing = DrawChart(chart);
  std::vector<double> widths;
  int names = 0;
  for (const ChartMark& mark : drawing.Marks)
  {
    if (mark.Kind == ChartMark::Area)
    {
      widths.push_back(mark.Points[1].X - mark.Points[0].X);
    }
    names += mark.Kind == ChartMark::Words && !mark.Method.empty() ? 1 : 0;
  }
  RELIEVO_CHECK(names == 2); // once for both panels
  if (RELIEVO_CHECK(widths.size() == 4))
  {
    RELIEVO_CHECK_NEAR(widths[1], 2. * widths[0], 1e-6, "bar of 2");
    RELIEVO_CHECK_NEAR(widths[2], 2. * widths[0], 1e-6, "bar of 2 in the other panel");
    RELIEVO_CHECK_NEAR(widths[3], 4. * widths[0], 1e-6, "bar of 4");
  }
  chart.Kind = Chart::Dots;
  chart.Panels[1].Series[1].X = { HUGE_VAL };
  RELIEVO_CHECK(Count(SvgOf(DrawChart(chart)), ">infinite<") == 1);
}

// A table of something else under a bench's name.
void TestOtherColumns()
{
  const std::string folder = relievoTest::OutputFolder() + "/other";
  Table table({ "name", "value" });
  table.AddRow({ "a", "1" });
  RELIEVO_CHECK(MakeFolder(folder) && table.WriteCsv(folder + "/depth.csv"));
  std::vector<NamedChart> charts;
  RELIEVO_CHECK(!ChartsOfBench("depth", folder, charts));
  RELIEVO_CHECK(charts.empty());
}

// Charts say which renderer their folder was measured on.
void TestRenderer(const std::string& chartsFolder)
{
  const std::string folder = relievoTest::OutputFolder() + "/renderer";
  RELIEVO_CHECK(RelievoBench("depth", folder) == 0);
  RELIEVO_CHECK(std::ifstream(folder + "/renderer.txt").good());
  const auto write = [&folder](const std::string& name) {
    std::ofstream(folder + "/renderer.txt") << name << "\n";
  };
  write("llvmpipe (LLVM 15.0.6, 256 bits)");
  RELIEVO_CHECK(ReadRenderer(folder) == "software OpenGL");
  write("NVIDIA H200/PCIe/SSE2");
  RELIEVO_CHECK(ReadRenderer(folder) == "NVIDIA H200/PCIe/SSE2");
  RELIEVO_CHECK(ReadRenderer(folder + "/none") == "software OpenGL");
  RELIEVO_CHECK(FindRenderer("OpenGL vendor string:  A\nOpenGL renderer string:  B C\nD") == "B C");
  RELIEVO_CHECK(FindRenderer("OpenGL renderer string:\nD").empty() && FindRenderer("").empty());
  RELIEVO_CHECK(NameRenderer("ms, software OpenGL", "B") == "ms, B");
  RELIEVO_CHECK(NameRenderer("Software OpenGL. Grey", "B") == "B. Grey");
  RELIEVO_CHECK(
    NameRenderer("Software OpenGL. Grey", "software OpenGL") == "Software OpenGL. Grey");
  // Of charts that do say it.
  std::vector<NamedChart> charts;
  const std::string real = relievoTest::OutputFolder() + "/position";
  RELIEVO_CHECK(MakeFolder(real));
  std::ifstream from(chartsFolder + "/position.csv", std::ios::binary);
  std::ofstream(real + "/position.csv", std::ios::binary) << from.rdbuf();
  std::ofstream(real + "/renderer.txt") << "Some GPU\n";
  RELIEVO_CHECK(ChartsOfBench("position", real, charts));
  bool named = false;
  for (const NamedChart& chart : charts)
  {
    named = named || chart.What.X.Title == "times a plain frame, Some GPU";
  }
  RELIEVO_CHECK_THAT(named, "a chart of times names the GPU");
}

void TestNames()
{
  RELIEVO_CHECK(RelievoBench("no such bench", relievoTest::OutputFolder()) == 2);
  RELIEVO_CHECK(RelievoBenchEntries().size() >= 2);
  RELIEVO_CHECK(RelievoBench("depth", relievoTest::OutputFolder() + "/small.svg/under") == 1);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  relievoTest::TextTools text;
  relievoTest::Session session;
  TestTable();
  TestRenderer(argc > 1 ? argv[1] : "docs/charts");
  TestScales();
  TestSvg();
  TestFiles();
  TestBars();
  TestOtherColumns();
  TestNames();
  text.Release();
  return session.Result();
}
