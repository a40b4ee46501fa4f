// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A line edit for a file path, with a button that opens a file dialog.
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
  /// For images. `title`: of the dialog.
  explicit FileEdit(const QString& title, QWidget* parent = nullptr);

  /// Emits no signal.
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
