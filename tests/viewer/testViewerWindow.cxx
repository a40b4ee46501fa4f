// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files in by every way, switches by mouse, the probe, sessions, memory.
#include "TestCase.h"
#include "ViewerTest.h"

#include "PathGroup.h"
#include "Probe.h"
#include "Scripts.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QMimeData>
#include <QProcess>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolBar>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <malloc.h>
#include <unistd.h>

namespace testViewerWindow
{
using scene::Settings;

namespace
{
struct Memory
{
  long Allocated; // by malloc, of every thread, and not freed
  long Resident;  // of the process: includes memory mapped and compiled by drivers
};

// In kilobytes.
Memory GetMemory()
{
  malloc_trim(0); // freed memory does not count
  QFile file("/proc/self/statm");
  const long pages = file.open(QIODevice::ReadOnly) ? file.readAll().split(' ')[1].toLong() : 0;
  char* text = nullptr;
  std::size_t size = 0;
  FILE* stream = open_memstream(&text, &size);
  malloc_info(0, stream);
  std::fclose(stream);
  // The last elements are the sums: free in small and in other blocks, mapped, and total from the
  // system except mapped.
  const QString words = QString::fromUtf8(text);
  std::free(text);
  const auto sum = [&words](const char* element) {
    return words.mid(words.lastIndexOf(element))
      .section("size=\"", 1, 1)
      .section('"', 0, 0)
      .toLong();
  };
  const long allocated = sum("<system type=\"current\"") + sum("<total type=\"mmap\"") -
    sum("<total type=\"fast\"") - sum("<total type=\"rest\"");
  return { allocated / 1024, pages * (sysconf(_SC_PAGESIZE) / 1024) };
}
}

class TestViewerWindow : public viewerTest::ViewerTest
{
  Q_OBJECT

private Q_SLOTS:
  void badFiles()
  {
    const std::string scene = this->WriteScene();
    this->Open({ scene });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    QFile cut(QString::fromStdString(this->Path("cut.stl")));
    QVERIFY(cut.open(QIODevice::WriteOnly));
    cut.write("solid and no more");
    cut.close();
    for (const char* name : { "missing.vtp", "cut.stl", "unknown.xyz" })
    {
      const QString path = QString::fromStdString(this->Path(name));
      this->Window->OpenFiles({ path });
      this->WaitUntilRead();
      QVERIFY2(this->Window->GetTrouble().contains(name), qPrintable(this->Window->GetTrouble()));
      // The previous scene is still shown.
      QCOMPARE(CountDifferent(before, this->Grab()), 0);
      QCOMPARE(this->Window->GetDocument()->Get().Files, std::vector<std::string>{ scene });
    }
  }

  void settingsThatFail()
  {
    this->Open({ this->WriteScene() });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    this->Change([](scene::Settings& settings) { settings.Set("--color-by", "nothing"); });
    QVERIFY(this->Window->GetTrouble().contains("Colour by"));
    this->Change([](scene::Settings& settings) { settings.SetParameter("tone", "white", "none"); });
    QVERIFY(this->Window->GetTrouble().contains("white"));
    this->Change([](scene::Settings& settings) { settings.Set("--lamps", "missing.vtp"); });
    QVERIFY(this->Window->GetTrouble().contains("missing.vtp"));
    QVERIFY(!this->Window->GetDocument()->Get().Has("--color-by"));
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
  }

  void dragAndDrop()
  {
    this->Open({ this->WriteScene() });
    const std::string other = this->WriteScene("other.vtp");
    QMimeData files;
    files.setUrls({ QUrl::fromLocalFile(QString::fromStdString(other)) });
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
    QDropEvent drop(QPoint(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    drop.setDropAction(Qt::MoveAction);
    QApplication::sendEvent(this->Window.get(), &drop);
    QCOMPARE(drop.dropAction(), Qt::CopyAction); // who moved it would delete it there
    QVERIFY(ready.wait(60000));
    QCOMPARE(this->Window->GetDocument()->Get().Files, std::vector<std::string>{ other });
    QMimeData words;
    words.setText("no file");
    QDragEnterEvent text(QPoint(200, 200), Qt::CopyAction, &words, Qt::LeftButton, Qt::NoModifier);
    text.ignore();
    QApplication::sendEvent(this->Window.get(), &text);
    QVERIFY(!text.isAccepted());
  }

  // Every group that is a switch, on and off by its widget: the settings follow.
  void widgets()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    for (const char* stage : { "shadows", "tone", "deferred" })
    {
      auto* group = this->Window->findChild<QGroupBox*>(stage);
      QVERIFY2(group && group->isCheckable(), stage);
      const vtkSmartPointer<vtkImageData> before = this->Grab();
      group->setChecked(true);
      const scene::Settings& on = this->Window->GetDocument()->Get();
      QVERIFY(QString(stage) == "shadows" ? on.Has("--shadows") : on.IsStageAsked(stage));
      vtkRelievoPass* frame = this->Window->GetView()->GetPicture().GetFrame();
      QVERIFY(frame);
      this->Grab();
      QVERIFY2(frame->GetStage(stage)->GetReasonCode() == "ran",
        frame->GetStage(stage)->GetReason().c_str());
      group->setChecked(false);
      QVERIFY(!this->Window->GetView()->GetPicture().GetFrame());
      QCOMPARE(CountDifferent(before, this->Grab()), 0);
    }
  }

  // Leaked memory accumulates. Memory held for a while does not: Mesa's rasterizer keeps a deleted
  // shadow map as long as a frame in its queue names it, now and then. So the smallest amount after
  // any of some rounds counts, each of which switches everything off again.
  void memoryIsFlat()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    const auto getLeast = [this](int rounds) {
      Memory least = GetMemory();
      for (int i = 0; i < rounds; ++i)
      {
        for (const char* stage : { "shadows", "tone", "shadows", "tone", "deferred", "deferred" })
        {
          auto* group = this->Window->findChild<QGroupBox*>(stage);
          group->setChecked(!group->isChecked());
          this->Grab();
        }
        QApplication::processEvents(); // folding posts events, which wait here
        const Memory now = GetMemory();
        least = { std::min(least.Allocated, now.Allocated),
          std::min(least.Resident, now.Resident) };
      }
      return least;
    };
    getLeast(13);
    const Memory before = getLeast(12);
    getLeast(22); // with the next, 204 switches
    Memory after = getLeast(12);
    // On a busy machine frames stay in the queue for longer; leaks never come back.
    for (int more = 0; more < 8 && after.Allocated - before.Allocated >= 256; ++more)
    {
      const Memory later = getLeast(12);
      after = { std::min(after.Allocated, later.Allocated),
        std::min(after.Resident, later.Resident) };
    }
    const long allocated = after.Allocated - before.Allocated;
    const long resident = after.Resident - before.Resident;
    // A buffer of the picture's size that is left each time would be 100 MB and more.
    const int* size = this->Window->GetView()->renderWindow()->GetSize();
    const long buffers = 204L * size[0] * size[1] * 4 / 1024;
    qInfo() << allocated << "kB more allocated," << resident << "kB more held after 204 switches";
    QVERIFY(before.Allocated > 1000 && buffers > 50000);
    QVERIFY2(allocated < 256, qPrintable(QString::number(allocated))); // 1.3 kB a switch
    QVERIFY2(resident < buffers / 10, qPrintable(QString::number(resident)));
  }

  // The values under the mouse are those that the layers hold there, and known from the scene.
  void probe()
  {
    this->Open({ this->WriteScene(), "--camera", "0,0.8,5,0,0.8,0,0,1,0" });
    viewer::PictureView* view = this->Window->GetView();
    view->GetPicture().Grab();
    auto* probing = this->Window->findChild<QCheckBox*>("probing");
    auto* table = this->Window->findChild<QTableWidget*>("values");
    QVERIFY(probing && table);
    probing->setChecked(true);
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const int* size = view->renderWindow()->GetSize();
    viewer::Probe reading;
    const std::vector<std::string>& arrays = this->Window->GetDocument()->GetFacts().Layers;
    QVERIFY(std::count(arrays.begin(), arrays.end(), "height") == 1);
    const std::vector<viewer::ProbeValue> values =
      reading.Read(view->GetPicture().GetRenderer(), arrays, size[0] / 2, size[1] / 2);
    std::map<std::string, std::vector<double>> found;
    for (const viewer::ProbeValue& value : values)
    {
      QVERIFY(!value.IsBackground);
      found[value.Layer] = value.Values;
    }
    QVERIFY(std::abs(found["depth"][0] - 4.4) < 0.01); // the ball's front, 0.6 before its middle
    QVERIFY(std::abs(found["position"][2] - 0.6) < 0.01);
    QVERIFY(std::abs(found["height"][0] - found["position"][1]) < 1e-4);
    QVERIFY(found["normal"][2] > 0.99);
    QCOMPARE(found["part"][0], found["cell"][0] + 100.0);
    this->SendMouse(QEvent::MouseMove, view->rect().center(), Qt::NoButton);
    QTRY_VERIFY_WITH_TIMEOUT(table->rowCount() == static_cast<int>(values.size()), 20000);
    QVERIFY(table->item(0, 1)->text().startsWith("4.4"));
    this->SendMouse(QEvent::MouseMove, QPoint(1, 1), Qt::NoButton);
    QTRY_COMPARE_WITH_TIMEOUT(table->item(0, 1)->text(), QString("background"), 20000);
    QCOMPARE(this->Window->findChild<QLabel*>("underTheMouse")->text(),
      QString("Background: nothing of the files is here"));
    this->SendMouse(QEvent::MouseMove, view->rect().center(), Qt::NoButton);
    QTRY_VERIFY_WITH_TIMEOUT(table->item(0, 1)->text().startsWith("4.4"), 20000);
    QEvent left(QEvent::Leave);
    QApplication::sendEvent(view, &left);
    QTest::qWait(300);
    QVERIFY(table->item(0, 1)->text().startsWith("4.4")); // to be read and copied
    // Looking changes nothing.
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    // Another view, and another file, have other values.
    auto* words = this->Window->findChild<QLabel*>("underTheMouse");
    QVERIFY(words->text().startsWith("Depth 4.4"));
    QVERIFY(table->item(0, 1)->text().endsWith(" world units"));
    view->GetPicture().LookAlong({ -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    view->Draw();
    QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 0, 20000);
    QVERIFY(words->text().isEmpty());
    this->SendMouse(QEvent::MouseMove, view->rect().center(), Qt::NoButton);
    QTRY_VERIFY_WITH_TIMEOUT(table->rowCount() > 0, 20000);
    this->Change([](scene::Settings& settings) { settings.Set("--opacity", "0.5"); });
    QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 0, 20000);
    QTRY_VERIFY_WITH_TIMEOUT(table->rowCount() > 0, 20000); // the mouse is still there
    QApplication::sendEvent(view, &left);
    this->Window->OpenFiles({ QString::fromStdString(this->WriteScene("other.vtp")) });
    this->WaitUntilRead();
    QCOMPARE(table->rowCount(), 0);
  }

  void session()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6", "--shadows", "exact", "--tone",
      "reinhard,white=3", "--camera", "2,2,4,0,0.5,0,0,1,0", "--color-by", "height" });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const std::vector<std::string> words = this->Window->GetViewSettings().GetWords();
    const QString path = QString::fromStdString(this->Path("session.json"));
    this->Window->SaveSession(path);
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(!saved.readAll().contains("/scene.vtp")); // named from the session's folder
    this->Open({ this->WriteScene("other.vtp") });
    QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
    this->Window->OpenFiles({ path });
    QVERIFY(ready.wait(60000));
    QTRY_COMPARE_WITH_TIMEOUT(this->Window->GetViewSettings().GetWords(), words, 20000);
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    QFile broken(path);
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{\"relievo-viewer\": 1");
    broken.close();
    this->Window->OpenFiles({ path });
    QVERIFY(this->Window->GetTrouble().contains("session.json"));
  }

  void savesPictures()
  {
    this->Open({ this->WriteScene(), "--shadows", "map", "--light", "sun:0.4,1,0.6" });
    const QString png = QString::fromStdString(this->Path("saved.png"));
    this->Window->SavePicture({ png, {} });
    const vtkSmartPointer<vtkImageData> command = this->RenderCommand();
    QVERIFY(command);
    QFile saved(png), made(QString::fromStdString(this->Path("command.png")));
    QVERIFY(saved.open(QIODevice::ReadOnly) && made.open(QIODevice::ReadOnly));
    QCOMPARE(saved.readAll(), made.readAll());
    this->Window->SaveLayers(
      { QString::fromStdString(this->Path("saved.exr")), {}, { "color", "depth", "cell" } });
    QVERIFY(QFile(QString::fromStdString(this->Path("saved.exr"))).size() > 1000);
    QVERIFY_EXCEPTION_THROWN(
      this->Window->SavePicture({ QString::fromStdString(this->Path("no/such/place.png")), {} }),
      std::exception);
  }

  // Pictures of any size, and without a background: equal to the command's with these words, byte
  // for byte. Afterwards the view is restored.
  void savesOtherSizes()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--color-by", "height", "--scalar-bar",
      "--stage", "antialias:samples=2", "--soft-shadows", "2", "--shadows", "map" });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const std::string saved = this->Path("saved"), made = this->Path("made");
    const auto read = [](const std::string& path) {
      QFile file(QString::fromStdString(path));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray::fromStdString(path);
    };
    scene::Settings settings = this->Window->GetViewSettings();
    for (const QSize& size : { QSize(), QSize(1100, 500), QSize(100, 300) })
    {
      if (size.isValid())
      {
        settings.Set("--size", QString("%1x%2").arg(size.width()).arg(size.height()).toStdString());
      }
      this->Window->SavePicture({ QString::fromStdString(saved + ".png"), size });
      QVERIFY(this->RunCommand(settings, { "--png", made + ".png" }));
      QCOMPARE(read(saved + ".png"), read(made + ".png"));
      this->Window->SavePicture({ QString::fromStdString(saved + ".png"), size, true });
      QVERIFY(this->RunCommand(settings, { "--png", made + ".png", "--transparent" }));
      QCOMPARE(read(saved + ".png"), read(made + ".png"));
      this->Window->SaveLayers(
        { QString::fromStdString(saved + ".exr"), size, { "color", "depth", "height" } });
      QVERIFY(this->RunCommand(settings, { "--exr", made + ".exr", "--layers", "depth,height" }));
      QCOMPARE(read(saved + ".exr"), read(made + ".exr"));
      QCOMPARE(CountDifferent(before, this->Grab()), 0);
    }
    QVERIFY_EXCEPTION_THROWN(
      this->Window->SavePicture({ QString::fromStdString(saved + "2.png"), QSize(200000, 100) }),
      std::exception);
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
  }

  // The clipboard has the view's picture, with all samples.
  void copiesThePicture()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "shadows:map_size=256" });
    auto* copy = this->Window->findChild<QAction*>("copyPicture");
    QVERIFY(this->Window->findChild<QToolBar*>("tools")->actions().contains(copy)); // as Ctrl+C
    QCOMPARE(copy->toolTip(), QString("Copy picture (Ctrl+C)"));
    copy->trigger();
    QCOMPARE(this->Window->GetTrouble(), QString());
    const QString png = QString::fromStdString(this->Path("copied.png"));
    QVERIFY(QApplication::clipboard()->image().save(png));
    QCOMPARE(CountDifferent(this->Grab(), ReadPNG(png.toStdString())), 0);
  }

  // All settings but the permission to read the files get their defaults, and back.
  void resets()
  {
    const std::vector<std::string> words = { "--allow-folder", "/", this->WriteScene() };
    this->Open(words);
    const vtkSmartPointer<vtkImageData> fresh = this->Grab();
    this->Change([](scene::Settings& settings) {
      settings.Set("--edges", "");
      settings.SetParameter("shadows", "map_size", "256");
      settings.Set("--color", "#ff8000");
    });
    const scene::Settings edited = this->Window->GetDocument()->Get();
    QVERIFY(CountDifferent(fresh, this->Grab()) > 100);
    this->Window->findChild<QAction*>("resetSettings")->trigger();
    this->WaitUntilRead();
    QCOMPARE(this->Window->GetDocument()->Get().GetWords(), words);
    QCOMPARE(CountDifferent(fresh, this->Grab()), 0);
    this->Window->GetDocument()->Undo();
    this->WaitUntilRead();
    QVERIFY(this->Window->GetDocument()->Get() == edited);
  }

  void copiesTheCommand()
  {
    this->Open({ this->WriteScene("it's a scene.vtp"), "--shadows", "map" });
    QCOMPARE(viewer::WriteCommand(scene::Settings::FromWords({ "it's.vtp" }), "a b.png"),
      std::string("relievo render --png 'a b.png' 'it'\\''s.vtp'"));
    auto* copy = this->Window->findChild<QAction*>("copyCommand");
    QVERIFY(copy);
    copy->trigger();
    const QString text = QApplication::clipboard()->text();
    QVERIFY2(text.startsWith("relievo render") && text.contains("--shadows map"), qPrintable(text));
    auto* said = this->Window->findChild<QLabel*>("words");
    QCOMPARE(said->text(), QString("Copied: the command that makes this picture"));
    // The command, pasted into a shell, draws the window's picture.
    QProcess shell;
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    variables.insert("PATH",
      QFileInfo(qEnvironmentVariable("RELIEVO")).path() + ":" + qEnvironmentVariable("PATH"));
    shell.setProcessEnvironment(variables);
    shell.setWorkingDirectory(QString::fromStdString(this->Path("")));
    shell.start("sh", { "-c", text });
    QVERIFY(shell.waitForFinished(600000));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
    QCOMPARE(CountDifferent(this->Grab(), ReadPNG(this->Path("picture.png"))), 0);
    // With a camera path, it says where the film's command is, which draws the same frames.
    auto* path = this->Window->findChild<viewer::PathGroup*>();
    QVERIFY(!path->findChild<QAbstractButton*>("copyFilm")->isEnabled());
    path->findChild<QAbstractButton*>("addView")->click();
    path->findChild<QWidget*>("seconds")->findChild<QDoubleSpinBox*>()->setValue(0.04);
    this->Window->GetView()->GetPicture().Turn(-30.0, 0.0);
    path->findChild<QAbstractButton*>("addView")->click();
    copy->trigger();
    QVERIFY2(said->text().contains("Camera path"), qPrintable(said->text()));
    path->findChild<QAbstractButton*>("copyFilm")->click();
    QString film = QApplication::clipboard()->text();
    QVERIFY2(film.contains("--video film.mp4"), qPrintable(film));
    shell.start("sh", { "-c", film.replace("--video film.mp4", "--png f%d.png") });
    QVERIFY(shell.waitForFinished(600000));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
    const QStringList frames =
      QDir(shell.workingDirectory()).entryList({ "f*.png" }, QDir::Files, QDir::Name);
    QCOMPARE(frames.size(), 2);
    QCOMPARE(CountDifferent(this->Grab(), ReadPNG(this->Path(frames[1].toStdString()))), 0);
    // An existing file stays, and nothing is drawn.
    const std::string views = this->Path("camera-path.csv");
    QVERIFY(std::ofstream(views) << "kept");
    QFile::remove(QString::fromStdString(this->Path(frames[1].toStdString())));
    shell.start("sh", { "-c", film });
    QVERIFY(shell.waitForFinished(600000));
    QVERIFY(shell.exitCode() != 0);
    QVERIFY(!QFile::exists(QString::fromStdString(this->Path(frames[1].toStdString()))));
    QFile file(QString::fromStdString(views));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("kept"));
    // No film leads through opposite views, and so no command is copied.
    path->SetKeys({ { 0.0, { { 0, 0, 9 }, { 0, 0, 0 }, { 0, 1, 0 } } },
      { 1.0, { { 0, 0, -9 }, { 0, 0, 0 }, { 0, 1, 0 } } } });
    const QString before = QApplication::clipboard()->text();
    path->findChild<QAbstractButton*>("copyFilm")->click();
    QCOMPARE(QApplication::clipboard()->text(), before);
    QVERIFY(this->Window->GetTrouble().contains("180 degrees"));
  }

  // Colours of values are left out where no values are shown.
  void copiesNoIdleColors()
  {
    this->Open({ this->WriteScene(), "--colormap", "hot", "--range", "0,2" });
    const auto getCopied = [this] {
      this->Window->findChild<QAction*>("copyCommand")->trigger();
      return QApplication::clipboard()->text();
    };
    this->Change([](scene::Settings& settings) { settings.Set("--color-by", "height"); });
    for (const char* words : { "--range 0,2", "--colormap hot" })
    {
      QVERIFY2(getCopied().contains(words), qPrintable(getCopied()));
    }
    this->OpenAgain({ this->WriteOBJ(false), "--colormap", "hot", "--range", "0,2" });
    QVERIFY2(
      !getCopied().contains("hot") && !getCopied().contains("--range"), qPrintable(getCopied()));
    this->Compare("a map for no values");
  }
};

RELIEVO_TEST_CASE_APART(testViewerWindow)
{
  TestViewerWindow tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerWindow.moc"
