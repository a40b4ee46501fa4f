// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture of every switch equals that of the command line, byte for byte; so does the picture
// after it is switched off again.
#include "TestCase.h"
#include "ViewerTest.h"

#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QProgressDialog>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

#include <utility>

namespace testViewerPictures
{
using scene::Settings;

class TestViewerPictures : public viewerTest::ViewerTest
{
  Q_OBJECT

private Q_SLOTS:
  // On at a window that shows the scene plainly, and off again.
  void switches()
  {
    const std::pair<const char*, QStringList> rows[] = {
      { "plain", {} },
      { "shadows", { "--shadows", "map" } },
      { "exact shadows", { "--shadows", "exact" } },
      { "soft shadows", { "--shadows", "map", "--soft-shadows", "8" } },
      { "tone", { "--tone", "reinhard,white=2", "--exposure", "1" } },
      { "deferred", { "--deferred" } },
      { "layer", { "--stage", "display:layer=depth" } },
      { "array as layer", { "--stage", "display:layer=height" } },
      { "look", { "--color-by", "height", "--scalar-bar", "--edges", "--background", "white" } },
      { "opacity", { "--color", "#3366cc", "--opacity", "0.5" } },
      { "shading", { "--shading", "pbr" } },
      { "flat", { "--shading", "flat" } },
      { "preset", { "--preset", "town" } },
      { "preset without shadows", { "--preset", "studio", "--shadows", "off" } },
      { "lamps", { "--lamps", "POINTS,intensity=2" } },
      { "fog", { "--fog", "POINTS,density=0.8,color=0.6/0.7/0.8" } },
      { "fog by chords", { "--fog", "POINTS,density=0.8,mode=chord", "--tone", "simple" } },
      { "environment", { "--environment", "IMAGE,30", "--reflectivity", "0.4,0.3" } },
      { "sky", { "--environment", "IMAGE", "--skybox", "--shadows", "map" } },
      { "normal map", { "--normal-map", "IMAGE", "--texture-coordinates", "sphere" } },
      { "height map", { "--height-map", "IMAGE,0.1", "--shadows", "map", "--shadow-size", "512" } },
      { "blend", { "--opacity", "0.5", "--lamps", "POINTS", "--fog", "POINTS" } },
      { "markers", { "--markers", "POINTS,shape=ring,radius=0.4" } },
      { "up", { "--preset", "town", "--up", "z" } },
      { "parallel", { "--parallel-scale", "1.2" } },
      { "two lights", { "--light", "sun:1,1,1", "--light", "point:-2,2,1", "--shadows", "map" } },
    };
    const std::string scene = this->WriteScene();
    const QString points = QString::fromStdString(this->WritePoints());
    const QString image = QString::fromStdString(this->WriteImage());
    this->Open({ scene, "--light", "sun:0.4,1,0.6" });
    const vtkSmartPointer<vtkImageData> plain = this->Grab();
    const scene::Settings before = this->Window->GetDocument()->Get();
    for (const auto& [name, words] : rows)
    {
      std::vector<std::string> own = { scene };
      if (!words.contains("--light") && !words.contains("--preset"))
      {
        own.insert(own.end(), { "--light", "sun:0.4,1,0.6" });
      }
      for (QString word : words)
      {
        own.push_back(word.replace("POINTS", points).replace("IMAGE", image).toStdString());
      }
      scene::Settings wanted = scene::Settings::FromWords(own);
      wanted.Remove("--parallel-scale"); // which is the camera's
      this->Window->GetView()->GetPicture().SetParallel(words.contains("--parallel-scale"));
      this->Window->GetDocument()->Set(wanted);
      this->WaitUntilRead();
      QVERIFY2(this->Window->GetTrouble().isEmpty(), name);
      this->Compare(name);
      QVERIFY2(words.isEmpty() || CountDifferent(this->Grab(), plain) != 0, name);
      this->Window->GetView()->GetPicture().SetParallel(false);
      this->Window->GetDocument()->Set(before);
      this->WaitUntilRead();
      QVERIFY2(CountDifferent(this->Grab(), plain) == 0, name);
    }
  }

  void opensWithTheWords()
  {
    this->Open({ this->WriteScene(), "--camera", "2,2,4,0,0.5,0,0,1,0", "--view-angle", "40",
      "--light", "spot:2,4,2,0,0,0,25", "--shadows", "warped", "--tone", "simple" });
    this->Compare("words");
  }

  // Many samples are gathered while the user sees how far it is, and may end it.
  void savesSoftShadows()
  {
    this->Open({ this->WriteScene(), "--light", "point:1,3,1.5,size=0.4", "--shadows", "map",
      "--soft-shadows", "4096" });
    const QString png = QString::fromStdString(this->Path("soft.png"));
    int seen = 0, most = 0;
    QTimer cancel;
    QObject::connect(&cancel, &QTimer::timeout, &cancel, [&] {
      if (auto* dialog = this->Window->findChild<QProgressDialog*>())
      {
        ++seen;
        most = dialog->maximum();
        QSignalSpy ready(this->Window.get(), &viewer::MainWindow::ready);
        this->Window->OpenFiles({ QString::fromStdString(this->Path("missing.vtp")) });
        QVERIFY(!ready.wait(200)); // not before the picture is saved, or not
        dialog->cancel();
      }
    });
    cancel.start(30);
    this->Window->SavePicture({ png, {} });
    cancel.stop();
    QVERIFY(seen > 0 && most == 100 && !QFile::exists(png)); // percent
    QCOMPARE(
      this->Window->findChild<QLabel*>("words")->text(), QString("Stopped: nothing was saved."));
    QTRY_VERIFY_WITH_TIMEOUT(this->Window->GetTrouble().contains("missing.vtp"), 20000);
    this->Change(
      [](scene::Settings& settings) { settings.SetParameter("shadows", "soft_samples", "24"); });
    this->Window->SavePicture({ png, {} });
    QVERIFY(this->RenderCommand());
    QFile saved(png), made(QString::fromStdString(this->Path("command.png")));
    QVERIFY(saved.open(QIODevice::ReadOnly) && made.open(QIODevice::ReadOnly));
    QCOMPARE(saved.readAll(), made.readAll());
  }

  void afterTheMouse()
  {
    this->Open({ this->WriteScene(), "--shadows", "map", "--light", "sun:0.4,1,0.6" });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const QPoint middle = this->Window->GetView()->rect().center();
    const QPoint aside = middle + QPoint(40, 25);
    this->SendMouse(QEvent::MouseButtonPress, middle, Qt::LeftButton);
    this->SendMouse(QEvent::MouseMove, aside, Qt::LeftButton);
    this->SendMouse(QEvent::MouseButtonRelease, aside, Qt::NoButton);
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    this->Compare("orbit");
  }
};

RELIEVO_TEST_CASE_APART(testViewerPictures)
{
  TestViewerPictures tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerPictures.moc"
