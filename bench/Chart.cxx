// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"

#include "ChartScale.h"
#include "ChartSvg.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <fstream>
#include <iostream>

namespace relievoBench
{
namespace
{
// The axes hold logarithms: vtkAxis' own logarithmic scale chooses sparse and changing marks.
void SetUpAxis(vtkAxis* axis, const std::string& title, const ChartScale& scale)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(15);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(13);
  axis->GetGridPen()->SetColor(225, 225, 225, 255);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (const auto& tick : scale.Ticks)
  {
    places->InsertNextValue(tick.first);
    labels->InsertNextValue(tick.second);
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(scale.Low, scale.High);
  axis->SetCustomTickPositions(places, labels);
}

int MarkerOf(ChartStyle::Shape shape)
{
  switch (shape)
  {
    case ChartStyle::Square:
      return vtkPlotPoints::SQUARE;
    case ChartStyle::Diamond:
      return vtkPlotPoints::DIAMOND;
    case ChartStyle::Plus:
      return vtkPlotPoints::PLUS;
    case ChartStyle::Cross:
      return vtkPlotPoints::CROSS;
    case ChartStyle::Circle:
      break;
  }
  return vtkPlotPoints::CIRCLE;
}

void AddSeries(
  vtkChartXY* chart, const ChartSeries& series, int index, const ChartScale& x, const ChartScale& y)
{
  const std::vector<std::pair<double, double>> places = Places(series, x, y);
  if (places.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> across;
  vtkNew<vtkDoubleArray> up;
  across->SetName("x");
  up->SetName(series.Name.c_str());
  for (const auto& place : places)
  {
    across->InsertNextValue(place.first);
    up->InsertNextValue(place.second);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(across);
  table->AddColumn(up);
  const ChartStyle style = StyleOf(index);
  if (series.Bars)
  {
    vtkPlot* bars = chart->AddPlot(vtkChart::BAR);
    bars->SetInputData(table, 0, 1);
    bars->SetColor(style.Color[0], style.Color[1], style.Color[2], 255);
    bars->GetPen()->SetLineType(vtkPen::NO_PEN);
    return;
  }
  // VTK reports an error for a line of one point.
  const bool line = series.Line && places.size() > 1;
  vtkPlotPoints* plot =
    vtkPlotPoints::SafeDownCast(chart->AddPlot(line ? vtkChart::LINE : vtkChart::POINTS));
  plot->SetInputData(table, 0, 1);
  plot->SetColor(style.Color[0], style.Color[1], style.Color[2], 255);
  plot->SetWidth(1.5f);
  plot->GetPen()->SetLineType(style.Dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  plot->SetMarkerStyle(MarkerOf(style.Marker));
  plot->SetMarkerSize(9.f);
}

void SetUpLegend(vtkChartXY* chart)
{
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->SetInline(false);
  legend->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->GetLabelProperties()->SetFontSize(13);
  legend->GetPen()->SetColor(160, 160, 160, 255);
  legend->GetBrush()->SetColor(255, 255, 255, 255);
}

bool WritePng(const Chart& wanted, const std::string& path)
{
  vtkNew<vtkContextView> view;
  vtkRenderWindow* window = view->GetRenderWindow();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(ChartWidth, ChartHeight);
  view->GetRenderer()->SetBackground(1., 1., 1.);
  vtkNew<vtkChartXY> chart;
  view->GetScene()->AddItem(chart);
  chart->SetTitle(wanted.Title);
  chart->SetBarWidthFraction(static_cast<float>(BarShare));
  chart->GetTitleProperties()->SetFontSize(17);

  const ChartScale x = FitX(wanted);
  const ChartScale y = FitY(wanted);
  for (std::size_t i = 0; i < wanted.Series.size(); ++i)
  {
    AddSeries(chart, wanted.Series[i], static_cast<int>(i), x, y);
  }
  SetUpAxis(chart->GetAxis(vtkAxis::BOTTOM), wanted.X.Title, x);
  SetUpAxis(chart->GetAxis(vtkAxis::LEFT), wanted.Y.Title, y);
  SetUpLegend(chart);
  window->Render();

  vtkNew<vtkWindowToImageFilter> shot;
  shot->SetInput(window);
  shot->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(shot->GetOutputPort());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

bool WriteSvg(const Chart& chart, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file << SvgOf(chart);
  file.close();
  return static_cast<bool>(file);
}
}

//------------------------------------------------------------------------------
bool WriteChart(const Chart& chart, const std::string& stem)
{
  const bool written = WriteSvg(chart, stem + ".svg") && WritePng(chart, stem + ".png");
  if (!written)
  {
    std::cerr << "bench: cannot write " << stem << ".svg and .png: is the folder writable?\n";
  }
  return written;
}
}
