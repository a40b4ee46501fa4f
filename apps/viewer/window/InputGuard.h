// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reserves the wheel and keys for the control with the focus. The wheel over any other control
 * scrolls its panel, and the window's keys without modifiers do not act on keys that controls use.
 * One edit of the document comprises all changes from a mouse press to its release, or by wheel and
 * keys on one control until another action. It filters the application's events, so that new
 * controls need no code for it.
 */
#ifndef InputGuard_h
#define InputGuard_h

#include <QObject>
#include <QPointer>

class QKeyEvent;
class QWidget;

namespace viewer
{
class Document;

class InputGuard : public QObject
{
  Q_OBJECT

public:
  InputGuard(Document* document, QObject* parent);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void TakeKey(const QKeyEvent& key);
  void Turn(QWidget* control);
  void Stop();

  Document* Edited;
  int Edit = 0;      // number of the last edit begun by mouse, wheel or key
  bool Held = false; // a mouse button is down
  QPointer<QWidget> Turned;
};
}

#endif
