// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScalarBar.h"

#include "vtkColorTransferFunction.h"
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
constexpr double Width = 0.1;        // of the picture's, as all below
constexpr double Right = 0.97;       // of the bar at the most
constexpr double LabelsAt = 0.043;   // from the bar's left
constexpr double Margin = 0.01;      // beside texts
constexpr double TitleAtMost = 0.45; // as wide
constexpr std::size_t Short = 8;     // letters of a value

// Black or white, whatever is read better on the background.
std::array<double, 3> GetInk(vtkRenderer* renderer)
{
  const auto getLuma = [](const double* rgb) {
    return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
  };
  const double bottom = getLuma(renderer->GetBackground());
  const double luma = renderer->GetGradientBackground()
    ? (bottom + getLuma(renderer->GetBackground2())) / 2.0
    : bottom;
  const double ink = luma > 0.5 ? 0.0 : 1.0;
  return { ink, ink, ink };
}

std::vector<double> ListValues(const double* range)
{
  std::vector<double> values(Labels);
  for (int i = 0; i < Labels; ++i)
  {
    const double share = static_cast<double>(i) / (Labels - 1);
    values[static_cast<std::size_t>(i)] = (1.0 - share) * range[0] + share * range[1];
  }
  return values;
}

// A way to write numbers as printf has it, and the values written so.
struct Written
{
  std::string Format, Longest;
};

Written Write(const std::vector<double>& values, std::chars_format kind, int digits)
{
  Written written;
  written.Format = "%." + std::to_string(digits) + (kind == std::chars_format::fixed ? "f" : "e");
  for (const double value : values)
  {
    std::array<char, 400> letters; // 309 digits before the point
    const std::to_chars_result end =
      std::to_chars(letters.begin(), letters.end(), value, kind, digits);
    const std::string text(letters.data(), end.ptr);
    written.Longest = text.size() > written.Longest.size() ? text : written.Longest;
  }
  return written;
}

// With the fewest digits that are right to a few hundredths of the step between two values.
Written Write(const std::vector<double>& values, std::chars_format kind)
{
  const double step = std::abs(values[1] - values[0]);
  const double largest = std::max(std::abs(values.front()), std::abs(values.back()));
  const double tolerance = step > 0.0 ? 0.03 * step : 0.001 * largest;
  int digits = 0;
  const auto isRight = [&](double value) {
    const double exponent = kind == std::chars_format::fixed || value == 0.0
      ? 0.0
      : std::floor(std::log10(std::abs(value)));
    const double scaled = value / std::pow(10.0, exponent - digits);
    return std::abs(scaled - std::round(scaled)) <= tolerance / std::pow(10.0, exponent - digits);
  };
  while (digits < 17 && !std::all_of(values.begin(), values.end(), isRight))
  {
    ++digits;
  }
  return Write(values, kind, digits);
}

// Exponents are for what would be long without.
Written Write(const std::vector<double>& values)
{
  const Written fixed = Write(values, std::chars_format::fixed);
  const Written scientific = Write(values, std::chars_format::scientific);
  return fixed.Longest.size() <= std::max(Short, scientific.Longest.size()) ? fixed : scientific;
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
void AddScalarBar(vtkRenderer* renderer, vtkColorTransferFunction* map, const std::string& title)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(map);
  bar->SetTitle(title.c_str());
  const int height = renderer->GetSize()[1] > 0 ? renderer->GetSize()[1] : 768;
  bar->SetNumberOfLabels(Labels);
  bar->SetVerticalTitleSeparation(height / 60);
  bar->UnconstrainedFontSizeOn();
  const Written values = Write(ListValues(map->GetRange()));
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
  const double wide = GetWidth(renderer, bar->GetLabelTextProperty(), values.Longest);
  const double left = std::min(
    { Right - Width, 1.0 - Margin - LabelsAt - wide, 1.0 - Margin - (Width + broad) / 2.0 });
  bar->SetPosition(std::max(0.0, left), 0.1);
  bar->SetWidth(Width);
  bar->SetHeight(0.8);
  renderer->AddViewProp(bar);
}
}
