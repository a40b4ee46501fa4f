// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A menu of recently opened files, stored between runs.
 */
#ifndef RecentFiles_h
#define RecentFiles_h

#include <QMenu>
#include <QStringList>

namespace viewer
{
/// Folder of the last opened file, for dialogs; "" if there is none.
QString GetLastFolder();

class RecentFiles : public QMenu
{
  Q_OBJECT

public:
  explicit RecentFiles(QWidget* parent = nullptr);

  void Add(const QString& path);
  QStringList GetPaths() const;

Q_SIGNALS:
  void chosen(const QString& path);

private:
  void Fill();
};
}

#endif
