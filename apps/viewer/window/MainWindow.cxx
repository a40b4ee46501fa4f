// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MainWindow.h"

#include "Actions.h"
#include "AxisMarker.h"
#include "Colormaps.h"
#include "ColorsGroup.h"
#include "ComparisonPanel.h"
#include "EmptyPage.h"
#include "FileFacts.h"
#include "InputGuard.h"
#include "LayerBanner.h"
#include "LayerLegend.h"
#include "LayersPanel.h"
#include "LightHandles.h"
#include "LightPanel.h"
#include "LightsGroup.h"
#include "LookPanel.h"
#include "MessageBar.h"
#include "Messages.h"
#include "NextFile.h"
#include "OptionNames.h"
#include "Options.h"
#include "PanelSwitch.h"
#include "PathGroup.h"
#include "Pick.h"
#include "PictureView.h"
#include "Progress.h"
#include "QtVersions.h"
#include "Readers.h"
#include "RecentFiles.h"
#include "ReportPanel.h"
#include "SceneFacts.h"
#include "ScenePanel.h"
#include "SessionFile.h"
#include "StageGroup.h"
#include "TimeBar.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLayout>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUrl>

#include <algorithm>
#include <exception>

namespace viewer
{
namespace
{
// Milliseconds
constexpr int ProbePause = 120; // rest of the mouse before layers are drawn
constexpr int Patience = 250;   // delay before a reading message
constexpr int Silence = 1500;   // time without progress after which progress counts as unknown

QDockWidget* AddDock(QMainWindow* window, const QString& title, const QString& name, QWidget* panel)
{
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(name);
  dock->setWidget(panel);
  window->addDockWidget(Qt::RightDockWidgetArea, dock);
  return dock;
}

// Whether Tab stops at a widget: panels behind the tab of another are visible for Qt.
bool TakesTab(const QWidget* widget, const QWidget* window)
{
  if ((widget->focusPolicy() & Qt::TabFocus) == 0 || widget->focusProxy() || !widget->isEnabled() ||
    !widget->isVisible() || widget->window() != window)
  {
    return false;
  }
  const QWidget* dock = widget;
  while (dock != window && !qobject_cast<const QDockWidget*>(dock))
  {
    dock = dock->parentWidget();
  }
  return !dock->visibleRegion().isEmpty();
}

bool HaveCommon(const std::vector<std::string>& a, const std::vector<std::string>& b)
{
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

// Dropped files are copied, whatever the source proposes: moving would delete them there.
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

// Layout version: a layout stored with other docks does not fit.
constexpr int LayoutVersion = 2;

constexpr const char* PlaceWords[] = { "--camera", "--parallel-scale", "--size" };
constexpr const char* ColorWords[] = { "--color-by", "--range", "--scalar-bar", "--bar" };
constexpr const char* CameraWords[] = { "--camera", "--parallel-scale" };

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

constexpr int SmoothPatience = 500; // milliseconds until the user is told of it

// Reads a property of the picture. While a sample is drawn, its last value stays, or the reader
// waits for the sample.
template <typename Read>
auto ReadAtRest(PictureView* view, Read read)
{
  return [view, read, known = decltype(read(view->GetPicture()))()](bool waits = false) mutable {
    if (waits || !view->IsDrawing())
    {
      known = read(view->GetPicture());
    }
    return known;
  };
}
}

//------------------------------------------------------------------------------
// Progress of work in the window's own thread: nothing else is painted meanwhile.
class WorkTeller : public reading::ProgressListener
{
public:
  WorkTeller(QStatusBar* bar, QLabel* words, QProgressBar* share)
    : Bar(bar)
    , Words(words)
    , Share(share)
  {
  }

  void Say(const std::string& what, double share) override
  {
    const int percent = static_cast<int>(100.0 * share);
    if (!this->Share->isHidden() && percent == this->Share->value())
    {
      return;
    }
    QString words = QString::fromStdString(what);
    this->Words->setText(words.replace(0, 1, words.left(1).toUpper()));
    this->Share->setRange(0, 100);
    this->Share->setValue(percent);
    this->Share->show();
    this->Bar->layout()->activate();
    this->Bar->repaint();
  }

  bool IsStopped() override { return false; }

private:
  QStatusBar* Bar;
  QLabel* Words;
  QProgressBar* Share;
};

//------------------------------------------------------------------------------
MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , Edited(new Document(this))
  , Shown(new PictureView(this))
  , Reader(new Loader(this))
  , Recent(new RecentFiles(this))
  , Pages(new QStackedWidget(this))
  , Empty(new EmptyPage(this))
{
  new InputGuard(this->Edited, this);
  this->setWindowTitle("Relievo");
  this->setAcceptDrops(true);
  this->setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  this->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  this->Pages->addWidget(this->Empty);
  this->Pages->addWidget(this->Shown);
  this->Axes = new AxisMarker(this->Shown);
  this->Legend = new LayerLegend(this->Shown);
  this->Handles = new LightHandles(this->Edited, this->Shown);
  this->Message = new MessageBar(this->Shown);
  this->Hint = new MessageBar(this->Shown);
  this->Hint->setObjectName("hint");
  this->Hint->PutBelow(this->Message);
  this->StopPlacing = new QShortcut(Qt::Key_Escape, this);
  this->StopPlacing->setObjectName("stopPlacing");
  this->StopPlacing->setEnabled(false);
  this->Banner = new LayerBanner(this->Shown);
  this->Banner->PutBelow(this->Hint);
  this->setCentralWidget(this->Pages);
  this->AddPanels();
  this->AddStatus();
  this->Time = new TimeBar(this->Edited, this);
  this->addToolBar(Qt::BottomToolBarArea, this->Time);
  AddActions(this, this->Recent);
  this->Connect();
  this->ConnectComparison();
  this->ConnectPath();
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
  this->Layers = new LayersPanel(this->Edited, ReadAtRest(this->Shown, &GetShownRange), this);
  this->Report = new ReportPanel(
    [this]() -> std::optional<std::string> {
      if (this->Shown->IsDrawing())
      {
        return std::nullopt;
      }
      vtkRelievoPass* frame = this->Shown->GetPicture().GetFrame();
      return frame ? frame->GetFrameReport() : std::string();
    },
    this);
  auto* look = new LookPanel(
    this->Edited, ReadAtRest(this->Shown, &GetColorRange),
    [this](bool /*waits*/) {
      return FindSeenRange(
        this->Shown->GetPicture(), this->Edited->Get().Parse().Look, this->Edited->GetFacts());
    },
    ReadAtRest(this->Shown, &GetVolumeFacts), this);
  auto* scene = new ScenePanel(this->Edited, this);
  this->Path = scene->GetPath();
  QDockWidget* first = AddDock(this, "Scene", "scene", scene);
  this->tabifyDockWidget(first, AddDock(this, "Light", "light", this->Light));
  this->tabifyDockWidget(first, AddDock(this, "Look", "look", look));
  this->tabifyDockWidget(first, AddDock(this, "Layers", "layers", this->Layers));
  this->tabifyDockWidget(first, AddDock(this, "Report", "report", this->Report));
  this->Comparison = new ComparisonPanel(this);
  QDockWidget* comparison = AddDock(this, "Comparison", "comparison", this->Comparison);
  this->tabifyDockWidget(first, comparison);
  comparison->hide(); // until there is one
  first->raise();
  this->Panels = new PanelSwitch(this);
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
  this->Values->setToolTip("Lengths are in world units");
  this->Smoothing = new QLabel(this);
  this->Smoothing->setObjectName("smoothing");
  this->Smoothing->setToolTip("Soft shadows and smooth edges are gathered while nothing moves");
  this->Bar = new QProgressBar(this);
  this->Bar->setObjectName("progress");
  this->Bar->setMaximumWidth(200);
  this->Cancel = new QPushButton("Cancel", this);
  this->Cancel->setObjectName("cancel");
  this->Bar->hide();
  this->Cancel->hide();
  this->statusBar()->addWidget(this->Words, 1);
  this->statusBar()->addPermanentWidget(this->Smoothing);
  this->statusBar()->addPermanentWidget(this->Values);
  this->statusBar()->addPermanentWidget(this->Bar);
  this->statusBar()->addPermanentWidget(this->Cancel);
  this->Teller = std::make_unique<WorkTeller>(this->statusBar(), this->Words, this->Bar);
  this->Shown->GetPicture().SetListener(this->Teller.get());
}

//------------------------------------------------------------------------------
void MainWindow::Connect()
{
  QObject::connect(this->Edited, &Document::asked, this, [this] { this->Follow(); });
  QObject::connect(
    this->Edited, &Document::refused, this, [this](const QString& why) { this->Say(why, true); });
  QObject::connect(this->Reader, &Loader::progressed, this, &MainWindow::OnProgress);
  QObject::connect(this->Reader, &Loader::ended, this, &MainWindow::OnRead);
  QObject::connect(this->Reader, &Loader::busyChanged, this, &MainWindow::busyChanged);
  QObject::connect(this->Cancel, &QPushButton::clicked, this, &MainWindow::StopReading);
  QObject::connect(&this->Waiting, &QTimer::timeout, this, &MainWindow::ShowReading);
  QObject::connect(&this->Later, &QTimer::timeout, this, &MainWindow::ShowLate);
  QObject::connect(&this->Quiet, &QTimer::timeout, this, [this] { this->Bar->setRange(0, 0); });
  QObject::connect(this->Shown, &PictureView::drawn, this, &MainWindow::OnDrawn);
  QObject::connect(this->Shown, &PictureView::drawing, this, [this] {
    this->FirstIsSlow = true;
    this->Smoothing->setText(QString("Drawing") + QChar(0x2026));
  });
  QObject::connect(this->Shown, &PictureView::returned, this, &MainWindow::CatchUp);
  QObject::connect(this->Shown, &PictureView::pointed, this, &MainWindow::PointAt);
  LightsGroup* lights = this->Light->GetLights();
  QObject::connect(lights, &LightsGroup::placing, this, &MainWindow::WaitForPlace);
  QObject::connect(lights, &LightsGroup::selected, this->Handles, &LightHandles::Select);
  QObject::connect(this->Handles, &LightHandles::selected, lights, &LightsGroup::Select);
  QObject::connect(this->StopPlacing, &QShortcut::activated, lights, &LightsGroup::StopPlacing);
  QObject::connect(this->Hint, &MessageBar::closed, lights, &LightsGroup::StopPlacing);
  QObject::connect(this->findChild<QDockWidget*>("light"), &QDockWidget::visibilityChanged,
    this->Handles, &LightHandles::SetWanted);
  QObject::connect(this->Shown, &PictureView::picked, this, &MainWindow::PlaceLight);
  QObject::connect(&this->Pause, &QTimer::timeout, this, [this] { this->ShowProbe(); });
  QObject::connect(this->Layers, &LayersPanel::probing, this, [this](bool on) {
    this->Reading.Forget();
    this->Values->setVisible(on);
    this->Values->clear();
  });
  QObject::connect(this->findChild<QDockWidget*>("report"), &QDockWidget::visibilityChanged,
    this->Report, [this](bool shown) {
      if (shown)
      {
        this->Report->Show();
      }
    });
  QObject::connect(
    this->Report, &ReportPanel::framesWanted, this->Shown, [this] { this->Shown->Draw(); });
  QObject::connect(this->Axes, &AxisMarker::lookWanted, this, &MainWindow::LookFrom);
  QObject::connect(this->Banner, &LayerBanner::pictureWanted, this, [this] {
    this->Edited->Change(
      [](scene::Settings& settings) { settings.SetParameter("display", "layer", ""); });
  });
  QObject::connect(this->findChild<ColorsGroup*>(), &ColorsGroup::layersWanted, this,
    [this] { this->findChild<QAction*>("jumpToLayers")->trigger(); });
  QObject::connect(this->Empty, &EmptyPage::openWanted, this,
    [this] { this->findChild<QAction*>("open")->trigger(); });
  QObject::connect(this->Recent, &RecentFiles::chosen, this,
    [this](const QString& path) { this->OpenFiles({ path }); });
}

//------------------------------------------------------------------------------
void MainWindow::Say(const QString& said, bool isTrouble)
{
  const QString text = NameOptions(said);
  this->Words->setText(isTrouble ? QString() : text);
  this->Words->setToolTip(this->Words->text());
  this->Trouble = isTrouble ? text : QString();
  if (isTrouble)
  {
    this->OfFile = false;
    this->Shown->IsEmpty() ? this->Empty->ShowTrouble(text)
                           : this->Message->Show(text, MessageBar::Error);
  }
}

//------------------------------------------------------------------------------
// An error of opening a file: only opening another one clears it.
void MainWindow::SayOfFile(const QString& why)
{
  this->Say(why, true);
  this->OfFile = true;
}

//------------------------------------------------------------------------------
// Clears errors that an edit can fix.
void MainWindow::Mend()
{
  if (!this->OfFile)
  {
    this->Message->hide();
  }
  this->Say("");
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
// Waits for a click in the picture, and says for which purpose.
void MainWindow::WaitForPlace(const QString& hint)
{
  const bool on = !hint.isEmpty();
  this->Shown->PickNext(on);
  this->Handles->setAttribute(Qt::WA_TransparentForMouseEvents, on);
  this->StopPlacing->setEnabled(on);
  on ? this->Hint->Show(hint, MessageBar::Hint) : this->Hint->hide();
}

//------------------------------------------------------------------------------
void MainWindow::PlaceLight(int x, int y)
{
  const std::optional<std::array<double, 3>> place =
    Pick(this->Shown->GetPicture(), this->Reading, x, y);
  this->Reading.Forget(); // the new scene has no arrays
  if (place)
  {
    this->Light->GetLights()->Place(*place);
  }
  else
  {
    this->Hint->Show("Nothing is there: click on a surface. Esc to stop.", MessageBar::Hint);
    this->Shown->PickNext(true);
  }
}

//------------------------------------------------------------------------------
void MainWindow::ShowProbe()
{
  if (this->Pointed[0] < 0 || this->Reader->IsReading())
  {
    return; // keeps the last values readable
  }
  const std::vector<ProbeValue> values = this->Reading.Read(this->Shown->GetPicture().GetRenderer(),
    this->Edited->GetFacts().Layers, this->Pointed[0], this->Pointed[1]);
  this->Layers->ShowValues(values);
  QStringList words;
  for (const ProbeValue& value : values)
  {
    const QStringList shown = { "depth", "position", "cell", "volume_depth", "volume_value" };
    if (!value.IsBackground && shown.contains(QString::fromStdString(value.Layer)))
    {
      words += relievoQt::NameLayer(value.Layer) + " " + WriteValues(value);
    }
  }
  this->Values->setText(words.empty() && !values.empty()
      ? QString("Background: nothing of the files is here")
      : words.join("   "));
}

//------------------------------------------------------------------------------
// Values of an outdated picture, read anew when the mouse rests.
void MainWindow::DropValues()
{
  this->Reading.Forget();
  this->Layers->ShowValues({});
  this->Values->clear();
  this->Probed = this->GetViewSettings();
  if (this->Layers->IsProbing() && this->Pointed[0] >= 0)
  {
    this->Pause.start();
  }
}

//------------------------------------------------------------------------------
// Resizes the view to this size in screen pixels, as far as the screen allows.
void MainWindow::SetViewSize(const std::string& words)
{
  if (words.empty())
  {
    return;
  }
  scene::Settings asked;
  asked.Set("--size", words);
  const std::array<int, 2> pixels = asked.Parse().Size;
  const bool fixed = this->isMaximized() || this->isFullScreen();
  const double ratio = this->Shown->effectiveDevicePixelRatio();
  const QSize frame = this->frameGeometry().size() - this->size();
  double share = 1.0;
  for (int i = 0; i < 3; ++i) // panels may take another share of another window
  {
    const QSize panels = this->size() - this->Pages->size();
    const QSize room =
      fixed ? this->Pages->size() : this->screen()->availableSize() - frame - panels;
    share = std::min({ 1.0, room.width() * ratio / pixels[0], room.height() * ratio / pixels[1] });
    if (!fixed)
    {
      this->resize(panels +
        QSize(static_cast<int>(pixels[0] * share / ratio),
          static_cast<int>(pixels[1] * share / ratio)));
    }
  }
  if (share < 1.0)
  {
    reading::Messages::Note(
      "--size " + words + ": the screen is too small for this size; the view is smaller");
  }
}

//------------------------------------------------------------------------------
void MainWindow::RestoreLayout()
{
  const QSettings kept;
  this->restoreGeometry(kept.value("geometry").toByteArray());
  this->restoreState(kept.value("state").toByteArray(), LayoutVersion);
  this->Time->ShowSettings(); // hides the bar without animations
  const QSize room = this->screen()->availableSize();
  if (!this->isMaximized() && !this->isFullScreen())
  {
    this->resize(this->size().boundedTo(room));
  }
}

//------------------------------------------------------------------------------
void MainWindow::KeepLayout()
{
  QSettings kept;
  kept.setValue("geometry", this->saveGeometry());
  kept.setValue("state", this->saveState(LayoutVersion));
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
    scene::Settings settings = this->Edited->Get();
    const bool first = this->Good.Files.empty(); // earlier notes belong to it
    const QString dropped = beside || first ? QString() : DropFiles(settings);
    settings.Files = beside ? settings.Files : std::vector<std::string>();
    QStringList whole;
    for (const QString& path : paths)
    {
      whole += QFileInfo(path).absoluteFilePath();
      settings.Files.push_back(whole.back().toStdString());
    }
    if (!beside || first)
    {
      const bool safe = this->IsSafe || !this->HasEdits();
      const scene::Settings before = this->Edited->Get();
      // While a file is being read, its colours by an array are not in the settings yet.
      const bool pending = this->Reader->IsReading() && this->Colors.Has("--color-by") &&
        !before.Has("--color-by") && !before.Has("--color");
      const scene::Settings colors = pending ? this->Colors : before;
      const QString told = this->Reader->IsReading() ? this->Dropped : QString();
      this->Open(settings, whole);
      this->IsSafe = safe;
      this->Dropped = told + (told.isEmpty() || dropped.isEmpty() ? "" : ", ") + dropped;
      for (const char* word : ColorWords)
      {
        if (!first && colors.Has("--color-by") && colors.Has(word))
        {
          this->Colors.SetAll(word, colors.GetAll(word));
        }
      }
      const std::string map = colors.Get("--colormap");
      if (this->Colors.Has("--color-by") && !map.empty() && look::Colormap::Parse(map).Log)
      {
        this->Colors.Set("--colormap", map);
      }
      return;
    }
    this->Opening = whole;
    this->Edited->Set(settings);
  }
  catch (const std::exception& error)
  {
    this->SayOfFile(QString::fromStdString(error.what()));
  }
}

//------------------------------------------------------------------------------
// From the present camera.
void MainWindow::Reload()
{
  this->ReadingKey.clear();
  this->KeepCamera = true;
  this->Follow();
}

//------------------------------------------------------------------------------
void MainWindow::OpenNext(int step)
{
  const std::vector<std::string>& shown = this->Edited->Get().Files;
  const QFileInfo file(QString::fromStdString(shown.empty() ? std::string() : shown.back()));
  QStringList names;
  for (const QString& name : file.dir().entryList(QDir::Files, QDir::Name))
  {
    // TIFFs beside models may be their textures: terrains and other files are two sequences.
    const std::string next = name.toStdString();
    if (reading::HasReader(next) &&
      reading::IsRaster(next) == reading::IsRaster(file.fileName().toStdString()))
    {
      names += name;
    }
  }
  const auto at = names.indexOf(file.fileName());
  const auto all = names.size();
  if (at < 0 || all < 2)
  {
    this->Say("There is no other file in " + file.dir().path() + " that can be opened.");
    return;
  }
  this->OpenFiles({ file.dir().filePath(names[(at + step + all) % all]) });
}

//------------------------------------------------------------------------------
void MainWindow::OpenSession(const QString& path)
{
  const Session session = LoadSession(path);
  this->Open(session.View, { QFileInfo(path).absoluteFilePath() });
  this->IsSafe = true;
  this->AskedKeys = session.Keys;
  if (session.View.Files.empty()) // none is read
  {
    this->TakeKeys();
  }
}

//------------------------------------------------------------------------------
// Shows the camera path of a session that has been read.
void MainWindow::TakeKeys()
{
  if (this->AskedKeys)
  {
    this->Path->SetKeys(*this->AskedKeys);
    this->SafeKeys = *this->AskedKeys;
    this->AskedKeys.reset();
  }
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
  if (!paths.isEmpty() && !this->Saving && !this->Filming)
  {
    AcceptCopy(*event);
    this->OpenFiles(paths, GetModifiers(*event).testFlag(Qt::ShiftModifier));
  }
}

//------------------------------------------------------------------------------
// Tab goes around through the picture and the panels in front. Qt's own chain also holds the
// panels behind other tabs, and loses controls to whose order it was told.
bool MainWindow::focusNextPrevChild(bool next)
{
  QList<QWidget*> stops;
  for (QWidget* each : this->findChildren<QWidget*>())
  {
    if (TakesTab(each, this))
    {
      stops += each;
    }
  }
  if (stops.isEmpty())
  {
    return false;
  }
  const auto count = stops.size();
  const auto at = stops.indexOf(this->focusWidget());
  const auto to = next ? at + 1 : (at < 0 ? count : at) - 1 + count;
  stops[to % count]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

//------------------------------------------------------------------------------
void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->LetGoOfEdits())
  {
    event->ignore();
    return;
  }
  this->Reader->Stop();
  this->hide(); // the rest may have to wait for a sample
  this->Panels->Open();
  this->KeepLayout();
  this->QMainWindow::closeEvent(event);
}

//------------------------------------------------------------------------------
void MainWindow::Open(const scene::Settings& settings)
{
  QStringList paths;
  for (const std::string& file : settings.Files)
  {
    paths += QString::fromStdString(file);
  }
  this->Open(settings, paths);
  this->IsSafe = true;
}

//------------------------------------------------------------------------------
void MainWindow::Open(const scene::Settings& settings, const QStringList& recent)
{
  settings.Parse(); // an error leaves everything unchanged
  this->Opening = recent;
  this->AskedKeys.reset();
  this->Dropped.clear();
  this->Colors = scene::Settings();
  this->Place = scene::Settings();
  scene::Settings rest = settings;
  for (const char* word : PlaceWords)
  {
    this->Place.SetAll(word, settings.GetAll(word));
    rest.Remove(word);
  }
  this->ReadingKey.clear(); // reads displayed files again, too
  this->KeepCamera = false;
  rest == this->Edited->Get() ? this->Follow() : this->Edited->Set(rest);
}

//------------------------------------------------------------------------------
void MainWindow::Follow()
{
  const scene::Settings settings = this->Edited->Get();
  const std::string key = GetReadingKey(settings);
  this->Reading.Forget();
  this->FirstIsSlow = false; // that was the former picture's
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
  this->KeepView();
  this->Shown->GetPicture().Clear();
  this->Pages->setCurrentWidget(this->Empty);
  this->Empty->ShowHint();
  this->Good = this->Edited->Get();
  this->ReadingKey = GetReadingKey(this->Good);
  this->Edited->SetFacts(Facts());
  this->DropValues();
  this->setWindowTitle("Relievo");
  this->Say("");
  this->TellMessages();
  this->Remember();
}

//------------------------------------------------------------------------------
// The edits made while a sample was drawn.
void MainWindow::CatchUp()
{
  if (this->Behind)
  {
    this->Behind = false;
    this->Follow();
    if (!this->Reader->IsReading())
    {
      Q_EMIT this->Edited->shown();
    }
  }
}

//------------------------------------------------------------------------------
// Panels show an edit at once. The picture changes after the sample that is being drawn.
void MainWindow::Update()
{
  if (this->Shown->IsDrawing())
  {
    this->Behind = true;
    return;
  }
  try
  {
    this->Shown->GetPicture().Update(this->Edited->Get());
    this->Good = this->Edited->Get();
    this->Report->Renew();
    this->Mend();
    this->TellMessages();
  }
  catch (const std::exception& error)
  {
    this->Edited->Refuse(this->Good, QString::fromStdString(error.what()));
  }
  this->Begin(); // without the progress bar of finished work
  this->Shown->Draw();
}

//------------------------------------------------------------------------------
// Settings changed while a file is read apply at once if no file is needed.
void MainWindow::ChangeShown(const scene::Settings& settings)
{
  scene::Settings changed = this->Meanwhile;
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
    if (picture.HasSurfaceOf(changed)) // messages about files belong to the reader now
    {
      picture.Update(changed);
      this->Good = changed;
    }
  }
  catch (const std::exception&) // it may suit the file being read
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
  const bool shown = !this->Shown->IsEmpty();
  const bool opened = this->ReadingKey.empty(); // by the user
  this->Asked = this->Edited->Get();
  const bool other = this->Asked.Files != this->BeingRead;
  this->BeingRead = this->Asked.Files;
  if (!opened && (!this->Reader->IsReading() || other))
  {
    this->Dropped.clear();
    this->Colors = scene::Settings();
    this->KeepCamera = shown && HaveCommon(this->Asked.Files, this->Good.Files);
    const auto found = this->Cameras.find(this->Asked.Files);
    this->Place =
      this->KeepCamera || found == this->Cameras.end() ? scene::Settings() : found->second;
  }
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
  const QString name = GetFileName(this->Asked.Files.front());
  this->Words->setText("Reading " + name);
  this->Empty->ShowReading(name);
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
  if (percent > 0) // some readers report only their start
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
// Cancels reading; other changes stay.
void MainWindow::GiveUp()
{
  this->Begin();
  this->IsSafe = false;
  this->AskedKeys.reset();
  this->Opening.clear();
  this->Dropped.clear();
  this->Colors = scene::Settings();
  if (this->SetMeanwhile)
  {
    this->Edited->ForgetPast(); // undo would lead to the cancelled files
  }
  Picture& picture = this->Shown->GetPicture();
  if (picture.IsEmpty())
  {
    this->Empty->ShowHint();
    // Settings for the next file.
    this->Good = this->Edited->Get();
    this->Good.Files.clear();
    this->Good.TakeChanges(scene::Settings(), this->Place);
  }
  else if (this->Meanwhile != this->Good)
  {
    try
    {
      picture.Update(this->Meanwhile);
      this->Good = this->Meanwhile;
    }
    catch (const std::exception&) // unchanged
    {
    }
  }
  this->ReadingKey = GetReadingKey(this->Good);
}

//------------------------------------------------------------------------------
void MainWindow::OnRead(const QString& trouble)
{
  if (this->Saving || this->Filming)
  {
    this->Late = trouble;
    return;
  }
  const QString why = trouble.isEmpty() ? this->ShowRead() : trouble;
  if (!why.isEmpty())
  {
    this->GiveUp();
    this->Edited->Refuse(this->Good, why);
    this->OfFile = true;
  }
  this->EndReading();
}

//------------------------------------------------------------------------------
QString MainWindow::ShowRead()
{
  this->Begin();
  Picture& picture = this->Shown->GetPicture();
  QWidget* page = this->Pages->currentWidget();
  this->KeepView();
  const scene::Scene scene = this->Reader->TakeScene();
  const scene::FramePoints points = this->Reader->TakePoints();
  try
  {
    if (this->PointsOnly)
    {
      picture.ShowPoints(points, this->Edited->Get());
    }
    else
    {
      scene::Settings settings = this->Edited->Get();
      settings.TakeChanges(scene::Settings(), this->Place);
      this->Pages->setCurrentWidget(this->Shown);
      if (!this->focusWidget())
      {
        this->Shown->setFocus(); // for its keys
      }
      this->SetViewSize(this->Place.Get("--size"));
      picture.Show(scene, points, settings, this->KeepCamera);
    }
  }
  catch (const std::exception& error)
  {
    this->Pages->setCurrentWidget(page);
    return QString::fromStdString(error.what());
  }
  if (!this->HasShown)
  {
    this->HasShown = true;
    this->Edited->ForgetPast(); // there is nothing to undo before the first file
  }
  this->Good = this->Edited->Get();
  this->DropValues();
  Facts facts = GetFacts(picture);
  facts.Files = GetFileFacts(picture, this->Good.Files);
  this->Edited->SetFacts(facts);
  this->setWindowTitle(GetTitle(this->Good.Files));
  // Dialogs that save propose this name.
  this->setWindowFilePath(QString::fromStdString(this->Good.Files.front()));
  this->OfFile = false;
  this->Mend();
  this->TellMessages();
  const scene::Settings colors = this->Colors;
  this->Colors = scene::Settings();
  if (colors.Has("--color-by") && !this->KeepColors(colors, facts))
  {
    this->Dropped += this->Dropped.isEmpty() ? "the colours" : ", and the colours";
  }
  this->TellDropped();
  this->Safe = this->IsSafe ? this->Edited->Get() : this->Safe;
  this->IsSafe = false;
  this->TakeKeys();
  this->Remember();
  return QString();
}

//------------------------------------------------------------------------------
void MainWindow::EndReading()
{
  this->Begin(); // without the progress bar of finished work
  this->Report->Renew();
  this->Place = scene::Settings();
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
// Stores the camera of the displayed files, for undo.
void MainWindow::KeepView()
{
  if (this->Shown->IsEmpty())
  {
    return;
  }
  const scene::Settings view = this->GetViewSettings();
  for (const char* word : CameraWords)
  {
    this->Cameras[this->Good.Files].SetAll(word, view.GetAll(word));
  }
}

//------------------------------------------------------------------------------
// Colours by an array stay if the next file has it, as in a series, unless the user has chosen
// others since.
bool MainWindow::KeepColors(const scene::Settings& colors, const Facts& facts)
{
  const scene::Settings now = this->Edited->Get();
  const std::string given = colors.Get("--color-by");
  if (now.Has("--color") || now.Has("--color-by") || now.Has("--range") ||
    now.Has("--scalar-bar") || now.Has("--bar"))
  {
    return false;
  }
  const std::string array =
    facts.Components.count(given) != 0 ? given : colors.Parse().Look.ColorBy;
  if (facts.Components.count(array) == 0)
  {
    return false;
  }
  scene::Settings kept = now;
  kept.TakeChanges(scene::Settings(), colors);
  Picture& picture = this->Shown->GetPicture();
  try
  {
    picture.Update(kept);
  }
  catch (const std::exception&) // the array has no such component, or no values
  {
    picture.Update(now);
    return false;
  }
  this->Good = kept;
  this->Edited->Amend(kept);
  return true;
}

//------------------------------------------------------------------------------
// Settings that have no visible effect any more.
void MainWindow::TellDropped()
{
  if (!this->Dropped.isEmpty())
  {
    const QString before = this->Words->text().isEmpty() ? "" : this->Words->text() + "; ";
    this->Say(before + "Gone with the file before: " + this->Dropped + ". Undo brings it back.");
    this->Dropped.clear();
  }
}

//------------------------------------------------------------------------------
void MainWindow::TellMessages()
{
  QStringList notes, warnings;
  for (const std::string& text : reading::Messages::TakeNotes())
  {
    notes += QString::fromStdString(text);
  }
  for (const std::string& text : reading::Messages::TakeWarnings())
  {
    warnings += QString::fromStdString(text);
  }
  if (!notes.isEmpty())
  {
    static const QRegularExpression ofSun("^--light sun:\\S+: night: (?=the sun is )");
    for (QString& note : notes)
    {
      const bool isOfSun = note.contains(ofSun);
      note.remove(ofSun);
      note = isOfSun ? note.left(1).toUpper() + note.mid(1) : note;
    }
    this->Say(notes.join("; "));
  }
  if (!warnings.isEmpty() && this->Message->GetText().isEmpty())
  {
    this->Message->Show(NameOptions(warnings.join('\n')), MessageBar::Warning);
  }
}

//------------------------------------------------------------------------------
void MainWindow::OnDrawn()
{
  this->Reading.Forget();
  if (this->Layers->IsProbing() && this->Probed != this->GetViewSettings())
  {
    this->DropValues();
  }
  for (StageGroup* stage : this->findChildren<StageGroup*>())
  {
    stage->ShowReason(this->Shown->GetPicture().GetFrame());
  }
  this->Report->Follow();
  this->ShowSmoothing();
  this->Axes->Follow(this->Shown->GetPicture().GetRenderer());
  const relievoQt::LightNames lights = GetLightNames(this->Shown->GetPicture());
  this->Layers->Follow(lights);
  this->Banner->Follow(this->Shown->GetPicture().GetFrame(), lights);
  this->Legend->Follow(this->Shown->GetPicture().GetFrame(), lights);
  this->Handles->Follow();
  try
  {
    if (!this->Reader->IsBusy()) // otherwise messages belong to the thread
    {
      reading::Messages::Check("Picture");
    }
  }
  catch (const std::exception& error)
  {
    this->Say(QString::fromStdString(error.what()), true);
  }
}

//------------------------------------------------------------------------------
// Looks from an axis's end; along the up axis, the rear turns to the top.
void MainWindow::LookFrom(int end)
{
  const int up = this->Edited->GetUpAxis();
  std::array<double, 3> along{};
  std::array<double, 3> upwards{};
  along[static_cast<std::size_t>(end % 3)] = end < 3 ? -1.0 : 1.0;
  upwards[static_cast<std::size_t>(end % 3 == up ? (up == 2 ? 1 : 2) : up)] =
    end == up && up != 2 ? -1.0 : 1.0;
  this->Shown->Change([along, upwards](Picture& picture) { picture.LookAlong(along, upwards); });
}

//------------------------------------------------------------------------------
// Progress of the samples of a resting picture, if they take long.
void MainWindow::ShowSmoothing()
{
  vtkRelievoPass* frame = this->Shown->GetPicture().GetFrame();
  const int left = frame ? frame->GetSamplesLeft() : 0;
  if (left >= this->SamplesLeft) // they accumulate anew
  {
    this->Samples = left + 1;
    this->Smoothed.start();
  }
  this->SamplesLeft = left;
  const bool isLong = this->FirstIsSlow || this->Smoothed.elapsed() > SmoothPatience;
  const bool shown = left > 0 && !this->Saving && isLong;
  this->Smoothing->setText(shown
      ? QString("Refining: %1 of %2 samples").arg(this->Samples - left).arg(this->Samples)
      : "");
  this->FirstIsSlow = this->FirstIsSlow && left > 0;
}

//------------------------------------------------------------------------------
scene::Settings MainWindow::GetViewSettings()
{
  return this->Shown->GetPicture().GetView(this->Good);
}

//------------------------------------------------------------------------------
scene::Settings MainWindow::GetCopiedSettings()
{
  scene::Settings settings = this->GetViewSettings();
  if (!HasColorsOfValues(this->Shown->GetPicture()))
  {
    settings.Remove("--colormap");
    settings.Remove("--range");
  }
  return settings;
}

//------------------------------------------------------------------------------
std::size_t MainWindow::CountViews() const
{
  return this->Path->GetKeys().size();
}
}
