// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keys of the window and of its controls, the wheel, and edits that are undone.
#include "TestCase.h"
#include "ViewerTest.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>

namespace testViewerKeys
{
using scene::Settings;

class TestViewerKeys : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  vtkCamera* GetCamera()
  {
    return this->Window->GetView()->GetPicture().GetRenderer()->GetActiveCamera();
  }

  // Keys go to the active window alone.
  bool Activate()
  {
    for (int attempt = 0; attempt < 10; ++attempt)
    {
      this->Window->activateWindow();
      if (QTest::qWaitForWindowActive(this->Window.get()))
      {
        return true;
      }
    }
    return false;
  }

  void Press(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier)
  {
    QVERIFY(this->Activate());
    QTest::keyClick(this->Window->GetView(), key, with);
  }

  // The mouse presses a slider, which goes to these values, and lets go.
  void Drag(QSlider* slider, const std::vector<int>& values)
  {
    QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, QPoint(1, 1));
    for (const int value : values)
    {
      slider->setValue(value);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, QPoint(1, 1));
    for (int i = 0; i < 3; ++i)
    {
      QCoreApplication::processEvents(); // until it is let go
    }
  }

  // Undoes all there is.
  int CountEdits()
  {
    int count = 0;
    for (; this->Window->GetDocument()->CanUndo(); ++count)
    {
      this->Window->GetDocument()->Undo();
    }
    return count;
  }

private Q_SLOTS:
  void parallelKey()
  {
    this->Open({ this->WriteScene(), "--parallel-scale", "1.2" });
    this->Grab();
    this->Press(Qt::Key_P);
    QVERIFY(!this->GetCamera()->GetParallelProjection()); // by the first press
    this->Press(Qt::Key_P);
    QVERIFY(this->GetCamera()->GetParallelProjection());
    // Objects at the centre keep their size.
    this->Open({ this->WriteScene(), "--camera", "0,0.5,7,0,0.5,0,0,1,0" });
    this->Grab();
    this->Press(Qt::Key_P);
    QVERIFY(this->GetCamera()->GetParallelProjection());
    const double half = 7.0 * std::tan(vtkMath::RadiansFromDegrees(15.0));
    QVERIFY(std::abs(this->GetCamera()->GetParallelScale() - half) < 1e-9);
    this->Compare("parallel");
    // Back again as well, with the angle that was asked for.
    this->GetCamera()->SetParallelScale(0.5 * half);
    this->Press(Qt::Key_P);
    QVERIFY(std::abs(this->GetCamera()->GetDistance() - 3.5) < 1e-9);
    this->Press(Qt::Key_P);
    this->Change([](scene::Settings& settings) { settings.Set("--view-angle", "60"); });
    this->Press(Qt::Key_P);
    QVERIFY(std::abs(this->GetCamera()->GetViewAngle() - 60.0) < 1e-9);
    QVERIFY(std::abs(this->GetCamera()->GetDistance() - 0.5 * half * std::sqrt(3.0)) < 1e-9);
    this->Compare("perspective");
  }

  void viewKeys()
  {
    this->Open({ this->WriteScene(), "--up", "z" });
    this->Grab();
    const auto looks = [this](double x, double y, double z) {
      const double* d = this->GetCamera()->GetDirectionOfProjection();
      return std::abs(d[0] - x) + std::abs(d[1] - y) + std::abs(d[2] - z) < 1e-9;
    };
    this->Press(Qt::Key_1);
    QVERIFY(looks(-1, 0, 0));
    this->Press(Qt::Key_1, Qt::ControlModifier);
    QVERIFY(looks(1, 0, 0));
    this->Press(Qt::Key_2);
    QVERIFY(looks(0, 0, -1));
    this->Press(Qt::Key_2, Qt::ControlModifier);
    QVERIFY(looks(0, 0, 1));
    this->Press(Qt::Key_3);
    QVERIFY(looks(0, 1, 0));
    this->Press(Qt::Key_3, Qt::ControlModifier);
    QVERIFY(looks(0, -1, 0));
    // A digit that misses its number does not turn the picture.
    auto* list = this->Window->findChild<QTreeWidget*>("list");
    this->Window->findChild<QDockWidget*>("light")->raise();
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), 20000);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_1);
    QVERIFY(looks(0, -1, 0));
    this->Window->GetView()->setFocus();
    const double fitted = this->GetCamera()->GetDistance();
    this->GetCamera()->Dolly(3.0);
    this->Press(Qt::Key_R);
    QVERIFY(std::abs(this->GetCamera()->GetDistance() - fitted) < 1e-9);
    this->Compare("from the back");
  }

  void gridKey()
  {
    this->Open({ this->WriteScene() });
    this->Grab();
    this->Press(Qt::Key_G);
    QVERIFY(this->Window->GetDocument()->Get().Has("--grid"));
    this->Press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!this->Window->GetDocument()->Get().Has("--grid"));
    this->Press(Qt::Key_G);
    this->Press(Qt::Key_G);
    QVERIFY(!this->Window->GetDocument()->Get().Has("--grid"));
  }

  // The wheel over a control without the focus scrolls its panel.
  void wheel()
  {
    this->Open({ this->WriteScene(), "--stage", "tone" });
    QVERIFY(this->Activate());
    auto* dock = this->Window->findChild<QDockWidget*>("look");
    dock->raise();
    auto* panel = dock->findChild<QScrollArea*>();
    const auto turn = [](QWidget* widget) {
      const QPointF at = widget->rect().center();
      QWheelEvent event(at, widget->mapToGlobal(at.toPoint()), QPoint(), QPoint(0, -120),
        Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QSpontaneKeyEvent::setSpontaneous(&event); // others stay where they are sent to
      qApp->notify(widget, &event);
    };
    QList<QWidget*> controls;
    for (QAbstractSpinBox* each : panel->findChildren<QAbstractSpinBox*>())
    {
      controls += each;
    }
    for (QComboBox* each : panel->findChildren<QComboBox*>())
    {
      controls += each;
    }
    for (QSlider* each : panel->findChildren<QSlider*>())
    {
      controls += each;
    }
    QVERIFY(controls.size() > 20 && panel->verticalScrollBar()->maximum() > 100);
    this->Window->GetView()->setFocus();
    const scene::Settings before = this->Window->GetDocument()->Get();
    for (QWidget* control : controls)
    {
      panel->verticalScrollBar()->setValue(0);
      turn(control);
      QVERIFY2(panel->verticalScrollBar()->value() > 0,
        qPrintable(control->parentWidget()->parentWidget()->objectName()));
      QVERIFY(!control->hasFocus());
      QVERIFY(!control->hasFocus());
    }
    QVERIFY(this->Window->GetDocument()->Get() == before);
    auto* exposure = panel->findChild<QGroupBox*>("tone")
                       ->findChild<QWidget*>("exposure")
                       ->findChild<QDoubleSpinBox*>();
    exposure->setFocus();
    turn(exposure);
    QVERIFY(this->Window->GetDocument()->Get() != before);
  }

  // Keys that a control uses are its own while it has the focus.
  void keysOfControls()
  {
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/glTF2/";
    this->Open({ models + "simple_skin/simple_skin.gltf", "--time", "0" });
    auto* play = this->Window->findChild<QToolBar*>("time")->actions().first();
    auto* parallel = this->Window->findChild<QAction*>("parallel");
    QVERIFY(play->isCheckable() && play->isEnabled());
    this->Window->findChild<QDockWidget*>("look")->raise();
    QVERIFY(this->Activate());
    auto* edges = this->Window->findChild<QCheckBox*>("edges");
    auto* shading = this->Window->findChild<QComboBox*>("shading");
    QTRY_VERIFY_WITH_TIMEOUT(edges->isVisible(), 20000);
    edges->setFocus();
    QTest::keyClick(edges, Qt::Key_Space);
    QVERIFY(edges->isChecked() && !play->isChecked());
    shading->setFocus();
    QTest::keyClick(shading, Qt::Key_P);
    QVERIFY(!parallel->isChecked());
    QCOMPARE(shading->currentText(), QString("phong"));
    QTest::keyClick(edges, Qt::Key_P); // which has no use for it
    QVERIFY(parallel->isChecked());
    this->Window->GetView()->setFocus();
    QTest::keyClick(this->Window->GetView(), Qt::Key_Space);
    QVERIFY(play->isChecked());
    play->setChecked(false);
    this->WaitUntilRead();
  }

  // Copying takes a table's cell or a label's text where one is selected and has the focus.
  void copies()
  {
    this->Open({ this->WriteScene() });
    QVERIFY(this->Activate());
    QClipboard* clipboard = QApplication::clipboard();
    auto* table = this->Window->findChild<QTableWidget*>("values");
    this->Window->findChild<QDockWidget*>("layers")->raise();
    QTRY_VERIFY_WITH_TIMEOUT(table->isVisible(), 20000);
    table->setRowCount(1);
    table->setItem(0, 1, new QTableWidgetItem("1.25"));
    table->setCurrentCell(0, 1);
    table->setFocus();
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(clipboard->text(), QString("1.25"));
    table->clearSelection();
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    QVERIFY(!clipboard->image().isNull());
    auto* label = this->Window->findChild<QLabel*>("file");
    this->Window->findChild<QDockWidget*>("scene")->raise();
    QTRY_VERIFY_WITH_TIMEOUT(label->isVisible(), 20000);
    label->setSelection(0, 3);
    label->setFocus();
    QTest::keyClick(label, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(clipboard->text(), QString("sce"));
  }

  void undo()
  {
    this->Open({ this->WriteScene(), "--edges" });
    const scene::Settings opened = this->Window->GetDocument()->Get();
    auto* undo = this->Window->findChild<QAction*>("undo");
    auto* redo = this->Window->findChild<QAction*>("redo");
    QVERIFY(!undo->isEnabled() && !redo->isEnabled()); // opening is no edit
    auto* number = this->Window->findChild<QGroupBox*>("surfaces")->findChild<QWidget*>("opacity");
    auto* opacity = number->findChild<QSlider*>();
    this->Drag(opacity, { 80, 60, 40 });
    this->Window->findChild<QCheckBox*>("edges")->setChecked(false);
    this->Change([](scene::Settings& settings) { settings.Set("--color-by", "nothing"); });
    QVERIFY(this->Window->GetTrouble().contains("Colour by"));
    const scene::Settings edited = this->Window->GetDocument()->Get();
    const vtkSmartPointer<vtkImageData> after = this->Grab();
    this->Window->findChild<QDockWidget*>("look")->raise();
    QTRY_VERIFY_WITH_TIMEOUT(opacity->isVisible(), 20000);
    // Also with the focus on a number, of which nothing was typed.
    QVERIFY(this->Activate());
    auto* digits = number->findChild<QDoubleSpinBox*>();
    digits->setFocus();
    QTest::keyClick(digits, Qt::Key_Z, Qt::ControlModifier); // and not the refused text
    QCOMPARE(this->Window->GetDocument()->Get().Get("--opacity"), std::string("0.4"));
    QVERIFY(this->Window->GetDocument()->Get().Has("--edges"));
    QTest::keyClick(digits, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(this->Window->GetDocument()->Get() == opened);
    QVERIFY(!undo->isEnabled() && redo->isEnabled());
    QCOMPARE(undo->text(), QString("&Undo"));
    QCOMPARE(redo->text(), QString("&Redo: Opacity"));
    QVERIFY2(redo->toolTip().startsWith("Redo: Opacity ("), qPrintable(redo->toolTip()));
    QCOMPARE(opacity->value(), 100);
    redo->trigger();
    redo->trigger();
    QVERIFY(this->Window->GetDocument()->Get() == edited);
    QCOMPARE(CountDifferent(after, this->Grab()), 0);
  }

  // The names of views give the axis that they look from, by the axis that points up.
  void namesOfViews()
  {
    this->Open({ this->WriteScene() });
    const auto says = [this](const char* view) {
      return this->Window->findChild<QAction*>(view)->text().remove('&');
    };
    QCOMPARE(says("look1"), QString("From right (+X)"));
    QCOMPARE(says("lookCtrl+3"), QString("From the back (\u2212Z)"));
    this->Change([](scene::Settings& settings) { settings.Set("--up", "z"); });
    QCOMPARE(says("look3"), QString("From the front (\u2212Y)"));
    QCOMPARE(says("lookCtrl+3"), QString("From the back (+Y)"));
    QCOMPARE(says("look2"), QString("From above (+Z)"));
    this->Window->findChild<QAction*>("lookCtrl+3")->trigger();
    vtkCamera* camera = this->Window->GetView()->GetPicture().GetRenderer()->GetActiveCamera();
    QVERIFY(camera->GetDirectionOfProjection()[1] < -0.999);
  }

  // Tab goes around, through the picture and all groups of the panel in front, both ways.
  void tab()
  {
    this->Open({ this->WriteScene(), "--lamps", this->WritePoints() });
    for (const char* name : { "scene", "light", "look", "layers", "report", "comparison" })
    {
      this->Window->findChild<QDockWidget*>(name)->show();
      this->Window->findChild<QDockWidget*>(name)->raise();
      QTest::qWait(50);
      QVERIFY(this->Activate());
      for (const Qt::Key key : { Qt::Key_Tab, Qt::Key_Backtab })
      {
        this->Window->GetView()->setFocus();
        QString seen;
        const auto* dock = this->Window->findChild<QDockWidget*>(name);
        int folds = 0;
        for (const auto* fold : dock->findChildren<QToolButton*>("fold"))
        {
          folds += fold->isVisible() && fold->isEnabled() ? 1 : 0;
        }
        QWidget* last = this->Window->GetView();
        int steps = 0;
        do
        {
          QTest::keyClick(this->Window->windowHandle(), key);
          QWidget* focus = QApplication::focusWidget();
          QVERIFY2(focus && focus != last && focus->isVisible(),
            qPrintable(QString("%1: %2, stays").arg(name, seen)));
          seen += QString(" ") + focus->metaObject()->className() + ":" + focus->objectName();
          for (const auto* other : this->Window->findChildren<QDockWidget*>())
          {
            QVERIFY2(other == dock || !other->isAncestorOf(focus), qPrintable(seen));
          }
          folds -= dock->isAncestorOf(focus) && focus->objectName() == "fold" ? 1 : 0;
          last = focus;
          QVERIFY2(++steps < 200, qPrintable(seen.left(2000)));
        } while (last != this->Window->GetView());
        QVERIFY2(folds == 0, qPrintable(QString("%1: %2").arg(name, seen)));
      }
    }
  }

  // Arrows turn and move the objects in their direction, plus and minus zoom.
  void cameraKeys()
  {
    this->Open({ this->WriteScene(), "--camera", "0,0.5,7,0,0.5,0,0,1,0" });
    this->Grab();
    const auto isAt = [this](double x, double y, double z) {
      const double* at = this->GetCamera()->GetPosition();
      return std::abs(at[0] - x) + std::abs(at[1] - y) + std::abs(at[2] - z) < 1e-9;
    };
    const double angle = vtkMath::RadiansFromDegrees(5.0);
    this->Press(Qt::Key_Right);
    QVERIFY(isAt(-7.0 * std::sin(angle), 0.5, 7.0 * std::cos(angle)));
    this->Press(Qt::Key_Left);
    QVERIFY(isAt(0, 0.5, 7));
    this->Press(Qt::Key_Left, Qt::ControlModifier); // no key of the picture
    QVERIFY(isAt(0, 0.5, 7));
    this->Press(Qt::Key_Down);
    QVERIFY(isAt(0, 0.5 + 7.0 * std::sin(angle), 7.0 * std::cos(angle)));
    this->Press(Qt::Key_Up);
    QVERIFY(isAt(0, 0.5, 7));
    const double step = 0.05 * 14.0 * std::tan(vtkMath::RadiansFromDegrees(15.0));
    this->Press(Qt::Key_Right, Qt::ShiftModifier);
    this->Press(Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY(isAt(-step, 0.5 + step, 7));
    QVERIFY(std::abs(this->GetCamera()->GetFocalPoint()[0] + step) < 1e-9);
    this->Press(Qt::Key_Plus);
    QVERIFY(std::abs(this->GetCamera()->GetDistance() - 7.0 / 1.1) < 1e-9);
    this->Compare("by keys");
    this->Press(Qt::Key_P);
    const double scale = this->GetCamera()->GetParallelScale();
    this->Press(Qt::Key_Minus);
    QVERIFY(std::abs(this->GetCamera()->GetParallelScale() - 1.1 * scale) < 1e-9);
  }

  // A key brings each panel to the front and the keyboard to its first control, and back.
  void panelKeys()
  {
    this->Open({ this->WriteScene() });
    const Qt::Key keys[] = { Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_6 };
    int number = 0;
    for (const char* name : { "scene", "light", "look", "layers", "report", "comparison" })
    {
      auto* dock = this->Window->findChild<QDockWidget*>(name);
      dock->hide();
      this->Press(keys[number++], Qt::AltModifier);
      QTRY_VERIFY_WITH_TIMEOUT(!dock->visibleRegion().isEmpty(), 20000);
      QVERIFY2(dock->isAncestorOf(QApplication::focusWidget()), name);
      this->Press(Qt::Key_0, Qt::AltModifier);
      QVERIFY(this->Window->GetView()->hasFocus());
    }
  }

  // The menu View brings a panel to the front, and closes the one in front; in the tabs' order.
  void panelItems()
  {
    this->Open({ this->WriteScene() });
    auto* item = this->Window->findChild<QAction*>("showLook");
    QStringList names;
    for (const QAction* action : qobject_cast<QMenu*>(item->parent())->actions())
    {
      names += action->objectName();
    }
    const auto first = names.indexOf("showScene");
    QVERIFY(first > 0 && names[first - 1].isEmpty()); // a separator
    QCOMPARE(names.mid(first),
      QStringList(
        { "showScene", "showLight", "showLook", "showLayers", "showReport", "showComparison" }));
    auto* look = this->Window->findChild<QDockWidget*>("look");
    for (const bool open : { true, false }) // behind another tab, then closed
    {
      QCOMPARE(item->isChecked(), open);
      item->trigger();
      QTRY_VERIFY_WITH_TIMEOUT(!look->visibleRegion().isEmpty(), 20000);
      QVERIFY(item->isChecked());
      item->trigger();
      QVERIFY(look->isHidden() && !item->isChecked());
    }
  }

  // Each item of a menu has a letter of its own.
  void letters()
  {
    this->Window = std::make_unique<viewer::MainWindow>();
    QList<QWidget*> menus{ this->Window->menuBar() };
    for (QMenu* menu : this->Window->findChildren<QMenu*>())
    {
      menus += menu;
    }
    QVERIFY(menus.size() > 4);
    for (const QWidget* menu : menus)
    {
      QString letters;
      for (const QAction* action : menu->actions())
      {
        const int at = action->text().indexOf('&');
        const QChar letter = at < 0 ? QChar() : action->text()[at + 1].toLower();
        QVERIFY2(at < 0 || !letters.contains(letter), qPrintable(action->text()));
        letters += letter;
      }
    }
  }

  // The sheet lists every key of the menus; the key that shows it hides it.
  void sheet()
  {
    this->Open({ this->WriteScene() });
    this->Press(Qt::Key_H);
    auto* sheet = this->Window->findChild<QDialog*>("keys");
    QVERIFY(sheet && sheet->isVisible());
    const QString words = sheet->findChild<QLabel*>("sheet")->text();
    for (const char* name : { "open", "parallel", "fullScreen", "undo", "nextFile", "reload" })
    {
      auto* action = this->Window->findChild<QAction*>(name);
      QVERIFY2(words.contains(action->shortcut().toString(QKeySequence::NativeText)), name);
    }
    QVERIFY(QTest::qWaitForWindowActive(sheet));
    QTest::keyClick(sheet, Qt::Key_H);
    QVERIFY(!sheet->isVisible());
  }

  // Files of the folder one after the other and around, others left out; the same file anew.
  void filesOfTheFolder()
  {
    const std::string second = this->WriteScene("b.vtp");
    const std::string first = this->WritePoints("a.vtp");
    this->WriteText("aa.txt", "no mesh");
    this->WriteText("ab.tif", "a texture");
    this->Open({ first });
    const auto press = [this](const char* name) {
      this->Window->findChild<QAction*>(name)->trigger();
      this->WaitUntilRead();
      return this->Window->GetDocument()->Get().Files;
    };
    QCOMPARE(press("nextFile"), std::vector<std::string>{ second });
    QCOMPARE(press("nextFile"), std::vector<std::string>{ first });
    QCOMPARE(press("previousFile"), std::vector<std::string>{ second });
    this->GetCamera()->Azimuth(30.0);
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    QFile::remove(QString::fromStdString(second));
    QVERIFY(QFile::copy(QString::fromStdString(first), QString::fromStdString(second)));
    press("reload");
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    QFile::remove(QString::fromStdString(second));
    this->WriteScene("b.vtp");
    press("reload");
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
  }

  // Undoing goes on where it has hidden the field with the focus, and where a text has it.
  void undoAfterHiding()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    const scene::Settings opened = this->Window->GetDocument()->Get();
    this->Window->findChild<QDockWidget*>("light")->raise();
    this->Window->findChild<QCheckBox*>("edges")->setChecked(true);
    auto* lights = this->Window->findChild<QGroupBox*>("lights");
    lights->findChild<QComboBox*>("by")->setCurrentIndex(1);
    auto* hours = lights->findChild<QWidget*>("time")->findChild<QDoubleSpinBox*>();
    QTRY_VERIFY_WITH_TIMEOUT(hours->isVisible(), 20000);
    QVERIFY(this->Activate());
    hours->setFocus();
    for (int i = 0; i < 2; ++i) // the place, and the edges
    {
      QWidget* focus = this->Window->focusWidget();
      QTest::keyClick(focus ? focus : this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
    }
    QVERIFY(!hours->isVisible());
    QVERIFY(this->Window->GetDocument()->Get() == opened);
    this->Window->findChild<QCheckBox*>("edges")->setChecked(true);
    auto* name = lights->findChild<QLineEdit*>("name");
    name->setFocus(); // in which nothing was typed
    QTest::keyClick(name, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(this->Window->GetDocument()->Get() == opened);
  }

  // A slider that is dragged is one edit, wherever it begins; the next drag is another, however
  // soon it follows.
  void undoOfDrag()
  {
    this->Open({ this->WriteScene() });
    this->Window->findChild<QDockWidget*>("light")->raise();
    auto* slider = this->Window->findChild<QGroupBox*>("shadows")
                     ->findChild<QWidget*>("filter_radius")
                     ->findChild<QSlider*>();
    QVERIFY(slider);
    auto* undo = this->Window->findChild<QAction*>("undo");
    const scene::Settings opened = this->Window->GetDocument()->Get();
    this->Drag(slider, { 3, 5 }); // the first value asks for the stage
    undo->trigger();
    QVERIFY(this->Window->GetDocument()->Get() == opened);
    QVERIFY(!undo->isEnabled());
    this->Drag(slider, { 3, 5 });
    const scene::Settings once = this->Window->GetDocument()->Get();
    this->Drag(slider, { 7, 9 });
    undo->trigger();
    QVERIFY(this->Window->GetDocument()->Get() == once);
    // There and back in one drag is no edit, but the next change is.
    this->Drag(slider, { 7, 5, 8 });
    undo->trigger();
    QVERIFY(this->Window->GetDocument()->Get() == once);
    QCOMPARE(this->CountEdits(), 1);
  }

  // Each click is an edit, however soon it follows, and if it is the second of two.
  void undoOfClicks()
  {
    this->Open({ this->WriteScene() });
    this->Window->findChild<QDockWidget*>("look")->raise();
    auto* edges = this->Window->findChild<QCheckBox*>("edges");
    QTRY_VERIFY_WITH_TIMEOUT(edges->isVisible(), 20000);
    const QPoint at(5, edges->height() / 2);
    const auto click = [edges, &at](QEvent::Type press) {
      for (const auto& each : { std::pair{ press, Qt::LeftButton },
             std::pair{ QEvent::MouseButtonRelease, Qt::NoButton } })
      {
        QMouseEvent event(
          each.first, at, edges->mapToGlobal(at), Qt::LeftButton, each.second, Qt::NoModifier);
        QApplication::sendEvent(edges, &event); // with nothing between
      }
    };
    click(QEvent::MouseButtonPress);
    click(QEvent::MouseButtonDblClick);
    click(QEvent::MouseButtonPress);
    QVERIFY(edges->isChecked());
    QCOMPARE(this->CountEdits(), 3);
    QVERIFY(this->Activate());
    edges->setFocus();
    for (int i = 0; i < 3; ++i)
    {
      QTest::keyClick(edges, Qt::Key_Space);
    }
    QCOMPARE(this->CountEdits(), 3);
  }

  // Turning one control by wheel and keys is one edit, until another action.
  void undoOfTurning()
  {
    this->Open({ this->WriteScene() });
    this->Window->findChild<QDockWidget*>("look")->raise();
    auto* number = this->Window->findChild<QGroupBox*>("surfaces")->findChild<QWidget*>("opacity");
    auto* digits = number->findChild<QDoubleSpinBox*>();
    auto* slider = number->findChild<QSlider*>();
    auto* edges = this->Window->findChild<QCheckBox*>("edges");
    QTRY_VERIFY_WITH_TIMEOUT(digits->isVisible(), 20000);
    QVERIFY(this->Activate());
    const auto turn = [](QWidget* control, Qt::Key key) {
      control->setFocus();
      for (int i = 0; i < 3; ++i)
      {
        QTest::keyClick(control, key);
      }
    };
    turn(digits, Qt::Key_Down);
    QCOMPARE(digits->value(), 0.97);
    const auto wheel = [](QWidget* over) {
      QWheelEvent event(QPointF(2, 2), over->mapToGlobal(QPoint(2, 2)), QPoint(), QPoint(0, -120),
        Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QSpontaneKeyEvent::setSpontaneous(&event);
      qApp->notify(over, &event);
    };
    wheel(digits->findChild<QLineEdit*>());
    wheel(digits);
    QCOMPARE(digits->value(), 0.95);
    QCOMPARE(this->CountEdits(), 1);
    // Another control; a number that is typed; and the first again, after something else.
    turn(digits, Qt::Key_Down);
    turn(slider, Qt::Key_Left);
    turn(digits, Qt::Key_Down);
    digits->selectAll();
    QTest::keyClicks(digits, "0.5");
    QTest::keyClick(digits, Qt::Key_Return);
    digits->selectAll();
    QTest::keyClicks(digits, "0.6");
    QTest::keyClick(digits, Qt::Key_Return);
    QCOMPARE(digits->value(), 0.6);
    turn(digits, Qt::Key_Up);
    edges->toggle();
    QTest::mouseClick(edges, Qt::LeftButton, Qt::NoModifier, QPoint(5, edges->height() / 2));
    turn(digits, Qt::Key_Up);
    QCOMPARE(this->CountEdits(), 8);
  }
};

RELIEVO_TEST_CASE_APART(testViewerKeys)
{
  TestViewerKeys tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerKeys.moc"
