// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are opened and dropped, and the window that is closed.
#include "MainWindow.h"

#include "LightPanel.h"
#include "ModelOptions.h"
#include "QtVersions.h"
#include "SessionFile.h"
#include "SunGroup.h"

#include "vtkRelievoLayerCatalogue.h"

#include <QCloseEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include <exception>

namespace viewer
{
namespace
{
// What belongs to the file before, and not to the one that is opened.
constexpr const char* FileWords[] = { "--color-by", "--range", "--scalar-bar", "--clip" };

// Whoever lets go of a file keeps it, whatever was proposed: moved files would be deleted there.
void AcceptCopy(QDropEvent& event)
{
  event.setDropAction(Qt::CopyAction);
  event.accept();
}

QStringList GetPaths(const QMimeData* data)
{
  QStringList paths;
  for (const QUrl& url : data->urls())
  {
    if (url.isLocalFile())
    {
      paths += url.toLocalFile();
    }
  }
  return paths;
}
}

//------------------------------------------------------------------------------
void MainWindow::OpenFiles(const QStringList& paths, bool beside)
{
  try
  {
    if (paths.size() == 1 && paths[0].endsWith(".json", Qt::CaseInsensitive))
    {
      this->OpenSession(paths[0]);
      return;
    }
    Settings settings = this->Edited->Get();
    const bool first = this->Good.Files.empty(); // what was said before it is meant for it
    settings.Files = beside ? settings.Files : std::vector<std::string>();
    if (!beside && !first)
    {
      for (const char* word : FileWords)
      {
        settings.Remove(word);
      }
      for (const std::string& word : cli::GetModelOptions())
      {
        settings.Remove(word);
      }
      const std::string layer = settings.GetParameter("display", "layer");
      if (!layer.empty() && !vtkRelievoLayerCatalogue::GetIsLayer(layer)) // but an array
      {
        settings.SetParameter("display", "layer", "");
      }
    }
    QStringList whole;
    for (const QString& path : paths)
    {
      whole += QFileInfo(path).absoluteFilePath();
      settings.Files.push_back(whole.back().toStdString());
    }
    if (!beside || first)
    {
      this->Open(settings, whole);
      return;
    }
    this->Opening = whole;
    this->Edited->Set(settings);
  }
  catch (const std::exception& error)
  {
    this->Say(QString::fromStdString(error.what()), true);
  }
}

//------------------------------------------------------------------------------
void MainWindow::OpenSession(const QString& path)
{
  const Session session = LoadSession(path);
  this->Light->GetSun()->SetTime(session.Sun, session.SunByTime);
  this->Open(session.View, { QFileInfo(path).absoluteFilePath() });
}

//------------------------------------------------------------------------------
void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (!GetPaths(event->mimeData()).isEmpty())
  {
    AcceptCopy(*event);
  }
}

//------------------------------------------------------------------------------
void MainWindow::dropEvent(QDropEvent* event)
{
  const QStringList paths = GetPaths(event->mimeData());
  if (!paths.isEmpty() && !this->Saving)
  {
    AcceptCopy(*event);
    this->OpenFiles(paths, GetModifiers(*event).testFlag(Qt::ShiftModifier));
  }
}

//------------------------------------------------------------------------------
void MainWindow::closeEvent(QCloseEvent* event)
{
  this->Reader->Stop();
  this->KeepLayout();
  this->QMainWindow::closeEvent(event);
}
}
