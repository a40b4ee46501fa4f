// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoPanel
 * @brief Dock: what the last picture of the active view took, stage by stage.
 *
 * A row for each stage of the frame report: its toggle, GPU milliseconds, memory, draw calls, and
 * why it ran or did not; a bar chart of the times; the whole frame. Read after pictures, at most
 * four times a second. While it is closed, or behind another tab, it observes and reads nothing.
 */
#ifndef pqRelievoPanel_h
#define pqRelievoPanel_h

#include "pqRelievoFrameReport.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"

class QLabel;
class QToolButton;
class pqRelievoStageTable;
class pqRelievoTimesChart;
class pqView;

class pqRelievoPanel : public QDockWidget
{
  Q_OBJECT
  using Superclass = QDockWidget;
  /** Whether it observes a view. */
  Q_PROPERTY(bool watching READ IsWatching)
  /** Names of the stages that have a time on show, with commas. */
  Q_PROPERTY(QString timedStages READ GetTimedStages)

public:
  explicit pqRelievoPanel(QWidget* parent = nullptr);
  ~pqRelievoPanel() override;

  bool IsWatching() const { return !this->View.isNull(); }
  QString GetTimedStages() const;

  /** Looks again at the active view: it may have changed, or got Relievo's settings. */
  void Rewatch();

private Q_SLOTS:
  void ShowToggles();
  void Introduce();

private:
  void Watch(pqView* view);
  void Schedule();
  void Refresh();
  QByteArray PullReport();
  void Show(const pqRelievoFrameReport& report);
  void Tell(const QString& message);

  bool Seen = false; // it is open, and no tab covers it
  QPointer<pqView> View;
  vtkNew<vtkEventQtSlotConnect> Connector;
  QTimer Timer;
  QElapsedTimer SinceRefresh;
  pqRelievoFrameReport Report;

  QLabel* Heading;
  QLabel* Message;
  QToolButton* Sun;
  pqRelievoStageTable* Table;
  pqRelievoTimesChart* Chart;
};

#endif
