// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From what is asked for to what is shown: files are read in the background, and what fails leaves
// the picture that there was.
#include "MainWindow.h"

#include "LayersPanel.h"
#include "Messages.h"
#include "Options.h"
#include "PictureView.h"
#include "RecentFiles.h"
#include "ReportPanel.h"
#include "SceneFacts.h"
#include "StagesPanel.h"
#include "TimeBar.h"

#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

#include <exception>

namespace viewer
{
namespace
{
constexpr const char* PlaceWords[] = { "--camera", "--parallel-scale", "--size" };

QString GetFileName(const std::string& path)
{
  return QFileInfo(QString::fromStdString(path)).fileName();
}

QString GetTitle(const std::vector<std::string>& files)
{
  const std::size_t more = files.size() - 1;
  return GetFileName(files.front()) + (more > 0 ? QString(" and %1 more").arg(more) : QString()) +
    " " + QChar(0x2013) + " Relievo";
}
}

//------------------------------------------------------------------------------
void MainWindow::Open(const Settings& settings)
{
  QStringList paths;
  for (const std::string& file : settings.Files)
  {
    paths += QString::fromStdString(file);
  }
  this->Open(settings, paths);
}

//------------------------------------------------------------------------------
void MainWindow::Open(const Settings& settings, const QStringList& recent)
{
  settings.Parse(); // what is refused leaves everything as it is
  this->Opening = recent;
  this->Place = Settings();
  Settings rest = settings;
  for (const char* word : PlaceWords)
  {
    this->Place.SetAll(word, settings.GetAll(word));
    rest.Remove(word);
  }
  this->ReadingKey.clear(); // read even what is shown already
  this->KeepCamera = false;
  rest == this->Edited->Get() ? this->Follow() : this->Edited->Set(rest);
}

//------------------------------------------------------------------------------
void MainWindow::Follow()
{
  const Settings settings = this->Edited->Get();
  const std::string key = GetReadingKey(settings);
  this->Reading.Forget();
  if (settings.Files.empty())
  {
    this->ShowNothing();
  }
  else if (this->ReadingKey.empty() || !this->Reader->IsReading())
  {
    key == this->ReadingKey ? this->Update() : this->Read();
  }
  else
  {
    this->ChangeShown(settings);
    if (key != this->ReadingKey)
    {
      this->Read();
    }
  }
}

//------------------------------------------------------------------------------
void MainWindow::ShowNothing()
{
  this->Reader->Stop();
  this->Begin();
  this->Shown->GetPicture().Clear();
  this->Pages->setCurrentWidget(this->Hint);
  if (!this->Good.Files.empty())
  {
    this->Edited->ForgetPast();
  }
  this->Good = this->Edited->Get();
  this->ReadingKey = GetReadingKey(this->Good);
  this->Edited->SetFacts(Facts());
  this->Layers->ShowValues({});
  this->setWindowTitle("Relievo");
  this->Say("");
  this->TellMessages();
  this->Remember();
}

//------------------------------------------------------------------------------
void MainWindow::Update()
{
  try
  {
    this->Shown->GetPicture().Update(this->Edited->Get());
    this->Good = this->Edited->Get();
    this->Report->Renew();
    this->Say("");
    this->TellMessages();
  }
  catch (const std::exception& error)
  {
    this->Edited->Refuse(this->Good, QString::fromStdString(error.what()));
  }
  this->Shown->Draw();
}

//------------------------------------------------------------------------------
// What is set while a file is read is seen at once, where that needs no file.
void MainWindow::ChangeShown(const Settings& settings)
{
  Settings changed = this->Meanwhile;
  changed.TakeChanges(this->Asked, settings);
  this->Asked = settings;
  Picture& picture = this->Shown->GetPicture();
  if (picture.IsEmpty() || GetReadingKey(changed) != GetReadingKey(this->Good))
  {
    return;
  }
  this->Meanwhile = changed;
  this->SetMeanwhile = true;
  try
  {
    if (picture.IsDressedAlike(changed)) // for messages about files are the reader's now
    {
      picture.Update(changed);
      this->Good = changed;
    }
  }
  catch (const std::exception&) // it may suit what is being read
  {
  }
  this->Shown->Draw();
}

//------------------------------------------------------------------------------
void MainWindow::Read()
{
  if (!this->Reader->IsReading())
  {
    this->Meanwhile = this->Good;
    this->SetMeanwhile = false;
  }
  const bool shown = !this->Shown->GetPicture().IsEmpty();
  const bool opened = this->ReadingKey.empty(); // by the user
  if (!opened && !this->Reader->IsReading())
  {
    this->KeepCamera = shown;
  }
  this->Asked = this->Edited->Get();
  this->PointsOnly = !opened && shown && (!this->Reader->IsReading() || this->PointsOnly) &&
    GetSceneKey(this->Asked) == GetSceneKey(this->Good);
  this->ReadingKey = GetReadingKey(this->Asked);
  this->Reader->Start(this->Asked, this->PointsOnly);
  this->Begin();
}

//------------------------------------------------------------------------------
void MainWindow::Begin()
{
  if (!this->Reader->IsReading())
  {
    this->Waiting.stop();
    this->Quiet.stop();
    this->Bar->hide();
    this->Cancel->hide();
  }
  else if (this->Bar->isHidden())
  {
    this->Bar->setRange(0, 0);
    this->Waiting.start();
  }
}

//------------------------------------------------------------------------------
void MainWindow::ShowReading()
{
  this->Words->setText("Reading " + GetFileName(this->Asked.Files.front()));
  this->Bar->show();
  this->Cancel->show();
}

//------------------------------------------------------------------------------
void MainWindow::OnProgress(const QString& what, int percent)
{
  if (this->Reader->IsReading() && !this->Bar->isHidden())
  {
    this->Words->setText(what);
  }
  if (percent > 0) // some readers say that they began, and no more
  {
    this->Bar->setRange(0, 100);
    this->Bar->setValue(percent);
    this->Quiet.start();
  }
}

//------------------------------------------------------------------------------
void MainWindow::StopReading()
{
  if (this->Reader->IsReading())
  {
    this->Reader->Stop();
    this->Time->Stop();
    this->GiveUp();
    this->Edited->Return(this->Good);
    this->Say("Stopped.");
    this->EndReading();
  }
}

//------------------------------------------------------------------------------
// What is being read is not asked for any more; what else was set stays.
void MainWindow::GiveUp()
{
  this->Begin();
  this->Opening.clear();
  if (this->SetMeanwhile)
  {
    this->Edited->ForgetPast(); // which would lead to what is given up
  }
  Picture& picture = this->Shown->GetPicture();
  if (picture.IsEmpty())
  {
    // For the next file.
    this->Good = this->Edited->Get();
    this->Good.Files.clear();
    this->Good.TakeChanges(Settings(), this->Place);
  }
  else if (this->Meanwhile != this->Good)
  {
    try
    {
      picture.Update(this->Meanwhile);
      this->Good = this->Meanwhile;
    }
    catch (const std::exception&) // as it was before
    {
    }
  }
  this->ReadingKey = GetReadingKey(this->Good);
}

//------------------------------------------------------------------------------
void MainWindow::OnRead(const QString& trouble)
{
  if (this->Saving)
  {
    this->Late = trouble;
    return;
  }
  const QString why = trouble.isEmpty() ? this->ShowRead() : trouble;
  if (!why.isEmpty())
  {
    this->GiveUp();
    this->Edited->Refuse(this->Good, why);
  }
  this->EndReading();
}

//------------------------------------------------------------------------------
QString MainWindow::ShowRead()
{
  this->Begin();
  Picture& picture = this->Shown->GetPicture();
  QWidget* page = this->Pages->currentWidget();
  const cli::Scene scene = this->Reader->TakeScene();
  const cli::FramePoints points = this->Reader->TakePoints();
  try
  {
    if (this->PointsOnly)
    {
      picture.ShowPoints(points, this->Edited->Get());
    }
    else
    {
      Settings settings = this->Edited->Get();
      settings.TakeChanges(Settings(), this->Place);
      this->Pages->setCurrentWidget(this->Shown);
      this->SetViewSize(this->Place.Get("--size"));
      picture.Show(scene, points, settings, this->KeepCamera);
    }
  }
  catch (const std::exception& error)
  {
    this->Pages->setCurrentWidget(page);
    return QString::fromStdString(error.what());
  }
  if (this->Good.Files != this->Edited->Get().Files)
  {
    this->Edited->ForgetPast(); // that of other files
  }
  this->Good = this->Edited->Get();
  this->Edited->SetFacts(GetFacts(picture));
  this->setWindowTitle(GetTitle(this->Good.Files));
  this->Say("");
  this->TellMessages();
  this->Remember();
  return QString();
}

//------------------------------------------------------------------------------
void MainWindow::EndReading()
{
  this->Report->Renew();
  this->Place = Settings();
  this->Shown->Draw();
  Q_EMIT this->Edited->shown();
  Q_EMIT this->ready();
}

//------------------------------------------------------------------------------
void MainWindow::Remember()
{
  for (const QString& path : this->Opening)
  {
    this->Recent->Add(path);
  }
  this->Opening.clear();
}

//------------------------------------------------------------------------------
void MainWindow::TellMessages()
{
  QStringList all;
  for (const std::string& text : cli::Messages::TakeNotes())
  {
    all += QString::fromStdString(text);
  }
  for (const std::string& text : cli::Messages::TakeWarnings())
  {
    all += "Warning: " + QString::fromStdString(text);
  }
  if (!all.isEmpty())
  {
    this->Say(all.join("; "));
  }
}

//------------------------------------------------------------------------------
void MainWindow::OnDrawn()
{
  this->Reading.Forget();
  this->Stages->ShowReasons(this->Shown->GetPicture().GetFrame());
  this->Report->Follow();
  try
  {
    if (!this->Reader->IsBusy()) // whose messages are the thread's
    {
      cli::Messages::Check("Picture");
    }
  }
  catch (const std::exception& error)
  {
    this->Say(QString::fromStdString(error.what()), true);
  }
}
}
