// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include "Actions.h"
#include "InputGuard.h"
#include "LayersPanel.h"
#include "LightPanel.h"
#include "LookPanel.h"
#include "Messages.h"
#include "Options.h"
#include "PictureView.h"
#include "RecentFiles.h"
#include "ReportPanel.h"
#include "StagesPanel.h"
#include "SunGroup.h"
#include "TimeBar.h"

#include "vtkRelievoPass.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>

#include <exception>

namespace viewer
{
namespace
{
constexpr const char* PlaceWords[] = { "--camera", "--parallel-scale", "--size" };

constexpr int ProbePause = 120; // milliseconds that the mouse rests before layers are drawn

QDockWidget* AddDock(QMainWindow* window, const QString& title, const QString& name, QWidget* panel)
{
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(name);
  dock->setWidget(panel);
  window->addDockWidget(Qt::RightDockWidgetArea, dock);
  return dock;
}
}

//------------------------------------------------------------------------------
MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , Edited(new Document(this))
  , Shown(new PictureView(this))
  , Reader(new Loader(this))
  , Recent(new RecentFiles(this))
  , Pages(new QStackedWidget(this))
  , Hint(new QLabel("Open a file (Ctrl+O), or drop one here.", this))
{
  new InputGuard(this);
  this->setWindowTitle("Relievo");
  this->setAcceptDrops(true);
  this->setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  this->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  this->Hint->setAlignment(Qt::AlignCenter);
  this->Pages->addWidget(this->Hint);
  this->Pages->addWidget(this->Shown);
  this->setCentralWidget(this->Pages);
  this->AddPanels();
  this->AddStatus();
  this->addToolBar(Qt::BottomToolBarArea, new TimeBar(this->Edited, this));
  AddActions(this, this->Recent);
  this->Connect();
  this->Pause.setSingleShot(true);
  this->Pause.setInterval(ProbePause);
  this->resize(1280, 800);
}

//------------------------------------------------------------------------------
MainWindow::~MainWindow()
{
  this->Reader->Stop();
}

//------------------------------------------------------------------------------
void MainWindow::AddPanels()
{
  this->Light = new LightPanel(this->Edited, this);
  this->Stages = new StagesPanel(this->Edited, this);
  this->Layers = new LayersPanel(this->Edited, this);
  this->Report = new ReportPanel(
    [this] {
      vtkRelievoPass* frame = this->Shown->GetPicture().GetFrame();
      return frame ? frame->GetFrameReport() : std::string();
    },
    this);
  QDockWidget* first = AddDock(this, "Stages", "stages", this->Stages);
  this->tabifyDockWidget(first, AddDock(this, "Light", "light", this->Light));
  this->tabifyDockWidget(first, AddDock(this, "Look", "look", new LookPanel(this->Edited, this)));
  this->tabifyDockWidget(first, AddDock(this, "Layers", "layers", this->Layers));
  this->tabifyDockWidget(first, AddDock(this, "Report", "report", this->Report));
  first->raise();
}

//------------------------------------------------------------------------------
void MainWindow::AddStatus()
{
  this->Words = new QLabel(this);
  this->Words->setObjectName("words");
  this->Words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Words->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  this->Values = new QLabel(this);
  this->Values->setObjectName("underTheMouse");
  this->Bar = new QProgressBar(this);
  this->Bar->setMaximumWidth(200);
  this->Cancel = new QPushButton("Cancel", this);
  this->Cancel->setObjectName("cancel");
  this->Bar->hide();
  this->Cancel->hide();
  this->statusBar()->addWidget(this->Words, 1);
  this->statusBar()->addPermanentWidget(this->Values);
  this->statusBar()->addPermanentWidget(this->Bar);
  this->statusBar()->addPermanentWidget(this->Cancel);
}

//------------------------------------------------------------------------------
void MainWindow::Connect()
{
  QObject::connect(this->Edited, &Document::asked, this, [this] { this->Follow(); });
  QObject::connect(
    this->Edited, &Document::refused, this, [this](const QString& why) { this->Say(why, true); });
  QObject::connect(this->Reader, &Loader::progressed, this, [this](const QString& what, int done) {
    if (this->Reader->IsReading())
    {
      this->Words->setText(what);
      this->Bar->setValue(done);
    }
  });
  QObject::connect(this->Reader, &Loader::ended, this, &MainWindow::OnRead);
  QObject::connect(this->Cancel, &QPushButton::clicked, this, [this] {
    this->Reader->Stop();
    this->OnRead("Stopped.");
  });
  QObject::connect(this->Shown, &PictureView::drawn, this, &MainWindow::OnDrawn);
  QObject::connect(this->Shown, &PictureView::pointed, this, &MainWindow::PointAt);
  QObject::connect(&this->Pause, &QTimer::timeout, this, [this] { this->ShowProbe(); });
  QObject::connect(this->Layers, &LayersPanel::probing, this, [this](bool on) {
    this->Reading.Forget();
    this->Values->setVisible(on);
    this->Values->clear();
  });
  QObject::connect(this->Recent, &RecentFiles::chosen, this,
    [this](const QString& path) { this->OpenFiles({ path }); });
}

//------------------------------------------------------------------------------
void MainWindow::Say(const QString& text, bool isTrouble)
{
  this->Words->setText(isTrouble ? QString(QChar(0x26a0)) + " " + text : text);
  this->Words->setToolTip(text);
  this->Trouble = isTrouble ? text : QString();
}

//------------------------------------------------------------------------------
void MainWindow::Open(const Settings& settings)
{
  settings.Parse(); // what is refused leaves everything as it is
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
// The view takes the size, in pixels of the screen, if the screen has room.
void MainWindow::SetViewSize(const std::string& words)
{
  const std::size_t at = words.find('x');
  if (at != std::string::npos && !this->isMaximized())
  {
    const double ratio = this->Shown->effectiveDevicePixelRatio();
    const QSize wanted(static_cast<int>(std::stoi(words.substr(0, at)) / ratio),
      static_cast<int>(std::stoi(words.substr(at + 1)) / ratio));
    this->resize(this->size() + wanted - this->Pages->size());
  }
}

//------------------------------------------------------------------------------
void MainWindow::Follow()
{
  const Settings& settings = this->Edited->Get();
  Picture& picture = this->Shown->GetPicture();
  const std::string key = GetReadingKey(settings);
  this->Reading.Forget();
  if (settings.Files.empty())
  {
    this->Reader->Stop();
    this->Begin();
    picture.Clear();
    this->Pages->setCurrentWidget(this->Hint);
    this->Good = settings;
    this->ReadingKey = key;
    return;
  }
  if (key != this->ReadingKey)
  {
    this->Read(settings, this->ReadingKey.empty() ? this->KeepCamera : !picture.IsEmpty());
    return;
  }
  if (this->Reader->IsReading())
  {
    return; // what was read is shown with the newest settings
  }
  try
  {
    picture.Update(settings);
    this->Good = settings;
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
void MainWindow::Read(const Settings& settings, bool keepCamera)
{
  this->ReadingKey = GetReadingKey(settings);
  this->KeepCamera = keepCamera;
  this->Reader->Start(settings);
  this->Begin();
}

//------------------------------------------------------------------------------
void MainWindow::Begin()
{
  const bool reading = this->Reader->IsReading();
  this->Bar->setValue(0);
  this->Bar->setVisible(reading);
  this->Cancel->setVisible(reading);
}

//------------------------------------------------------------------------------
void MainWindow::OnRead(const QString& trouble)
{
  this->Begin();
  QString why = trouble;
  if (why.isEmpty())
  {
    Settings settings = this->Edited->Get();
    for (const char* word : PlaceWords)
    {
      settings.SetAll(word, this->Place.GetAll(word));
    }
    this->SetViewSize(this->Place.Get("--size"));
    this->Pages->setCurrentWidget(this->Shown);
    const cli::Scene scene = this->Reader->TakeScene();
    try
    {
      this->Shown->GetPicture().Show(scene, this->Reader->TakePoints(), settings, this->KeepCamera);
      this->Good = this->Edited->Get();
      this->Edited->SetArrays(this->Shown->GetPicture().GetArrays());
      this->Edited->SetTimes(this->Shown->GetPicture().GetTimes());
      this->setWindowTitle(QFileInfo(QString::fromStdString(this->Good.Files[0])).fileName() + " " +
        QChar(0x2013) + " Relievo");
      this->Say("");
      this->TellMessages();
    }
    catch (const std::exception& error)
    {
      why = QString::fromStdString(error.what());
      if (this->Shown->GetPicture().IsEmpty())
      {
        this->Pages->setCurrentWidget(this->Hint);
      }
    }
  }
  this->Place = Settings();
  if (!why.isEmpty())
  {
    this->ReadingKey = GetReadingKey(this->Good);
    this->Edited->Refuse(this->Good, why);
  }
  this->Shown->Draw();
  Q_EMIT this->Edited->shown();
  Q_EMIT this->ready();
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

//------------------------------------------------------------------------------
void MainWindow::PointAt(int x, int y)
{
  this->Pointed[0] = x;
  this->Pointed[1] = y;
  if (this->Layers->IsProbing())
  {
    this->Reading.IsFresh() || x < 0 ? this->ShowProbe() : this->Pause.start();
  }
}

//------------------------------------------------------------------------------
void MainWindow::ShowProbe()
{
  Picture& picture = this->Shown->GetPicture();
  const std::vector<ProbeValue> values = this->Pointed[0] < 0 || this->Reader->IsReading()
    ? std::vector<ProbeValue>()
    : this->Reading.Read(
        picture.GetRenderer(), picture.GetArrays(), this->Pointed[0], this->Pointed[1]);
  this->Layers->ShowValues(values);
  QStringList words;
  for (const ProbeValue& value : values)
  {
    if (value.Layer == "depth" || value.Layer == "position" || value.Layer == "cell")
    {
      words += QString::fromStdString(value.Layer) + " " + WriteValues(value);
    }
  }
  this->Values->setText(
    !values.empty() && values[0].IsBackground ? QString("background") : words.join("   "));
}
}
