// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The controls of lights: they write what was edited, and leave all other words as they are.
#include "ViewerTest.h"

#include "LightOptions.h"
#include "Number.h"
#include "ParameterEdit.h"
#include "Sun.h"
#include "SunGroup.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QtTest>

#include <cmath>

using scene::Settings;
using Words = std::vector<std::string>;

class TestViewerLight : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  Words GetLights() { return this->Window->GetDocument()->Get().GetAll("--light"); }

  QWidget* Find(const char* group, const char* name)
  {
    return this->Window->findChild<QGroupBox*>(group)->findChild<QWidget*>(name);
  }

  // Types a value into a field, as the user does.
  void Type(const char* group, const char* name, double value)
  {
    this->Find(group, name)->findChild<QDoubleSpinBox*>()->setValue(value);
  }

  double Shown(const char* group, const char* name)
  {
    return this->Find(group, name)->findChild<QDoubleSpinBox*>()->value();
  }

private Q_SLOTS:
  // A sun by date and place stands in the sky: its direction in the data follows the axis.
  void sunFollowsUp()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6,size=2" });
    auto* sun = this->Window->findChild<viewer::SunGroup*>("sun");
    viewer::SunTime time;
    time.Hour = 15.5;
    time.Latitude = 48.0;
    sun->SetTime(time, true);
    auto* up = static_cast<QComboBox*>(this->Find("scene", "up"));
    for (const int axis : { 2, 0, 1 })
    {
      up->setCurrentIndex(axis + 1); // behind that of the file
      this->WaitUntilRead();
      const std::array<double, 3> wanted =
        viewer::GetSunDirection(viewer::GetSunAngles(time), axis);
      QCOMPARE(
        this->Window->GetDocument()->Get().Get("--light"), viewer::WriteSun(wanted) + ",size=2");
    }
  }

  // Off and on again is as it was: other suns, sizes, and every digit.
  void severalSuns()
  {
    const Words lights = { "point:1,2,3,size=0.2", "sun:0.123456789,1,0.6,size=2", "sun:1,1,1" };
    this->Open(
      { this->WriteScene(), "--light", lights[0], "--light", lights[1], "--light", lights[2] });
    auto* sun = this->Window->findChild<viewer::SunGroup*>("sun");
    auto* text = this->Window->findChild<QPlainTextEdit*>("lights");
    QCOMPARE(text->toPlainText(), QString("point:1,2,3,size=0.2\nsun:1,1,1\n"));
    sun->setChecked(false);
    QCOMPARE(this->GetLights(), (Words{ lights[0], lights[2] }));
    QVERIFY(!sun->isChecked()); // though there is another sun
    QCOMPARE(text->toPlainText(), QString("point:1,2,3,size=0.2\nsun:1,1,1\n"));
    sun->setChecked(true);
    QCOMPARE(this->GetLights(), lights);
    // One angle is edited; the other is not rounded.
    const double elevation =
      viewer::GetSunAngles(scene::ParseLight(lights[1]).Position, 1).Elevation;
    this->Type("sun", "azimuth", -30.0);
    QCOMPARE(this->Shown("sun", "azimuth"), 330.0); // the same direction
    const Words after = this->GetLights();
    QCOMPARE(after.size(), std::size_t(3));
    QCOMPARE(after[0], lights[0]);
    QCOMPARE(after[2], lights[2]);
    QVERIFY(after[1].find(",size=2") != std::string::npos);
    const viewer::SunAngles angles = viewer::GetSunAngles(scene::ParseLight(after[1]).Position, 1);
    QVERIFY(std::abs(angles.Elevation - elevation) < 1e-12);
    QVERIFY(std::abs(angles.Azimuth - 330.0) < 1e-9);
    // The other sun is edited with the other lights, and all are in their places.
    text->setPlainText("point:1,2,3,size=0.2\nsun:0,1,0");
    this->Window->findChild<QPushButton*>("apply")->click();
    QCOMPARE(this->GetLights(), (Words{ lights[0], after[1], "sun:0,1,0" }));
  }

  // By date and place, and back to angles, which are then those of the date.
  void backToAngles()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    auto* by = static_cast<QComboBox*>(this->Find("sun", "by"));
    by->setCurrentIndex(1);
    const Words placed = this->GetLights();
    QVERIFY(placed != Words{ "sun:0.4,1,0.6" });
    by->setCurrentIndex(0);
    QCOMPARE(this->GetLights(), placed);
    const viewer::SunAngles angles = viewer::GetSunAngles(viewer::SunTime());
    QVERIFY(std::abs(this->Shown("sun", "azimuth") - angles.Azimuth) < 0.006);
    QVERIFY(std::abs(this->Shown("sun", "elevation") - angles.Elevation) < 0.006);
  }

  // Undoing and doing again bring back that the sun stood by date, with the time.
  void undoByDate()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    auto* by = static_cast<QComboBox*>(this->Find("sun", "by"));
    by->setCurrentIndex(1);
    const double noon = this->Shown("sun", "time");
    QTest::qWait(1100); // another edit
    this->Type("sun", "time", 9.5);
    viewer::Document* document = this->Window->GetDocument();
    document->Undo();
    QCOMPARE(by->currentIndex(), 1);
    QCOMPARE(this->Shown("sun", "time"), noon);
    document->Undo();
    QCOMPARE(by->currentIndex(), 0);
    document->Redo();
    document->Redo();
    QCOMPARE(by->currentIndex(), 1);
    QCOMPARE(this->Shown("sun", "time"), 9.5);
    // Chosen angles stay angles.
    by->setCurrentIndex(0);
    QTest::qWait(1100);
    this->Type("sun", "azimuth", 100.0);
    document->Undo();
    QCOMPARE(by->currentIndex(), 0);
  }

  // The panel says where the light comes from that no control shows, and what own lights change.
  void presetsLights()
  {
    const auto note = [this](const char* group) {
      auto* label = static_cast<QLabel*>(this->Find(group, "presetsLights"));
      return label->isHidden() || !label->isEnabled() ? QString() : label->text();
    };
    this->Open({ this->WriteScene(), "--preset", "studio" });
    QVERIFY(note("otherLights").contains("studio") && note("otherLights").contains("first light"));
    this->Window->findChild<QGroupBox*>("sun")->setChecked(true);
    QVERIFY(note("sun").contains("fill") && !note("sun").contains("first light is on"));
    this->Change([](scene::Settings& settings) { settings.Set("--preset", "none"); });
    QCOMPARE(note("sun"), QString());
    QCOMPARE(note("otherLights"), QString());
  }

  // A slider stands where its number is, also before it was ever moved.
  void sliderAndNumber()
  {
    relievoQt::Number edit(-90.0, 90.0, 1.0, 2);
    QCOMPARE(edit.findChild<QSlider*>()->value(), 90);
    edit.SetUnit("samples");
    edit.SetValue(1.0);
    auto* digits = edit.findChild<QDoubleSpinBox*>();
    QCOMPARE(digits->text(), QString("1 sample"));
    edit.SetValue(2.5);
    QCOMPARE(digits->text(), QString("2.5 samples"));
    edit.SetValue(1.0 / 3.0);
    QCOMPARE(edit.GetValue(), 1.0 / 3.0);
    relievoQt::Number clock(0.0, 24.0, 1.0 / 12.0, 6);
    clock.SetClock();
    clock.SetValue(15.25);
    digits = clock.findChild<QDoubleSpinBox*>();
    QCOMPARE(digits->text(), QString("15:15"));
    QTest::keyClick(digits, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(digits, "7:30");
    QTest::keyClick(digits, Qt::Key_Return);
    QCOMPARE(clock.GetValue(), 7.5);
  }

  void environment()
  {
    const std::string image = this->WriteImage() + ",400.25";
    this->Open(
      { this->WriteScene(), "--environment", image, "--reflectivity", "0.123456,0.3", "--skybox" });
    const auto get = [this](const char* option) {
      return this->Window->GetDocument()->Get().Get(option);
    };
    QCOMPARE(this->Shown("environment", "rotation"), 40.25);
    this->Type("environment", "roughness", 0.5);
    QCOMPARE(get("--environment"), image);
    QCOMPARE(get("--reflectivity"), std::string("0.123456,0.5"));
    Q_EMIT this->Window->findChild<viewer::ParameterEdit*>("irradiance_weight")->edited("0.5");
    QCOMPARE(get("--material"), std::string("irradiance_weight=0.5"));
    const scene::Settings before = this->Window->GetDocument()->Get();
    auto* group = this->Window->findChild<QGroupBox*>("environment");
    group->setChecked(false);
    for (const char* option : { "--environment", "--reflectivity", "--skybox", "--material" })
    {
      QVERIFY2(!this->Window->GetDocument()->Get().Has(option), option);
    }
    group->setChecked(true);
    QVERIFY(this->Window->GetDocument()->Get() == before);
    this->Type("environment", "rotation", -30.0);
    QCOMPARE(get("--environment"), this->Path("waves.png") + ",330");
    QCOMPARE(get("--reflectivity"), std::string("0.123456,0.5"));
    static_cast<QCheckBox*>(this->Find("environment", "sky"))->setChecked(false);
    QVERIFY(!this->Window->GetDocument()->Get().Has("--skybox"));
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->Compare("environment");
  }

  // What is typed stays until it is right, whatever else changes.
  void otherLights()
  {
    this->Open({ this->WriteScene(), "--light", "point:1,2,3" });
    auto* text = this->Window->findChild<QPlainTextEdit*>("lights");
    auto* wrong = this->Window->findChild<QLabel*>("wrong");
    auto* apply = this->Window->findChild<QPushButton*>("apply");
    QVERIFY(!apply->isEnabled());
    text->setPlainText("point:1,2\nspot:0,3,2,0,0,0,30");
    apply->click();
    QVERIFY(!wrong->isHidden());
    QVERIFY2(wrong->text().contains("1,2"), qPrintable(wrong->text()));
    this->Change([](scene::Settings& settings) { settings.Set("--edges", ""); });
    QCOMPARE(text->toPlainText(), QString("point:1,2\nspot:0,3,2,0,0,0,30"));
    QCOMPARE(this->GetLights(), Words{ "point:1,2,3" });
    text->setPlainText("point:1,2,4\nspot:0,3,2,0,0,0,30");
    apply->click();
    QVERIFY(wrong->isHidden() && !apply->isEnabled());
    QCOMPARE(this->GetLights(), (Words{ "point:1,2,4", "spot:0,3,2,0,0,0,30" }));
    text->setPlainText("nonsense");
    this->Window->findChild<QPushButton*>("revert")->click();
    QCOMPARE(text->toPlainText(), QString("point:1,2,4\nspot:0,3,2,0,0,0,30\n"));
  }
};

int main(int argc, char* argv[])
{
  TestViewerLight tests;
  return viewerTest::Run(tests, argc, argv);
}

#include "testViewerLight.moc"
