// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpacityCurve.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
// Pixels
constexpr double CurveBorder = 6.0;
constexpr double CurveReach = 9.0; // of the mouse
constexpr double CurveRadius = 4.0;

constexpr double CurveApart = 1e-3; // least distance of two points, as a share of the range
}

//------------------------------------------------------------------------------
OpacityCurve::OpacityCurve(QWidget* parent)
  : QWidget(parent)
{
  this->setObjectName("opacityCurve");
  this->setToolTip(
    "Opacity by value, over the numbers of values. Drag a point; a double click adds "
    "one, a right click removes one");
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

//------------------------------------------------------------------------------
QSize OpacityCurve::sizeHint() const
{
  return { 160, 110 };
}

//------------------------------------------------------------------------------
void OpacityCurve::ShowValues(
  const std::array<double, 2>& range, const std::vector<double>& histogram)
{
  this->Range = range;
  this->Histogram = histogram;
  this->update();
}

//------------------------------------------------------------------------------
void OpacityCurve::ShowCurve(const Points& points)
{
  if (this->Held < 0)
  {
    this->Curve = points;
    this->update();
  }
}

//------------------------------------------------------------------------------
QPointF OpacityCurve::GetPlace(const std::array<double, 2>& point) const
{
  const double share = (point[0] - this->Range[0]) / (this->Range[1] - this->Range[0]);
  return { CurveBorder + std::clamp(share, 0.0, 1.0) * (this->width() - 2.0 * CurveBorder),
    CurveBorder + (1.0 - point[1]) * (this->height() - 2.0 * CurveBorder) };
}

//------------------------------------------------------------------------------
std::array<double, 2> OpacityCurve::GetPoint(const QPointF& place) const
{
  const double share = std::clamp(
    (place.x() - CurveBorder) / std::max(1.0, this->width() - 2.0 * CurveBorder), 0.0, 1.0);
  const double opacity =
    1.0 - (place.y() - CurveBorder) / std::max(1.0, this->height() - 2.0 * CurveBorder);
  return { this->Range[0] + share * (this->Range[1] - this->Range[0]),
    std::round(100.0 * std::clamp(opacity, 0.0, 1.0)) / 100.0 };
}

//------------------------------------------------------------------------------
int OpacityCurve::FindPoint(const QPointF& place) const
{
  int found = -1;
  double nearest = CurveReach;
  for (std::size_t i = 0; i < this->Curve.size(); ++i)
  {
    const QPointF way = this->GetPlace(this->Curve[i]) - place;
    const double away = std::hypot(way.x(), way.y());
    if (away <= nearest)
    {
      nearest = away;
      found = static_cast<int>(i);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
double OpacityCurve::GetTick() const
{
  return CurveApart * (this->Range[1] - this->Range[0]);
}

//------------------------------------------------------------------------------
void OpacityCurve::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(this->rect(), this->palette().color(QPalette::Base));
  // Roots: the background of most images would hide all other values.
  double most = 0.0;
  for (const double count : this->Histogram)
  {
    most = std::max(most, std::sqrt(std::sqrt(count)));
  }
  const double width =
    (this->width() - 2.0 * CurveBorder) / std::max<std::size_t>(1, this->Histogram.size());
  for (std::size_t i = 0; i < this->Histogram.size() && most > 0.0; ++i)
  {
    const double height =
      std::sqrt(std::sqrt(this->Histogram[i])) / most * (this->height() - 2.0 * CurveBorder);
    painter.fillRect(QRectF(CurveBorder + static_cast<double>(i) * width,
                       this->height() - CurveBorder - height, width, height),
      this->palette().color(QPalette::Mid));
  }
  if (this->Curve.empty())
  {
    return;
  }
  QPolygonF line;
  line << QPointF(CurveBorder, this->GetPlace(this->Curve.front()).y());
  for (const std::array<double, 2>& point : this->Curve)
  {
    line << this->GetPlace(point);
  }
  line << QPointF(this->width() - CurveBorder, this->GetPlace(this->Curve.back()).y());
  painter.setPen(QPen(this->palette().color(QPalette::Text), 1.5));
  painter.drawPolyline(line);
  painter.setBrush(this->palette().color(QPalette::Highlight));
  for (const std::array<double, 2>& point : this->Curve)
  {
    painter.drawEllipse(this->GetPlace(point), CurveRadius, CurveRadius);
  }
}

//------------------------------------------------------------------------------
void OpacityCurve::mousePressEvent(QMouseEvent* event)
{
  const int point = this->FindPoint(event->pos());
  this->Held = event->button() == Qt::LeftButton ? point : -1;
  this->Moved = false;
  if (event->button() == Qt::RightButton && point >= 0 && this->Curve.size() > 2)
  {
    this->Curve.erase(this->Curve.begin() + point);
    this->update();
    Q_EMIT this->edited(this->Curve);
  }
}

//------------------------------------------------------------------------------
// A point stays between its neighbours.
void OpacityCurve::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Held < 0)
  {
    return;
  }
  const auto held = static_cast<std::size_t>(this->Held);
  std::array<double, 2> point = this->GetPoint(event->pos());
  const double least = held > 0 ? this->Curve[held - 1][0] + this->GetTick() : this->Range[0];
  const double most =
    held + 1 < this->Curve.size() ? this->Curve[held + 1][0] - this->GetTick() : this->Range[1];
  point[0] = least < most ? std::clamp(point[0], least, most) : this->Curve[held][0];
  this->Curve[held] = point;
  this->Moved = true;
  this->update();
}

//------------------------------------------------------------------------------
void OpacityCurve::mouseReleaseEvent(QMouseEvent*)
{
  const bool moved = this->Held >= 0 && this->Moved;
  this->Held = -1;
  if (moved)
  {
    Q_EMIT this->edited(this->Curve);
  }
}

//------------------------------------------------------------------------------
void OpacityCurve::mouseDoubleClickEvent(QMouseEvent* event)
{
  this->Held = -1;
  const std::array<double, 2> point = this->GetPoint(event->pos());
  const auto after = std::find_if(this->Curve.begin(), this->Curve.end(),
    [&point](const auto& other) { return other[0] >= point[0]; });
  const bool near = std::any_of(this->Curve.begin(), this->Curve.end(),
    [&](const auto& other) { return std::abs(other[0] - point[0]) < this->GetTick(); });
  if (!near && !this->Curve.empty())
  {
    this->Curve.insert(after, point);
    this->update();
    Q_EMIT this->edited(this->Curve);
  }
}
}
