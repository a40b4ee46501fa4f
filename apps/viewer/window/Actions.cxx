// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Actions.h"

#include "Appearance.h"
#include "AxisMarker.h"
#include "HelpMenu.h"
#include "LightOptions.h"
#include "MainWindow.h"
#include "OptionNames.h"
#include "Picture.h"
#include "PictureView.h"
#include "Properties.h"
#include "Readers.h"
#include "RecentFiles.h"
#include "SaveDialog.h"
#include "SceneFacts.h"
#include "SceneText.h"
#include "Scripts.h"
#include "ToolBar.h"

#include "vtkRelievoLayerCatalogue.h"
#include "vtkRenderWindow.h"

#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QMenuBar>
#include <QSignalBlocker>

#include <algorithm>
#include <exception>
#include <functional>
#include <set>
#include <string>

namespace viewer
{
namespace
{
// In the order of their tabs.
const char* const Panels[] = { "&Scene", "&Light", "L&ook", "La&yers", "&Report", "&Comparison" };

const char* const FilmHint = "; that of the film is copied in Camera path";

QAction* Add(QMenu* menu, MainWindow* window, const QString& text, const QKeySequence& key,
  const QString& name, const std::function<void()>& run)
{
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  action->setShortcut(key);
  QObject::connect(action, &QAction::triggered, window, [window, run] {
    try
    {
      run();
    }
    catch (const std::exception& error)
    {
      window->Say(QString::fromStdString(error.what()), true);
    }
  });
  return action;
}

//------------------------------------------------------------------------------
// An action on the picture, disabled while there is none; or while a file is read, if the action
// collects messages, which are the reader's then.
QAction* NeedPicture(MainWindow* window, QAction* action, bool collectsMessages = false)
{
  const auto follow = [window, action, collectsMessages] {
    action->setEnabled(!window->GetView()->IsEmpty() && !(collectsMessages && window->IsBusy()));
  };
  QObject::connect(window->GetDocument(), &Document::factsChanged, action, follow);
  QObject::connect(window, &MainWindow::busyChanged, action, follow);
  follow();
  return action;
}

//------------------------------------------------------------------------------
QSize GetViewSize(MainWindow* window)
{
  const int* size = window->GetView()->renderWindow()->GetSize();
  return { size[0], size[1] };
}

//------------------------------------------------------------------------------
// The catalogue's layers, a shadow for each light that casts, and arrays.
std::vector<std::string> ListLayers(MainWindow* window, const relievoQt::LightNames& lights)
{
  std::vector<std::string> layers = { vtkRelievoLayerCatalogue::GetPicture().Name };
  for (int i = 0; i < vtkRelievoLayerCatalogue::GetNumberOfLayers(); ++i)
  {
    const std::string name = vtkRelievoLayerCatalogue::GetLayerName(i);
    if (name == layers.front())
    {
      continue;
    }
    if (vtkRelievoLayerCatalogue::GetIsLayer(name))
    {
      layers.push_back(name);
      continue;
    }
    for (const auto& light : lights)
    {
      layers.push_back(light.first);
    }
  }
  const std::vector<std::string>& arrays = window->GetDocument()->GetFacts().Layers;
  layers.insert(layers.end(), arrays.begin(), arrays.end());
  return layers;
}

//------------------------------------------------------------------------------
// Filters of a file dialog: files that can be opened, first.
QString GetFilters(bool sessions = true)
{
  QString patterns;
  for (const std::string& extension : reading::GetExtensions())
  {
    patterns += QString::fromStdString(" *." + extension);
  }
  patterns += sessions ? " *.json" : "";
  return "Readable files (" + patterns.trimmed() + ");;All files (*)";
}

//------------------------------------------------------------------------------
void AddFileMenu(MainWindow* window, RecentFiles* recent)
{
  QMenu* menu = window->menuBar()->addMenu("&File");
  Add(menu, window, "&Open...", QKeySequence::Open, "open", [window] {
    const QStringList paths =
      QFileDialog::getOpenFileNames(window, "Open", GetLastFolder(), GetFilters());
    if (!paths.isEmpty())
    {
      window->OpenFiles(paths);
    }
  });
  Add(menu, window, "Open &beside...", QKeySequence("Ctrl+Shift+O"), "openBeside", [window] {
    const QStringList paths = QFileDialog::getOpenFileNames(
      window, "Add files to the scene", GetLastFolder(), GetFilters(false));
    if (!paths.isEmpty())
    {
      window->OpenFiles(paths, true);
    }
  });
  menu->addMenu(recent);
  NeedPicture(window,
    Add(menu, window, "Reloa&d", QKeySequence("F5"), "reload", [window] { window->Reload(); }));
  NeedPicture(window,
    Add(menu, window, "&Next file in the folder", QKeySequence("PgDown"), "nextFile",
      [window] { window->OpenNext(1); }));
  NeedPicture(window,
    Add(menu, window, "Previous &file in the folder", QKeySequence("PgUp"), "previousFile",
      [window] { window->OpenNext(-1); }));
  menu->addSeparator();
  Add(menu, window, "&Save session...", QKeySequence::Save, "saveSession", [window] {
    const QString path = AskPlace(window, "Save session", ".json");
    if (!path.isEmpty())
    {
      window->SaveSession(path);
    }
  });
  NeedPicture(
    window, Add(menu, window, "Save &picture...", QKeySequence("Ctrl+P"), "savePicture", [window] {
      if (const auto choice = AskPicture(window, GetViewSize(window)))
      {
        window->SavePicture(*choice);
      }
    }));
  NeedPicture(window,
    Add(menu, window, "Save &layers...", QKeySequence("Ctrl+E"), "saveLayers",
      [window] {
        const relievoQt::LightNames lights = GetLightNames(window->GetView()->GetPicture());
        if (const auto choice =
              AskLayers(window, GetViewSize(window), ListLayers(window, lights), lights))
        {
          window->SaveLayers(*choice);
        }
      }),
    true);
  NeedPicture(window,
    Add(menu, window, "Export &glTF...", QKeySequence(), "exportGltf",
      [window] {
        const QString path = AskPlace(window, "Export glTF", ".glb");
        if (!path.isEmpty())
        {
          window->ExportGltf(path);
        }
      }),
    true);
  NeedPicture(
    window, Add(menu, window, "Compare &with...", QKeySequence(), "compareWith", [window] {
      const QString path =
        QFileDialog::getOpenFileName(window, "Compare with a baseline or picture", GetLastFolder(),
          "Baselines and pictures (*.exr *.png);;All files (*)");
      if (!path.isEmpty())
      {
        window->CompareWith(path);
      }
    }));
  menu->addSeparator();
  const auto tell = [window] {
    ShowProperties(
      window, WriteScene(window->GetView()->GetPicture(), window->GetDocument()->Get().Files));
  };
  NeedPicture(
    window, Add(menu, window, "Proper&ties", QKeySequence("Alt+Return"), "properties", tell));
  QObject::connect(window->GetDocument(), &Document::factsChanged, window, [window, tell] {
    if (AreShown(window))
    {
      tell();
    }
  });
  menu->addSeparator();
  Add(menu, window, "&Quit", QKeySequence::Quit, "quit", [window] { window->close(); });
}

//------------------------------------------------------------------------------
// Names a change of the lights: the light that comes or goes, or what changes of one.
QString NameLights(const std::vector<std::string>& before, const std::vector<std::string>& after)
{
  const auto nameLight = [](const std::vector<std::string>& lights, std::size_t i) {
    const std::string name = look::ParseLight(lights[i]).Name;
    return name.empty() ? QString("light %1").arg(i) : QString::fromStdString(name);
  };
  const std::vector<std::string>& more = before.size() > after.size() ? before : after;
  const std::vector<std::string>& less = before.size() > after.size() ? after : before;
  const auto first = static_cast<std::size_t>(
    std::mismatch(less.begin(), less.end(), more.begin()).first - less.begin());
  if (more.size() == less.size() + 1 &&
    std::equal(less.begin() + static_cast<std::ptrdiff_t>(first), less.end(),
      more.begin() + static_cast<std::ptrdiff_t>(first) + 1))
  {
    return (&more == &after ? "new " : "removal of ") + nameLight(more, first);
  }
  if (more.size() != less.size() || first == less.size() ||
    !std::equal(less.begin() + static_cast<std::ptrdiff_t>(first) + 1, less.end(),
      more.begin() + static_cast<std::ptrdiff_t>(first) + 1))
  {
    return QString();
  }
  const look::LightWords was = look::SplitLight(before[first]);
  const look::LightWords is = look::SplitLight(after[first]);
  QStringList parts;
  if (was.Kind != is.Kind || was.Numbers != is.Numbers)
  {
    parts += "place";
  }
  const struct
  {
    const char* Word;
    const char* Name;
  } values[] = { { "color", "colour" }, { "intensity", "intensity" }, { "size", "softness" },
    { "casts", "shadow" }, { "name", "name" } };
  for (const auto& value : values)
  {
    if (words::FindWords(was.Values, value.Word) != words::FindWords(is.Values, value.Word))
    {
      parts += value.Name;
    }
  }
  return (parts.size() == 1 ? parts[0] + " of " : QString()) + nameLight(before, first);
}

//------------------------------------------------------------------------------
// Names the files that were opened, or, if there are none, those that were closed.
QString NameFiles(const std::vector<std::string>& before, const std::vector<std::string>& after)
{
  constexpr int most = 40; // letters
  const auto findNew = [](
                         const std::vector<std::string>& from, const std::vector<std::string>& to) {
    QStringList names;
    for (const std::string& file : to)
    {
      if (std::find(from.begin(), from.end(), file) == from.end())
      {
        names += QFileInfo(QString::fromStdString(file)).fileName();
      }
    }
    return names;
  };
  const QStringList opened = findNew(before, after);
  const QStringList names = opened.isEmpty() ? findNew(after, before) : opened;
  if (names.isEmpty())
  {
    return "order of files";
  }
  const auto more = names.size() - 1;
  const QString name = names.front().size() > most
    ? names.front().left(most - 10) + QChar(0x2026) + names.front().right(9)
    : names.front();
  return (opened.isEmpty() ? "closing " : "opening ") + name +
    (more > 0 ? QString(" and %1 more").arg(more) : QString());
}

//------------------------------------------------------------------------------
// Names changes of settings by their control or group; other files bring other settings.
QString NameChanges(
  const MainWindow* window, const scene::Settings& before, const scene::Settings& after)
{
  const std::set<std::string> changes = before.GetChanges(after);
  if (before.Files != after.Files)
  {
    return NameFiles(before.Files, after.Files);
  }
  if (changes == std::set<std::string>{ "--light" })
  {
    const QString name = NameLights(before.GetAll("--light"), after.GetAll("--light"));
    if (!name.isEmpty())
    {
      return name;
    }
  }
  QString name;
  for (const std::string& change : changes)
  {
    const QString word = QString::fromStdString(change).section(':', 0, 0); // option or stage
    const auto* group = window->findChild<QGroupBox*>(word);
    const QString label = group ? group->title() : FindOptionName(word).Label;
    if (label.isEmpty() || (!name.isEmpty() && label != name))
    {
      return "several settings";
    }
    name = label;
  }
  return name;
}

//------------------------------------------------------------------------------
// Appends the name of the setting or light that the step changes, in the menu and the tool tip.
void NameStep(const MainWindow* window, QAction* action, const scene::Settings& before,
  const scene::Settings& after)
{
  const QString text = action->text().section(':', 0, 0);
  const QString plain = QString(text).remove('&');
  const QString name = NameChanges(window, before, after);
  action->setText(text + (name.isEmpty() ? "" : ": " + QString(name).replace("&", "&&")));
  action->setToolTip(plain + (name.isEmpty() ? "" : ": " + name) + " (" +
    action->shortcut().toString(QKeySequence::NativeText) + ")");
}

//------------------------------------------------------------------------------
void AddEditMenu(MainWindow* window)
{
  QMenu* menu = window->menuBar()->addMenu("&Edit");
  Document* document = window->GetDocument();
  // A focused field that this hides would keep the keys.
  const auto keepFocus = [window] {
    const QWidget* focus = window->focusWidget();
    if (!focus || !focus->isVisible())
    {
      window->GetView()->setFocus();
    }
  };
  QAction* undo = Add(menu, window, "&Undo", QKeySequence::Undo, "undo", [document, keepFocus] {
    document->Undo();
    keepFocus();
  });
  QAction* redo = Add(menu, window, "&Redo", QKeySequence::Redo, "redo", [document, keepFocus] {
    document->Redo();
    keepFocus();
  });
  const auto follow = [window, document, undo, redo] {
    undo->setEnabled(document->CanUndo());
    redo->setEnabled(document->CanRedo());
    const scene::Settings& now = document->Get();
    NameStep(window, undo, document->GetPast(), now);
    NameStep(window, redo, now, document->GetFuture());
  };
  QObject::connect(document, &Document::pastChanged, undo, follow);
  undo->setEnabled(false);
  redo->setEnabled(false);
  NeedPicture(window,
    Add(menu, window, "R&eset settings", QKeySequence(), "resetSettings",
      [document] {
        document->Change([](scene::Settings& settings) {
          scene::Settings fresh;
          fresh.Files = settings.Files;
          fresh.SetAll("--allow-folder", settings.GetAll("--allow-folder")); // to read them
          settings = fresh;
        });
      }))
    ->setToolTip(
      "All settings get their defaults; files and camera stay, undo brings the settings back");
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  NeedPicture(window,
    Add(menu, window, "C&opy picture", QKeySequence::Copy, "copyPicture",
      [window] { window->CopyPicture(); }));
  NeedPicture(window,
    Add(
      menu, window, "Copy as &command line", QKeySequence("Ctrl+Shift+C"), "copyCommand", [window] {
        window->GetView()->GetPicture().CheckShown("Copy as command line");
        QApplication::clipboard()->setText(
          QString::fromStdString(WriteCommand(window->GetCopiedSettings(), "picture.png")));
        window->Say(QString("Copied: the command that makes this picture") +
          (window->CountViews() < 2 ? "" : FilmHint));
      }));
  NeedPicture(window,
    Add(menu, window, "Copy as &Python", QKeySequence("Ctrl+Shift+P"), "copyPython", [window] {
      QApplication::clipboard()->setText(
        QString::fromStdString(WritePython(window->GetCopiedSettings(), "picture.png")));
      window->Say("Copied: the Python program that makes this picture");
    }));
}

//------------------------------------------------------------------------------
// A check item for a picture option that follows the settings.
void AddShadows(MainWindow* window, QMenu* menu)
{
  QAction* shadows = NeedPicture(window, menu->addAction("&Shadows"));
  shadows->setObjectName("shadowsOn");
  shadows->setShortcut(QKeySequence("S"));
  shadows->setToolTip("Shadows of the lights in the picture");
  shadows->setCheckable(true);
  Document* document = window->GetDocument();
  QObject::connect(shadows, &QAction::toggled, document, &Document::SwitchShadows);
  QObject::connect(document, &Document::changed, shadows, [document, shadows] {
    const QSignalBlocker quiet(shadows);
    shadows->setChecked(document->Get().IsStageOn("shadows"));
  });
}

//------------------------------------------------------------------------------
void AddGrid(MainWindow* window, QMenu* menu)
{
  QAction* grid = NeedPicture(window, menu->addAction("&Grid"));
  grid->setObjectName("grid");
  grid->setShortcut(QKeySequence("G"));
  grid->setToolTip("Round the scene, with numbers on its axes");
  grid->setCheckable(true);
  Document* document = window->GetDocument();
  QObject::connect(grid, &QAction::toggled, document, [document](bool on) {
    document->Change([on](scene::Settings& settings) {
      on ? settings.Set("--grid", "") : settings.Remove("--grid");
    });
  });
  QObject::connect(document, &Document::changed, grid, [document, grid] {
    const QSignalBlocker quiet(grid);
    grid->setChecked(document->Get().Has("--grid"));
  });
}

//------------------------------------------------------------------------------
// Its data is the last unit.
void AddScaleBar(MainWindow* window, QMenu* menu)
{
  QAction* bar = NeedPicture(window, menu->addAction("S&cale bar"));
  bar->setObjectName("scaleBar");
  bar->setToolTip("A scale bar at the lower right; the panel Scene sets its unit");
  bar->setCheckable(true);
  bar->setData("none");
  Document* document = window->GetDocument();
  QObject::connect(bar, &QAction::toggled, document, [document, bar](bool on) {
    document->Change([on, bar](scene::Settings& settings) {
      on ? settings.Set("--scale-bar", bar->data().toString().toStdString())
         : settings.Remove("--scale-bar");
    });
  });
  QObject::connect(document, &Document::changed, bar, [document, bar] {
    const QSignalBlocker quiet(bar);
    bar->setChecked(document->Get().Has("--scale-bar"));
    if (bar->isChecked())
    {
      bar->setData(QString::fromStdString(document->Get().Get("--scale-bar")));
    }
  });
}

//------------------------------------------------------------------------------
// Brings a panel to the front, or closes the one in front; ticked while it is open, also behind
// another one's tab.
void AddPanel(QDockWidget* dock, QMenu* menu)
{
  QAction* shown = menu->addAction(dock->windowTitle());
  shown->setObjectName("show" + dock->windowTitle());
  shown->setCheckable(true);
  shown->setChecked(!dock->isHidden());
  QObject::connect(dock->toggleViewAction(), &QAction::toggled, shown, &QAction::setChecked);
  QObject::connect(shown, &QAction::triggered, dock, [dock, shown] {
    const bool opens = dock->visibleRegion().isEmpty();
    dock->setVisible(opens);
    opens ? dock->raise() : void();
    shown->setChecked(opens);
  });
}

//------------------------------------------------------------------------------
// Actions that give the keyboard to the picture, or to the first control of a panel.
void AddJumps(MainWindow* window, QMenu* menu)
{
  QMenu* jumps = menu->addMenu("&Jump to");
  Add(jumps, window, "&Picture", QKeySequence("Alt+0"), "jumpToPicture",
    [window] { window->GetView()->setFocus(Qt::TabFocusReason); });
  int number = 0;
  for (const char* text : Panels)
  {
    const QString name = QString(text).remove('&');
    auto* dock = window->findChild<QDockWidget*>(name.toLower());
    Add(
      jumps, window, text, QKeySequence(QString("Alt+%1").arg(++number)), "jumpTo" + name, [dock] {
        dock->show();
        dock->raise();
        QWidget* first = dock->widget();
        do
        {
          first = first->nextInFocusChain();
        } while (first != dock->widget() &&
          !(dock->widget()->isAncestorOf(first) && first->isVisible() && first->isEnabled() &&
            (first->focusPolicy() & Qt::TabFocus)));
        first->setFocus(Qt::TabFocusReason);
      });
  }
}

//------------------------------------------------------------------------------
// The end of an axis from which a view along it looks.
QString NameEnd(const std::array<double, 3>& along)
{
  const std::size_t axis = along[0] != 0.0 ? 0 : along[1] != 0.0 ? 1 : 2;
  return QString(along[axis] < 0.0 ? QChar('+') : QChar(0x2212)) + "XYZ"[axis];
}

//------------------------------------------------------------------------------
void AddViewMenu(MainWindow* window)
{
  QMenu* menu = window->menuBar()->addMenu("&View");
  const auto draw = [window](const std::function<void(Picture&)>& change) {
    return [window, change] { window->GetView()->Change(change); };
  };
  menu->setToolTipsVisible(true);
  NeedPicture(window,
    Add(menu, window, "&Fit", QKeySequence("R"), "fit",
      draw([](Picture& picture) { picture.ResetCamera(); })))
    ->setToolTip("The whole scene, from the current direction");
  struct
  {
    const char* Text;
    const char* Key;
    std::array<double, 3> Along, Up;
  } const sides[] = { { "From &right", "1", { -1, 0, 0 }, { 0, 1, 0 } },
    { "From l&eft", "Ctrl+1", { 1, 0, 0 }, { 0, 1, 0 } },
    { "From &above", "2", { 0, -1, 0 }, { 0, 0, -1 } },
    { "From &below", "Ctrl+2", { 0, 1, 0 }, { 0, 0, 1 } },
    { "From the fr&ont", "3", { 0, 0, -1 }, { 0, 1, 0 } },
    { "From the bac&k", "Ctrl+3", { 0, 0, 1 }, { 0, 1, 0 } } };
  auto* views = new QMenu(window); // of the tool bar
  views->setObjectName("views");
  views->setToolTipsVisible(true);
  for (const auto& side : sides)
  {
    // The names of sides assume y up; other axes turn them like the fitted camera.
    const auto turn = [document = window->GetDocument()](const std::array<double, 3>& v) {
      const int axis = document->GetUpAxis();
      return axis == 2 ? std::array<double, 3>{ v[0], -v[2], v[1] }
        : axis == 0    ? std::array<double, 3>{ v[1], -v[0], v[2] }
                       : v;
    };
    QAction* look = Add(menu, window, side.Text, QKeySequence(side.Key), QString("look") + side.Key,
      [window, turn, along = side.Along, up = side.Up] {
        window->GetView()->Change([side = turn(along), upwards = turn(up)](
                                    Picture& picture) { picture.LookAlong(side, upwards); });
      });
    NeedPicture(window, look)->setToolTip("The whole scene, with the up axis upwards");
    const auto name = [look, turn, side] {
      look->setText(side.Text + (" (" + NameEnd(turn(side.Along)) + ")"));
    };
    QObject::connect(window->GetDocument(), &Document::changed, look, name);
    QObject::connect(window->GetDocument(), &Document::factsChanged, look, name);
    name();
    if (QString(side.Key).size() == 1) // a digit alone, which may be meant for a number
    {
      look->setShortcutContext(Qt::WidgetShortcut);
      window->GetView()->addAction(look);
    }
    views->addAction(look);
  }
  QAction* parallel = NeedPicture(window, menu->addAction("&Parallel projection"));
  parallel->setToolTip("Without perspective; objects at the centre keep their size");
  parallel->setObjectName("parallel");
  parallel->setShortcut(QKeySequence("P"));
  parallel->setCheckable(true);
  QObject::connect(parallel, &QAction::toggled, window, [window](bool on) {
    window->GetView()->Change([on](Picture& picture) { picture.SetParallel(on); });
  });
  // Files and sessions can switch it too.
  QObject::connect(window->GetView(), &PictureView::drawn, parallel, [window, parallel] {
    const QSignalBlocker quiet(parallel);
    parallel->setChecked(window->GetView()->GetPicture().IsParallel());
  });
  views->addSeparator();
  views->addAction(parallel);
  menu->addSeparator();
  AddShadows(window, menu);
  AddGrid(window, menu);
  AddScaleBar(window, menu);
  QAction* axes = menu->addAction("A&xes in the corner");
  axes->setObjectName("axisMarker");
  axes->setToolTip("Only in the window, not in saved pictures");
  axes->setCheckable(true);
  axes->setChecked(window->GetAxes()->IsWanted());
  QObject::connect(
    axes, &QAction::toggled, window, [window](bool on) { window->GetAxes()->SetWanted(on); });
  menu->addSeparator();
  QAction* full = menu->addAction("F&ull screen");
  full->setObjectName("fullScreen");
  full->setShortcut(QKeySequence("F11")); // desktops differ
  full->setToolTip("Shows the window on the full screen");
  QObject::connect(full, &QAction::triggered, window,
    [window] { window->setWindowState(window->windowState() ^ Qt::WindowFullScreen); });
  AddAppearance(menu->addMenu("Appeara&nce"));
  AddToolBar(window, menu);
  menu->addAction(window->findChild<QAction*>("panels"));
  AddJumps(window, menu);
  menu->addSeparator();
  for (const char* name : Panels)
  {
    AddPanel(window->findChild<QDockWidget*>(QString(name).toLower().remove('&')), menu);
  }
}
}

//------------------------------------------------------------------------------
void AddActions(MainWindow* window, RecentFiles* recent)
{
  AddFileMenu(window, recent);
  AddEditMenu(window);
  AddViewMenu(window);
  AddHelpMenu(window);
}
}
