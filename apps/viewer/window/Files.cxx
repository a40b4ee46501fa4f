// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files in and out: opened, dropped, saved.
#include "MainWindow.h"

#include "LightPanel.h"
#include "Messages.h"
#include "ModelOptions.h"
#include "Outputs.h"
#include "PictureView.h"
#include "QtVersions.h"
#include "RecentFiles.h"
#include "SessionFile.h"
#include "SunGroup.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"

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

// Whole or not at all.
template <typename Writer>
void Write(const QString& path, vtkImageData* image)
{
  const std::string place = path.toStdString();
  cli::Outputs outputs;
  outputs.Add("Save", place, {});
  vtkNew<Writer> writer;
  writer->SetInputData(image);
  writer->SetFileName(outputs.Temporary(place).c_str());
  writer->Write();
  cli::Messages::Check(place, writer->GetErrorCode() != 0, "cannot be written; is the disk full?");
  outputs.Commit();
}

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
Settings MainWindow::GetViewSettings()
{
  return this->Shown->GetPicture().GetView(this->Good);
}

//------------------------------------------------------------------------------
void MainWindow::OpenSession(const QString& path)
{
  const Session session = LoadSession(path);
  this->Light->GetSun()->SetTime(session.Sun, session.SunByTime);
  this->Open(session.View, { QFileInfo(path).absoluteFilePath() });
}

//------------------------------------------------------------------------------
void MainWindow::SaveSession(const QString& path)
{
  const SunGroup* sun = this->Light->GetSun();
  viewer::SaveSession(path, { this->GetViewSettings(), sun->GetTime(), sun->IsByTime() });
  this->Recent->Add(QFileInfo(path).absoluteFilePath());
  this->Say("Saved " + path);
}

//------------------------------------------------------------------------------
void MainWindow::SavePicture(const QString& path)
{
  this->Shown->GetPicture().CheckShown("Save picture");
  Write<vtkPNGWriter>(path, this->Shown->GetPicture().Grab());
  this->Say("Saved " + path);
}

//------------------------------------------------------------------------------
void MainWindow::SaveLayers(const QString& path, const std::vector<std::string>& layers)
{
  this->Shown->GetPicture().CheckShown("Save layers");
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(this->Shown->GetPicture().GetRenderer());
  for (const std::string& layer : layers)
  {
    source->AddLayer(layer);
  }
  source->Update();
  cli::Messages::Check(path.toStdString(), source->GetErrorCode() != 0);
  Write<vtkRelievoEXRWriter>(path, source->GetOutput());
  this->Say("Saved " + path);
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
  if (!paths.isEmpty())
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
