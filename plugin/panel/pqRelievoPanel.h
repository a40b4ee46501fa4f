// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoPanel
 * @brief Dock: what Relievo does in the active view, in the order of use, and what that took.
 *
 * Shadows, sun, ground, environment, the layer shown with the values under the mouse, further
 * stages; then the frame report, folded away. While the dock is closed, or behind another tab, it
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
  /** Names of the stages that have a time on show, with commas. */
  Q_PROPERTY(QString timedStages READ GetTimedStages)

public:
  explicit pqRelievoPanel(QWidget* parent = nullptr);
  ~pqRelievoPanel() override;

  bool IsWatching() const;
  QString GetTimedStages() const;

  /** Looks again at the active view: it may have changed, or got Relievo's settings. */
  void Rewatch();

private Q_SLOTS:
  void Introduce();

private:
  bool Seen = false; // it is open, and no tab covers it
  QLabel* Heading;
  QLabel* Message;
  QWidget* All;
  QVector<pqRelievoControls*> Sections;
  pqRelievoReportView* Report;
};

#endif
