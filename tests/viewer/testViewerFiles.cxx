// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that cannot be shown, that follow one another, that are saved, that are compared with, and
// none at all.
#include "TestCase.h"
#include "ViewerTest.h"

#include "ComparisonPanel.h"
#include "ComparisonView.h"
#include "Errors.h"
#include "Options.h"
#include "PathGroup.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRenderer.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTreeWidget>
#include <QtTest>

#include <cmath>
#include <map>

namespace testViewerFiles
{
using scene::Settings;

namespace
{
std::string Repeat(const std::string& text, int times)
{
  std::string all;
  for (int i = 0; i < times; ++i)
  {
    all += text;
  }
  return all;
}

int CountPixels(const QImage& image, const QColor& color)
{
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      count += image.pixelColor(x, y) == color;
    }
  }
  return count;
}
}

class TestViewerFiles : public viewerTest::ViewerTest
{
  Q_OBJECT

private Q_SLOTS:
  // A file that is read well, and of which no picture can be made beside the other.
  void whatWasShownStays()
  {
    const std::string scene = this->WriteScene();
    this->WriteText("other.vtk",
      "# vtk DataFile Version 3.0\nother\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
      "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS warmth float 1\n"
      "LOOKUP_TABLE default\n1 2 3\n");
    this->Open({ scene, "--scalar-bar", "--light", "sun:0.4,1,0.6", "--shadows", "map" });
    QCOMPARE(this->Window->GetTrouble(), QString());
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const std::vector<std::string> words = this->Window->GetViewSettings().GetWords();
    this->Window->OpenFiles({ QString::fromStdString(this->Path("other.vtk")) }, true);
    this->WaitUntilRead();
    QVERIFY2(this->Window->GetTrouble().contains("Show a colour bar"),
      qPrintable(this->Window->GetTrouble()));
    QCOMPARE(this->Window->GetViewSettings().GetWords(), words);
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    this->Change([](scene::Settings& settings) { settings.SetParameter("tone", "exposure", "1"); });
    this->Compare("after it");
  }

  // A file that was there is gone when the settings need it again.
  void filesThatDisappear()
  {
    const std::string image = this->WriteImage();
    this->Open({ this->WriteScene(), "--environment", image, "--skybox" });
    QCOMPARE(this->Window->GetTrouble(), QString());
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const scene::Settings shown = this->Window->GetDocument()->Get();
    QVERIFY(QFile::remove(QString::fromStdString(image)));
    for (int i = 0; i < 2; ++i)
    {
      this->Change([](scene::Settings& settings) { settings.Set("--reflectivity", "0.9,0.1"); });
      QVERIFY2(
        this->Window->GetTrouble().contains("waves.png"), qPrintable(this->Window->GetTrouble()));
      QVERIFY(this->Window->GetDocument()->Get() == shown);
      QCOMPARE(CountDifferent(before, this->Grab()), 0);
    }
    // Changes that need no file continue.
    this->Change([](scene::Settings& settings) { settings.SetParameter("tone", "exposure", "1"); });
    QCOMPARE(this->Window->GetTrouble(), QString());
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
  }

  // A file that crashes its reader: the shown scene stays, and the next file opens.
  void readersThatCrash()
  {
    const std::string scene = this->WriteScene();
    this->Open({ scene });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const scene::Settings shown = this->Window->GetDocument()->Get();
    this->WriteText("deep.vtp",
      "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\" version=\"0.1\"><PolyData>" +
        Repeat("<Piece>", 300000) + Repeat("</Piece>", 300000) + "</PolyData></VTKFile>");
    for (int i = 0; i < 2; ++i)
    {
      this->Window->OpenFiles({ QString::fromStdString(this->Path("deep.vtp")) });
      this->WaitUntilRead();
      const QString trouble = this->Window->GetTrouble();
      QVERIFY2(
        trouble.contains("deep.vtp: the reader (VTK) crashed (segmentation"), qPrintable(trouble));
      QVERIFY(this->Window->GetDocument()->Get() == shown);
      QCOMPARE(CountDifferent(before, this->Grab()), 0);
    }
    this->Window->OpenFiles({ QString::fromStdString(this->WriteScene("next.vtp")) });
    this->WaitUntilRead();
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(
      this->Window->GetDocument()->Get().Files, std::vector<std::string>{ this->Path("next.vtp") });
  }

  void nothingIsOpen()
  {
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->show();
    const QString png = QString::fromStdString(this->Path("none.png"));
    QVERIFY_EXCEPTION_THROWN(this->Window->SavePicture({ png, {} }), words::WorkError);
    QVERIFY_EXCEPTION_THROWN(this->Window->SaveLayers({ png, {}, { "depth" } }), words::WorkError);
    const char* const names[] = { "copyCommand", "copyPython", "copyPicture", "resetSettings",
      "savePicture", "saveLayers", "exportGltf", "fit", "look1", "parallel" };
    for (const char* name : names)
    {
      QVERIFY2(!this->Window->findChild<QAction*>(name)->isEnabled(), name);
    }
    QVERIFY(this->Window->findChild<QAction*>("saveSession")->isEnabled());
    this->Open({ this->WriteScene() });
    for (const char* name : names)
    {
      QVERIFY2(this->Window->findChild<QAction*>(name)->isEnabled(), name);
    }
  }

  // The session of a window without a file is one.
  void sessionOfNothing()
  {
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->show();
    this->Window->GetDocument()->Change(
      [](scene::Settings& settings) { settings.Set("--preset", "studio"); });
    const QString path = QString::fromStdString(this->Path("empty.json"));
    this->Window->SaveSession(path);
    this->Window->GetDocument()->Change(
      [](scene::Settings& settings) { settings.Remove("--preset"); });
    this->Window->OpenFiles({ path });
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(this->Window->GetDocument()->Get().Get("--preset"), std::string("studio"));
  }

  // Views become a path, which is played, kept by sessions, read by the command, and drawn as a
  // film whose frames are the command's pictures.
  void cameraPath()
  {
    this->Open({ this->WriteScene(), "--camera", "0,0.5,7,0,0.5,0,0,1,0", "--size", "96x64" });
    this->Grab();
    auto* path = this->Window->findChild<viewer::PathGroup*>();
    auto* list = path->findChild<QListWidget*>("views");
    viewer::PictureView* view = this->Window->GetView();
    const auto getX = [view] {
      return view->GetPicture().GetRenderer()->GetActiveCamera()->GetPosition()[0];
    };
    path->findChild<QAbstractButton*>("addView")->click();
    QVERIFY(!path->findChild<QAbstractButton*>("playPath")->isEnabled());
    view->GetPicture().Turn(-30.0, 0.0);
    const double last = getX();
    QVERIFY(std::abs(last + 3.5) < 1e-9);
    path->findChild<QAbstractButton*>("addView")->click();
    QCOMPARE(list->count(), 2);
    Q_EMIT list->itemActivated(list->item(1));
    Q_EMIT list->itemActivated(list->item(0)); // which is not the current one
    QCOMPARE(getX(), 0.0);
    std::vector<scene::CameraKey> keys = path->GetKeys();
    keys[1].Time = 0.08;
    path->SetKeys(keys);
    path->findChild<QAbstractButton*>("playPath")->click();
    QTRY_VERIFY_WITH_TIMEOUT(!path->findChild<QAbstractButton*>("playPath")->isChecked(), 60000);
    QCOMPARE(getX(), last);
    const QString session = QString::fromStdString(this->Path("path.json"));
    this->Window->SaveSession(session);
    path->SetKeys({});
    this->Window->OpenFiles({ session });
    this->WaitUntilRead();
    QCOMPARE(list->count(), 2);
    const scene::CameraPath read = scene::CameraPath::Read(session.toStdString());
    QCOMPARE(read.GetKeys()[1].Place.Position[0], last);
    QCOMPARE(path->GetKeys()[1].Time, 0.08);
    // A session whose file or views cannot be read leaves the path.
    const auto refuse = [this](const char* files, const char* time, const char* why) {
      this->WriteText("wrong.json",
        QString(R"({ "relievo-viewer": 1, "words": [%1], "keys": [{ "time": %2,)"
                R"( "position": [0, 0, 7], "focal_point": [0, 0, 0], "view_up": [0, 1, 0] }] })")
          .arg(files, time)
          .toStdString());
      this->Window->OpenFiles({ QString::fromStdString(this->Path("wrong.json")) });
      this->WaitUntilRead();
      QVERIFY2(this->Window->GetTrouble().contains(why), qPrintable(this->Window->GetTrouble()));
    };
    refuse("\"gone.obj\"", "0", "gone.obj");
    refuse("", "\"0\"", "expected numbers");
    QCOMPARE(list->count(), 2);
    // Without a view in between, the others keep their times after it.
    keys.push_back(keys[0]);
    keys[2].Time = 0.28;
    path->SetKeys(keys);
    list->setCurrentRow(0);
    path->findChild<QAbstractButton*>("removeView")->click();
    QCOMPARE(path->GetKeys()[0].Time, 0.0);
    QVERIFY(std::abs(path->GetKeys()[1].Time - 0.2) < 1e-9);
    keys.pop_back();
    path->SetKeys(keys);
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty())
    {
      QSKIP("There is no ffmpeg.");
    }
    const QString film = QString::fromStdString(this->Path("film.mkv"));
    const int* size = view->renderWindow()->GetSize();
    this->Window->SaveFilm({ film, { size[0], size[1] } });
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(getX(), last);
    QProcess decoder;
    decoder.start(
      "ffmpeg", { "-v", "error", "-i", film, QString::fromStdString(this->Path("film%d.png")) });
    QVERIFY(decoder.waitForFinished(60000) && decoder.exitCode() == 0);
    QVERIFY(QFile::exists(QString::fromStdString(this->Path("film3.png"))) &&
      !QFile::exists(QString::fromStdString(this->Path("film4.png"))));
    QCOMPARE(CountDifferent(ReadPNG(this->Path("film3.png")), this->RenderCommand()), 0);
    QVERIFY(CountDifferent(ReadPNG(this->Path("film2.png")), ReadPNG(this->Path("film3.png"))) > 0);
    // No path leads to the opposite direction.
    keys[1].Place.Position = { 0.0, 0.5, -7.0 };
    path->SetKeys(keys);
    path->findChild<QAbstractButton*>("playPath")->click();
    QTRY_VERIFY_WITH_TIMEOUT(this->Window->GetTrouble().contains("180 degrees"), 60000);
  }

  // Nothing is overwritten without a question, whatever the name lacks.
  void asksBeforeItOverwrites()
  {
    this->Open({ this->WriteScene() });
    for (const char* name :
      { "taken.png", "taken.json", "taken.exr", "taken.glb", "v1.2.png", "LOUD.PNG" })
    {
      this->WriteText(name, "mine");
    }
    struct
    {
      const char *Action, *Typed, *Asked;
    } const rows[] = { { "savePicture", "taken", "taken.png" },
      { "saveSession", "taken", "taken.json" }, { "saveLayers", "taken", "taken.exr" },
      { "exportGltf", "taken", "taken.glb" }, { "savePicture", "v1.2", "v1.2.png" },
      { "savePicture", "LOUD.PNG", "LOUD.PNG" } };
    for (const auto& row : rows)
    {
      QString question, folder;
      bool typed = false;
      QTimer answer;
      QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
        QWidget* asking = QApplication::activeModalWidget();
        if (auto* box = qobject_cast<QMessageBox*>(asking))
        {
          question = box->text();
          box->button(QMessageBox::No)->click();
        }
        else if (auto* dialog = qobject_cast<QFileDialog*>(asking))
        {
          folder = typed ? folder : dialog->directory().absolutePath();
          dialog->findChild<QLineEdit*>()->setText(QString::fromStdString(this->Path(row.Typed)));
          const bool again = typed;
          typed = true;
          again ? dialog->reject()
                : void(QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection));
        }
      });
      answer.start(50);
      this->Window->findChild<QAction*>(row.Action)->trigger();
      QVERIFY2(question.contains(row.Asked), qPrintable(row.Typed + (": " + question)));
      // That of the file which is shown.
      QCOMPARE(folder, QFileInfo(QString::fromStdString(this->Path("scene.vtp"))).absolutePath());
      QFile file(QString::fromStdString(this->Path(row.Asked)));
      QVERIFY(file.open(QIODevice::ReadOnly));
      QCOMPARE(file.readAll(), QByteArray("mine"));
    }
  }

  // Width and height of pictures keep their ratio until they are unlinked.
  void linksWidthAndHeight()
  {
    this->Open({ this->WriteScene() });
    const double ratio =
      static_cast<double>(this->Window->GetView()->width()) / this->Window->GetView()->height();
    std::vector<int> found;
    const viewerTest::Dialogs dialogs([&](QDialog* dialog) {
      auto* width = dialog->findChild<QSpinBox*>("width");
      auto* height = dialog->findChild<QSpinBox*>("height");
      auto* linked = dialog->findChild<QCheckBox*>("linked");
      width->setValue(1000);
      found.push_back(height->value());
      width->setValue(3);
      height->setValue(2000); // the ratio is not that of small numbers
      found.push_back(width->value());
      linked->setChecked(false);
      width->setValue(500);
      found.push_back(height->value());
      linked->setChecked(true);
      height->setValue(1000);
      found.push_back(width->value());
      auto* sizes = dialog->findChild<QComboBox*>("sizes");
      sizes->setCurrentIndex(sizes->findData(QSize(1920, 1080)));
      width->setValue(960);
      found.push_back(height->value());
      linked->setChecked(false);
      width->setValue(200);
      height->setValue(800);
      linked->setChecked(true);
      width->setValue(scene::LargestSize);
      found.push_back(width->value());
      found.push_back(height->value());
      dialog->reject();
    });
    this->Window->findChild<QAction*>("savePicture")->trigger();
    QCOMPARE(found,
      (std::vector<int>{ static_cast<int>(std::lround(1000 / ratio)),
        static_cast<int>(std::lround(2000 * ratio)), 2000, 250, 540, scene::LargestSize / 4,
        scene::LargestSize }));
  }

  // The exported scene is the command's, with the view's camera, and the picture stays.
  void exportsGltf()
  {
    this->Open({ this->WriteScene(), "--color-by", "height", "--preset", "studio" });
    this->Window->GetView()->GetPicture().LookAlong({ -1.0, -0.5, 0.0 }, { 0.0, 1.0, 0.0 });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    this->Window->ExportGltf(QString::fromStdString(this->Path("shown.glb")));
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    QVERIFY(
      this->RunCommand(this->Window->GetViewSettings(), { "--gltf", this->Path("command.glb") }));
    QByteArray bytes[2];
    for (const auto& [name, i] : { std::pair("shown.glb", 0), std::pair("command.glb", 1) })
    {
      QFile file(QString::fromStdString(this->Path(name)));
      QVERIFY(file.open(QIODevice::ReadOnly));
      bytes[i] = file.readAll();
    }
    QVERIFY(bytes[0].startsWith("glTF") && bytes[0] == bytes[1]);
    QVERIFY_EXCEPTION_THROWN(
      this->Window->ExportGltf(QString::fromStdString(this->Path("no/folder.glb"))),
      std::exception);
  }

  // Outputs replace no file of the scene, and notes name no option.
  void keepsInputs()
  {
    const std::string image = this->WriteImage();
    const std::string scene = this->WriteScene();
    this->Open({ scene, "--environment", image, "--light", "point:1,3,1.5" });
    const auto read = [](const std::string& path) {
      QFile file(QString::fromStdString(path));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray before[] = { read(scene), read(image) };
    viewer::PictureChoice picture;
    picture.Path = QString::fromStdString(image);
    QVERIFY_EXCEPTION_THROWN(this->Window->SavePicture(picture), words::UsageError);
    QVERIFY_EXCEPTION_THROWN(
      this->Window->ExportGltf(QString::fromStdString(scene)), words::UsageError);
    QVERIFY(!before[0].isEmpty() && read(scene) == before[0] && read(image) == before[1]);
    this->Window->ExportGltf(QString::fromStdString(this->Path("noted.glb")));
    const QString said = this->Window->findChild<QLabel*>("words")->text();
    QVERIFY2(said.contains("noted.glb; glTF: "), qPrintable(said));
    // Messages belong to the reader while there is one.
    auto* action = this->Window->findChild<QAction*>("exportGltf");
    QVERIFY(action->isEnabled());
    this->Window->Reload();
    QVERIFY(!action->isEnabled());
    this->WaitUntilRead();
    QVERIFY(action->isEnabled());
  }

  // The view keeps its picture while one of another size is drawn.
  void viewWhileSaving()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--stage", "shadows:map_size=256" });
    viewer::PictureView* view = this->Window->GetView();
    const auto look = [&] { // at the screen, in the view's middle
      this->Window->repaint();
      QTest::qWait(50);
      const QPoint place = view->mapTo(this->Window.get(), view->rect().center());
      return this->Window->screen()
        ->grabWindow(this->Window->winId(), place.x() - 40, place.y() - 40, 80, 80)
        .toImage();
    };
    const auto rest = [&] {
      QSignalSpy drawn(view, &viewer::PictureView::drawn);
      view->Draw();
      QVERIFY(drawn.wait(60000));
      QTRY_COMPARE_WITH_TIMEOUT(view->GetPicture().GetFrame()->GetSamplesLeft(), 0, 60000);
      QTest::qWait(100);
    };
    rest();
    const QImage before = look();
    {
      const viewer::PictureView::OtherSize sized(view, QSize(90, 400));
      view->renderWindow()->Render();
      QCOMPARE(look(), before);
    }
    rest();
    QCOMPARE(look(), before);
  }

  // Edits that no session has do not go with the window, unless the user says so.
  void asksBeforeItQuits()
  {
    this->Open({ this->WriteScene(), "--edges" });
    const auto edit = [this](const char* opacity) {
      this->Change([opacity](scene::Settings& settings) { settings.Set("--opacity", opacity); });
    };
    const auto close = [this](QMessageBox::StandardButton answer) {
      const viewerTest::Dialogs dialogs([this, answer](QDialog* dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(dialog))
        {
          box->button(answer)->click();
        }
        else
        {
          const QString place = QString::fromStdString(this->Path("kept.json"));
          dialog->findChild<QLineEdit*>()->setText(place);
          QMetaObject::invokeMethod(dialog, "accept");
        }
      });
      this->Window->close();
      return dialogs.GetCount();
    };
    const auto show = [this] {
      QVERIFY(!this->Window->isVisible());
      this->Window->show();
    };
    // Nothing was edited: the camera, files and moments are no edits.
    this->Window->GetView()->GetPicture().LookAlong({ -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    QCOMPARE(close(QMessageBox::Cancel), 0);
    show();
    this->Window->OpenFiles({ QString::fromStdString(this->WriteOBJ()) });
    this->WaitUntilRead();
    QCOMPARE(close(QMessageBox::Cancel), 0);
    show();
    edit("0.5");
    QCOMPARE(close(QMessageBox::Cancel), 1);
    QVERIFY(this->Window->isVisible());
    this->Window->OpenFiles({ QString::fromStdString(this->WriteScene()) });
    this->WaitUntilRead();
    QCOMPARE(close(QMessageBox::Cancel), 1); // it is as it was
    edit("1");
    this->Change([](scene::Settings& settings) { settings.Remove("--opacity"); });
    QCOMPARE(close(QMessageBox::Cancel), 0);
    show();
    edit("0.25");
    QCOMPARE(close(QMessageBox::Save), 2);
    show();
    QVERIFY(QFileInfo::exists(QString::fromStdString(this->Path("kept.json"))));
    QCOMPARE(close(QMessageBox::Cancel), 0);
    show();
    edit("0.5");
    QCOMPARE(close(QMessageBox::Discard), 1);
    show();
    edit("0.25"); // as the session has it
    QCOMPARE(close(QMessageBox::Cancel), 0);
    show();
    this->Window->findChild<viewer::PathGroup*>()->Add({ { 0, 0, 7 }, { 0, 0, 0 }, { 0, 1, 0 } });
    QCOMPARE(close(QMessageBox::Cancel), 1);
  }

  // A picture that lights a scene is no scene: who opens one is told where it is taken.
  void environmentIsNoScene()
  {
    this->Open({ this->WriteScene() });
    for (const char* name : { "sky.exr", "sky.HDR" })
    {
      this->WriteText(name, "light");
      this->Window->OpenFiles({ QString::fromStdString(this->Path(name)) });
      this->WaitUntilRead();
      QVERIFY2(this->Window->GetTrouble().contains(QString::fromUtf8("“Environment” in Light")),
        qPrintable(this->Window->GetTrouble()));
    }
  }

  // Another file begins a new scene: the look and suns stay, and settings of the previous file are
  // dropped. Undo restores them, with the camera.
  void anotherFile()
  {
    const std::string scene = this->WriteScene(), plain = this->WriteOBJ();
    const std::string camera = "2,3,4,0,0.5,0,0,1,0";
    this->Open({ scene, "--preset", "town", "--edges", "--light", "sun:0.4,1,0.6", "--light",
      "spot:2,5,2,0,0,0,30", "--lamps", this->WritePoints(), "--color-by", "height", "--up", "y",
      "--stage", "display:layer=height", "--camera", camera });
    viewer::Document* document = this->Window->GetDocument();
    document->Change([](scene::Settings& settings) { settings.Set("--opacity", "0.5"); });
    const scene::Settings before = document->Get();
    this->Window->OpenFiles({ QString::fromStdString(plain) });
    this->WaitUntilRead();
    QCOMPARE(this->Window->GetTrouble(), QString());
    const std::vector<std::string> left = { "--preset", "town", "--opacity", "0.5", "--edges",
      "--light", "sun:0.4,1,0.6", plain };
    QCOMPARE(document->Get().GetWords(), left);
    QVERIFY(this->Window->GetViewSettings().Get("--camera") != camera);
    const QString says = this->Window->findChild<QLabel*>("words")->text();
    for (const char* what :
      { "a light", "lamps", "the colours", "the up axis", "the layer", "Undo" })
    {
      QVERIFY2(says.contains(what), qPrintable(says));
    }
    const std::string other = this->Window->GetViewSettings().Get("--camera");
    document->Undo();
    this->WaitUntilRead();
    QVERIFY(document->Get() == before);
    QCOMPARE(this->Window->GetViewSettings().Get("--camera"), camera);
    document->Undo();
    QVERIFY(document->Get() != before);
    QCOMPARE(document->Get().Files, std::vector<std::string>{ scene });
    QVERIFY(!document->CanUndo());
    document->Redo();
    document->Redo();
    this->WaitUntilRead();
    QCOMPARE(document->Get().GetWords(), left);
    QCOMPARE(this->Window->GetViewSettings().Get("--camera"), other);
    // Files that are taken away come back, too.
    document->Change([](scene::Settings& settings) { settings.Files.clear(); });
    QVERIFY(this->Window->GetView()->GetPicture().IsEmpty());
    document->Undo();
    this->WaitUntilRead();
    QCOMPARE(document->Get().GetWords(), left);
    QCOMPARE(this->Window->GetViewSettings().Get("--camera"), other);
    // Colours by an array stay where the next file has it, and are no edit of their own.
    this->Open({ scene, "--color-by", "height", "--range", "0,0.5", "--scalar-bar" });
    document = this->Window->GetDocument();
    const std::string same = this->WriteScene("same.vtp");
    this->Window->OpenFiles({ QString::fromStdString(same) });
    this->WaitUntilRead();
    QCOMPARE(document->Get().GetWords(),
      (std::vector<std::string>{
        "--color-by", "height", "--range", "0,0.5", "--scalar-bar", same }));
    this->Compare("colours that stay");
    document->Undo();
    this->WaitUntilRead();
    QCOMPARE(document->Get().Files, std::vector<std::string>{ scene });
    QCOMPARE(document->Get().Get("--color-by"), std::string("height"));
    QVERIFY(!document->CanUndo());
    // Others that were chosen while it was read stay; nothing kept comes back later.
    this->Window->OpenFiles({ QString::fromStdString(same) });
    document->Change([](scene::Settings& settings) { settings.Set("--color", "red"); });
    this->WaitUntilRead();
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(document->Get().GetWords(), (std::vector<std::string>{ "--color", "red", same }));
    this->Compare("a colour that was chosen meanwhile");
    // Undone before it was read, with the camera as it was.
    this->Window->OpenFiles({ QString::fromStdString(plain) });
    document->Undo();
    this->WaitUntilRead();
    QCOMPARE(document->Get().GetWords(), (std::vector<std::string>{ "--color", "red", same }));
    document->Change([](scene::Settings& settings) { settings.Set("--up", "z"); });
    this->WaitUntilRead();
    QVERIFY(!this->Window->findChild<QLabel*>("words")->text().contains("Gone with"));
  }

  void recentFiles()
  {
    QSettings().clear();
    this->Open({ this->WriteScene() });
    const QString other = QString::fromStdString(this->WriteScene("other.vtp"));
    const QString third = QString::fromStdString(this->WriteScene("third.vtp"));
    for (const QString& path : { other, third })
    {
      this->Window->OpenFiles({ path });
      this->WaitUntilRead();
    }
    const std::string scene = this->Path("scene.vtp");
    this->Open({ scene }); // another window has the list too
    QAction* found = nullptr;
    for (QMenu* menu : this->Window->findChildren<QMenu*>())
    {
      for (QAction* action : menu->actions())
      {
        found = action->text().contains("other.vtp") ? action : found;
      }
    }
    QVERIFY(found);
    QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
    found->trigger();
    QVERIFY(ready.wait(60000));
    QCOMPARE(
      this->Window->GetDocument()->Get().Files, std::vector<std::string>{ other.toStdString() });
  }

  // The saved file equals the layers, number by number.
  void savesLayers()
  {
    this->Open({ this->WriteScene(), "--shadows", "map", "--light", "sun:0.4,1,0.6" });
    this->Grab();
    const std::vector<std::string> layers = { "color", "depth", "normal", "cell" };
    this->Window->SaveLayers({ QString::fromStdString(this->Path("saved.exr")), {}, layers });
    vtkNew<vtkRelievoEXRReader> reader;
    reader->SetFileName(this->Path("saved.exr").c_str());
    reader->Update();
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(this->Window->GetView()->GetPicture().GetRenderer());
    for (const std::string& layer : layers)
    {
      source->AddLayer(layer);
    }
    source->Update();
    for (const char* layer : { "depth", "normal", "cell" })
    {
      vtkDataArray* saved = reader->GetOutput()->GetPointData()->GetArray(layer);
      vtkDataArray* held = source->GetOutput()->GetPointData()->GetArray(layer);
      QVERIFY2(saved && held, layer);
      QCOMPARE(saved->GetNumberOfTuples(), held->GetNumberOfTuples());
      int different = 0, finite = 0;
      for (vtkIdType i = 0; i < held->GetNumberOfTuples(); ++i)
      {
        for (int k = 0; k < held->GetNumberOfComponents(); ++k)
        {
          const double a = saved->GetComponent(i, k), b = held->GetComponent(i, k);
          different += a != b && !(std::isnan(a) && std::isnan(b));
          finite += std::isfinite(b);
        }
      }
      QCOMPARE(different, 0);
      QVERIFY(finite > 1000);
    }
  }

  // The scene is drawn with the size and the camera of the baseline, and the view stays as it is.
  void comparesWithABaseline()
  {
    const auto writePart = [this](const char* x, const char* farX) {
      const std::string left = std::string("\nv ") + x, right = std::string("\nv ") + farX;
      this->WriteText("part.obj",
        left + " 0.2 1.2" + right + " 0.2 1.2" + right + " 0.7 1.2" + left +
          " 0.7 1.2\nf 1 2 3 4\n");
    };
    const std::string base = this->Path("base.exr");
    writePart("0", "0.5");
    this->Open({ this->WriteScene(), this->Path("part.obj"), "--light", "sun:0.4,1,0.6,name=noon",
      "--shadows", "map", "--view-angle", "40", "--color-by", "height", "--scalar-bar" });
    auto* dock = this->Window->findChild<QDockWidget*>("comparison");
    QVERIFY(dock->isHidden());
    dock->show(); // a further tab makes the view narrower
    QTest::qWait(50);
    const vtkSmartPointer<vtkImageData> picture = this->Grab();
    const Settings view = this->Window->GetViewSettings();
    Settings other = view;
    other.Set("--size", "240x160");
    other.Set("--camera", "1,2,5,0,0.5,0,0,1,0");
    other.Remove("--view-angle");
    QVERIFY(this->RunCommand(other, { "--baseline", base }));
    this->Window->CompareWith(QString::fromStdString(base));
    auto* panel = this->Window->findChild<viewer::ComparisonPanel*>();
    QVERIFY2(panel->GetComparison()->GetAlike(), panel->GetComparison()->GetText().c_str());
    QVERIFY(!dock->isHidden() && !dock->visibleRegion().isEmpty());
    QVERIFY(this->Window->GetViewSettings() == view);
    QCOMPARE(CountDifferent(picture, this->Grab()), 0);

    writePart("0.125", "0.625");
    this->Window->Reload();
    this->WaitUntilRead();
    this->Change(
      [](Settings& settings) { settings.Set("--light", "sun:0.4,1,0.6,name=noon,intensity=0.5"); });
    QVERIFY(panel->GetComparison()->GetAlike()); // not compared yet
    QVERIFY(!panel->findChild<QLabel*>("comparisonOutdated")->isHidden());
    panel->findChild<QPushButton*>("compareAgain")->click();
    QVERIFY(panel->findChild<QLabel*>("comparisonOutdated")->isHidden());
    auto* table = panel->findChild<QTableWidget*>("causes");
    auto* shown = panel->findChild<viewer::ComparisonView*>();
    const auto find = [&](const QString& object) {
      const QList<QTableWidgetItem*> items = table->findItems(object, Qt::MatchExactly);
      return items.isEmpty() ? -1 : items.first()->row();
    };
    const int moved = find("part.obj (actor 1)");
    const int light = find("noon (light 0)");
    QVERIFY2(moved >= 0 && light >= 0, panel->GetComparison()->GetText().c_str());
    QVERIFY2(table->item(moved, 1)->text().startsWith("moved by (0.125, 0, 0)"),
      qPrintable(table->item(moved, 1)->text()));
    const auto count = [&](int row) { return QLocale().toInt(table->item(row, 2)->text()); };
    const QColor ofMoved("#f5a00b"), ofLight("#ffc9a3"); // compare/page/report.html
    QVERIFY(count(moved) > 100 && count(light) > 1000);
    QCOMPARE(CountPixels(shown->GetImage(), ofMoved), count(moved));
    QCOMPARE(CountPixels(shown->GetImage(), ofLight), count(light));
    // A click shows the row's pixels alone, another one all again; a light is chosen in its list.
    const auto click = [&](int row) {
      const QRect cell = table->visualItemRect(table->item(row, 2));
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell.center());
    };
    click(moved);
    QCOMPARE(CountPixels(shown->GetImage(), ofMoved), count(moved));
    QCOMPARE(CountPixels(shown->GetImage(), ofLight), 0);
    click(moved);
    QCOMPARE(CountPixels(shown->GetImage(), ofLight), count(light));
    auto* lights = this->Window->findChild<QTreeWidget*>("list");
    lights->setCurrentItem(nullptr);
    click(light);
    QVERIFY(lights->currentItem() && lights->currentItem()->text(0) == "noon");
    click(light);
    // A held key shows the baseline in place of the causes.
    const QImage causes = shown->GetImage();
    QTest::keyPress(table, Qt::Key_B);
    const QImage held = shown->GetImage();
    QTest::keyRelease(table, Qt::Key_B);
    QVERIFY(shown->GetImage() == causes);
    panel->findChild<QRadioButton*>("showBaseline")->click();
    QVERIFY(held != causes && held == shown->GetImage());
    panel->findChild<QRadioButton*>("showNow")->click();
    QVERIFY(shown->GetImage() != held);

    const QString page = QString::fromStdString(this->Path("report.html"));
    this->Window->SaveReport(page);
    QFile file(page);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("moved by (0.125, 0, 0)") && text.contains("\"moved\":\"#f5a00b\""));
  }

  // A picture has the camera of the view, and its samples. A file that cannot be read is reported
  // once.
  void comparesWithAPicture()
  {
    this->Open(
      { this->WriteScene(), "--light", "sun:0.4,1,0.6", "--stage", "antialias:samples=4" });
    QVERIFY_EXCEPTION_THROWN(this->Window->SaveReport("none.html"), words::WorkError);
    auto* action = this->Window->findChild<QAction*>("compareWith");
    for (const char* name : { "broken.exr", "broken.png" })
    {
      this->WriteText(name, "v/1");
      const viewerTest::Dialogs dialogs([&](QDialog* dialog) {
        dialog->findChild<QLineEdit*>()->setText(QString::fromStdString(this->Path(name)));
        QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
      });
      action->trigger();
      QCOMPARE(dialogs.GetCount(), 1);
      QVERIFY2(this->Window->GetTrouble().count(name) == 1, qPrintable(this->Window->GetTrouble()));
      QVERIFY(this->Window->findChild<QDockWidget*>("comparison")->isHidden());
    }
    const QString png = QString::fromStdString(this->Path("picture.png"));
    this->Window->SavePicture({ png, QSize(320, 200), false });
    this->Window->CompareWith(png);
    QVERIFY2(this->Window->GetTrouble().isEmpty(), qPrintable(this->Window->GetTrouble()));
    auto* panel = this->Window->findChild<viewer::ComparisonPanel*>();
    QVERIFY2(panel->GetComparison()->GetAlike(), panel->GetComparison()->GetText().c_str());
    QVERIFY(panel->findChild<QLabel*>("comparisonNotes")->text().contains("moved"));
    // Pixels within the limits have their colours only when chosen.
    vtkNew<vtkImageData> frame, causes;
    frame->SetDimensions(4, 1, 1);
    frame->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    frame->GetPointData()->GetScalars()->Fill(0.);
    causes->SetDimensions(4, 1, 1);
    causes->AllocateScalars(VTK_INT, 1);
    std::map<int, QColor> colors;
    for (const int cause :
      { -1, viewer::ComparisonView::Rounding, viewer::ComparisonView::Edge, 0 })
    {
      causes->SetScalarComponentFromDouble(static_cast<int>(colors.size()), 0, 0, 0, cause);
      colors[cause] = QColor(10 - 10 * cause, 0, 0);
    }
    colors.erase(-1);
    auto* view = panel->findChild<viewer::ComparisonView*>();
    view->SetFrames(frame, frame, causes, colors);
    view->SetKind(viewer::ComparisonView::CAUSES);
    const auto red = [&] {
      const QImage image = view->GetImage();
      return QVector<int>{ qRed(image.pixel(1, 0)), qRed(image.pixel(2, 0)),
        qRed(image.pixel(3, 0)) };
    };
    QCOMPARE(red(), (QVector<int>{ 0, 0, 10 }));
    view->Choose(viewer::ComparisonView::Rounding);
    QCOMPARE(red(), (QVector<int>{ 30, 0, 0 }));
    // Another camera is seen in the colours alone.
    this->Window->GetView()->GetPicture().LookAlong({ 0., -1., 0. }, { 0., 0., -1. });
    this->Window->CompareWith(png);
    QVERIFY(panel->GetComparison()->GetNumberOfDifferentPixels() > 1000);
  }
};

RELIEVO_TEST_CASE_APART(testViewerFiles)
{
  TestViewerFiles tests;
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerFiles.moc"
