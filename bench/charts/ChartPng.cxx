// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartPng.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace relievoBench
{
namespace
{
// VTK has y up.
class DrawingItem : public vtkContextItem
{
public:
  vtkTypeMacro(DrawingItem, vtkContextItem);
  static DrawingItem* New();

  bool Paint(vtkContext2D* painter) override
  {
    for (const ChartMark& mark : this->Drawing->Marks)
    {
      this->Paint(painter, mark);
    }
    return true;
  }

  const ChartDrawing* Drawing = nullptr;

private:
  void Paint(vtkContext2D* painter, const ChartMark& mark);
  void PaintLine(vtkContext2D* painter, const ChartMark& mark);
  void PaintWords(vtkContext2D* painter, const ChartMark& mark);
  float Up(double y) const { return static_cast<float>(this->Drawing->Height - y); }
};
vtkStandardNewMacro(DrawingItem);

void ColorOf(const ChartMark& mark, unsigned char color[4])
{
  const long hex = std::strtol(mark.Color.c_str() + 1, nullptr, 16);
  color[0] = static_cast<unsigned char>(hex >> 16);
  color[1] = static_cast<unsigned char>(hex >> 8 & 255);
  color[2] = static_cast<unsigned char>(hex & 255);
  color[3] = 255;
}

//------------------------------------------------------------------------------
void DrawingItem::Paint(vtkContext2D* painter, const ChartMark& mark)
{
  unsigned char color[4];
  ColorOf(mark, color);
  painter->GetPen()->SetColorF(color[0] / 255., color[1] / 255., color[2] / 255.);
  painter->GetPen()->SetWidth(static_cast<float>(mark.Width));
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetBrush()->SetColor(color);
  const ChartPoint at = mark.Points.front();
  const auto x = static_cast<float>(at.X);
  switch (mark.Kind)
  {
    case ChartMark::Line:
      this->PaintLine(painter, mark);
      return;
    case ChartMark::Area:
    {
      // As a fan about the middle: crosses are not convex, but all of them is seen from there.
      ChartPoint middle;
      for (const ChartPoint& point : mark.Points)
      {
        middle.X += point.X / static_cast<double>(mark.Points.size());
        middle.Y += point.Y / static_cast<double>(mark.Points.size());
      }
      painter->GetPen()->SetLineType(vtkPen::NO_PEN);
      for (std::size_t i = 0; i < mark.Points.size(); ++i)
      {
        const ChartPoint& a = mark.Points[i];
        const ChartPoint& b = mark.Points[(i + 1) % mark.Points.size()];
        float corners[] = { static_cast<float>(middle.X), this->Up(middle.Y),
          static_cast<float>(a.X), this->Up(a.Y), static_cast<float>(b.X), this->Up(b.Y) };
        painter->DrawPolygon(corners, 3);
      }
      return;
    }
    case ChartMark::Disc:
      painter->GetPen()->SetLineType(vtkPen::NO_PEN);
      painter->DrawWedge(x, this->Up(at.Y), static_cast<float>(mark.Radius), 0.f, 0.f, 360.f);
      return;
    case ChartMark::Ring:
      painter->GetPen()->SetLineType(vtkPen::NO_PEN);
      painter->DrawWedge(x, this->Up(at.Y), static_cast<float>(mark.Radius + 0.5 * mark.Width),
        static_cast<float>(mark.Radius - 0.5 * mark.Width), 0.f, 360.f);
      return;
    case ChartMark::Words:
      this->PaintWords(painter, mark);
      return;
  }
}

//------------------------------------------------------------------------------
void DrawingItem::PaintLine(vtkContext2D* painter, const ChartMark& mark)
{
  std::vector<double> dashes; // on, off, on, off
  switch (mark.Dash)
  {
    case ChartDash::Dashed:
      dashes = { 7., 4. };
      break;
    case ChartDash::Dotted:
      dashes = { 2., 3. };
      break;
    case ChartDash::DashDotted:
      dashes = { 8., 3., 2., 3. };
      break;
    case ChartDash::Solid:
      dashes = { 1e9 };
      break;
  }
  // Cut here: OpenGL's own stipple begins anew, or is missing, from driver to driver.
  std::size_t dash = 0;
  double left = dashes[0];
  for (std::size_t i = 1; i < mark.Points.size(); ++i)
  {
    ChartPoint from = mark.Points[i - 1];
    const ChartPoint& to = mark.Points[i];
    double rest = std::hypot(to.X - from.X, to.Y - from.Y);
    while (rest > 0.)
    {
      const double step = std::min(rest, left);
      const ChartPoint end = { from.X + step / rest * (to.X - from.X),
        from.Y + step / rest * (to.Y - from.Y) };
      if (dash % 2 == 0)
      {
        painter->DrawLine(
          static_cast<float>(from.X), this->Up(from.Y), static_cast<float>(end.X), this->Up(end.Y));
      }
      from = end;
      rest -= step;
      left -= step;
      if (left <= 0.)
      {
        dash = (dash + 1) % dashes.size();
        left = dashes[dash];
      }
    }
  }
}

//------------------------------------------------------------------------------
void DrawingItem::PaintWords(vtkContext2D* painter, const ChartMark& mark)
{
  unsigned char color[4];
  ColorOf(mark, color);
  vtkTextProperty* words = painter->GetTextProp();
  words->SetColor(color[0] / 255., color[1] / 255., color[2] / 255.);
  words->SetFontFamilyToArial();
  words->SetFontSize(static_cast<int>(std::lround(mark.Size)));
  words->SetBold(0);
  words->SetOrientation(mark.Upright ? 90. : 0.);
  words->SetJustification(mark.Anchor); // VTK_TEXT_LEFT, _CENTERED, _RIGHT
  words->SetVerticalJustificationToCentered();
  const ChartPoint at = mark.Points.front();
  painter->DrawString(static_cast<float>(at.X), this->Up(at.Y), mark.Text.c_str());
}
}

//------------------------------------------------------------------------------
bool WritePng(const ChartDrawing& drawing, const std::string& path)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(
    static_cast<int>(std::lround(drawing.Width)), static_cast<int>(std::lround(drawing.Height)));
  renderer->SetBackground(1., 1., 1.);
  vtkNew<DrawingItem> item;
  item->Drawing = &drawing;
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  renderer->AddActor(actor);
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
}
