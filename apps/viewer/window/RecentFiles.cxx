// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

namespace viewer
{
namespace
{
const char* const Key = "recent_files";
constexpr int Most = 10;
}

//------------------------------------------------------------------------------
RecentFiles::RecentFiles(QWidget* parent)
  : QMenu("Open &recent", parent)
{
  QObject::connect(this, &QMenu::aboutToShow, this, &RecentFiles::Fill);
  QObject::connect(this, &QMenu::triggered, this,
    [this](QAction* action) { Q_EMIT this->chosen(action->data().toString()); });
  this->Fill();
}

//------------------------------------------------------------------------------
QStringList RecentFiles::GetPaths() const
{
  return QSettings().value(Key).toStringList();
}

//------------------------------------------------------------------------------
void RecentFiles::Add(const QString& path)
{
  QStringList paths = this->GetPaths();
  paths.removeAll(path);
  paths.prepend(path);
  while (paths.size() > Most)
  {
    paths.removeLast();
  }
  QSettings().setValue(Key, paths);
}

//------------------------------------------------------------------------------
void RecentFiles::Fill()
{
  this->clear();
  for (const QString& path : this->GetPaths())
  {
    QAction* action = this->addAction(QFileInfo(path).fileName());
    action->setData(path);
    action->setToolTip(path);
    action->setStatusTip(path);
  }
  if (this->isEmpty())
  {
    this->addAction("(none)")->setEnabled(false);
  }
}
}
