// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An error or a wait message in a strip over the top of the picture, which keeps its size; it stays
 * until it is closed.
 */
#ifndef MessageBar_h
#define MessageBar_h

#include "Overlay.h"

class QLabel;

namespace viewer
{
class MessageBar : public Overlay
{
  Q_OBJECT

public:
  enum Kind
  {
    Hint,
    Warning,
    Error
  };

  /// Placed over the parent's top, with the same width.
  explicit MessageBar(QWidget* parent);

  void Show(const QString& text, Kind kind);
  QString GetText() const;

Q_SIGNALS:
  /// The user closed it.
  void closed();

protected:
  void Place() override;
  void paintEvent(QPaintEvent* event) override;

private:
  QLabel* Words;
  Kind Shown = Error;
};
}

#endif
