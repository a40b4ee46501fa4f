// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What stages cost, as a bar each: the longest fills the width.
 */
#ifndef StageChart_h
#define StageChart_h

#include <QString>
#include <QWidget>

#include <vector>

namespace viewer
{
class StageChart : public QWidget
{
  Q_OBJECT

public:
  struct Bar
  {
    QString Label;
    double Milliseconds;
  };

  explicit StageChart(QWidget* parent = nullptr);

  void SetBars(const std::vector<Bar>& bars);
  const std::vector<Bar>& GetBars() const { return this->Bars; }

  /// Where a bar is painted.
  QRect GetPlace(std::size_t bar) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return this->sizeHint(); }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  int GetRowHeight() const;
  int GetLabelWidth() const;
  int GetNumberWidth() const;

  std::vector<Bar> Bars;
};
}

#endif
