// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A bar for each timed stage: the longest fills the width.
 */
#ifndef TimesChart_h
#define TimesChart_h

#include "FrameReport.h"

#include <QWidget>

namespace relievoQt
{
class TimesChart : public QWidget
{
  Q_OBJECT

public:
  explicit TimesChart(QWidget* parent = nullptr);

  /// An empty report clears the chart.
  void SetReport(const FrameReport& report);

  /// The stages with a bar.
  const QVector<FrameReport::Stage>& GetStages() const { return this->Stages; }

  /// The area of a bar.
  QRect GetPlace(int stage) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return { 80, this->sizeHint().height() }; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  int GetRowHeight() const;
  int GetLabelWidth() const;
  int GetNumberWidth() const;

  QVector<FrameReport::Stage> Stages;
};
}

#endif
