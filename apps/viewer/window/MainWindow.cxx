// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include "Actions.h"
#include "InputGuard.h"
#include "LayersPanel.h"
#include "LightPanel.h"
#include "LookPanel.h"
#include "PictureView.h"
#include "RecentFiles.h"
#include "ReportPanel.h"
#include "SceneFacts.h"
#include "StagesPanel.h"
#include "SunGroup.h"
#include "TimeBar.h"

#include "vtkRelievoPass.h"

#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>

namespace viewer
{
namespace
{
// Milliseconds
constexpr int ProbePause = 120; // that the mouse rests before layers are drawn
constexpr int Patience = 250;   // until reading is told of
constexpr int Silence = 1500;   // of a reader, until how far it is counts as unknown

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
  this->Time = new TimeBar(this->Edited, this);
  this->addToolBar(Qt::BottomToolBarArea, this->Time);
  AddActions(this, this->Recent);
  this->Connect();
  this->Later.setSingleShot(true);
  this->Pause.setSingleShot(true);
  this->Pause.setInterval(ProbePause);
  this->Waiting.setSingleShot(true);
  this->Waiting.setInterval(Patience);
  this->Quiet.setSingleShot(true);
  this->Quiet.setInterval(Silence);
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
  auto* look = new LookPanel(
    this->Edited, [this] { return GetColorRange(this->Shown->GetPicture()); }, this);
  QDockWidget* first = AddDock(this, "Stages", "stages", this->Stages);
  this->tabifyDockWidget(first, AddDock(this, "Light", "light", this->Light));
  this->tabifyDockWidget(first, AddDock(this, "Look", "look", look));
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
  QObject::connect(this->Reader, &Loader::progressed, this, &MainWindow::OnProgress);
  QObject::connect(this->Reader, &Loader::ended, this, &MainWindow::OnRead);
  QObject::connect(this->Cancel, &QPushButton::clicked, this, &MainWindow::StopReading);
  QObject::connect(&this->Waiting, &QTimer::timeout, this, &MainWindow::ShowReading);
  QObject::connect(&this->Later, &QTimer::timeout, this, &MainWindow::ShowLate);
  QObject::connect(&this->Quiet, &QTimer::timeout, this, [this] { this->Bar->setRange(0, 0); });
  QObject::connect(this->Shown, &PictureView::drawn, this, &MainWindow::OnDrawn);
  QObject::connect(this->Shown, &PictureView::pointed, this, &MainWindow::PointAt);
  QObject::connect(&this->Pause, &QTimer::timeout, this, [this] { this->ShowProbe(); });
  QObject::connect(this->Layers, &LayersPanel::probing, this, [this](bool on) {
    this->Reading.Forget();
    this->Values->setVisible(on);
    this->Values->clear();
  });
  QObject::connect(
    this->Report, &ReportPanel::framesWanted, this->Shown, [this] { this->Shown->Draw(); });
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
  if (this->Pointed[0] < 0 || this->Reader->IsReading())
  {
    return; // the last values stay, to be read
  }
  const std::vector<ProbeValue> values = this->Reading.Read(this->Shown->GetPicture().GetRenderer(),
    this->Edited->GetFacts().Layers, this->Pointed[0], this->Pointed[1]);
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
