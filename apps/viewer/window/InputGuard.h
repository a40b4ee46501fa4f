// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The wheel and the keys belong to the control that has the focus. The wheel over any other control
 * of a panel scrolls the panel, and the window's keys without modifiers leave alone what controls
 * use them for. One edit of the document is what the mouse changes from its press to its release,
 * and what wheel and keys turn one control by, until anything else is done. A filter of the
 * application's events, so that new controls need no word of it.
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
  int Edit = 0;      // that the mouse, the wheel or a key has begun last
  bool Held = false; // by the mouse
  QPointer<QWidget> Turned;
};
}

#endif
