// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageChart.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
constexpr int Gap = 6; // pixels between label, bar and number
}

//------------------------------------------------------------------------------
StageChart::StageChart(QWidget* parent)
  : QWidget(parent)
{
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

//------------------------------------------------------------------------------
void StageChart::SetBars(const std::vector<Bar>& bars)
{
  const bool moved = bars.size() != this->Bars.size();
  this->Bars = bars;
  if (moved)
  {
    this->updateGeometry();
  }
  this->update();
}

//------------------------------------------------------------------------------
int StageChart::GetRowHeight() const
{
  return this->fontMetrics().height() + 4;
}

//------------------------------------------------------------------------------
int StageChart::GetLabelWidth() const
{
  int width = 0;
  for (const Bar& bar : this->Bars)
  {
    width = std::max(width, this->fontMetrics().horizontalAdvance(bar.Label));
  }
  return std::min(width, this->width() / 2);
}

//------------------------------------------------------------------------------
int StageChart::GetNumberWidth() const
{
  return this->fontMetrics().horizontalAdvance("0000.00 ms");
}

//------------------------------------------------------------------------------
QRect StageChart::GetPlace(std::size_t bar) const
{
  double longest = 0.0;
  for (const Bar& each : this->Bars)
  {
    longest = std::max(longest, each.Milliseconds);
  }
  const int begin = this->GetLabelWidth() + Gap;
  const int room = std::max(0, this->width() - begin - Gap - this->GetNumberWidth());
  const double share = longest > 0.0 ? this->Bars[bar].Milliseconds / longest : 0.0;
  const int height = this->GetRowHeight();
  return { begin, static_cast<int>(bar) * height + 2, static_cast<int>(std::lround(share * room)),
    height - 4 };
}

//------------------------------------------------------------------------------
QSize StageChart::sizeHint() const
{
  return { 160, static_cast<int>(this->Bars.size()) * this->GetRowHeight() };
}

//------------------------------------------------------------------------------
void StageChart::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  const int label = this->GetLabelWidth();
  const int number = this->GetNumberWidth();
  for (std::size_t i = 0; i < this->Bars.size(); ++i)
  {
    const Bar& bar = this->Bars[i];
    const QRect place = this->GetPlace(i);
    const QRect row(0, place.top(), this->width(), place.height());
    painter.fillRect(place, this->palette().color(QPalette::Highlight));
    painter.setPen(this->palette().color(QPalette::WindowText));
    painter.drawText(QRect(0, row.top(), label, row.height()), Qt::AlignRight | Qt::AlignVCenter,
      this->fontMetrics().elidedText(bar.Label, Qt::ElideRight, label));
    painter.drawText(QRect(place.right() + 1 + Gap, row.top(), number, row.height()),
      Qt::AlignLeft | Qt::AlignVCenter, QString::number(bar.Milliseconds, 'f', 2) + " ms");
  }
}
}
