// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScalarBar.h"

#include "Annotation.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <array>
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
  const WrittenValues values = WriteValues(ListValues(map->GetRange()));
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
