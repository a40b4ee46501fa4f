// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoTimesChart
 * @brief A bar for each stage that took time on the GPU, the longest as wide as the chart.
 */
#ifndef pqRelievoTimesChart_h
#define pqRelievoTimesChart_h

#include "pqRelievoFrameReport.h"

#include <QWidget>

class pqRelievoTimesChart : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;

public:
  explicit pqRelievoTimesChart(QWidget* parent = nullptr);

  /** Shows the stages that have a time; none clears the chart. */
  void SetStages(const QVector<pqRelievoFrameReport::Stage>& stages);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  int GetRowHeight() const;

  QVector<pqRelievoFrameReport::Stage> Stages;
};

#endif
