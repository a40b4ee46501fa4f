// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A file as a line with its path, and a button that asks for one.
 */
#ifndef FileEdit_h
#define FileEdit_h

#include <QString>
#include <QWidget>

class QLineEdit;

namespace viewer
{
class FileEdit : public QWidget
{
  Q_OBJECT

public:
  /// Of images. `title`: that of the dialog.
  explicit FileEdit(const QString& title, QWidget* parent = nullptr);

  /// Sends no signal.
  void SetPath(const QString& path);

Q_SIGNALS:
  /// An absolute path; empty: no file.
  void edited(const QString& path);

private:
  void Ask();

  QString Title;
  QString Shown;
  QLineEdit* Line;
};
}

#endif
