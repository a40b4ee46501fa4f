// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// While files are read: opening others, changing settings, and the state afterwards.
#include "TestCase.h"
#include "ViewerTest.h"

#include "Options.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QToolBar>
#include <QtTest>

#include <cmath>
#include <condition_variable>
#include <fstream>
#include <memory>
#include <mutex>

namespace testViewerReading
{
using scene::Settings;

namespace
{
// A file whose reading, in the loader's thread, waits until it is let go, and then goes on.
class SlowFile
{
public:
  SlowFile(viewer::MainWindow* window, const std::string& path)
  {
    std::ofstream(path) << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                           "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
    this->Connection = QObject::connect(
      window->findChild<viewer::Loader*>(), &viewer::Loader::progressed, window,
      [gate = this->Gate, name = QString::fromStdString(path)](const QString& what) {
        if (what.contains(name))
        {
          std::unique_lock<std::mutex> lock(gate->Lock);
          gate->Opened.wait(lock, [&gate] { return gate->IsOpen; });
        }
      },
      Qt::DirectConnection);
  }

  ~SlowFile()
  {
    QObject::disconnect(this->Connection);
    this->LetGo();
  }

  void LetGo()
  {
    const std::lock_guard<std::mutex> guard(this->Gate->Lock);
    this->Gate->IsOpen = true;
    this->Gate->Opened.notify_all();
  }

private:
  struct Latch
  {
    std::mutex Lock;
    std::condition_variable Opened;
    bool IsOpen = false;
  };
  std::shared_ptr<Latch> Gate = std::make_shared<Latch>(); // readers may outlive the file
  QMetaObject::Connection Connection;
};
}

class TestViewerReading : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  QString Words() { return this->Window->findChild<QLabel*>("words")->text(); }

  // Opens a file that its reader waits for.
  std::unique_ptr<SlowFile> OpenSlow()
  {
    auto slow = std::make_unique<SlowFile>(this->Window.get(), this->Path("slow.stl"));
    this->Window->OpenFiles({ QString::fromStdString(this->Path("slow.stl")) });
    return slow;
  }

  void StopSlow(std::unique_ptr<SlowFile> slow)
  {
    this->Window->findChild<QPushButton*>("cancel")->click();
    slow->LetGo();
    QTRY_VERIFY_WITH_TIMEOUT(!this->Window->IsBusy(), 60000);
  }

private Q_SLOTS:
  // The window goes on at once, whatever the reader waits for, and takes the next file after it.
  void cancelDoesNotWait()
  {
    this->Open({ this->WriteScene() });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const std::string next = this->WriteScene("next.vtp");
    SlowFile slow(this->Window.get(), this->Path("slow.stl"));
    this->Window->OpenFiles({ QString::fromStdString(this->Path("slow.stl")) });
    QVERIFY(this->Window->IsReading());
    QTest::qWait(50);
    this->Window->findChild<QPushButton*>("cancel")->click();
    QVERIFY(!this->Window->IsReading()); // though nothing let the reader go
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
    this->Window->OpenFiles({ QString::fromStdString(next) });
    QTest::qWait(50);
    QVERIFY(this->Window->IsReading() && ready.isEmpty());
    slow.LetGo();
    QVERIFY(ready.wait(60000));
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(this->Window->GetDocument()->Get().Files, std::vector<std::string>{ next });
  }

  // Settings changed while a file is read apply at once, and stay when the reading is stopped.
  void setsMeanwhile()
  {
    const std::string scene = this->WriteScene();
    this->Open({ scene, "--edges" });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    std::unique_ptr<SlowFile> slow = this->OpenSlow();
    this->Window->GetDocument()->Change([](scene::Settings& settings) {
      settings.SetParameter("tone", "exposure", "1");
      settings.Remove("--edges");
    });
    QVERIFY(this->Window->IsReading());
    const vtkSmartPointer<vtkImageData> during = this->Grab();
    QVERIFY(CountDifferent(before, during) > 100);
    this->StopSlow(std::move(slow));
    const scene::Settings& after = this->Window->GetDocument()->Get();
    QCOMPARE(after.Files, std::vector<std::string>{ scene });
    QCOMPARE(after.GetParameter("tone", "exposure"), std::string("1"));
    QVERIFY(!after.Has("--edges"));
    QCOMPARE(CountDifferent(during, this->Grab()), 0);
    QCOMPARE(this->Window->GetTrouble(), QString()); // as the user wants
    QCOMPARE(this->Words(), QString("Stopped."));
  }

  // A file is opened with the camera fitted to it, whatever is set before it has been read.
  void upMeanwhile()
  {
    this->Open({ this->WriteScene(), "--camera", "30,40,50,0,0,0,0,1,0" });
    QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
    this->Window->OpenFiles({ QString::fromStdString(this->WriteScene("next.vtp")) });
    this->Window->GetDocument()->Change(
      [](scene::Settings& settings) { settings.Set("--up", "z"); });
    QVERIFY(ready.wait(60000));
    vtkCamera* camera = this->Window->GetView()->GetPicture().GetRenderer()->GetActiveCamera();
    QVERIFY(std::abs(camera->GetDirectionOfProjection()[1] - 1.0) < 1e-9);
    QVERIFY(camera->GetDistance() < 20.0);
  }

  // A reader that does not say how far it is gets a bar that does not say so either.
  void busyBar()
  {
    this->Open({ this->WriteScene() });
    auto* bar = this->Window->findChild<QProgressBar*>("progress");
    std::unique_ptr<SlowFile> slow = this->OpenSlow();
    QVERIFY(!bar->isVisible()); // as for most files
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible(), 20000);
    QCOMPARE(bar->maximum(), 0);
    QVERIFY2(this->Words().contains("slow.stl"), qPrintable(this->Words()));
    this->StopSlow(std::move(slow));
    QVERIFY(!bar->isVisible());
  }

  // Settings made for an unreadable file apply to the next.
  void optionsOfAFailure()
  {
    const std::string missing = this->Path("missing.glb");
    this->Open({ missing, "--preset", "studio", "--camera", "3,4,5,0,0,0,0,1,0", "--color-by",
      "height", "--skin", "off" });
    QVERIFY(this->Window->GetTrouble().contains("missing.glb"));
    this->Window->GetDocument()->Change(
      [](scene::Settings& settings) { settings.Remove("--skin"); });
    QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
    this->Window->OpenFiles({ QString::fromStdString(this->WriteScene()) });
    QVERIFY(ready.wait(60000));
    QCOMPARE(this->Window->GetTrouble(), QString());
    const scene::Settings view = this->Window->GetViewSettings();
    QCOMPARE(view.Get("--preset"), std::string("studio"));
    QCOMPARE(view.Get("--color-by"), std::string("height"));
    QCOMPARE(view.Get("--camera"), std::string("3,4,5,0,0,0,0,1,0"));
  }

  // The list contains files read in any way, and distinguishes files of one name.
  void recentFiles()
  {
    QSettings().clear();
    QVERIFY(QDir(QString::fromStdString(this->Path(""))).mkdir("a&b"));
    const std::string first = this->WriteScene(), second = this->WriteScene("a&b/scene.vtp");
    this->Open({ first });
    this->Window->OpenFiles({ QString::fromStdString(second) });
    this->WaitUntilRead();
    this->Window->OpenFiles({ QString::fromStdString(this->Path("missing.vtp")) });
    this->WaitUntilRead();
    QMenu* recent = nullptr;
    for (QMenu* menu : this->Window->findChildren<QMenu*>())
    {
      recent = menu->title() == "Open &recent" ? menu : recent;
    }
    QVERIFY(recent);
    Q_EMIT recent->aboutToShow();
    QCOMPARE(recent->actions().size(), 2);
    QCOMPARE(recent->actions()[0]->data().toString().toStdString(), second);
    QCOMPARE(recent->actions()[0]->text().toStdString(), "scene.vtp (" + this->Path("a&&b") + ")");
    QCOMPARE(recent->actions()[1]->data().toString().toStdString(), first);
  }

  // A view that the screen has no room for keeps its shape, and says that it is smaller.
  void sizeOfTheView()
  {
    this->Open({ this->WriteScene(), "--size", "16000x8000" });
    QVERIFY2(this->Words().contains("--size 16000x8000"), qPrintable(this->Words()));
    const QSize room = this->Window->screen()->availableSize();
    const QSize window = this->Window->frameGeometry().size();
    QVERIFY(window.width() <= room.width() && window.height() <= room.height());
    const int* size = this->Window->GetView()->renderWindow()->GetSize();
    QVERIFY2(
      std::abs(size[0] - 2 * size[1]) <= 2, qPrintable(QString("%1x%2").arg(size[0]).arg(size[1])));
    this->Open({ this->WriteScene(), "--size", "320x240" });
    QCOMPARE(
      QString::fromStdString(this->Window->GetViewSettings().Get("--size")), QString("320x240"));
    QCOMPARE(this->Words(), QString());
  }

  // The time bar is there where something moves, whatever was there when the program ended.
  void timeBarAfterRestart()
  {
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/glTF2/";
    this->Open({ models + "simple_skin/simple_skin.gltf", "--times", "0.5:1:0.1" });
    QVERIFY2(this->Words().contains("--times"), qPrintable(this->Words()));
    QCOMPARE(this->Window->GetDocument()->Get().Get("--time"), std::string("0.5"));
    QVERIFY(this->Window->findChild<QToolBar*>("time")->isVisible());
    this->Window->close();
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->RestoreLayout();
    this->Window->show();
    QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
    QVERIFY(!this->Window->findChild<QToolBar*>("time")->isVisible());
  }

  // A session without files clears the previous scene; one with other contents is named.
  void emptySessions()
  {
    this->Open({ this->WriteScene() });
    this->WriteText("empty.json", "{\"relievo-viewer\": 1, \"words\": []}");
    this->WriteText("numbers.json", "{\"relievo-viewer\": 1, \"words\": [1, 2]}");
    this->Window->OpenFiles({ QString::fromStdString(this->Path("numbers.json")) });
    QVERIFY(this->Window->GetTrouble().contains("numbers.json"));
    QVERIFY(this->Window->windowTitle().startsWith("scene.vtp"));
    this->Window->OpenFiles({ QString::fromStdString(this->Path("empty.json")) });
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(this->Window->windowTitle(), QString("Relievo"));
    QVERIFY(this->Window->GetDocument()->GetFacts().Components.empty());
  }
};

RELIEVO_TEST_CASE_APART(testViewerReading)
{
  TestViewerReading tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerReading.moc"
