// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables and charts of the benches hold what was put in, and say when they cannot be written.
#include "Chart.h"
#include "ChartScale.h"
#include "ChartSvg.h"
#include "Check.h"
#include "RelievoBench.h"
#include "Session.h"
#include "Table.h"
#include "TextTools.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace
{
using namespace relievoBench;

std::string Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

int Count(const std::string& text, const std::string& part)
{
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

Chart SmallChart()
{
  Chart chart;
  chart.Title = "a < b & c";
  chart.X.Title = "bytes";
  chart.X.Ticks = { { 1., "one" }, { 4., "four" } };
  chart.Y.Title = "error";
  chart.Y.Log = true;
  // Zero has no place on a logarithmic axis.
  chart.Series.push_back({ "first", { 1., 2., 4. }, { 1e-3, 0., 1e-6 }, true });
  chart.Series.push_back({ "second", { 3. }, { 1e-4 }, true });
  return chart;
}

void TestTable()
{
  Table table({ "format", "max" });
  table.AddRow({ "a, b", Number(1. / 3.) });
  table.AddRow({ "with \"quotes\"", Number(1e-7, 2) });
  const std::string path = relievoTest::OutputFolder() + "/table.csv";
  RELIEVO_CHECK(table.WriteCsv(path));
  RELIEVO_CHECK(Read(path) == "format,max\n\"a, b\",0.3333\n\"with \"\"quotes\"\"\",1e-07\n");
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
  RELIEVO_CHECK(Places(chart.Series[0], x, y).size() == 2);
  Chart even;
  even.Series.push_back({ "series", { 0., 12. }, { -1., 1. }, true });
  const ChartScale evenX = FitX(even);
  RELIEVO_CHECK(evenX.Ticks.size() == 7 && evenX.Ticks[1].second == "2");
}

void TestSvg()
{
  const std::string svg = SvgOf(SmallChart());
  RELIEVO_CHECK(svg == SvgOf(SmallChart()));
  // Two markers of the first series and its legend, one of the second and its legend.
  RELIEVO_CHECK(Count(svg, "<circle") == 3);
  RELIEVO_CHECK(Count(svg, "<rect fill=\"#d55e00\"") == 2);
  RELIEVO_CHECK(Count(svg, "a &lt; b &amp; c") == 2);
  RELIEVO_CHECK(Count(svg, ">four<") == 1 && Count(svg, ">1e-5<") == 1);
}

void TestFiles()
{
  const std::string stem = relievoTest::OutputFolder() + "/small";
  RELIEVO_CHECK(WriteChart(SmallChart(), stem));
  RELIEVO_CHECK(Read(stem + ".svg") == SvgOf(SmallChart()));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((stem + ".png").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  RELIEVO_CHECK(image->GetDimensions()[0] == ChartWidth);
  RELIEVO_CHECK(image->GetDimensions()[1] == ChartHeight);
  int white = 0;
  int inColor[2] = { 0, 0 };
  for (int y = 0; y < image->GetDimensions()[1]; ++y)
  {
    for (int x = 0; x < image->GetDimensions()[0]; ++x)
    {
      const unsigned char* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      white += pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255 ? 1 : 0;
      for (int i = 0; i < 2; ++i)
      {
        const ChartStyle style = StyleOf(i);
        int apart = 0;
        for (int c = 0; c < 3; ++c)
        {
          apart += std::abs(pixel[c] - style.Color[c]);
        }
        inColor[i] += apart < 12 ? 1 : 0;
      }
    }
  }
  RELIEVO_CHECK(white > ChartWidth * ChartHeight / 2);
  RELIEVO_CHECK(inColor[0] > 200 && inColor[1] > 50);
  RELIEVO_CHECK(!WriteChart(SmallChart(), relievoTest::OutputFolder() + "/no-such-folder/small"));
}

// The value of an attribute of the n-th element that begins so.
double Attribute(const std::string& svg, const std::string& element, int n, const std::string& name)
{
  std::size_t at = svg.find(element);
  for (; n > 0 && at != std::string::npos; --n)
  {
    at = svg.find(element, at + 1);
  }
  const std::size_t value = at == std::string::npos ? at : svg.find(" " + name + "=\"", at);
  return value == std::string::npos ? 0. : std::atof(svg.c_str() + value + name.size() + 3);
}

void TestBars()
{
  Chart chart;
  chart.X.Ticks = { { 1., "here" }, { 2., "there" } };
  for (double value : { 1., 2. })
  {
    ChartSeries series;
    series.Name = "bars";
    series.X = { 1., 2. };
    series.Y = { value, 2. * value };
    series.Bars = true;
    chart.Series.push_back(series);
  }
  RELIEVO_CHECK(HasBars(chart) && !HasBars(SmallChart()));
  RELIEVO_CHECK(FitY(chart).Low == 0. && FitX(chart).Low < 0.5 && FitX(chart).High > 2.5);
  const std::string svg = SvgOf(chart);
  const std::string first = "<rect fill=\"#0072b2\"";
  const std::string second = "<rect fill=\"#d55e00\"";
  RELIEVO_CHECK(Count(svg, first) == 2 && Count(svg, second) == 3); // and a square in the legend
  const double one = Attribute(svg, first, 0, "height");
  RELIEVO_CHECK_NEAR(Attribute(svg, first, 1, "height"), 2. * one, 0.02, "bar of 2");
  RELIEVO_CHECK_NEAR(Attribute(svg, second, 1, "height"), 4. * one, 0.04, "bar of 4");
  const double right = Attribute(svg, first, 0, "x") + Attribute(svg, first, 0, "width");
  RELIEVO_CHECK_NEAR(Attribute(svg, second, 0, "x"), right, 0.02, "bars side by side");

  // The picture: the second colour's bars are twice as high.
  const std::string stem = relievoTest::OutputFolder() + "/bars";
  RELIEVO_CHECK(WriteChart(chart, stem));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((stem + ".png").c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  double inColor[2] = { 0., 0. };
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    const unsigned char* pixel =
      static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer()) + 3 * i;
    for (int k = 0; k < 2; ++k)
    {
      const ChartStyle style = StyleOf(k);
      inColor[k] += std::equal(style.Color, style.Color + 3, pixel) ? 1. : 0.;
    }
  }
  RELIEVO_CHECK(inColor[0] > 10000.);
  RELIEVO_CHECK_NEAR(inColor[1] / inColor[0], 2., 0.1, "pixels of the bars");
}

void TestNames()
{
  RELIEVO_CHECK(RelievoBench("no such bench", relievoTest::OutputFolder()) == 2);
  RELIEVO_CHECK(RelievoBenchEntries().size() >= 2);
  RELIEVO_CHECK(RelievoBench("depth", relievoTest::OutputFolder() + "/small.svg/under") == 1);
}
}

//------------------------------------------------------------------------------
int main()
{
  relievoTest::TextTools text;
  relievoTest::Session session;
  TestTable();
  TestScales();
  TestSvg();
  TestFiles();
  TestBars();
  TestNames();
  text.Release();
  return session.Result();
}
