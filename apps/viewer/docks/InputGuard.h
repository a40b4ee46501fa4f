// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The wheel and the keys belong to the control that has the focus. The wheel over any other control
 * of a panel scrolls the panel, and the window's keys without modifiers leave alone what controls
 * use them for. A filter of the application's events, so that new controls need no word of it.
 */
#ifndef InputGuard_h
#define InputGuard_h

#include <QObject>

namespace viewer
{
class InputGuard : public QObject
{
  Q_OBJECT

public:
  explicit InputGuard(QObject* parent);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};
}

#endif
