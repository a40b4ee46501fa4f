// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shown while there is no picture: how to open a file, the file being read, or an error.
 */
#ifndef EmptyPage_h
#define EmptyPage_h

#include <QWidget>

class QLabel;
class QPushButton;

namespace viewer
{
class EmptyPage : public QWidget
{
  Q_OBJECT

public:
  explicit EmptyPage(QWidget* parent = nullptr);

  void ShowHint();
  void ShowReading(const QString& what);
  void ShowTrouble(const QString& text);

Q_SIGNALS:
  void openWanted();

private:
  void Show(const QString& title, const QString& text, const QString& button);

  QLabel *Title, *Words;
  QPushButton* Open;
};
}

#endif
