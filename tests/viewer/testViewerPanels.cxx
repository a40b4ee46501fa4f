// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The panels: their order, contents, folding and idle controls; layouts of older windows.
#include "TestCase.h"
#include "ViewerTest.h"

#include "ColorStage.h"
#include "Labels.h"
#include "Panel.h"
#include "ParameterEdit.h"
#include "StageGroup.h"

#include "vtkNew.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageRegistry.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace testViewerPanels
{
namespace
{
const char* const Docks[] = { "scene", "light", "look", "layers", "report" };

// From a library unknown to the viewer.
vtkRelievoStage* NewUnplaced()
{
  relievoTest::ColorStage* stage = relievoTest::ColorStage::New();
  stage->Name = "unplaced";
  return stage;
}
}

class TestViewerPanels : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  QGroupBox* Group(const char* name) { return this->Window->findChild<QGroupBox*>(name); }

  void Raise(const char* dock)
  {
    this->Window->findChild<QDockWidget*>(dock)->raise();
    QTest::qWait(50);
  }

  QStringList GetTabs()
  {
    for (const QTabBar* bar : this->Window->findChildren<QTabBar*>())
    {
      QStringList titles;
      for (int i = 0; i < bar->count(); ++i)
      {
        titles += bar->tabText(i);
      }
      if (titles.contains("Report"))
      {
        return titles;
      }
    }
    return {};
  }

  // The name of the dock that a widget is in.
  static QString GetDock(QWidget* widget)
  {
    while (widget && !qobject_cast<QDockWidget*>(widget))
    {
      widget = widget->parentWidget();
    }
    return widget ? widget->objectName() : QString();
  }

  void CheckDocks()
  {
    QCOMPARE(this->GetTabs(), QStringList({ "Scene", "Light", "Look", "Layers", "Report" }));
    for (const char* name : Docks)
    {
      auto* dock = this->Window->findChild<QDockWidget*>(name);
      QVERIFY2(dock && !dock->isHidden() && !dock->isFloating(), name);
      // One that is behind another has no region that is seen.
      QCOMPARE(!dock->visibleRegion().isEmpty(), QString(name) == "scene");
    }
  }

  void CheckShown()
  {
    for (const char* name : Docks)
    {
      QVERIFY2(!this->Window->findChild<QDockWidget*>(name)->isHidden(), name);
    }
    QVERIFY(this->Window->findChild<QDockWidget*>("comparison")->isHidden());
  }

private Q_SLOTS:
  void order()
  {
    this->Open({ this->WriteScene() });
    this->CheckDocks();
  }

  // The window of a version with a dock of stages, in front and beside others.
  void olderLayout()
  {
    QMainWindow older;
    QDockWidget* first = nullptr;
    for (const char* name : { "stages", "light", "look", "layers", "report" })
    {
      auto* dock = new QDockWidget(name, &older);
      dock->setObjectName(name);
      older.addDockWidget(Qt::RightDockWidgetArea, dock);
      first ? older.tabifyDockWidget(first, dock) : void(first = dock);
    }
    older.show();
    older.findChild<QDockWidget*>("look")->setFloating(true);
    QSettings().setValue("state", older.saveState());
    this->Open({ this->WriteScene() });
    this->Window->RestoreLayout();
    QTest::qWait(50);
    this->CheckDocks();
    // Its own comes back.
    this->Window->findChild<QDockWidget*>("look")->setFloating(true);
    this->Window->close();
    this->Open({ this->WriteScene() });
    this->Window->RestoreLayout();
    QVERIFY(this->Window->findChild<QDockWidget*>("look")->isFloating());
    QSettings().clear();
  }

  // Every configurable stage has one group, in Look by default.
  void everyStage()
  {
    this->Open({ this->WriteScene() });
    const std::map<std::string, QString> places = { { "shadows", "light" }, { "lamps", "light" } };
    vtkNew<vtkRelievoPass> frame;
    std::set<std::string> seen;
    for (int i = 0; i < frame->GetNumberOfStages(); ++i)
    {
      const vtkRelievoStageDescription& stage = frame->GetStage(i)->GetDescription();
      const auto groups =
        this->Window->findChildren<viewer::StageGroup*>(QString::fromStdString(stage.Name));
      const bool none = stage.Name == "display" ||
        (stage.OnByDefault && stage.Parameters.empty() && !stage.TakesData);
      QVERIFY2(groups.size() == (none ? 0 : 1), stage.Name.c_str());
      if (!none)
      {
        seen.insert(stage.Name);
        const auto place = places.find(stage.Name);
        QCOMPARE(this->GetDock(groups[0]), place == places.end() ? QString("look") : place->second);
      }
    }
    QVERIFY(seen.count("unplaced") == 1 && seen.count("tone") == 1 && seen.size() >= 9);
    auto* group = this->Group("unplaced");
    QVERIFY(!this->Group("advancedStages")->isAncestorOf(group));
    QVERIFY(this->Group("advancedStages")->isAncestorOf(this->Group("deferred")));
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    group->setChecked(true);
    QVERIFY(this->Window->GetDocument()->Get().IsStageAsked("unplaced"));
    Q_EMIT group->findChild<viewer::ParameterEdit*>("factor")->edited("0.25");
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
  }

  // Exactly the marked parameters are in the section Advanced, under its own label.
  void advanced()
  {
    this->Open({ this->WriteScene(), "--shadows", "map", "--light", "sun:0.4,1,0.6" });
    vtkNew<vtkRelievoPass> frame;
    int marked = 0;
    for (const auto* group : this->Window->findChildren<viewer::StageGroup*>())
    {
      const vtkRelievoStageDescription& stage =
        frame->GetStage(group->objectName().toStdString())->GetDescription();
      auto* section = group->findChild<QWidget*>("advancedRows");
      for (const vtkRelievoParameter& parameter : stage.Parameters)
      {
        auto* edit =
          group->findChild<viewer::ParameterEdit*>(QString::fromStdString(parameter.Name));
        const std::string which = stage.Name + ":" + parameter.Name;
        QVERIFY2(edit, which.c_str());
        QVERIFY2(parameter.Advanced == (section && section->isAncestorOf(edit)), which.c_str());
        marked += parameter.Advanced;
        for (const QLabel* label : edit->parentWidget()->findChildren<QLabel*>())
        {
          if (label->buddy() == edit)
          {
            QCOMPARE(
              label->text(), viewer::WriteLabel(QString::fromStdString(parameter.GetLabel())));
          }
        }
      }
    }
    QVERIFY2(marked >= 8, qPrintable(QString::number(marked)));
    this->Raise("light");
    auto* group = this->Group("shadows");
    auto* bias = group->findChild<viewer::ParameterEdit*>("bias");
    auto* strength = group->findChild<viewer::ParameterEdit*>("strength");
    QVERIFY(bias->isHidden() == false && !bias->isVisible() && strength->isVisible());
    auto* title = group->findChild<QAbstractButton*>("advanced");
    title->click();
    QVERIFY(bias->isVisible());
    title->click();
    QVERIFY(!bias->isVisible() && strength->isVisible());
  }

  // Switching on unfolds, switching off folds, for any cause; the arrow folds groups that are on or
  // have no switch.
  void folding()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    this->Raise("light");
    auto* shadows = this->Group("shadows");
    auto* strength = shadows->findChild<viewer::ParameterEdit*>("strength");
    auto* arrow = shadows->findChild<QToolButton*>("fold", Qt::FindDirectChildrenOnly);
    const auto height = [shadows] {
      QTest::qWait(50);
      return shadows->height();
    };
    QVERIFY(!strength->isVisible() && !arrow->isVisible());
    const int folded = height();
    QVERIFY2(folded < 2 * shadows->fontMetrics().height(), qPrintable(QString::number(folded)));
    shadows->setChecked(true);
    QVERIFY(strength->isVisible() && arrow->isVisible());
    QVERIFY(height() > 100);
    arrow->click();
    QVERIFY(!strength->isVisible() && arrow->isVisible() && shadows->isChecked());
    QCOMPARE(height(), folded);
    QVERIFY(this->Window->GetDocument()->Get().Has("--shadows")); // it is folded, and no less on
    shadows->setChecked(false);
    shadows->setChecked(true);
    QVERIFY(strength->isVisible());
    this->Window->GetDocument()->Undo();
    QVERIFY(!shadows->isChecked() && !strength->isVisible() && !arrow->isVisible());
    this->Window->GetDocument()->Redo();
    QVERIFY(shadows->isChecked() && strength->isVisible());
    this->Raise("look");
    auto* surfaces = this->Group("surfaces");
    auto* edges = surfaces->findChild<QCheckBox*>("edges");
    QVERIFY(edges->isVisible());
    surfaces->findChild<QToolButton*>("fold")->click();
    QVERIFY(!edges->isVisible());
    QTest::mouseClick(surfaces, Qt::LeftButton, Qt::NoModifier, QPoint(12, 8)); // the title
    QVERIFY(edges->isVisible());
    auto* deferred = this->Group("deferred"); // which has nothing to fold
    this->Group("advancedStages")->findChild<QToolButton*>("fold")->click();
    deferred->setChecked(true);
    QVERIFY(deferred->isVisible());
    QVERIFY(!deferred->findChild<QToolButton*>("fold")->isVisible());
  }

  void files()
  {
    this->Open({ this->WriteScene() });
    const auto text = [this](int file) {
      return this->Group("shownFiles")->findChildren<QLabel*>("file").value(file)->text();
    };
    // A ball of 24 by 16, whose poles are two of its points, and a square. The ball's points are
    // highest 84 degrees from its poles.
    for (const char* words : { "scene.vtp", "673 polygons", ">342<",
           "3 "
           "\u00d7"
           " 1.397 "
           "\u00d7"
           " 3",
           "height", "part (cells)", "VTP, " })
    {
      QVERIFY2(text(0).contains(words), qPrintable(QString(words) + ": " + text(0)));
    }
    this->Open({ this->WriteScene(), this->WriteOBJ() });
    QCOMPARE(this->Group("shownFiles")->findChildren<QLabel*>("file").size(), 2);
    QVERIFY2(text(1).contains("2 triangles"), qPrintable(text(1)));
    this->Change([](scene::Settings& settings) { settings.Files.clear(); });
    QVERIFY(!this->Group("shownFiles")->findChild<QLabel*>("file"));
  }

  void ground()
  {
    this->Open({ this->WriteScene(), "--preset", "studio" });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    auto* ground = this->Group("scene")->findChild<QComboBox*>("ground");
    ground->setCurrentIndex(ground->findData("off"));
    QCOMPARE(this->Window->GetDocument()->Get().Get("--ground"), std::string("off"));
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    ground->setCurrentIndex(ground->findData(""));
    QVERIFY(!this->Window->GetDocument()->Get().Has("--ground"));
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
  }

  // Controls without effect are disabled with their label, and give the reason; others give their
  // help.
  void idle()
  {
    this->Open({ this->WriteScene(), "--shadows", "map", "--light", "sun:0.4,1,0.6", "--stage",
      "tone:operator=simple" });
    const auto check = [this](const char* group, const char* name, bool idle, const char* why) {
      auto* edit = this->Group(group)->findChild<QWidget*>(name);
      QVERIFY2(edit && edit->isEnabled() != idle, name);
      QVERIFY2(edit->toolTip().contains(why) == idle, qPrintable(edit->toolTip()));
      QVERIFY2(edit->toolTip().size() > 2 * QString(why).size() || !idle, name);
      for (const QLabel* label : edit->parentWidget()->findChildren<QLabel*>())
      {
        QVERIFY2(label->buddy() != edit || label->isEnabled() != idle, name);
      }
    };
    check("tone", "white", true, "where Operator is not simple");
    check("colors", "component", true, "Has an effect on arrays");
    check("material", "depth", true, "height map");
    this->Change([](scene::Settings& settings) {
      settings.SetParameter("tone", "operator", "reinhard");
      settings.Set("--color-by", "Normals");
    });
    check("tone", "white", false, "where Operator is not simple");
    check("colors", "component", false, "Has an effect on arrays");
  }

  // Panels leave most of a small window to the picture, until the user shows them.
  void smallWindow()
  {
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->resize(800, 480);
    this->Window->show();
    QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
    const auto getShare = [this] { // of the panels
      return 1.0 - 1.0 * this->Window->centralWidget()->width() / this->Window->width();
    };
    auto* look = this->Window->findChild<QDockWidget*>("look");
    auto* panels = this->Window->findChild<QAction*>("panels");
    QCOMPARE(panels->shortcut(), QKeySequence(Qt::Key_F9));
    QTRY_VERIFY(getShare() <= 0.3);
    panels->trigger();
    QTRY_VERIFY(getShare() > 0.3);
    QVERIFY(this->Window->findChild<QDockWidget*>("scene")->isVisible());
    look->raise();
    QTRY_VERIFY(!look->visibleRegion().isEmpty());
    panels->trigger();
    QTRY_VERIFY(getShare() <= 0.3);
    panels->trigger();
    QTRY_VERIFY(!look->visibleRegion().isEmpty()); // the panel that was shown last
    this->Window->resize(1280, 800);
    QTRY_VERIFY(getShare() <= 0.3 && !look->isHidden());
    this->Window->resize(800, 480);
    QTRY_VERIFY(getShare() <= 0.3 && look->isHidden());
    look->toggleViewAction()->trigger(); // the others are not forgotten
    QVERIFY(!look->isHidden());
    panels->trigger();
    QVERIFY(look->isHidden());
    panels->trigger();
    this->CheckShown();
    this->Window->resize(1280, 800);
    QTRY_VERIFY(!look->isHidden());
    // Hidden by the user, they stay hidden.
    panels->trigger();
    this->Window->resize(800, 480);
    QTRY_COMPARE(this->Window->width(), 800);
    this->Window->resize(1280, 800);
    QTRY_COMPARE(this->Window->width(), 1280);
    QVERIFY(look->isHidden());
  }

  // Panels that were closed one by one, or hidden in the last run, come back.
  void hiddenPanels()
  {
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->show();
    for (const char* name : Docks)
    {
      this->Window->findChild<QDockWidget*>(name)->close();
    }
    this->Window->findChild<QAction*>("panels")->trigger();
    this->CheckShown();
    this->Window->findChild<QAction*>("panels")->trigger();
    this->Window->close();
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->RestoreLayout();
    QSettings().clear();
    this->Window->show();
    QVERIFY(this->Window->findChild<QDockWidget*>("scene")->isHidden());
    this->Window->findChild<QAction*>("panels")->trigger();
    this->CheckShown();
  }

  // The view gets the size, whether panels are hidden or shown with the window's new one.
  void viewSize()
  {
    viewer::PictureView* view = nullptr;
    const auto open = [&](const QSize& window, const char* size) {
      this->Window = std::make_unique<viewer::MainWindow>();
      this->Window->resize(window);
      this->Window->show();
      QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
      view = this->Window->GetView();
      this->OpenAgain({ this->WriteScene(), "--size", size });
    };
    open(QSize(1280, 800), "320x240");
    QTRY_COMPARE(view->size(), QSize(320, 240));
    QVERIFY(this->Window->findChild<QDockWidget*>("scene")->isHidden());
    open(QSize(800, 480), "1180x500");
    QTRY_VERIFY(this->Window->findChild<QDockWidget*>("scene")->isVisible());
    const int room = this->Window->screen()->availableSize().width() -
      (this->Window->frameGeometry().width() - view->width());
    QTRY_VERIFY2(std::abs(view->width() - std::min(1180, room)) <= 1,
      qPrintable(QString("%1 of %2").arg(view->width()).arg(room)));
  }

  // Nothing is cut off at the right, with all that can be unfolded.
  void width()
  {
    const std::string points = this->WritePoints();
    const std::string image = this->WriteImage();
    this->Open({ this->WriteScene(), "--lamps", points, "--fog", points, "--markers", points,
      "--shadows", "map", "--light", "sun:0.4,1,0.6", "--stage", "tone", "--environment", image });
    this->Window->resize(1280, 800);
    for (QAbstractButton* title : this->Window->findChildren<QAbstractButton*>("advanced"))
    {
      title->click();
    }
    for (const char* name : { "scene", "light", "look", "layers" })
    {
      this->Raise(name);
      auto* panel = this->Window->findChild<QDockWidget*>(name)->findChild<viewer::Panel*>();
      const int needed = panel->widget()->minimumSizeHint().width();
      QVERIFY2(needed <= panel->viewport()->width(),
        qPrintable(QString("%1: %2 of %3").arg(name).arg(needed).arg(panel->viewport()->width())));
      QVERIFY(!panel->horizontalScrollBar()->isVisible());
    }
  }
};

RELIEVO_TEST_CASE_APART(testViewerPanels)
{
  vtkRelievoStageRegistry::Add([]() -> vtkRelievoStage* { return NewUnplaced(); });
  TestViewerPanels tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerPanels.moc"
