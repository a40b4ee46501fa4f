// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A button that shows a colour and opens Qt's colour dialog.
 */
#ifndef ColorButton_h
#define ColorButton_h

#include <QColor>
#include <QPushButton>

namespace viewer
{
class ColorButton : public QPushButton
{
  Q_OBJECT

public:
  explicit ColorButton(QWidget* parent = nullptr);

  /// Emits no signal.
  void SetColor(const QColor& color);
  QColor GetColor() const { return this->Color; }

  /// Whether the colour's name is beside it; true by default.
  void ShowNames(bool on);

Q_SIGNALS:
  void edited(const QColor& color);

private:
  QColor Color;
  bool Named = true;
};
}

#endif
