// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stages of points, and the values of their points, by the controls.
#include "TestCase.h"
#include "ViewerTest.h"

#include "ColorButton.h"
#include "LinearColor.h"

#include "vtkRenderer.h"

#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QtTest>

namespace testViewerPoints
{
using scene::Settings;
using Words = std::vector<std::string>;

class TestViewerPoints : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  QGroupBox* Group(const char* stage) { return this->Window->findChild<QGroupBox*>(stage); }

  template <typename Widget>
  Widget* Find(const char* stage, const char* name)
  {
    auto* found = this->Group(stage)->findChild<QWidget*>(name);
    auto* self = qobject_cast<Widget*>(found);
    return self ? self : found->findChild<Widget*>();
  }

  // Types a text into a field, as the user does.
  void Type(const char* stage, const char* name, const QString& text)
  {
    auto* box = this->Find<QComboBox>(stage, name);
    box->setEditText(text);
    Q_EMIT box->lineEdit()->editingFinished();
    this->WaitUntilRead();
  }

  void Choose(const char* stage, const char* name, const QString& text)
  {
    auto* box = this->Find<QComboBox>(stage, name);
    box->setCurrentIndex(box->findText(text));
    Q_EMIT box->activated(box->currentIndex());
    this->WaitUntilRead();
  }

  Words Get(const char* option) { return this->Window->GetDocument()->Get().GetAll(option); }

private Q_SLOTS:
  void values()
  {
    const std::string points = this->WritePoints();
    this->Open({ this->WriteScene(), "--lamps", points, "--lamps", points + ",intensity=0.5" });
    auto* files = this->Find<QListWidget>("lamps", "files");
    QCOMPARE(files->count(), 2);
    QCOMPARE(files->item(1)->text(), QString("points.vtp"));
    QCOMPARE(this->Find<QComboBox>("lamps", "intensity")->currentText(), QString());
    QCOMPARE(this->Find<QComboBox>("lamps", "casts")->currentText(), QString());
    files->setCurrentRow(1);
    QCOMPARE(this->Find<QComboBox>("lamps", "intensity")->currentText(), QString("0.5"));
    QVERIFY(this->Find<QComboBox>("lamps", "radius")->findText("radius") >= 0); // an array of it
    const vtkSmartPointer<vtkRenderer> scene = this->Window->GetView()->GetPicture().GetRenderer();
    this->Type("lamps", "intensity", "2");
    QVERIFY(scene == this->Window->GetView()->GetPicture().GetRenderer()); // is not read again
    this->Choose("lamps", "radius", "radius");
    QCOMPARE(this->Get("--lamps"), (Words{ points, points + ",intensity=2,radius=radius" }));
    QCOMPARE(files->currentRow(), 1);
    QVERIFY(!this->Find<QComboBox>("lamps", "attenuation")->isEnabled());
    this->Choose("lamps", "falloff", "vtk");
    this->Type("lamps", "attenuation", "1/0.5/0.1");
    QCOMPARE(this->Get("--lamps")[1],
      points + ",intensity=2,radius=radius,falloff=vtk,attenuation=1/0.5/0.1");
    this->Compare("lamps");
    this->Choose("lamps", "falloff", "linear");
    this->Type("lamps", "intensity", "");
    QCOMPARE(this->Get("--lamps"), (Words{ points, points + ",radius=radius" }));
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->Type("lamps", "radius", "-1");
    QVERIFY(this->Window->GetTrouble().contains("radius"));
    QCOMPARE(this->Find<QComboBox>("lamps", "radius")->currentText(), QString("radius"));
    this->Find<QPushButton>("lamps", "remove")->click();
    this->WaitUntilRead();
    QCOMPARE(this->Get("--lamps"), Words{ points });
  }

  // From a file and from an array.
  void commas()
  {
    const std::string points = this->WritePoints("a,b.vtp", "wide,\\1");
    QString word = QString::fromStdString(points).replace(",", "\\,");
    this->Open({ this->WriteScene(), "--lamps", word.toStdString() });
    QCOMPARE(this->Find<QListWidget>("lamps", "files")->item(0)->text(), QString("a,b.vtp"));
    this->Choose("lamps", "radius", "wide,\\1");
    QCOMPARE(this->Window->GetTrouble(), QString());
    word += ",radius=wide\\,\\\\1";
    QCOMPARE(this->Get("--lamps"), Words{ word.toStdString() });
    this->Type("lamps", "intensity", "0.7");
    QCOMPARE(this->Get("--lamps"), Words{ word.toStdString() + ",intensity=0.7" });
    this->Compare("commas");
  }

  void colors()
  {
    const std::string points = this->WritePoints();
    this->Open({ this->WriteScene(), "--fog", points, "--markers", points });
    auto* button = this->Find<viewer::ColorButton>("fog", "color");
    Q_EMIT button->edited(QColor(255, 188, 0));
    this->WaitUntilRead();
    QCOMPARE(this->Get("--fog"), Words{ points + ",color=1/0.5029/0" }); // in linear light
    QCOMPARE(button->GetColor(), QColor(255, 188, 0));
    this->Type("fog", "density", "0.6");
    this->Choose("markers", "shape", "disc");
    this->Type("markers", "color", "0/1/0.25");
    QCOMPARE(this->Get("--markers"), Words{ points + ",shape=disc,color=0/1/0.25" });
    this->Compare("fog and markers");
    QCOMPARE(viewer::ReadLinearColor("tomato"), QColor("tomato"));
    for (int byte = 0; byte < 256; ++byte)
    {
      const QColor color(byte, 255 - byte, byte / 2);
      QCOMPARE(viewer::ReadLinearColor(viewer::WriteLinearColor(color)), color);
    }
  }

  // Switched on without a file, a group asks for one, and opens no dialog.
  void firstFile()
  {
    this->Open({ this->WriteScene() });
    const scene::Settings before = this->Window->GetDocument()->Get();
    for (const char* stage : { "lamps", "fog", "markers" })
    {
      const viewerTest::Dialogs dialogs;
      QGroupBox* group = this->Group(stage);
      group->setChecked(true);
      QCOMPARE(dialogs.GetCount(), 0);
      QVERIFY2(group->isChecked() && this->Window->GetDocument()->Get() == before, stage);
      auto* hint = group->findChild<QLabel*>("hint");
      QVERIFY2(!hint->isHidden() && hint->text().contains(stage), qPrintable(hint->text()));
      QVERIFY(this->Find<QPushButton>(stage, "add")->isEnabled());
      group->setChecked(false);
      QVERIFY(!group->isChecked());
      group->setChecked(true);
      const std::string option = std::string("--") + stage;
      this->Change(
        [&](scene::Settings& settings) { settings.SetAll(option, { this->WritePoints() }); });
      QVERIFY2(group->isChecked() && hint->isHidden(), stage);
      this->Window->GetDocument()->Undo();
      this->WaitUntilRead();
      QVERIFY2(!group->isChecked(), stage);
    }
  }

  // Off leaves no word behind, and on again is as it was.
  void offAndOn()
  {
    const std::string points = this->WritePoints();
    this->Open({ this->WriteScene(), "--lamps", points + ",radius=0.7", "--stage",
      "lamps:way=quads", "--stage", "tone:exposure=1,white=3" });
    const scene::Settings before = this->Window->GetDocument()->Get();
    for (const char* stage : { "lamps", "tone" })
    {
      this->Group(stage)->setChecked(false);
      this->WaitUntilRead();
      const scene::Settings& off = this->Window->GetDocument()->Get();
      QVERIFY2(!off.IsStageAsked(stage) && !off.Has(std::string("--") + stage), stage);
      this->Group(stage)->setChecked(true);
      this->WaitUntilRead();
      QVERIFY2(this->Window->GetDocument()->Get() == before, stage);
    }
    this->Find<QPushButton>("lamps", "remove")->click();
    this->WaitUntilRead();
    QVERIFY(!this->Window->GetDocument()->Get().IsStageAsked("lamps"));
    QVERIFY(!this->Group("lamps")->isChecked());
  }
};

RELIEVO_TEST_CASE_APART(testViewerPoints)
{
  TestViewerPoints tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerPoints.moc"
