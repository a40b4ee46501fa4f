// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoTimesChart.h"

#include <QPainter>

#include <algorithm>

//------------------------------------------------------------------------------
pqRelievoTimesChart::pqRelievoTimesChart(QWidget* parent)
  : Superclass(parent)
{
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

//------------------------------------------------------------------------------
void pqRelievoTimesChart::SetStages(const QVector<pqRelievoFrameReport::Stage>& stages)
{
  const int rows = this->Stages.size();
  this->Stages.clear();
  std::copy_if(stages.begin(), stages.end(), std::back_inserter(this->Stages),
    [](const pqRelievoFrameReport::Stage& stage) { return stage.Milliseconds >= 0.0; });
  if (this->Stages.size() != rows)
  {
    this->updateGeometry();
  }
  this->update();
}

//------------------------------------------------------------------------------
int pqRelievoTimesChart::GetRowHeight() const
{
  return this->fontMetrics().height() + 4;
}

//------------------------------------------------------------------------------
QSize pqRelievoTimesChart::sizeHint() const
{
  return QSize(200, this->Stages.size() * this->GetRowHeight());
}

//------------------------------------------------------------------------------
QSize pqRelievoTimesChart::minimumSizeHint() const
{
  return QSize(80, this->sizeHint().height());
}

//------------------------------------------------------------------------------
void pqRelievoTimesChart::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  double longest = 0.0;
  int labels = 0;
  int numbers = 0;
  for (const pqRelievoFrameReport::Stage& stage : this->Stages)
  {
    longest = std::max(longest, stage.Milliseconds);
    labels = std::max(labels, this->fontMetrics().horizontalAdvance(stage.Label));
    numbers = std::max(numbers,
      this->fontMetrics().horizontalAdvance(
        pqRelievoFrameReport::FormatMilliseconds(stage.Milliseconds) + " ms"));
  }
  const int gap = 6;
  const int left = labels + gap;
  const int width = std::max(0, this->width() - left - numbers - gap);
  const int height = this->GetRowHeight();
  QRect row(0, 0, this->width(), height);
  for (const pqRelievoFrameReport::Stage& stage : this->Stages)
  {
    const double share = longest > 0.0 ? stage.Milliseconds / longest : 0.0;
    const int bar = std::max(1, static_cast<int>(width * share));
    painter.setPen(this->palette().color(QPalette::WindowText));
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, stage.Label);
    painter.fillRect(
      left, row.top() + 2, bar, height - 4, this->palette().color(QPalette::Highlight));
    painter.drawText(row.adjusted(left + bar + gap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
      pqRelievoFrameReport::FormatMilliseconds(stage.Milliseconds) + " ms");
    row.translate(0, height);
  }
}
