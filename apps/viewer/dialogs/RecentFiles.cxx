// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RecentFiles.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace viewer
{
namespace
{
const char* const Key = "recent_files";
constexpr int Most = 10;

// The name, with the folder if another file has the same name.
QString GetLabel(const QString& path, const QStringList& all)
{
  const QString name = QFileInfo(path).fileName();
  const auto count = std::count_if(all.begin(), all.end(),
    [&name](const QString& other) { return QFileInfo(other).fileName() == name; });
  QString label = count > 1 ? name + " (" + QFileInfo(path).path() + ")" : name;
  return label.replace('&', "&&"); // otherwise it would mark a key
}
}

//------------------------------------------------------------------------------
QString GetLastFolder()
{
  for (const QString& path : QSettings().value(Key).toStringList())
  {
    // Qt would offer the name of a folder that is gone as that of a file.
    const QString folder = QFileInfo(path).path();
    if (QFileInfo(folder).isDir())
    {
      return folder;
    }
  }
  return {};
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
  const QStringList paths = this->GetPaths();
  for (const QString& path : paths)
  {
    QAction* action = this->addAction(GetLabel(path, paths));
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
