// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Hides all panels of a window, or shows them again: by its action, and by itself where they would
 * leave too little of a narrow window to the picture.
 */
#ifndef PanelSwitch_h
#define PanelSwitch_h

#include <QList>
#include <QObject>
#include <QPointer>

class QDockWidget;
class QMainWindow;

namespace viewer
{
class PanelSwitch : public QObject
{
  Q_OBJECT

public:
  /// Names its action "panels".
  explicit PanelSwitch(QMainWindow* window);

  /// Shows the panels that a narrow window has hidden, as for storing the layout.
  void Open();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QList<QDockWidget*> FindDocked() const;
  void Show();
  void Hide();
  void Toggle();

  QMainWindow* Window;
  QList<QPointer<QDockWidget>> Hidden;
  QPointer<QDockWidget> Top; // of their tabs
  bool Narrow = false;
  bool ByItself = false; // the panels are hidden because the window is narrow
};
}

#endif
