// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimesChart.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace relievoQt
{
namespace
{
constexpr int Gap = 6; // pixels between label, bar and number

QString WriteTime(const FrameReport::Stage& stage)
{
  return FrameReport::FormatMilliseconds(stage.Milliseconds) + " ms";
}
}

//------------------------------------------------------------------------------
TimesChart::TimesChart(QWidget* parent)
  : QWidget(parent)
{
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

//------------------------------------------------------------------------------
void TimesChart::SetReport(const FrameReport& report)
{
  const auto rows = this->Stages.size();
  this->Stages.clear();
  std::copy_if(report.Stages.begin(), report.Stages.end(), std::back_inserter(this->Stages),
    [](const FrameReport::Stage& stage) { return stage.Milliseconds >= 0.0; });
  if (this->Stages.size() != rows)
  {
    this->updateGeometry();
  }
  this->update();
}

//------------------------------------------------------------------------------
int TimesChart::GetRowHeight() const
{
  return this->fontMetrics().height() + 4;
}

//------------------------------------------------------------------------------
int TimesChart::GetLabelWidth() const
{
  int width = 0;
  for (const FrameReport::Stage& stage : this->Stages)
  {
    width = std::max(width, this->fontMetrics().horizontalAdvance(stage.Label));
  }
  return std::min(width, 2 * this->width() / 3);
}

//------------------------------------------------------------------------------
int TimesChart::GetNumberWidth() const
{
  int width = 0;
  for (const FrameReport::Stage& stage : this->Stages)
  {
    width = std::max(width, this->fontMetrics().horizontalAdvance(WriteTime(stage)));
  }
  return width;
}

//------------------------------------------------------------------------------
QRect TimesChart::GetPlace(int stage) const
{
  double longest = 0.0;
  for (const FrameReport::Stage& each : this->Stages)
  {
    longest = std::max(longest, each.Milliseconds);
  }
  const int begin = this->GetLabelWidth() + Gap;
  const int room = std::max(0, this->width() - begin - Gap - this->GetNumberWidth());
  const double share = longest > 0.0 ? this->Stages[stage].Milliseconds / longest : 0.0;
  const int height = this->GetRowHeight();
  return { begin, stage * height + 2, static_cast<int>(std::lround(share * room)), height - 4 };
}

//------------------------------------------------------------------------------
QSize TimesChart::sizeHint() const
{
  return { 160, static_cast<int>(this->Stages.size()) * this->GetRowHeight() };
}

//------------------------------------------------------------------------------
void TimesChart::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  const int label = this->GetLabelWidth();
  const int number = this->GetNumberWidth();
  for (int i = 0; i < static_cast<int>(this->Stages.size()); ++i)
  {
    const FrameReport::Stage& stage = this->Stages[i];
    const QRect place = this->GetPlace(i);
    const QRect row(0, place.top(), this->width(), place.height());
    painter.fillRect(place, this->palette().color(QPalette::Highlight));
    painter.setPen(this->palette().color(QPalette::WindowText));
    painter.drawText(QRect(0, row.top(), label, row.height()), Qt::AlignRight | Qt::AlignVCenter,
      this->fontMetrics().elidedText(stage.Label, Qt::ElideRight, label));
    painter.drawText(QRect(place.right() + 1 + Gap, row.top(), number, row.height()),
      Qt::AlignLeft | Qt::AlignVCenter, WriteTime(stage));
  }
}
}
