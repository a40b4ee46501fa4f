// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScalarBar.h"

#include "Annotation.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace scene
{
namespace
{
constexpr int Labels = 5;
constexpr int MostWrittenSteps = 13; // where colours change
constexpr int MostDecades = 8;
constexpr double Width = 0.1;        // share of the picture, like those below
constexpr double Right = 0.97;       // right limit of the bar
constexpr double LabelsAt = 0.043;   // from the bar's left
constexpr double Margin = 0.01;      // beside texts
constexpr double TitleAtMost = 0.45; // largest width

// Evenly spaced values.
std::vector<double> ListValues(const double* range, int count)
{
  std::vector<double> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    const double share = static_cast<double>(i) / (count - 1);
    values[static_cast<std::size_t>(i)] = (1.0 - share) * range[0] + share * range[1];
  }
  return values;
}

// Values of a logarithmic map: where the steps' colours change, or the ends and powers of ten.
std::vector<double> ListLogValues(const double* range, int steps)
{
  const double logs[2] = { std::log10(range[0]), std::log10(range[1]) };
  std::vector<double> values;
  if (steps > 0)
  {
    for (const double log : ListValues(logs, steps + 1))
    {
      values.push_back(std::pow(10.0, log));
    }
    return values;
  }
  const int every = std::max(1, static_cast<int>(std::ceil((logs[1] - logs[0]) / MostDecades)));
  const double gap = 0.06 * (logs[1] - logs[0]);
  values.push_back(range[0]);
  for (int decade = static_cast<int>(std::floor(logs[0])); decade < logs[1]; ++decade)
  {
    if (decade > logs[0] + gap && decade < logs[1] - gap && decade % every == 0)
    {
      values.push_back(std::pow(10.0, decade));
    }
  }
  values.push_back(range[1]);
  return values;
}

// Writes values that are not evenly spaced.
WrittenValues WriteLogValues(const std::vector<double>& values)
{
  WrittenValues written;
  written.Format = "%.4g";
  for (const double value : values)
  {
    std::array<char, 32> letters;
    const std::to_chars_result end =
      std::to_chars(letters.begin(), letters.end(), value, std::chars_format::general, 4);
    written.Texts.emplace_back(letters.data(), end.ptr);
  }
  return written;
}

// The text's width as a share of the picture's.
double GetWidth(vtkRenderer* renderer, vtkTextProperty* property, const std::string& text)
{
  const int dpi = renderer->GetRenderWindow() ? renderer->GetRenderWindow()->GetDPI() : 72;
  std::array<int, 4> box{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, text, box.data(), dpi);
  return static_cast<double>(box[1] - box[0] + 1) /
    (renderer->GetSize()[0] > 0 ? renderer->GetSize()[0] : 1024);
}
}

//------------------------------------------------------------------------------
void AddScalarBar(
  vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title, int steps)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(map);
  bar->SetTitle(title.c_str());
  const int height = renderer->GetSize()[1] > 0 ? renderer->GetSize()[1] : 768;
  const bool log = map->GetScale() == VTK_CTF_LOG10;
  const int written = steps > 0 && steps < MostWrittenSteps ? steps : 0;
  const std::vector<double> labels = log
    ? ListLogValues(map->GetRange(), written)
    : ListValues(map->GetRange(), written > 0 ? written + 1 : Labels);
  if (log || written > 0)
  {
    vtkNew<vtkDoubleArray> places;
    for (const double label : labels)
    {
      places->InsertNextValue(label);
    }
    bar->SetCustomLabels(places);
    bar->UseCustomLabelsOn();
  }
  bar->SetNumberOfLabels(Labels);
  if (steps > 0)
  {
    bar->SetMaximumNumberOfColors(steps);
  }
  bar->SetVerticalTitleSeparation(height / 60);
  bar->UnconstrainedFontSizeOn();
  const WrittenValues values = log ? WriteLogValues(labels) : WriteValues(labels);
  bar->SetLabelFormat(values.Format.c_str());
  const std::array<double, 3> ink = GetInk(renderer);
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetColor(ink[0], ink[1], ink[2]);
    text->SetFontSize(std::max(8, height / 45));
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
  double broad = GetWidth(renderer, bar->GetTitleTextProperty(), title);
  if (broad > TitleAtMost)
  {
    const int size = bar->GetTitleTextProperty()->GetFontSize();
    bar->GetTitleTextProperty()->SetFontSize(
      std::max(6, static_cast<int>(size * TitleAtMost / broad)));
    broad = GetWidth(renderer, bar->GetTitleTextProperty(), title);
  }
  double wide = 0.0;
  for (const std::string& text : values.Texts)
  {
    wide = std::max(wide, GetWidth(renderer, bar->GetLabelTextProperty(), text));
  }
  const double left = std::min(
    { Right - Width, 1.0 - Margin - LabelsAt - wide, 1.0 - Margin - (Width + broad) / 2.0 });
  bar->SetPosition(std::max(0.0, left), 0.1);
  bar->SetWidth(Width);
  bar->SetHeight(0.8);
  renderer->AddViewProp(bar);
}
}
