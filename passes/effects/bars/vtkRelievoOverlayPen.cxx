// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOverlayPen.h"

#include "vtkRelievoAnnotation.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkViewport.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int PointsPerInch = 72;

unsigned char ToByte(double share)
{
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

void SetText(vtkTextActor* actor, const std::string& text, int size, const double* color)
{
  if (!actor->GetInput() || text != actor->GetInput())
  {
    actor->SetInput(text.c_str());
  }
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(color[0], color[1], color[2]);
}

void RenderAt(vtkTextActor* text, vtkViewport* viewport, double x, double y)
{
  text->SetPosition(x, y);
  // Makes the text's image. VTK magnifies texts in tiles, but this size is for the whole picture.
  vtkWindow* window = viewport->GetVTKWindow();
  const std::array<int, 2> tiles = { window->GetTileScale()[0], window->GetTileScale()[1] };
  window->SetTileScale(1, 1);
  text->RenderOpaqueGeometry(viewport);
  window->SetTileScale(tiles[0], tiles[1]);
  text->RenderOverlay(viewport);
}
}

//------------------------------------------------------------------------------
vtkRelievoOverlayPen::vtkRelievoOverlayPen()
{
  vtkRelievoAnnotation::SetFont(this->Measured);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Data);
  this->Shapes->SetMapper(mapper);
}

//------------------------------------------------------------------------------
vtkRelievoOverlayPen::~vtkRelievoOverlayPen() = default;

//------------------------------------------------------------------------------
// Font sizes are in points.
int vtkRelievoOverlayPen::GetFontSize(double size) const
{
  return std::max(1, static_cast<int>(size * PointsPerInch / this->DPI));
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayPen::Begin(vtkViewport* viewport)
{
  this->Viewport = viewport;
  this->DPI = viewport->GetVTKWindow() ? viewport->GetVTKWindow()->GetDPI() : PointsPerInch;
  this->Rectangles.clear();
  this->Written = 0;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkRelievoOverlayPen::Measure(const std::string& text, double size)
{
  std::array<int, 4> box{};
  this->Measured->SetFontSize(this->GetFontSize(size));
  vtkTextRenderer::GetInstance()->GetBoundingBox(this->Measured, text, box.data(), this->DPI);
  return { box[1] - box[0] + 1.0, box[3] - box[2] + 1.0 };
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayPen::AddRectangle(
  const std::array<double, 4>& box, const Color& color, double opacity)
{
  this->Rectangles.push_back(
    { box, { ToByte(color[0]), ToByte(color[1]), ToByte(color[2]), ToByte(opacity) } });
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayPen::AddText(const std::array<double, 2>& at, const std::string& text,
  double size, const Color& color, const Color& edge, double halo)
{
  if (this->Written == this->Texts.size())
  {
    this->Texts.push_back(std::make_unique<Text>());
    vtkRelievoAnnotation::SetFont(this->Texts.back()->Ink->GetTextProperty());
    vtkRelievoAnnotation::SetFont(this->Texts.back()->Edge->GetTextProperty());
  }
  Text& written = *this->Texts[this->Written++];
  written.At = { std::round(at[0]), std::round(at[1]) };
  written.Halo = halo;
  const int points = this->GetFontSize(size);
  SetText(written.Ink, text, points, color.data());
  SetText(written.Edge, text, points, edge.data());
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayPen::Draw()
{
  if (this->Rectangles != this->Drawn)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    for (const Rectangle& each : this->Rectangles)
    {
      const std::array<double, 4>& box = each.Box;
      const vtkIdType first = points->InsertNextPoint(box[0], box[1], 0.0);
      points->InsertNextPoint(box[2], box[1], 0.0);
      points->InsertNextPoint(box[2], box[3], 0.0);
      points->InsertNextPoint(box[0], box[3], 0.0);
      cells->InsertNextCell({ first, first + 1, first + 2, first + 3 });
      for (int corner = 0; corner < 4; ++corner)
      {
        colors->InsertNextTypedTuple(each.Color.data());
      }
    }
    this->Data->Initialize();
    this->Data->SetPoints(points);
    this->Data->SetPolys(cells);
    this->Data->GetPointData()->SetScalars(colors);
    this->Drawn = this->Rectangles;
  }
  this->Shapes->RenderOverlay(this->Viewport);
  for (std::size_t i = 0; i < this->Written; ++i)
  {
    Text& text = *this->Texts[i];
    for (const double dx : { -text.Halo, 0.0, text.Halo })
    {
      for (const double dy : { -text.Halo, 0.0, text.Halo })
      {
        if (dx != 0.0 || dy != 0.0)
        {
          RenderAt(text.Edge, this->Viewport, text.At[0] + dx, text.At[1] + dy);
        }
      }
    }
    RenderAt(text.Ink, this->Viewport, text.At[0], text.At[1]);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOverlayPen::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shapes->ReleaseGraphicsResources(window);
  for (const std::unique_ptr<Text>& text : this->Texts)
  {
    text->Ink->ReleaseGraphicsResources(window);
    text->Edge->ReleaseGraphicsResources(window);
  }
}
