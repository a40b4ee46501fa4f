// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A method has one look in all charts, two have not the same, and words overlap nowhere: of the
// charts of this repository, drawn again from their CSV files, and of crowded ones.
//   testChartLooks [folder of the CSV files]
#include "BenchCharts.h"
#include "Chart.h"
#include "ChartLabels.h"
#include "ChartLayout.h"
#include "ChartSvg.h"
#include "Check.h"
#include "RelievoBench.h"
#include "Session.h"
#include "SmallChart.h"
#include "TextTools.h"

#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace relievoBench;
using relievoTest::Count;
using relievoTest::Read;
using relievoTest::SmallChart;

void TestMethods()
{
  std::set<std::string> names;
  for (const ChartMethod& method : ChartMethods())
  {
    RELIEVO_CHECK_THAT(names.insert(method.Name).second, method.Name + " is there twice");
    RELIEVO_CHECK(FindChartMethod(method.Name) == &method && !method.Label.empty());
  }
  RELIEVO_CHECK(!FindChartMethod("no such method"));
  Chart unknown = SmallChart();
  unknown.Panels[0].Series[0].Method = "no such method";
  RELIEVO_CHECK(!WriteChart(unknown, relievoTest::OutputFolder() + "/unknown"));
}

// Names stay in order and apart, and move no more than they must.
void TestSpread()
{
  const std::vector<double> free = Spread({ 10., 50., 90. }, 15., 0., 100.);
  RELIEVO_CHECK(free == std::vector<double>({ 10., 50., 90. }));
  const std::vector<double> pair = Spread({ 52., 48. }, 15., 0., 100.);
  RELIEVO_CHECK_NEAR(pair[0], 57.5, 1e-9, "the lower of two");
  RELIEVO_CHECK_NEAR(pair[1], 42.5, 1e-9, "the upper of two");
  const std::vector<double> crowd = Spread(std::vector<double>(6, 99.), 15., 0., 100.);
  for (std::size_t i = 0; i < crowd.size(); ++i)
  {
    RELIEVO_CHECK_NEAR(crowd[i], 25. + 15. * static_cast<double>(i), 1e-9, "at the lower end");
  }
}

// What no chart may do: words that overlap, leave the picture or are too small to read; a method
// that has another look than elsewhere; two methods that look alike.
using Looks = std::map<std::string, std::set<std::string>>;

std::string Faults(const ChartDrawing& drawing, Looks& looks)
{
  std::string faults;
  const ChartBox picture = { 0., 0., drawing.Width, drawing.Height };
  std::vector<const ChartMark*> words;
  for (const ChartMark& mark : drawing.Marks)
  {
    const bool isWords = mark.Kind == ChartMark::Words;
    if (!mark.Method.empty())
    {
      looks[mark.Method].insert((isWords ? "words " : "drawn ") + mark.Color);
      if (mark.Kind == ChartMark::Area || mark.Kind == ChartMark::Disc)
      {
        looks[mark.Method].insert("marker " + std::to_string(mark.Points.size()));
      }
    }
    if (!isWords)
    {
      for (const ChartPoint& p : mark.Points)
      {
        const bool within = p.X >= picture.Left && p.X <= picture.Right && p.Y >= picture.Top &&
          p.Y <= picture.Bottom;
        faults += within ? "" : "a mark of '" + mark.Method + "' leaves the picture; ";
      }
      continue;
    }
    const ChartBox box = BoxOf(mark);
    const bool within =
      box.Left >= 0. && box.Top >= 0. && box.Right <= picture.Right && box.Bottom <= picture.Bottom;
    faults += within ? "" : "'" + mark.Text + "' leaves the picture; ";
    faults += mark.Size >= 11. ? "" : "'" + mark.Text + "' is too small; ";
    for (const ChartMark* other : words)
    {
      faults +=
        box.Meets(BoxOf(*other)) ? "'" + mark.Text + "' overlaps '" + other->Text + "'; " : "";
    }
    words.push_back(&mark);
  }
  return faults;
}

std::string FaultsOfMethods(const Looks& looks)
{
  std::string faults;
  for (const auto& [method, look] : looks)
  {
    for (const std::string kind : { "words", "drawn", "marker" })
    {
      const auto count = std::count_if(look.begin(), look.end(),
        [&kind](const std::string& one) { return one.compare(0, kind.size(), kind) == 0; });
      faults += count <= 1 ? "" : "'" + method + "' has several " + kind + "; ";
    }
  }
  return faults;
}

// Colour and marker together tell the methods of a chart apart; in grey, marker and dash.
std::string FaultsOfSeries(const Chart& chart)
{
  std::set<std::string> methods;
  std::set<std::pair<int, int>> markers;
  std::string faults;
  for (const ChartPanel& panel : chart.Panels)
  {
    for (const ChartSeries& series : panel.Series)
    {
      const ChartMethod* method = FindChartMethod(series.Method);
      if (!method)
      {
        faults += "no method '" + series.Method + "'; ";
      }
      else if (methods.insert(series.Method).second && chart.Kind != Chart::Bars)
      {
        const std::pair<int, int> look(
          static_cast<int>(method->Marker), static_cast<int>(method->Dash));
        faults += markers.insert(look).second ? "" : "'" + series.Method + "' looks like another; ";
      }
    }
  }
  return faults;
}

// The checks find what they are for.
void TestFaults()
{
  Looks looks;
  RELIEVO_CHECK(Faults(DrawChart(SmallChart()), looks).empty());
  RELIEVO_CHECK(FaultsOfMethods(looks).empty() && looks.size() == 2);
  ChartDrawing twice = DrawChart(SmallChart());
  const auto name = std::find_if(twice.Marks.begin(), twice.Marks.end(),
    [](const ChartMark& mark) { return mark.Text == "map"; });
  ChartMark copy = *name;
  copy.Points[0].X += 4.;
  copy.Color = "#123456";
  twice.Marks.push_back(copy);
  RELIEVO_CHECK(Faults(twice, looks) == "'map' overlaps 'map'; ");
  RELIEVO_CHECK(FaultsOfMethods(looks) == "'map' has several words; ");
  twice.Marks.back().Points[0].X = twice.Width - 3.;
  RELIEVO_CHECK(Faults(twice, looks) == "'map' leaves the picture; ");
  Chart alike = SmallChart();
  alike.Panels[0].Series[1].Method = "R32F, linear";
  RELIEVO_CHECK(!FaultsOfSeries(alike).empty() && FaultsOfSeries(SmallChart()).empty());
}

// The charts of this repository, from their CSV files.
void TestCommitted(const std::string& folder)
{
  Looks looks;
  int count = 0;
  for (const std::string& bench : BenchesWithCharts())
  {
    std::vector<NamedChart> charts;
    RELIEVO_CHECK_THAT(ChartsOfBench(bench, folder, charts) && !charts.empty(), bench);
    for (const NamedChart& chart : charts)
    {
      const ChartDrawing drawing = DrawChart(chart.What);
      const std::string faults = Faults(drawing, looks) + FaultsOfSeries(chart.What);
      RELIEVO_CHECK_THAT(faults.empty(), chart.Stem + ": " + faults);
      RELIEVO_CHECK_THAT(Read(folder + "/" + chart.Stem + ".svg") == SvgOf(drawing),
        chart.Stem + ".svg is not what its CSV gives: relievo bench --redraw docs/charts");
      RELIEVO_CHECK_THAT(!Read(folder + "/" + chart.Stem + ".png").empty(), chart.Stem);
      const bool ringed = std::any_of(drawing.Marks.begin(), drawing.Marks.end(),
        [](const ChartMark& mark) { return mark.Kind == ChartMark::Ring; });
      RELIEVO_CHECK_THAT(ringed == (Count(chart.What.Note, "Ring:") == 1), chart.Stem);
      ++count;
    }
  }
  RELIEVO_CHECK_THAT(FaultsOfMethods(looks).empty(), FaultsOfMethods(looks));
  RELIEVO_CHECK_AT_MOST(15., count, "charts");
}

// As many names as fit, at one place: at the right end, and in the plot.
void TestCrowds()
{
  Looks looks;
  for (const double end : { 4., 2.5 })
  {
    Chart chart = SmallChart();
    chart.Panels[0].Series.clear();
    for (const char* method :
      { "map", "forward", "warped", "vtkShadowMapPass", "cube", "sphere map", "lat-long" })
    {
      chart.Panels[0].Series.push_back({ method, "", { 1., end }, { 1e-3, 1e-6 } });
    }
    const ChartDrawing drawing = DrawChart(chart);
    RELIEVO_CHECK_THAT(Faults(drawing, looks).empty(), Faults(drawing, looks));
  }
}

// Words take no more room than the layout thinks.
void TestTextWidth()
{
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  vtkNew<vtkTextProperty> arial;
  arial->SetFontFamilyToArial();
  arial->SetFontSize(12);
  for (const std::string text : { "octahedral precise", "R16F, scaled by 2^k, 2 B",
         "vtkShadowMapPass", "sun at 10°", "WWWMMM@@", "illi.,:'|", "1e-5" })
  {
    int box[4] = {};
    RELIEVO_CHECK(renderer && renderer->GetBoundingBox(arial, text, box, 72));
    RELIEVO_CHECK_AT_MOST(box[1] - box[0] - 2., TextWidth(text, 12.), text + ": width");
  }
}

void TestRedraw(const std::string& folder)
{
  const std::string out = relievoTest::OutputFolder() + "/redrawn";
  RELIEVO_CHECK(RelievoBenchRedraw("depth", folder, out) == 0);
  RELIEVO_CHECK(Read(out + "/depth-ratio.svg") == Read(folder + "/depth-ratio.svg"));
  RELIEVO_CHECK(RelievoBenchRedraw("depth", out + "/nowhere", out) == 1);
  RELIEVO_CHECK(RelievoBenchRedraw("no such bench", folder, out) == 2);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  relievoTest::TextTools text;
  relievoTest::Session session;
  const std::string charts = argc > 1 ? argv[1] : "docs/charts";
  TestMethods();
  TestSpread();
  TestFaults();
  TestCommitted(charts);
  TestCrowds();
  TestTextWidth();
  TestRedraw(charts);
  text.Release();
  return session.Result();
}
