// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files opened last, in a menu, from one run of the program to the next.
 */
#ifndef RecentFiles_h
#define RecentFiles_h

#include <QMenu>
#include <QStringList>

namespace viewer
{
/// Of the file opened last, for dialogs to start in; "" if there is none.
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
