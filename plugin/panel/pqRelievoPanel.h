// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoPanel
 * @brief Dock for Relievo's settings of the active view, in the order of use, and the frame report.
 *
 * Shadows, sun, ground, environment, the displayed layer with the values under the mouse, further
 * stages; then the frame report, folded. While the dock is closed or behind another tab, it
 * observes nothing.
 */
#ifndef pqRelievoPanel_h
#define pqRelievoPanel_h

#include <QDockWidget>
#include <QPointer>
#include <QVector>

class QLabel;
class pqRelievoControls;
class pqRelievoReportView;
class pqView;

class pqRelievoPanel : public QDockWidget
{
  Q_OBJECT
  using Superclass = QDockWidget;
  /** Whether it reads reports of a view's pictures. */
  Q_PROPERTY(bool watching READ IsWatching)
  /** Names of the stages with a displayed time, separated by commas. */
  Q_PROPERTY(QString timedStages READ GetTimedStages)

public:
  explicit pqRelievoPanel(QWidget* parent = nullptr);
  ~pqRelievoPanel() override;

  bool IsWatching() const;
  QString GetTimedStages() const;

  /** Updates for the active view, which may have changed or received Relievo's settings. */
  void Rewatch();

private Q_SLOTS:
  void Introduce();

private:
  bool Seen = false; // open, and not covered by another tab
  QLabel* Heading;
  QLabel* Message;
  QWidget* All;
  QVector<pqRelievoControls*> Sections;
  pqRelievoReportView* Report;
};

#endif
