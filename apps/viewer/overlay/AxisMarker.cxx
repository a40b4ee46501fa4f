// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AxisMarker.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSettings>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace viewer
{
namespace
{
const char* const SettingsKey = "axis_marker"; // of QSettings
constexpr int Side = 96;                       // pixels
constexpr double Length = 33.0;
constexpr double BallRadius = 9.0; // radius of a named end
constexpr double OtherBall = 6.0;  // radius of the opposite end
const QColor Colors[] = { { 214, 64, 64 }, { 76, 158, 58 }, { 64, 112, 224 } };
const char* const Names[] = { "x", "y", "z" };
}

//------------------------------------------------------------------------------
AxisMarker::AxisMarker(QWidget* parent)
  : Overlay(parent)
  , Wanted(QSettings().value(SettingsKey, true).toBool())
{
  this->setObjectName("axes");
  this->setToolTip("Click on the end of an axis to look from there");
  this->setMouseTracking(true); // shows the values under the mouse
  this->resize(Side, Side);
  this->Place();
  this->hide();
}

//------------------------------------------------------------------------------
void AxisMarker::SetWanted(bool wanted)
{
  this->Wanted = wanted;
  QSettings().setValue(SettingsKey, wanted);
  this->setVisible(this->Wanted && this->Seen);
}

//------------------------------------------------------------------------------
void AxisMarker::Follow(vtkRenderer* renderer)
{
  this->Seen = renderer != nullptr;
  if (renderer)
  {
    vtkMatrix4x4* view = renderer->GetActiveCamera()->GetViewTransformMatrix();
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::array<double, 3> seen = { view->GetElement(0, axis), view->GetElement(1, axis),
        view->GetElement(2, axis) };
      auto& known = this->Axes[static_cast<std::size_t>(axis)];
      if (known != seen)
      {
        known = seen;
        this->update();
      }
    }
  }
  this->setVisible(this->Wanted && this->Seen);
}

//------------------------------------------------------------------------------
QPointF AxisMarker::GetEnd(int end) const
{
  const std::array<double, 3>& axis = this->Axes[static_cast<std::size_t>(end % 3)];
  const double length = end < 3 ? Length : -Length;
  return { 0.5 * Side + length * axis[0], 0.5 * Side - length * axis[1] };
}

//------------------------------------------------------------------------------
// The end at a place; the nearer one if two overlap.
std::optional<int> AxisMarker::Find(const QPointF& at) const
{
  std::optional<int> found;
  double nearest = 0.0;
  for (int end = 0; end < 6; ++end)
  {
    const QPointF away = this->GetEnd(end) - at;
    const double depth = this->Axes[static_cast<std::size_t>(end % 3)][2] * (end < 3 ? 1 : -1);
    if (std::hypot(away.x(), away.y()) <= BallRadius && (!found || depth > nearest))
    {
      found = end;
      nearest = depth;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
void AxisMarker::mousePressEvent(QMouseEvent* event)
{
  const std::optional<int> end = this->Find(event->pos());
  if (end && event->button() == Qt::LeftButton)
  {
    Q_EMIT this->lookWanted(*end);
  }
  else
  {
    event->ignore(); // passed to the picture below
  }
}

//------------------------------------------------------------------------------
void AxisMarker::Place()
{
  this->move(4, this->parentWidget()->height() - Side - 4);
}

//------------------------------------------------------------------------------
void AxisMarker::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 255, 255, 70));
  painter.drawEllipse(this->rect());
  QFont font = painter.font();
  font.setPixelSize(13);
  font.setBold(true);
  painter.setFont(font);
  std::array<int, 6> order{};
  std::iota(order.begin(), order.end(), 0);
  const auto depth = [this](int end) {
    return this->Axes[static_cast<std::size_t>(end % 3)][2] * (end < 3 ? 1 : -1);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) < depth(b); });
  for (const int end : order)
  {
    const QColor color = Colors[end % 3];
    const QPointF at = this->GetEnd(end);
    if (end < 3)
    {
      painter.setPen(QPen(color, 2.5));
      painter.drawLine(QPointF(0.5 * Side, 0.5 * Side), at);
      painter.setPen(Qt::NoPen);
      painter.setBrush(color);
      painter.drawEllipse(at, BallRadius, BallRadius);
      painter.setPen(Qt::white);
      painter.drawText(
        QRectF(at - QPointF(BallRadius, BallRadius + 1), QSizeF(2 * BallRadius, 2 * BallRadius)),
        Qt::AlignCenter, Names[end]);
    }
    else
    {
      painter.setPen(QPen(color, 1.5));
      painter.setBrush(QColor(255, 255, 255, 150));
      painter.drawEllipse(at, OtherBall, OtherBall);
    }
  }
}
}
