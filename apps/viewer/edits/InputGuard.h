// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The wheel and the keys belong to the control that has the focus. The wheel over any other control
 * of a panel scrolls the panel, and the window's keys without modifiers leave alone what controls
 * use them for. What the mouse changes while it holds a control is one edit of the document. A
 * filter of the application's events, so that new controls need no word of it.
 */
#ifndef InputGuard_h
#define InputGuard_h

#include <QObject>

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
  Document* Edited;
};
}

#endif
