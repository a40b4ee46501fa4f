// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoReportView
 * @brief The cost of a view's last picture, stage by stage, folded until opened.
 *
 * Read after pictures, at most four times a second. While it is folded, or its dock is hidden, it
 * observes and reads nothing, so that pictures cost nothing extra.
 */
#ifndef pqRelievoReportView_h
#define pqRelievoReportView_h

#include "FrameReport.h"
#include "pqView.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <QWidget>

namespace relievoQt
{
class StageTable;
class TimesChart;
}

class QLabel;
class QToolButton;

class pqRelievoReportView : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;

public:
  explicit pqRelievoReportView(QWidget* parent = nullptr);

  /** The view to report on; nullptr for none. */
  void SetView(pqView* view);

  /** Whether it observes a view. */
  bool IsWatching() const { return !this->Watched.isNull(); }

  /** The report shown. */
  const relievoQt::FrameReport& GetReport() const { return this->Report; }

private:
  void Watch();
  void Schedule();
  void Refresh();
  QByteArray PullReport();
  void Show(const relievoQt::FrameReport& report, const QString& message);

  QPointer<pqView> View;
  QPointer<pqView> Watched; // observed while open
  QTimer Timer;
  QElapsedTimer SinceRefresh;
  relievoQt::FrameReport Report;

  QWidget* Rest;
  QToolButton* Fold;
  QLabel* Message;
  relievoQt::StageTable* Table;
  relievoQt::TimesChart* Chart;
};

#endif
