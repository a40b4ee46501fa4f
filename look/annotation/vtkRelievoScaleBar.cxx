// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoScaleBar.h"

#include "vtkRelievoAnnotation.h"
#include "vtkRelievoOverlayPen.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace
{
constexpr int LinesOfText = 40; // lines per shorter side of the picture
constexpr int SmallestText = 9; // pixels; lengths below are in units of the text's size
constexpr double Margin = 0.9;  // to the picture's edges
constexpr double Thickness = 0.25;
constexpr double Gap = 0.3; // between the bar and its label
constexpr double Halo = 0.08;
constexpr double Jitter = 1e-6; // tolerance for lengths seen by different tiles

// Pixels per unit length across the view; 0 if the camera or the tile has none.
double GetPixelsPerUnit(vtkRenderer* renderer, double depth)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  int size[2], lower[2];
  renderer->GetTiledSizeAndOrigin(size, size + 1, lower, lower + 1);
  if (size[0] < 1 || size[1] < 1)
  {
    return 0.0;
  }
  double point[4], along[3];
  camera->GetPosition(point);
  camera->GetDirectionOfProjection(along);
  for (int i = 0; i < 3; ++i)
  {
    point[i] += (depth > 0.0 ? depth : camera->GetDistance()) * along[i];
  }
  point[3] = 1.0;
  const vtkMatrix4x4* toView = camera->GetViewTransformMatrix();
  double right[4] = { toView->GetElement(0, 0), toView->GetElement(0, 1), toView->GetElement(0, 2),
    0.0 };
  const double norm = std::hypot(right[0], right[1], right[2]);
  vtkMatrix4x4* toNDC =
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  double moved[4];
  toNDC->MultiplyPoint(right, moved);
  toNDC->MultiplyPoint(point, point);
  // w is constant across the view.
  const double pixels = 0.5 * size[0] * moved[0] / (norm * point[3]);
  return std::isfinite(pixels) ? std::max(pixels, 0.0) : 0.0;
}

std::string WriteLength(double length)
{
  const bool plain = length >= 1e-4 && length < 1e7;
  std::array<char, 32> letters;
  const std::to_chars_result end = std::to_chars(letters.begin(), letters.end(), length,
    plain ? std::chars_format::fixed : std::chars_format::general);
  return { letters.data(), end.ptr };
}
}

vtkStandardNewMacro(vtkRelievoScaleBar);

//------------------------------------------------------------------------------
vtkRelievoScaleBar::vtkRelievoScaleBar() = default;

//------------------------------------------------------------------------------
vtkRelievoScaleBar::~vtkRelievoScaleBar() = default;

//------------------------------------------------------------------------------
double vtkRelievoScaleBar::GetShownLength(vtkRenderer* renderer)
{
  if (!renderer || !renderer->GetRenderWindow())
  {
    return 0.0;
  }
  const double perUnit = GetPixelsPerUnit(renderer, this->Depth);
  const int width = renderer->GetSize()[0];
  if (perUnit <= 0.0 || (this->Length > 0.0 && this->Length * perUnit > width))
  {
    return 0.0;
  }
  return this->Length > 0.0
    ? this->Length
    : vtkRelievoAnnotation::RoundDown((1.0 + Jitter) * this->Share * width / perUnit);
}

//------------------------------------------------------------------------------
std::string vtkRelievoScaleBar::GetLabel(vtkRenderer* renderer)
{
  const double length = this->GetShownLength(renderer);
  return length > 0.0 ? WriteLength(length) + (this->Unit.empty() ? "" : " " + this->Unit) : "";
}

//------------------------------------------------------------------------------
int vtkRelievoScaleBar::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  const double perUnit = renderer ? GetPixelsPerUnit(renderer, this->Depth) : 0.0;
  if (perUnit <= 0.0)
  {
    return 0;
  }
  const double width = renderer->GetSize()[0];
  const double length = this->GetShownLength(renderer);
  if (length <= 0.0)
  {
    if (this->Refused != this->Length)
    {
      this->Refused = this->Length;
      vtkErrorMacro("Length is " << this->Length << ", and the picture is " << width / perUnit
                                 << " wide: give a shorter one, or 0 for one that fits");
    }
    return 0;
  }
  double size = this->TextSize > 0.0
    ? this->TextSize
    : std::max<double>(
        SmallestText, std::min(renderer->GetSize()[0], renderer->GetSize()[1]) / LinesOfText);
  const double margin = std::round(Margin * size);
  const double thick = std::max(2.0, std::round(Thickness * size));
  const double halo = std::max(1.0, std::round(Halo * size));
  const double gap = std::round(Gap * size);
  const double bar = std::max(1.0, std::round(length * perUnit));
  const double right = std::round(std::max(width - margin, 0.5 * (width + bar)));
  const double ink = this->GetShownInk(renderer);
  const vtkRelievoOverlayPen::Color inkColor = { ink, ink, ink };
  const vtkRelievoOverlayPen::Color edge = { 1.0 - ink, 1.0 - ink, 1.0 - ink };
  this->Pen->Begin(viewport);
  this->Pen->AddRectangle(
    { right - bar - halo, margin - halo, right + halo, margin + thick + halo }, edge);
  this->Pen->AddRectangle({ right - bar, margin, right, margin + thick }, inkColor);

  const std::string label = this->GetLabel(renderer);
  const double room = width - 2.0 * margin;
  double wide = this->Pen->Measure(label, size)[0];
  if (wide > room)
  {
    size = std::max(1.0, size * room / wide);
    wide = this->Pen->Measure(label, size)[0];
  }
  this->Pen->AddText(
    { std::min(right - 0.5 * (bar + wide), width - margin - wide), margin + thick + gap }, label,
    size, inkColor, edge, halo);
  this->Pen->Draw();
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoScaleBar::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Share: " << this->Share << "\n";
  os << indent << "Depth: " << this->Depth << "\n";
}
