// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonView.h"

#include "Baseline.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoComparisonReport.h"
#include "vtkSmartPointer.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
constexpr double MostZoom = 64.0;

// The colours of a frame's picture, without alpha; grey if it has only layers.
QImage MakeImage(vtkImageData* frame)
{
  const int* size = frame->GetDimensions();
  QImage image(size[0], size[1], QImage::Format_RGB32);
  image.fill(Qt::gray);
  const vtkSmartPointer<vtkImageData> colors = scene::MakePicture(frame);
  const int components = colors ? colors->GetNumberOfScalarComponents() : 0;
  for (int y = 0; colors && y < size[1]; ++y)
  {
    const auto* from =
      static_cast<const unsigned char*>(colors->GetScalarPointer(0, size[1] - 1 - y, 0));
    for (int x = 0; x < size[0]; ++x, from += components)
    {
      image.setPixel(
        x, y, components < 3 ? qRgb(from[0], from[0], from[0]) : qRgb(from[0], from[1], from[2]));
    }
  }
  return image;
}

QRgb Mix(QRgb a, QRgb b, double share)
{
  const auto mix = [share](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}
}

//------------------------------------------------------------------------------
ComparisonView::ComparisonView(QWidget* parent)
  : QWidget(parent)
  , Center(0.5, 0.5)
{
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMinimumHeight(80);
  this->setAccessibleName("Compared pictures");
}

//------------------------------------------------------------------------------
void ComparisonView::SetFrames(vtkImageData* baseline, vtkImageData* now, vtkImageData* causes,
  const std::map<int, QColor>& colors)
{
  this->Pictures[0] = MakeImage(baseline);
  this->Pictures[1] = MakeImage(now);
  this->Colors = colors;
  this->Causes.clear();
  if (causes)
  {
    const int* size = causes->GetDimensions();
    vtkDataArray* values = causes->GetPointData()->GetScalars();
    for (int y = size[1] - 1; y >= 0; --y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        this->Causes.push_back(
          static_cast<int>(values->GetComponent(vtkIdType{ y } * size[0] + x, 0)));
      }
    }
  }
  this->Zoom = 1.0;
  this->Center = { 0.5, 0.5 };
  this->Choose(std::nullopt);
}

//------------------------------------------------------------------------------
void ComparisonView::SetKind(Kind kind)
{
  this->Shown = kind;
  this->Compose();
}

//------------------------------------------------------------------------------
void ComparisonView::Choose(std::optional<int> cause)
{
  this->Chosen = cause;
  this->Frame = QRect();
  const int width = this->Pictures[1].width();
  for (std::size_t i = 0; cause && i < this->Causes.size(); ++i)
  {
    if (this->Causes[i] == *cause)
    {
      const int pixel = static_cast<int>(i);
      this->Frame = this->Frame.united(QRect(pixel % width, pixel / width, 1, 1));
    }
  }
  this->Compose();
}

//------------------------------------------------------------------------------
void ComparisonView::Compose()
{
  this->Image = this->Pictures[this->Shown == BASELINE ? 0 : 1];
  const bool isOfCauses = this->Shown == CAUSES;
  if (!this->Causes.empty() && (isOfCauses || this->Chosen))
  {
    const int width = this->Image.width();
    for (int y = 0; y < this->Image.height(); ++y)
    {
      auto* line = reinterpret_cast<QRgb*>(this->Image.scanLine(y)); // NOLINT(*-reinterpret-cast)
      const int* causes = this->Causes.data() + static_cast<std::size_t>(y) * width;
      for (int x = 0; x < width; ++x)
      {
        const int grey = qGray(line[x]);
        const QRgb behind = isOfCauses
          ? Mix(qRgb(0, 0, 0), qRgb(grey, grey, grey), vtkRelievoComparisonReport::BehindCauses)
          : Mix(qRgb(0, 0, 0), line[x], vtkRelievoComparisonReport::AroundChosen);
        const auto color = this->Colors.find(causes[x]);
        const bool isSeen = color != this->Colors.end() &&
          (this->Chosen ? *this->Chosen == causes[x] : causes[x] != Rounding && causes[x] != Edge);
        line[x] = isSeen ? Mix(behind, color->second.rgb(),
                             isOfCauses ? 1.0 : vtkRelievoComparisonReport::OfChosen)
                         : behind;
      }
    }
  }
  this->update();
}

//------------------------------------------------------------------------------
// Widget pixels for each pixel of the image.
double ComparisonView::GetScale() const
{
  return this->Zoom *
    std::min(static_cast<double>(this->width()) / this->Image.width(),
      static_cast<double>(this->height()) / this->Image.height());
}

//------------------------------------------------------------------------------
QRectF ComparisonView::GetPlace() const
{
  const double scale = this->GetScale();
  const QSizeF size = scale * QSizeF(this->Image.size());
  return { QPointF(0.5 * this->width() - this->Center.x() * size.width(),
             0.5 * this->height() - this->Center.y() * size.height()),
    size };
}

//------------------------------------------------------------------------------
void ComparisonView::paintEvent(QPaintEvent*)
{
  if (this->Image.isNull())
  {
    return;
  }
  QPainter painter(this);
  const QRectF place = this->GetPlace();
  const double scale = this->GetScale();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, scale < 1.0);
  painter.drawImage(place, this->Image);
  if (!this->Frame.isEmpty())
  {
    const QRectF around(
      place.topLeft() + scale * QPointF(this->Frame.topLeft()), scale * QSizeF(this->Frame.size()));
    painter.setPen(QPen(Qt::black, 4));
    painter.drawRect(around.adjusted(-4, -4, 4, 4));
    painter.setPen(QPen(Qt::white, 2));
    painter.drawRect(around.adjusted(-4, -4, 4, 4));
  }
}

//------------------------------------------------------------------------------
// Zooms around the mouse.
void ComparisonView::wheelEvent(QWheelEvent* event)
{
  const QPointF mouse = event->position();
  const auto getPoint = [&] {
    const QRectF place = this->GetPlace();
    return QPointF(
      (mouse.x() - place.left()) / place.width(), (mouse.y() - place.top()) / place.height());
  };
  const QPointF before = getPoint();
  this->Zoom = std::clamp(this->Zoom * std::exp2(event->angleDelta().y() / 240.0), 1.0, MostZoom);
  this->Center = this->Zoom > 1.0 ? this->Center + before - getPoint() : QPointF(0.5, 0.5);
  event->accept();
  this->update();
}

//------------------------------------------------------------------------------
void ComparisonView::mousePressEvent(QMouseEvent* event)
{
  this->Dragged = event->pos();
}

//------------------------------------------------------------------------------
void ComparisonView::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Zoom > 1.0)
  {
    const QRectF place = this->GetPlace();
    const QPointF step = event->pos() - this->Dragged;
    this->Center -= QPointF(step.x() / place.width(), step.y() / place.height());
    this->Dragged = event->pos();
    this->update();
  }
}

//------------------------------------------------------------------------------
void ComparisonView::mouseDoubleClickEvent(QMouseEvent*)
{
  this->Zoom = 1.0;
  this->Center = { 0.5, 0.5 };
  this->update();
}
}
