// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tool bar and other parts around the picture.
#include "TestCase.h"
#include "ViewerTest.h"

#include "AxisMarker.h"
#include "LayerLegend.h"
#include "LayerWords.h"
#include "PathGroup.h"
#include "Picture.h"
#include "Probe.h"
#include "SampleThread.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkXMLImageDataWriter.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTextEdit>
#include <QThread>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace testViewerTools
{
class TestViewerTools : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  QToolBar* GetBar() { return this->Window->findChild<QToolBar*>("tools"); }

  // In a button, the share of pixels that are nearly the colour of the controls' text.
  double GetInk(QToolButton* button)
  {
    const QImage image = button->grab().toImage();
    const QColor text = button->palette().color(
      button->isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText);
    int ink = 0;
    for (int y = 0; y < image.height(); ++y)
    {
      for (int x = 0; x < image.width(); ++x)
      {
        ink += std::abs(image.pixelColor(x, y).lightness() - text.lightness()) < 40;
      }
    }
    return double(ink) / (image.width() * image.height());
  }

private Q_SLOTS:
  // Every button has a sign that is seen, be the controls light or dark, and says its key.
  void buttons()
  {
    this->Open({ this->WriteScene() });
    for (const char* appearance : { "light", "dark" })
    {
      this->Window->findChild<QAction*>(appearance)->trigger();
      int buttons = 0;
      for (auto* button : this->GetBar()->findChildren<QToolButton*>())
      {
        if (button->objectName() == "qt_toolbar_ext_button")
        {
          continue;
        }
        ++buttons;
        QVERIFY2(this->GetInk(button) > 0.02,
          qPrintable(QString("%1, %2").arg(appearance, button->toolTip())));
        const QAction* action = button->defaultAction();
        QVERIFY2(!action || button->toolTip().contains(action->shortcut().toString()),
          qPrintable(button->toolTip()));
      }
      QVERIFY2(buttons >= 9, qPrintable(QString::number(buttons)));
    }
    this->Window->findChild<QAction*>("desktop")->trigger();
  }

  // It is hidden in the next window, too.
  void isRemembered()
  {
    this->Open({ this->WriteScene() });
    QVERIFY(this->GetBar()->isVisible());
    this->GetBar()->toggleViewAction()->trigger();
    QVERIFY(!this->GetBar()->isVisible());
    this->Window->close();
    this->Open({ this->WriteScene() });
    this->Window->RestoreLayout();
    QVERIFY(!this->GetBar()->isVisible());
    this->GetBar()->toggleViewAction()->trigger();
    QVERIFY(this->GetBar()->isVisible());
  }

  void shadows()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "antialias:samples=2" });
    auto* shadows = this->Window->findChild<QAction*>("shadowsOn");
    QVERIFY(shadows->isChecked());
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    shadows->trigger();
    QVERIFY(CountDifferent(before, this->Grab()) > 1000);
    this->Compare("without shadows");
    shadows->trigger();
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    this->Window->GetDocument()->Undo();
    QVERIFY(!shadows->isChecked());
    // Two switches are two steps, however soon one follows the other.
    this->Window->GetDocument()->Undo();
    QVERIFY(shadows->isChecked() && !this->Window->GetDocument()->CanUndo());
    shadows->trigger();
    shadows->trigger();
    this->Window->GetDocument()->Undo();
    QVERIFY(!shadows->isChecked());
  }

  // By its action and by the panel; it goes round with the camera, and can be undone.
  void grid()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "antialias:samples=2",
      "--stage", "shadows:soft_samples=2,map_size=256" });
    auto* grid = this->Window->findChild<QAction*>("grid");
    auto* box = this->Window->findChild<QCheckBox*>("grid");
    viewer::Picture& picture = this->Window->GetView()->GetPicture();
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    grid->trigger();
    QVERIFY(grid->isChecked() && box->isChecked());
    QVERIFY(this->Window->GetDocument()->Get().Has("--grid"));
    QVERIFY(CountDifferent(before, this->Grab()) > 1000);
    this->Compare("with a grid");
    picture.LookAlong({ 0.6, 0.3, 0.7 }, { 0, 1, 0 });
    this->Window->GetView()->Draw();
    this->Compare("from behind and below");
    this->Window->GetDocument()->Undo();
    QVERIFY(!grid->isChecked() && !box->isChecked());
    this->Compare("undone");
    box->click();
    QVERIFY(grid->isChecked());
    grid->trigger();
    QVERIFY(!box->isChecked());
  }

  // By its action and by the panel, which has its unit; the action keeps that.
  void scaleBar()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "antialias:samples=2",
      "--stage", "shadows:soft_samples=2,map_size=256" });
    auto* bar = this->Window->findChild<QAction*>("scaleBar");
    auto* box = this->Window->findChild<QComboBox*>("scalebar");
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    bar->trigger();
    QCOMPARE(box->currentText(), QString("without a unit"));
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    this->Compare("with a scale bar");
    box->setCurrentText("mm");
    QVERIFY(bar->isChecked());
    QCOMPARE(this->Window->GetDocument()->Get().Get("--scale-bar"), std::string("mm"));
    this->Window->GetView()->GetPicture().LookAlong({ 0.6, 0.3, 0.7 }, { 0, 1, 0 });
    this->Window->GetView()->Draw();
    this->Compare("from behind, in millimetres");
    bar->trigger();
    QCOMPARE(box->currentText(), QString("off"));
    this->Compare("without a scale bar");
    bar->trigger();
    QCOMPARE(box->currentText(), QString("mm"));
    this->Window->GetDocument()->Undo();
    QVERIFY(!bar->isChecked());
  }

  // The axes turn with the camera, and a click on an end looks from there; the picture is without
  // them.
  void axes()
  {
    this->Open({ this->WriteScene(), "--camera", "0,0.5,7,0,0.5,0,0,1,0" });
    auto* axes = this->Window->findChild<viewer::AxisMarker*>("axes");
    this->Grab();
    QVERIFY(axes->isVisible());
    const QPointF middle(0.5 * axes->width(), 0.5 * axes->height());
    QVERIFY(axes->GetEnd(0).x() > middle.x() + 20); // x to the right, y upwards
    QVERIFY(axes->GetEnd(1).y() < middle.y() - 20);
    QVERIFY(std::abs(axes->GetEnd(2).x() - middle.x()) < 1); // z towards the viewer
    this->Compare("with axes in the window");
    const double looks[][3] = { { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, 1, 0 },
      { 0, 0, 1 } };
    for (const int end : { 0, 1, 3, 4, 5, 2 })
    {
      Q_EMIT axes->lookWanted(end);
      this->Grab();
      vtkCamera* camera = this->Window->GetView()->GetPicture().GetRenderer()->GetActiveCamera();
      const double* along = camera->GetDirectionOfProjection();
      for (int i = 0; i < 3; ++i)
      {
        QVERIFY2(std::abs(along[i] - looks[end][i]) < 1e-9, qPrintable(QString::number(end)));
      }
      if (end == 5) // from behind: x is at the left
      {
        QTest::mouseClick(axes, Qt::LeftButton, Qt::NoModifier, axes->GetEnd(0).toPoint());
        QVERIFY(std::abs(camera->GetDirectionOfProjection()[0] + 1.0) < 1e-9);
      }
    }
    this->Window->findChild<QAction*>("axisMarker")->trigger();
    QVERIFY(!axes->isVisible());
    this->Open({ this->WriteScene() });
    QVERIFY(!this->Window->findChild<viewer::AxisMarker*>("axes")->isVisible());
    this->Window->findChild<QAction*>("axisMarker")->trigger();
  }

  // A narrower view shows everything that the wider one showed, and widening restores the view.
  void narrowView()
  {
    this->Open({ this->WriteScene() });
    viewer::PictureView* view = this->Window->GetView();
    const auto findWidest = [view] { // the place farthest aside, in halves of the view
      vtkRenderer* renderer = view->GetPicture().GetRenderer();
      const double* b = view->GetPicture().GetScene().GetBounds();
      double widest = 0.0;
      for (int corner = 0; corner < 8; ++corner)
      {
        double at[3] = { b[corner & 1], b[2 + ((corner >> 1) & 1)], b[4 + ((corner >> 2) & 1)] };
        renderer->WorldToView(at[0], at[1], at[2]);
        widest = std::max(widest, std::abs(at[0]));
      }
      return widest;
    };
    for (const bool parallel : { false, true })
    {
      view->GetPicture().SetParallel(parallel);
      this->Grab();
      const QSize before = view->size();
      const scene::Settings camera = this->Window->GetViewSettings();
      const double wide = findWidest();
      QVERIFY2(wide < 1.0, qPrintable(QString::number(wide)));
      this->Window->resize(1, this->Window->height());
      QTRY_VERIFY(view->width() <= view->height() * 3 / 5);
      this->Grab();
      const double narrow = findWidest();
      QVERIFY2(narrow > 0.9 && narrow < 1.0 + 1e-6, qPrintable(QString::number(narrow)));
      this->Window->resize(this->Window->size() + before - view->size());
      QTRY_COMPARE(view->size(), before);
      const scene::Settings again = this->Window->GetViewSettings();
      QCOMPARE(again.Get("--camera"), camera.Get("--camera"));
      QCOMPARE(again.Get("--parallel-scale"), camera.Get("--parallel-scale"));
      // Places outside may stay as far outside.
      vtkCamera* near = view->GetPicture().GetRenderer()->GetActiveCamera();
      near->Zoom(4.0);
      this->Grab();
      const double outside = findWidest();
      this->Window->resize(1, this->Window->height());
      QTRY_VERIFY(view->width() <= view->height() * 3 / 5);
      this->Grab();
      const double now = findWidest();
      QVERIFY2(
        now > 1.0 && now < outside + 1e-6, qPrintable(QString("%1 > %2").arg(now).arg(outside)));
      this->Window->resize(this->Window->size() + before - view->size());
      QTRY_COMPARE(view->size(), before);
      near->Zoom(0.25);
    }
  }

  // A picture that has all its samples draws no more.
  void rests()
  {
    this->Open({ this->WriteScene(), "--preset", "studio" });
    QSignalSpy first(this->Window->GetView(), &viewer::PictureView::drawn);
    QVERIFY(first.count() > 0 || first.wait(60000));
    QTRY_COMPARE_WITH_TIMEOUT(
      this->Window->GetView()->GetPicture().GetFrame()->GetSamplesLeft(), 0, 60000);
    // Results of earlier requests may still arrive, after any time.
    QSignalSpy drawn(this->Window->GetView(), &viewer::PictureView::drawn);
    int late = 0;
    while (late < 5 && drawn.wait(400))
    {
      ++late;
    }
    QVERIFY(late < 5);
  }

  // Each slow sample is painted before the next one is drawn, and so is the last one.
  void paintsSamples()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "shadows:map_size=256" });
    viewer::PictureView* view = this->Window->GetView();
    QSignalSpy first(view, &viewer::PictureView::drawn);
    view->Draw();
    QVERIFY(first.count() > 0 || first.wait(60000));
    const auto countLeft = [view] { return view->GetPicture().GetFrame()->GetSamplesLeft(); };
    QTRY_COMPARE_WITH_TIMEOUT(countLeft(), 0, 60000);
    QCoreApplication::processEvents(); // the last sample may not have been announced yet
    QString order;                     // of samples drawn and of pictures painted
    const QObject here;
    QObject::connect(
      view, &viewer::PictureView::drawn, &here, [&] { order += countLeft() == 0 ? 'L' : 'd'; });
    QObject::connect(view, &QOpenGLWidget::frameSwapped, &here, [&] { order += 'p'; });
    view->GetPicture().LookAlong({ -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    view->Draw();
    QTRY_VERIFY_WITH_TIMEOUT(order.contains(QRegularExpression("L.*p")), 60000);
    if (view->GetPicture().GetFrame()->GetSamplesOneByOne())
    {
      QVERIFY2(order.count('d') > 2 && !order.mid(1).contains("dd") && !order.contains("dL"),
        qPrintable(order));
    }
  }

  // Who opens a menu while samples are gathered does not wait for them: they go on afterwards.
  void menusWhileGathering()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "shadows:map_size=256" });
    viewer::PictureView* view = this->Window->GetView();
    const auto countLeft = [view] { return view->GetPicture().GetFrame()->GetSamplesLeft(); };
    QSignalSpy first(view, &viewer::PictureView::drawn);
    view->Draw();
    QVERIFY(first.count() > 0 || first.wait(60000));
    QTRY_COMPARE_WITH_TIMEOUT(countLeft(), 0, 60000);
    QMenu menu(this->Window.get());
    menu.addAction("something");
    QObject::connect(view, &viewer::PictureView::drawn, &menu, [&] {
      if (countLeft() > 0)
      {
        menu.popup(this->Window->mapToGlobal(QPoint(9, 9)));
      }
    });
    view->GetPicture().LookAlong({ -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    view->Draw();
    QTRY_VERIFY_WITH_TIMEOUT(menu.isVisible(), 60000);
    QSignalSpy drawn(view, &viewer::PictureView::drawn);
    for (int i = 0; i < 3; ++i) // as often as a picture would have been drawn
    {
      QTimer tick;
      tick.setSingleShot(true);
      QSignalSpy passed(&tick, &QTimer::timeout);
      tick.start(0);
      QVERIFY(passed.wait(60000));
    }
    QCOMPARE(drawn.count(), 0);
    QObject::disconnect(view, nullptr, &menu, nullptr);
    menu.close();
    QTRY_COMPARE_WITH_TIMEOUT(countLeft(), 0, 60000);
  }

  // A menu opens, the mouse moves, a tab comes to the front, and a row shows an edit while a sample
  // is drawn, however long that takes. The picture follows afterwards, also a new edit.
  void menusWhileDrawing()
  {
    if (!viewer::SampleThread::IsPossible())
    {
      QSKIP("Samples are drawn in no thread of their own here.");
    }
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "shadows:map_size=256" });
    viewer::PictureView* view = this->Window->GetView();
    QMenu menu(this->Window.get());
    menu.addAction("something");
    QObject::connect(view, &viewer::PictureView::drawn, &menu, [view] {
      vtkRelievoPass* frame = view->GetPicture().GetFrame();
      frame->SetSamplesOneByOne(frame->GetSamplesLeft() > 0); // a fast machine draws all at once
    });
    struct
    {
      QSemaphore Shown;
      std::atomic<int> Drawn{ 0 }, Late{ 0 };
    } thread;
    vtkNew<vtkCallbackCommand> begin;
    begin->SetClientData(&thread);
    begin->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      auto* known = static_cast<decltype(thread)*>(data);
      if (QThread::currentThread() != qApp->thread() && known->Drawn++ == 0)
      {
        known->Late += known->Shown.tryAcquire(1, 60000) ? 0 : 1;
      }
    });
    const unsigned long observer = view->renderWindow()->AddObserver(vtkCommand::StartEvent, begin);
    const auto end = qScopeGuard([&] {
      thread.Shown.release();
      view->GetPicture(); // waits for the thread
      view->renderWindow()->RemoveObserver(observer);
    });
    view->GetPicture().LookAlong({ -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    view->Draw();
    QTRY_VERIFY_WITH_TIMEOUT(thread.Drawn > 0, 60000);
    QVERIFY(view->IsDrawing());
    QSignalSpy composed(view, &QOpenGLWidget::frameSwapped);
    menu.popup(this->Window->mapToGlobal(QPoint(9, 9)));
    QVERIFY(QTest::qWaitForWindowExposed(&menu));
    this->SendMouse(QEvent::MouseMove, QPoint(50, 60), Qt::NoButton);
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Shift, Qt::NoModifier);
    QApplication::sendEvent(view, &key);
    menu.close();
    struct Painting : QObject
    {
      bool eventFilter(QObject* /*watched*/, QEvent* event) override
      {
        this->Seen = this->Seen || event->type() == QEvent::Paint;
        return false;
      }
      bool Seen = false;
    } tab, row;
    auto* look = this->Window->findChild<QDockWidget*>("look");
    auto* edges = look->findChild<QCheckBox*>("edges");
    look->installEventFilter(&tab);
    look->raise();
    if (QGuiApplication::platformName() == "xcb")
    {
      QTRY_VERIFY_WITH_TIMEOUT(tab.Seen, 60000);
    }
    edges->installEventFilter(&row);
    edges->click();
    if (QGuiApplication::platformName() == "xcb")
    {
      QTRY_VERIFY_WITH_TIMEOUT(row.Seen, 60000);
    }
    for (const char* dock : { "report", "light", "layers", "look" })
    {
      this->Window->findChild<QDockWidget*>(dock)->raise();
      QCoreApplication::processEvents();
    }
    view->update();
    QTest::qWait(0);
    QVERIFY(view->IsDrawing() && !this->Window->GetView()->IsEmpty());
    QCOMPARE(composed.count(), 0);
    QVERIFY(this->Window->GetDocument()->Get().Has("--edges"));
    thread.Shown.release();
    this->Window->GetDocument()->Change(
      [](scene::Settings& settings) { settings.Set("--color", "0.3,0.6,0.2"); });
    QCOMPARE(thread.Late.load(), 0);
    view->GetPicture(); // waits for the sample
    view->Draw();
    QSignalSpy drawn(view, &viewer::PictureView::drawn);
    QCoreApplication::sendPostedEvents(view, QEvent::MetaCall);
    QCOMPARE(drawn.count(), 0); // for a sample of the picture before
    QTRY_VERIFY_WITH_TIMEOUT(composed.count() > 0, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(thread.Drawn > 2, 60000);
    QObject::disconnect(view, nullptr, &menu, nullptr);
    this->Compare("an edit during a sample");
  }

  // The first sample of a volume takes as long as each later one: a thread draws it, and the status
  // bar says so. Another view that is chosen meanwhile follows without keeping the window waiting.
  void volumesWhileDrawing()
  {
    if (!viewer::SampleThread::IsPossible())
    {
      QSKIP("Samples are drawn in no thread of their own here.");
    }
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 4, 4);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (int i = 0; i < 64; ++i)
    {
      image->GetPointData()->GetScalars()->SetTuple1(i, i);
    }
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(this->Path("image.vti").c_str());
    QVERIFY(writer->Write());
    this->Open({ this->Path("image.vti"), "--image", "volume" });
    viewer::PictureView* view = this->Window->GetView();
    const auto* said = this->Window->findChild<QLabel*>("smoothing");
    auto* path = this->Window->findChild<viewer::PathGroup*>();
    QSignalSpy drawn(view, &viewer::PictureView::drawn);
    QSignalSpy painted(view, &QOpenGLWidget::frameSwapped);
    int begun = 0; // samples of new views
    bool isSaid = false, goesOn = false, isSeen = false, isGap = false;
    // The sign of work stays until all samples are there.
    QObject::connect(view, &viewer::PictureView::drawn, &painted, [&] {
      vtkRelievoPass* frame = view->GetPicture().GetFrame();
      isGap = isGap || (frame && said->text().isEmpty() != (frame->GetSamplesLeft() == 0));
    });
    // The window's own slot was called before.
    QObject::connect(view, &viewer::PictureView::drawing, &painted, [&] {
      ++begun;
      drawn.clear();
      isSaid = said->text().startsWith("Drawing");
      isSeen = painted.count() > 0; // the view before
      painted.clear();
      if (begun == 2) // the next view of a path, which must not wait for this one
      {
        Q_EMIT path->viewWanted({ { 9, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 } });
        goesOn = view->IsDrawing();
      }
    });
    const auto look = [view](double side) {
      view->Change([side](viewer::Picture& picture) {
        picture.LookAlong({ side, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
      });
    };
    look(-1.0);
    QTRY_VERIFY_WITH_TIMEOUT(begun == 1 && drawn.count() > 0, 60000);
    QVERIFY(isSaid);
    QVERIFY(!said->text().startsWith("Drawing") && !isGap);
    look(1.0);
    QTRY_VERIFY_WITH_TIMEOUT(begun == 3 && drawn.count() > 0, 60000);
    QVERIFY(goesOn && isSeen);
    QCOMPARE(
      view->GetPicture().GetRenderer()->GetActiveCamera()->GetDirectionOfProjection()[0], -1.0);
  }

  // Layers are listed by names for people, and arrays as the data have them.
  void layerNames()
  {
    this->Open({ this->WriteScene() });
    auto* box = this->Window->findChild<QComboBox*>("layer");
    for (const auto& [layer, name] : { std::pair("lamp_evaluations", "Lamp evaluations"),
           std::pair("shadow_0", "Shadow of light 0"),
           std::pair("geometric_normal", "Geometric normal"), std::pair("range", "Distance"),
           std::pair("height", "height") })
    {
      const int row = box->findData(layer);
      QVERIFY2(row >= 0, layer);
      QCOMPARE(box->itemText(row), QString(name));
    }
    // They are grouped under titles, which cannot be chosen.
    QStringList titles;
    std::map<QString, QString> groups;
    for (int row = 0; row < box->count(); ++row)
    {
      if (!(box->model()->flags(box->model()->index(row, 0)) & Qt::ItemIsEnabled))
      {
        titles += box->itemText(row).isEmpty() ? QStringList() : QStringList(box->itemText(row));
        continue;
      }
      groups[box->itemData(row).toString()] = titles.isEmpty() ? QString() : titles.last();
    }
    QCOMPARE(titles,
      (QStringList{
        "Surfaces", "Objects", "Light and effects", "Volumes", "Arrays of the files" }));
    for (const auto& [layer, group] :
      { std::pair("", ""), std::pair("depth", "Surfaces"), std::pair("cell", "Objects"),
        std::pair("shadow_0", "Light and effects"), std::pair("fog", "Light and effects"),
        std::pair("volume", "Volumes"), std::pair("height", "Arrays of the files") })
    {
      QCOMPARE(groups[layer], QString(group));
    }
    QCOMPARE(relievoQt::NameLayer("shadow_key_light"), QString("Shadow of key light"));
    // Each light that casts has a row under the name that its user gave it.
    this->Change([](scene::Settings& settings) {
      settings.SetAll("--light",
        { "sun:40,50,name=warm", "sun:90,50,casts=off,name=pale", "sun:200,30,name=low" });
      settings.SetParameter("display", "layer", "shadow_2");
    });
    this->Grab();
    QCOMPARE(box->currentText(), QString("Shadow of low"));
    QVERIFY(box->findText("Shadow of warm") >= 0 && box->findData("shadow_1") < 0);
    QCOMPARE(this->Window->findChild<QLabel*>("layerBannerWords")->text(),
      QString("Showing: Shadow of low"));
    QStringList listed;
    const viewerTest::Dialogs dialogs([&listed](QDialog* dialog) {
      auto* list = dialog->findChild<QListWidget*>("layersToSave");
      for (int i = 0; i < list->count(); ++i)
      {
        listed += list->item(i)->text();
      }
      dialog->reject();
    });
    this->Window->findChild<QAction*>("saveLayers")->trigger();
    QVERIFY2(listed.contains("Lamp evaluations") && listed.contains("height") &&
        listed.contains("Shadow of low") && !listed.contains("Shadow of light 1") &&
        listed.filter("_").isEmpty(),
      qPrintable(listed.join(", ")));
  }

  // Each file has its own points, cells, bounds and arrays.
  void properties()
  {
    this->Open({ this->WriteScene(), this->WriteOBJ() });
    this->Window->findChild<QAction*>("properties")->trigger();
    auto* words = this->Window->findChild<QTextEdit*>("propertiesText");
    QVERIFY(words && words->isVisible());
    const QStringList files = words->toPlainText().split("two.obj");
    QCOMPARE(files.size(), 2);
    QVERIFY2(files[0].contains("scene.vtp") && files[0].contains("height (points)") &&
        files[0].contains("float, 0 to 1") && files[0].contains("part (cells)") &&
        files[0].contains("-1.5 to 1.5"),
      qPrintable(files[0]));
    // A strip of cells around the ball, and the square.
    const vtkIdType cells = 24 * (2 * 16 - 4) + 1;
    const QRegularExpression number("Cells\\s+" + QString::number(cells) + "\\s");
    QVERIFY2(number.match(files[0]).hasMatch(), qPrintable(files[0]));
    QVERIFY2(!files[1].contains("height") && files[1].contains("0 to 2"), qPrintable(files[1]));
    // Another file, while they are seen: a volume, with its dimensions.
    vtkNew<vtkImageData> image;
    image->SetDimensions(7, 8, 9);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (int i = 0; i < 7 * 8 * 9; ++i)
    {
      static_cast<float*>(image->GetScalarPointer())[i] = static_cast<float>(i);
    }
    image->GetPointData()->GetScalars()->SetName("density");
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(this->Path("image.vti").c_str());
    writer->SetInputData(image);
    QVERIFY(writer->Write());
    this->Window->OpenFiles({ QString::fromStdString(this->Path("image.vti")) });
    this->WaitUntilRead();
    for (const char* kind : { "volume", "surface" })
    {
      this->Change([kind](scene::Settings& settings) { settings.Set("--image", kind); });
      const QString text = words->toPlainText();
      QVERIFY2(
        text.contains("image.vti") && text.contains(QString::fromUtf8("7 \u00d7 8 \u00d7 9")),
        qPrintable(text));
      QVERIFY(!text.contains("scene.vtp"));
      auto* file = this->Window->findChild<QLabel*>("file");
      QVERIFY(file->text().contains(QString::fromUtf8("7 \u00d7 8 \u00d7 9")));
      QCOMPARE(text.contains("504"), kind == std::string("volume"));
      QVERIFY(kind != std::string("volume") || text.contains("density (points)"));
      // Under the mouse, a volume has its own values.
      const viewer::Picture& picture = this->Window->GetView()->GetPicture();
      const int* size = picture.GetRenderer()->GetRenderWindow()->GetSize();
      viewer::Probe reading;
      bool beside = true;
      for (const viewer::ProbeValue& value :
        reading.Read(picture.GetRenderer(), {}, size[0] / 2, size[1] / 2))
      {
        beside = beside && value.Layer != "volume_value";
        QVERIFY(value.Layer != "volume_opacity" || value.Values[0] > 0.1);
      }
      QCOMPARE(beside, kind != std::string("volume"));
    }
  }

  // A layer as the picture has a legend with its values, or the reason why nothing is seen.
  void legend()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6", "--clip", "1,12" });
    auto* legend = this->Window->findChild<viewer::LayerLegend*>("layerLegend");
    this->Grab();
    QCOMPARE(legend->GetText(), QString());
    const auto show = [this, legend](const char* layer) {
      this->Change(
        [layer](scene::Settings& settings) { settings.SetParameter("display", "layer", layer); });
      this->Grab();
      return legend->GetText();
    };
    // By default it fits the visible values, with any clipping; or it is as given.
    const QStringList fitted = show("depth").split('\n');
    const double ends[] = { fitted[2].toDouble(), fitted[3].section(' ', 0, 0).toDouble() };
    QVERIFY2(ends[0] > 1.5 && ends[1] < 11.0 && ends[0] < ends[1], qPrintable(legend->GetText()));
    QVERIFY(fitted[3].endsWith(" world units"));
    QCOMPARE(legend->GetText().count("world units"), 1);
    auto* range = this->Window->findChild<QWidget*>("shownRange");
    QCOMPARE(range->findChild<QLabel*>("unit")->text(), QString("in world units"));
    range->findChild<QCheckBox*>("automaticRange")->setChecked(false);
    auto* most = range->findChild<QLineEdit*>("most");
    QVERIFY(std::abs(most->text().toDouble() - ends[1]) < 0.01);
    most->setText("12");
    Q_EMIT most->editingFinished();
    this->Window->findChild<QComboBox*>("shownColormap")->setCurrentText("hot");
    this->Grab();
    QVERIFY2(legend->GetText().endsWith("\n12 world units"), qPrintable(legend->GetText()));
    this->Compare("a layer with a range and colours of its own");
    range->findChild<QCheckBox*>("automaticRange")->setChecked(true);
    QVERIFY2(show("height").endsWith("\n0\n1"), qPrintable(legend->GetText()));
    QVERIFY(range->findChild<QLabel*>("unit")->text().isEmpty());
    QVERIFY2(show("normal").contains("Red"), qPrintable(legend->GetText()));
    QVERIFY(show("cell").contains("colour of its own"));
    QCOMPARE(
      show("shadow_0"), QString("Shadow of light 0\nVisibility of a light.\nin shadow\nlit"));
    this->Compare("with a legend in the window");
    for (const char* blank : { "fog", "lamps_reaching" })
    {
      QVERIFY2(show(blank).contains("Nothing to see"), qPrintable(legend->GetText()));
    }
    // The banner goes back to the picture, in one step.
    auto* back = this->Window->findChild<QPushButton*>("showPicture");
    QVERIFY(back->isVisible());
    QCOMPARE(this->Window->findChild<QLabel*>("layerBannerWords")->text(),
      QString("Showing: Lamps reaching"));
    back->click();
    this->Grab();
    QVERIFY(!back->isVisible());
    QCOMPARE(legend->GetText(), QString());
    this->Compare("the picture again");
  }
};

RELIEVO_TEST_CASE_APART(testViewerTools)
{
  TestViewerTools tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerTools.moc"
