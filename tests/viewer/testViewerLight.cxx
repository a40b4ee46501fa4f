// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The controls of lights: they write the edited values, and leave all other words unchanged.
#include "TestCase.h"
#include "ViewerTest.h"

#include "ColorButton.h"
#include "FileEdit.h"
#include "LightHandles.h"
#include "LightOptions.h"
#include "LightsGroup.h"
#include "MessageBar.h"
#include "Number.h"
#include "ParameterEdit.h"
#include "SunEdit.h"
#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRenderer.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QShortcut>
#include <QSlider>
#include <QTreeWidget>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

namespace testViewerLight
{
using scene::Settings;
using Words = std::vector<std::string>;

class TestViewerLight : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  Words GetLights() { return this->Window->GetDocument()->Get().GetAll("--light"); }

  viewer::LightsGroup* GetGroup() { return this->Window->findChild<viewer::LightsGroup*>(); }
  QWidget* FindEdit(const char* name) { return this->GetGroup()->findChild<QWidget*>(name); }
  QComboBox* GetBox(const char* name) { return this->GetGroup()->findChild<QComboBox*>(name); }
  QTreeWidget* GetList() { return this->GetGroup()->findChild<QTreeWidget*>("list"); }

  QPushButton* GetButton(const char* name)
  {
    return this->GetGroup()->findChild<QPushButton*>(name);
  }

  void Select(int row) { this->GetList()->setCurrentItem(this->GetList()->topLevelItem(row)); }

  // The contents of the list, row by row.
  QStringList GetRows()
  {
    QStringList rows;
    for (int i = 0; i < this->GetList()->topLevelItemCount(); ++i)
    {
      QTreeWidgetItem* item = this->GetList()->topLevelItem(i);
      rows += item->text(0) + "|" + item->text(1);
    }
    return rows;
  }

  // Of the picture.
  vtkLight* GetLight(int place)
  {
    vtkRenderer* renderer = this->Window->GetView()->GetPicture().GetRenderer();
    return vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(place));
  }

  // Types a value into a field, as the user does.
  void Type(const char* name, double value)
  {
    this->FindEdit(name)->findChild<QDoubleSpinBox*>()->setValue(value);
  }

  double Shown(const char* name)
  {
    return this->FindEdit(name)->findChild<QDoubleSpinBox*>()->value();
  }

  // Pixels of the picture with a surface.
  std::vector<bool> FindSurface()
  {
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(this->Window->GetView()->GetPicture().GetRenderer());
    source->AddLayer("depth");
    source->Update();
    vtkDataArray* depth = source->GetOutput()->GetPointData()->GetArray("depth");
    std::vector<bool> seen;
    for (vtkIdType i = 0; i < depth->GetNumberOfTuples(); ++i)
    {
      seen.push_back(std::isfinite(depth->GetComponent(i, 0)));
    }
    return seen;
  }

  int CountLit()
  {
    const vtkSmartPointer<vtkImageData> picture = this->Grab();
    const auto* bytes = static_cast<const unsigned char*>(picture->GetScalarPointer());
    int lit = 0;
    for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
    {
      lit += bytes[3 * i] > 0;
    }
    return lit;
  }

private Q_SLOTS:
  // A sun by date and place stands in the sky: its direction in the data follows the axis, and its
  // words stay.
  void sunFollowsUp()
  {
    const std::string light = "sun:2026-06-21T15:30Z,48,0,size=2";
    this->Open({ this->WriteScene(), "--light", light });
    auto* up = this->Window->findChild<QGroupBox*>("scene")->findChild<QComboBox*>("up");
    QCOMPARE(this->GetBox("by")->currentIndex(), 1);
    QCOMPARE(this->Shown("time"), 15.5);
    for (const int axis : { 2, 0, 1 })
    {
      up->setCurrentIndex(axis + 1); // behind that of the file
      this->WaitUntilRead();
      QCOMPARE(this->GetLights(), Words{ light });
      const std::array<double, 3> wanted =
        look::GetSunDirection(look::GetSunAngles(*look::ParseLight(light).Time), axis);
      const double* found = this->GetLight(0)->GetPosition();
      QVERIFY(std::hypot(found[0] - wanted[0], found[1] - wanted[1], found[2] - wanted[2]) < 1e-12);
    }
  }

  // Edited preset lights, and a new sun, have the same height for any up axis.
  void editedSunsFollowUp()
  {
    this->Open({ this->WriteScene(), "--preset", "print" });
    this->Type("azimuth", 47.0);
    this->GetButton("add")->menu()->findChild<QAction*>("sun")->trigger();
    auto* up = this->Window->findChild<QGroupBox*>("scene")->findChild<QComboBox*>("up");
    const auto angles = [this](int light, int axis) {
      const double* d = this->GetLight(light)->GetPosition();
      return look::GetSunAngles({ d[0], d[1], d[2] }, axis);
    };
    const std::array<double, 2> high = { angles(0, 1).Elevation, angles(1, 1).Elevation };
    QVERIFY(high[0] > 20.0 && high[1] > 20.0);
    for (const int axis : { 2, 0, 1 })
    {
      up->setCurrentIndex(axis + 1);
      this->WaitUntilRead();
      QVERIFY(std::abs(angles(0, axis).Azimuth - 47.0) < 1e-9);
      QVERIFY(std::abs(angles(0, axis).Elevation - high[0]) < 1e-9);
      QVERIFY(std::abs(angles(1, axis).Elevation - high[1]) < 1e-9);
    }
  }

  // Words that are not edited stay, with their order and every digit.
  void severalLights()
  {
    const Words lights = { "point:1,2,3,size=0.2", "sun:0.123456789,1,0.6,size=2", "sun:1,1,1",
      "spot:0,3,2,0,0,0,30,color=1/0.25/0,name=stage\\, left" };
    Words words = { this->WriteScene() };
    for (const std::string& light : lights)
    {
      words.insert(words.end(), { "--light", light });
    }
    this->Open(words);
    QCOMPARE(this->GetRows(),
      (QStringList{ "light 0|point", "light 1|sun", "light 2|sun", "stage, left|spot" }));
    // One angle is edited; the other is not rounded.
    this->Select(1);
    const double elevation = look::GetSunAngles(look::ParseLight(lights[1]).Position, 1).Elevation;
    this->Type("azimuth", -30.0);
    QCOMPARE(this->Shown("azimuth"), 330.0); // the same direction
    const Words after = this->GetLights();
    QCOMPARE(after.size(), std::size_t(4));
    for (const std::size_t i : { 0, 2, 3 })
    {
      QCOMPARE(after[i], lights[i]);
    }
    QVERIFY(after[1].find(",size=2") != std::string::npos);
    const look::SunAngles angles = *look::ParseLight(after[1]).Angles;
    QVERIFY(std::abs(angles.Elevation - elevation) < 1e-12);
    QVERIFY(std::abs(angles.Azimuth - 330.0) < 1e-9);
    // Each value of the last.
    this->Select(3);
    this->Type("intensity", 0.75);
    this->Type("cone", 20.0);
    this->FindEdit("target")->findChild<QDoubleSpinBox*>("y")->setValue(0.25);
    static_cast<QCheckBox*>(this->FindEdit("casts"))->setChecked(false);
    auto* name = static_cast<QLineEdit*>(this->FindEdit("name"));
    QCOMPARE(name->text(), QString("stage, left"));
    name->setText("right");
    Q_EMIT name->editingFinished();
    QCOMPARE(this->GetLights()[3],
      std::string("spot:0,3,2,0,0.25,0,20,color=1/0.25/0,name=right,intensity=0.75,casts=off"));
    Q_EMIT this->GetGroup()->findChild<viewer::ColorButton*>("color")->edited(QColor("#3366ff"));
    QVERIFY(this->GetLights()[3].find(",color=#3366ff,") != std::string::npos);
    this->Compare("edited");
  }

  // Lights come, are named in the list, and go.
  void list()
  {
    this->Open({ this->WriteScene() });
    QCOMPARE(this->GetRows(), QStringList{ "headlight|at the camera" });
    QVERIFY(!this->GetButton("remove")->isEnabled() && !this->GetButton("duplicate")->isEnabled());
    for (const char* kind : { "sun", "spot", "point" })
    {
      this->GetButton("add")->menu()->findChild<QAction*>(kind)->trigger();
    }
    QCOMPARE(this->GetRows(), (QStringList{ "light 0|sun", "light 1|spot", "light 2|point" }));
    auto* list = this->GetList();
    QCOMPARE(list->indexOfTopLevelItem(list->currentItem()), 2);
    list->currentItem()->setText(0, "lamp, by the wall");
    QCOMPARE(look::ParseLight(this->GetLights()[2]).Name, std::string("lamp, by the wall"));
    QVERIFY(this->GetLights()[2].find("name=lamp\\, by") != std::string::npos);
    this->GetButton("duplicate")->click();
    QCOMPARE(this->GetLights()[3], this->GetLights()[2]);
    this->Compare("four lights");
    this->Select(1);
    this->GetButton("remove")->click();
    QCOMPARE(this->GetRows(),
      (QStringList{ "light 0|sun", "lamp, by the wall|point", "lamp, by the wall|point" }));
    list->currentItem()->setText(0, "");
    QCOMPARE(this->GetRows()[1], QString("light 1|point"));
    viewer::Document* document = this->Window->GetDocument();
    while (document->CanUndo())
    {
      document->Undo();
    }
    QCOMPARE(this->GetRows(), QStringList{ "headlight|at the camera" });
  }

  // A light that is added shows the scene, with each preset and each axis, and does not burn it.
  void addedLights_data()
  {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("preset");
    QTest::addColumn<QString>("up");
    QTest::addColumn<bool>("beside"); // the preset's first, as the user's own
    for (const char* kind : { "sun", "spot", "point" })
    {
      for (const char* preset : { "none", "studio", "town", "print" })
      {
        QTest::newRow(qPrintable(QString(kind) + " " + preset)) << kind << preset << "y" << false;
      }
      QTest::newRow(qPrintable(QString(kind) + " up")) << kind << "studio"
                                                       << "z" << false;
      QTest::newRow(qPrintable(QString(kind) + " beside")) << kind << "studio"
                                                           << "y" << true;
    }
  }

  void addedLights()
  {
    QFETCH(QString, kind);
    QFETCH(QString, preset);
    QFETCH(QString, up);
    QFETCH(bool, beside);
    this->Open({ this->WriteScene(), "--color", "white", "--preset", preset.toStdString(), "--up",
      up.toStdString(), "--shadows", "off", "--stage", "antialias:samples=1" });
    if (beside)
    {
      this->GetButton("makeOwn")->click();
    }
    this->GetButton("add")->menu()->findChild<QAction*>(kind)->trigger();
    QCOMPARE(this->Window->GetTrouble(), QString());
    const vtkSmartPointer<vtkImageData> picture = this->Grab();
    const std::vector<bool> seen = this->FindSurface();
    const auto* bytes = static_cast<const unsigned char*>(picture->GetScalarPointer());
    int burnt = 0, dark = 0, all = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
      all += seen[i];
      burnt += seen[i] && bytes[3 * i + 1] == 255;
      dark += seen[i] && bytes[3 * i + 1] < 40;
    }
    QVERIFY(all > 10000);
    QVERIFY2(burnt < 0.02 * all, qPrintable(QString("%1 of %2 burnt").arg(burnt).arg(all)));
    QVERIFY2(dark < 0.4 * all, qPrintable(QString("%1 of %2 dark").arg(dark).arg(all)));
  }

  // The first edit makes the preset's light one's own, and no row moves away from the mouse.
  void rowsStay()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--shadows", "off", "--stage",
      "antialias:samples=1" });
    this->Window->findChild<QDockWidget*>("light")->raise();
    const auto findPlaces = [this] {
      std::map<QString, QPoint> places;
      for (const QString name :
        { "name", "color", "intensity", "softness", "casts", "by", "azimuth", "elevation", "fill" })
      {
        places[name] = this->FindEdit(qPrintable(name))->mapTo(this->Window.get(), QPoint());
      }
      return places;
    };
    QTRY_VERIFY_WITH_TIMEOUT(this->FindEdit("azimuth")->isVisible(), 20000);
    const std::map<QString, QPoint> before = findPlaces();
    const std::vector<std::function<void()>> edits = { [this] { this->Type("azimuth", 90.0); },
      [this] { this->Type("elevation", 20.0); }, [this] { this->Type("angle", 3.0); },
      [this] { static_cast<QCheckBox*>(this->FindEdit("casts"))->setChecked(false); } };
    for (const auto& edit : edits)
    {
      QVERIFY(this->GetLights().empty());
      edit();
      QCOMPARE(this->GetLights().size(), std::size_t(1));
      QCoreApplication::processEvents(); // rows are laid out
      QVERIFY(findPlaces() == before);
      this->Window->GetDocument()->Undo();
    }
  }

  // A stage's note about its picture moves none of its rows.
  void reasonsMoveNothing()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6,casts=off", "--shadows", "map" });
    this->Window->findChild<QDockWidget*>("light")->raise();
    auto* group = this->Window->findChild<QGroupBox*>("shadows");
    auto* reason = group->findChild<QLabel*>("reason");
    this->Grab();
    QTRY_VERIFY_WITH_TIMEOUT(!reason->isHidden(), 20000);
    const auto findPlaces = [group] {
      QList<QPoint> places;
      for (QWidget* edit : group->findChildren<viewer::ParameterEdit*>())
      {
        places += edit->mapTo(group, QPoint());
      }
      return places;
    };
    const QList<QPoint> before = findPlaces();
    static_cast<QCheckBox*>(this->FindEdit("casts"))->setChecked(true);
    this->Grab();
    QTRY_VERIFY_WITH_TIMEOUT(reason->isHidden(), 20000);
    QCoreApplication::processEvents(); // rows are laid out
    QVERIFY(findPlaces() == before);
  }

  // Switched on without an image, the environment asks for one in its place, without a dialog.
  void environmentWithoutImage()
  {
    this->Open({ this->WriteScene() });
    auto* group = this->Window->findChild<QGroupBox*>("environment");
    const viewerTest::Dialogs dialogs;
    group->setChecked(true);
    QCOMPARE(dialogs.GetCount(), 0);
    QVERIFY(group->isChecked() && !group->findChild<QLabel*>("hint")->isHidden());
    for (const char* idle : { "sky", "rotation", "intensity", "irradiance_weight" })
    {
      QVERIFY2(!group->findChild<QWidget*>(idle)->isEnabled(), idle);
    }
    auto* file = group->findChild<viewer::FileEdit*>();
    Q_EMIT file->edited(QString::fromStdString(this->WriteImage()));
    QVERIFY(this->Window->GetDocument()->Get().Has("--environment"));
    QVERIFY(group->isChecked() && group->findChild<QLabel*>("hint")->isHidden());
    QVERIFY(group->findChild<QWidget*>("sky")->isEnabled());
    QVERIFY(group->findChild<QWidget*>("intensity")->isEnabled());
    this->Window->GetDocument()->Undo();
    QVERIFY(!group->isChecked());
  }

  // By date and place, and back to angles, which are then those of the date.
  void backToAngles()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6,size=3" });
    this->GetBox("by")->setCurrentIndex(1);
    QCOMPARE(this->GetLights(), Words{ "sun:2026-06-21T15:00Z,48,0,size=3" });
    this->GetBox("by")->setCurrentIndex(0);
    const look::SunAngles angles = look::GetSunAngles(look::SunTime());
    const look::SunAngles found = *look::ParseLight(this->GetLights()[0]).Angles;
    QVERIFY(std::abs(found.Azimuth - angles.Azimuth) < 1e-9);
    QVERIFY(std::abs(found.Elevation - angles.Elevation) < 1e-9);
    QVERIFY(std::abs(this->Shown("azimuth") - angles.Azimuth) < 0.006);
    QVERIFY(std::abs(this->Shown("elevation") - angles.Elevation) < 0.006);
  }

  // Undoing and doing again bring back that the sun stood by date, with the time.
  void undoByDate()
  {
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    auto* by = this->GetBox("by");
    by->setCurrentIndex(1);
    const double noon = this->Shown("time");
    this->Type("time", 9.5);
    viewer::Document* document = this->Window->GetDocument();
    document->Undo();
    QCOMPARE(by->currentIndex(), 1);
    QCOMPARE(this->Shown("time"), noon);
    document->Undo();
    QCOMPARE(by->currentIndex(), 0);
    document->Redo();
    document->Redo();
    QCOMPARE(by->currentIndex(), 1);
    QCOMPARE(this->Shown("time"), 9.5);
    // Chosen angles stay angles.
    by->setCurrentIndex(0);
    this->Type("azimuth", 100.0);
    document->Undo();
    QCOMPARE(by->currentIndex(), 0);
  }

  // By date and place there is no light of a sun below the horizon, and the panel says so; an
  // elevation that is typed lights from beneath.
  void night()
  {
    this->Open({ this->WriteScene(), "--light", "sun:2026-06-21T12:00Z,48,0", "--camera",
      "2,-3,3,0,0.5,0,0,1,0" });
    const auto says = [this] { return this->GetGroup()->findChild<QLabel*>("place")->text(); };
    QVERIFY(says().contains("Day: the sun is 65"));
    this->Type("time", 0.5);
    const double below =
      -look::GetSunAngles(*look::ParseLight(this->GetLights()[0]).Time).Elevation;
    QVERIFY(below > 15.0);
    QVERIFY2(
      says().contains(QString("Night: the sun is %1").arg(below, 0, 'f', 1)), qPrintable(says()));
    QCOMPARE(this->GetRows()[0], QString("light 0|sun, night"));
    for (const auto& [elevation, name] : { std::pair(0.1, "day"), std::pair(0.0, "civil twilight"),
           std::pair(-6.0, "nautical twilight"), std::pair(-12.0, "astronomical twilight"),
           std::pair(-17.9, "astronomical twilight"), std::pair(-18.0, "night") })
    {
      QCOMPARE(relievoQt::SunEdit::NamePartOfDay(elevation), QString(name));
    }
    QCOMPARE(this->CountLit(), 0);
    this->Compare("night");
    this->GetBox("by")->setCurrentIndex(0);
    QVERIFY(says().contains("from beneath"));
    QVERIFY(this->CountLit() > 10000);
    this->Compare("from beneath");
  }

  // The light of a preset's nights is in the list, and where the chosen light is gone, one that is
  // on is chosen instead of the preset's key light, which is off.
  void moon()
  {
    this->Open({ this->WriteScene(), "--preset", "town", "--light", "sun:2026-06-21T12:00Z,48,0",
      "--light", "point:1,2,3" });
    this->Select(1);
    this->Change([](scene::Settings& settings) {
      settings.SetAll("--light", { "sun:2026-06-21T00:30Z,48,0" });
    });
    QCOMPARE(this->GetRows(),
      (QStringList{
        "light 0|sun, night", "town: key light|sun, off", "town: moon|sun", "town: fill|4 suns" }));
    QCOMPARE(this->GetList()->currentIndex().row(), 0);
    this->Change([](scene::Settings& settings) {
      settings.SetAll("--light", { "sun:2026-06-21T12:00Z,48,0" });
    });
    QCOMPARE(this->GetRows().size(), 3);
  }

  // Sessions keep that the sun stands by date, also those that said it beside the words.
  void sessions()
  {
    const std::string scene = this->WriteScene();
    this->Open({ scene, "--light", "point:1,2,3", "--light", "sun:2026-06-21T12:00Z,48,0" });
    const Words before = this->GetLights();
    const QString path = QString::fromStdString(this->Path("a.json"));
    this->Window->SaveSession(path);
    this->Change([](scene::Settings& settings) { settings.Remove("--light"); });
    this->Window->OpenSession(path);
    this->WaitUntilRead();
    QCOMPARE(this->GetLights(), before);
    this->WriteText("old.json",
      "{\"relievo-viewer\": 1, \"words\": [\"" + scene +
        "\", \"--light\", \"point:1,2,3\", \"--light\", \"sun:0,1,0,size=2\"], \"sun\": "
        "{\"by_time\": true, \"date\": [2025, 3, 4], \"hour\": 9.5, \"time_zone\": -1.5, "
        "\"latitude\": 10.25, \"longitude\": -20}}");
    this->Window->OpenSession(QString::fromStdString(this->Path("old.json")));
    this->WaitUntilRead();
    QCOMPARE(
      this->GetLights(), (Words{ "point:1,2,3", "sun:2025-03-04T09:30-01:30,10.25,-20,size=2" }));
  }

  // The preset's lights are shown as they stand, are the user's own with one button, and the
  // picture stays.
  void presetsLights_data()
  {
    QTest::addColumn<QString>("preset");
    for (const char* preset : { "studio", "town", "print" })
    {
      QTest::newRow(preset) << preset;
    }
  }

  void presetsLights()
  {
    QFETCH(QString, preset);
    // Fewer samples than the preset's, which take long.
    this->Open({ this->WriteScene(), "--preset", preset.toStdString(), "--stage",
      "shadows:soft_samples=2,map_size=256", "--stage", "antialias:samples=2" });
    QCOMPARE(
      this->GetRows(), (QStringList{ preset + ": key light|sun", preset + ": fill|4 suns" }));
    const double* p = this->GetLight(0)->GetPosition();
    const look::SunAngles angles = look::GetSunAngles({ p[0], p[1], p[2] }, 1);
    QVERIFY(std::abs(this->Shown("azimuth") - angles.Azimuth) < 0.006);
    QVERIFY(std::abs(this->Shown("elevation") - angles.Elevation) < 0.006);
    QCOMPARE(this->Shown("fill"), 1.0);
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    this->GetButton("makeOwn")->click();
    QCOMPARE(this->GetRows(),
      (QStringList{ "key light|sun", preset + ": key light|sun, off", preset + ": fill|4 suns" }));
    QVERIFY(this->FindEdit("azimuth")->isEnabled());
    QCOMPARE(this->Shown("fill"), 1.0);
    QVERIFY(MostDifferent(before, this->Grab()) <= 1);
    this->Compare("own");
    // Beside others it is as strong as they are.
    this->Select(1);
    this->GetButton("makeOwn")->click();
    QCOMPARE(this->GetLights().size(), std::size_t(2));
    QVERIFY(this->GetLights()[1].find("intensity") == std::string::npos);
    // Editing the preset's light makes it the user's own, and changes no others.
    this->Change([](scene::Settings& settings) {
      settings.Remove("--light");
      settings.Remove("--fill");
    });
    this->Select(0);
    QVERIFY(!this->FindEdit("intensity")->isEnabled());
    this->Type("angle", 2.5);
    QCOMPARE(this->GetRows()[0], QString("key light|sun"));
    QVERIFY2(
      this->GetLights()[0].find(",size=2.5") != std::string::npos, this->GetLights()[0].c_str());
    QVERIFY(this->FindEdit("intensity")->isEnabled());
    QVERIFY(this->Shown("intensity") > 1.0);
    QCOMPARE(this->Shown("fill"), 1.0);
  }

  // One word, Softness, for the size of a light; controls without effect give the reason.
  void softness()
  {
    this->Open({ this->WriteScene(), "--shadows", "map", "--soft-shadows", "8", "--light",
      "sun:0.4,1,0.6", "--light", "point:1,2,3" });
    auto* edit = this->FindEdit("softness");
    for (int light = 0; light < 2; ++light)
    {
      this->Select(light);
      QVERIFY(edit->isEnabled());
      QVERIFY2(edit->toolTip().startsWith("How large it is"), qPrintable(edit->toolTip()));
    }
    const auto says = [&](const char* words) { return edit->toolTip().contains(words); };
    static_cast<QCheckBox*>(this->FindEdit("casts"))->setChecked(false);
    QVERIFY(!edit->isEnabled() && says("It casts no shadows."));
    static_cast<QCheckBox*>(this->FindEdit("casts"))->setChecked(true);
    this->Change([](scene::Settings& settings) { settings.SwitchStage("shadows", false); });
    QVERIFY(!edit->isEnabled() && says("Shadows are off"));
    this->Change([](scene::Settings& settings) {
      settings.SwitchStage("shadows", true);
      settings.SetParameter("shadows", "soft_samples", "0");
    });
    QVERIFY(!edit->isEnabled() && says("Shadows are hard"));
    QStringList soft;
    for (const QLabel* label : this->Window->findChild<QWidget*>("light")->findChildren<QLabel*>())
    {
      if (label->text().contains("soft", Qt::CaseInsensitive))
      {
        soft += label->text();
      }
    }
    QCOMPARE(soft, (QStringList{ "Softness", "Softness of suns", "Softness of lamps" }));
  }

  // A share of the fill, which goes with the preset.
  void fill()
  {
    this->Open({ this->WriteScene(), "--preset", "studio", "--light", "sun:0,1,0", "--stage",
      "shadows:soft_samples=2,map_size=256", "--stage", "antialias:samples=2" });
    QCOMPARE(this->Shown("fill"), 0.4);
    this->Type("fill", 0.25);
    QCOMPARE(this->Window->GetDocument()->Get().Get("--fill"), std::string("0.25"));
    this->Compare("fill");
    this->Change([](scene::Settings& settings) { settings.Set("--preset", "none"); });
    QCOMPARE(this->Window->GetTrouble(), QString());
    QVERIFY(!this->Window->GetDocument()->Get().Has("--fill"));
    QVERIFY(!this->FindEdit("fill")->isEnabled());
    QVERIFY(this->FindEdit("fill")->toolTip().contains("none has no fill"));
  }

  // Those of a file are shown, and others are in their place.
  void lightsOfTheFile()
  {
    this->WriteText("a.gltf", R"({ "asset": { "version": "2.0" },
      "extensionsUsed": ["KHR_lights_punctual"],
      "extensions": { "KHR_lights_punctual": { "lights": [
        { "type": "directional" }, { "type": "spot" } ] } },
      "scenes": [ { "nodes": [0, 1, 2] } ], "scene": 0,
      "nodes": [ { "mesh": 0 }, { "extensions": { "KHR_lights_punctual": { "light": 0 } } },
        { "extensions": { "KHR_lights_punctual": { "light": 1 } } } ],
      "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 } } ] } ],
      "buffers": [ { "byteLength": 36, "uri":
        "data:application/octet-stream;base64,AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAAgD8AAAAA" } ],
      "bufferViews": [ { "buffer": 0, "byteLength": 36 } ],
      "accessors": [ { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [-1, -1, 0], "max": [1, 1, 0] } ] })");
    this->Open({ this->Path("a.gltf") });
    QCOMPARE(this->GetRows(), (QStringList{ "of the file|sun", "of the file|spot" }));
    QVERIFY(this->FindEdit("azimuth")->isHidden() || !this->FindEdit("azimuth")->isVisible());
    this->GetButton("add")->menu()->findChild<QAction*>("point")->trigger();
    QCOMPARE(
      this->GetRows(), (QStringList{ "light 0|point", "of the file|sun", "of the file|spot" }));
    QVERIFY(!this->GetList()->topLevelItem(0)->font(0).strikeOut());
    QVERIFY(this->GetList()->topLevelItem(1)->font(0).strikeOut());
  }

  // A click in the picture sets a spot's target, or places a point light above the surface, or
  // above the ground. It does not turn the view.
  void placedInThePicture()
  {
    this->Open(
      { this->WriteScene(), "--preset", "studio", "--up", "y", "--light", "spot:2,5,2,0,0,0,30",
        "--light", "point:3,4,-2", "--camera", "0,12,0.001,0,0,0,0,0,-1", "--parallel-scale", "3",
        "--stage", "shadows:soft_samples=2,map_size=256", "--stage", "antialias:samples=2" });
    viewer::PictureView* view = this->Window->GetView();
    auto* button = static_cast<QPushButton*>(this->FindEdit("placeInPicture"));
    const QPoint middle(view->width() / 2, view->height() / 2);
    const double unit = 6.0 / view->height();
    const auto click = [&](const QPoint& by) {
      this->SendMouse(QEvent::MouseButtonPress, middle + by, Qt::LeftButton);
      this->SendMouse(QEvent::MouseButtonRelease, middle + by, Qt::NoButton);
    };
    const std::string camera = this->Window->GetViewSettings().Get("--camera");
    this->Grab(); // who clicks has seen it
    this->Select(0);
    button->click();
    click({ 0, 0 }); // the top of the ball
    QVERIFY(!button->isChecked());
    look::LightChoice light = look::ParseLight(this->GetLights()[0]);
    QVERIFY2(std::hypot(light.FocalPoint[0], light.FocalPoint[1] - 1.4, light.FocalPoint[2]) < 0.03,
      this->GetLights()[0].c_str());
    QCOMPARE(light.Position[1], 5.0);
    QCOMPARE(this->GetLights()[1], std::string("point:3,4,-2"));
    this->Select(1);
    this->Grab();
    button->click();
    const QPoint aside(view->height() / 3, 0); // on the ground, which layers do not have
    click(aside);
    light = look::ParseLight(this->GetLights()[1]);
    QVERIFY(std::abs(light.Position[0] - unit * aside.x()) < 0.03);
    QCOMPARE(light.Position[1], 4.0); // as high as before
    QVERIFY(std::abs(light.Position[2]) < 0.03);
    QCOMPARE(this->Window->GetViewSettings().Get("--camera"), camera);
    // After a click on the background, the viewer asks for another.
    this->Change([](scene::Settings& settings) { settings.Set("--ground", "off"); });
    button->click();
    const Words before = this->GetLights();
    click(aside);
    QCOMPARE(this->GetLights(), before);
    this->Grab();
    click({ 0, 0 });
    QVERIFY(this->GetLights() != before);
    this->Compare("placed");
  }

  // While a click is expected, the window gives its purpose; Esc cancels.
  void saysWhatIsWaitedFor()
  {
    this->Open({ this->WriteScene(), "--light", "spot:2,5,2,0,0,0,30", "--light", "point:3,4,-2" });
    auto* hint = this->Window->findChild<viewer::MessageBar*>("hint");
    auto* button = this->GetButton("placeInPicture");
    QCOMPARE(hint->GetText(), QString());
    for (int light = 0; light < 2; ++light)
    {
      this->Select(light);
      button->click();
      QVERIFY2(hint->GetText().startsWith(light == 0 ? "Click where the spot shall shine"
                                                     : "Click on the surface below the light"),
        qPrintable(hint->GetText()));
      QCOMPARE(this->Window->GetView()->cursor().shape(), Qt::CrossCursor);
      if (light == 0)
      {
        Q_EMIT this->Window->findChild<QShortcut*>("stopPlacing")->activated();
      }
      else
      {
        hint->findChild<QAbstractButton*>("closeMessage")->click();
      }
      QCOMPARE(hint->GetText(), QString());
      QVERIFY(!button->isChecked());
      QVERIFY(this->Window->GetView()->cursor().shape() != Qt::CrossCursor);
    }
  }

  // Handles are dragged: a light in the plane of the view, a spot's target over the surfaces, each
  // drag one undo step. Lights outside of the picture are at its border.
  void handles()
  {
    this->Open({ this->WriteScene(), "--light", "point:1,2,0", "--light",
      "spot:2,5,-1,1.2,0,1.2,30", "--light", "point:90,2,0", "--camera", "0,12,0.001,0,0,0,0,0,-1",
      "--parallel-scale", "3" });
    viewer::PictureView* view = this->Window->GetView();
    viewer::LightHandles* handles = this->Window->GetLightHandles();
    this->Grab();
    QVERIFY(!handles->GetPlace(0, false)); // but beside their controls
    this->Window->findChild<QDockWidget*>("light")->raise();
    QTRY_VERIFY_WITH_TIMEOUT(handles->isVisible(), 20000);
    const double unit = 6.0 / view->height();
    const auto seen = [&](double x, double z) {
      return QPointF(0.5 * view->width() + x / unit, 0.5 * view->height() + z / unit);
    };
    const auto near = [](const std::optional<QPointF>& a, const QPointF& b) {
      return a && std::hypot(a->x() - b.x(), a->y() - b.y()) < 1.0;
    };
    QVERIFY(near(handles->GetPlace(0, false), seen(1.0, 0.0)));
    QVERIFY(near(handles->GetPlace(1, false), seen(2.0, -1.0)));
    QVERIFY(!handles->GetPlace(1, true)); // of the one that is edited
    QVERIFY(handles->GetPlace(2, false)->x() > 0.9 * view->width());
    QVERIFY(handles->GetPlace(2, false)->x() < view->width());
    const auto drag = [&](const QPointF& from, const QPointF& to) {
      this->SendMouse(QEvent::MouseButtonPress, from.toPoint(), Qt::LeftButton);
      for (const double share : { 0.3, 0.7, 1.0 })
      {
        this->SendMouse(QEvent::MouseMove, (from + share * (to - from)).toPoint(), Qt::LeftButton);
      }
      this->SendMouse(QEvent::MouseButtonRelease, to.toPoint(), Qt::NoButton);
      QTest::qWait(1);
    };
    const std::string camera = this->Window->GetViewSettings().Get("--camera");
    const Words before = this->GetLights();
    drag(*handles->GetPlace(0, false), seen(-1.0, 1.0));
    std::array<double, 3> place = look::ParseLight(this->GetLights()[0]).Position;
    QVERIFY2(std::hypot(place[0] + 1.0, place[1] - 2.0, place[2] - 1.0) < 0.03,
      this->GetLights()[0].c_str());
    QVERIFY(this->GetLights()[0].size() < 25); // few digits
    drag(*handles->GetPlace(1, false), seen(2.0, 1.0));
    QCOMPARE(this->GetList()->currentIndex().row(), 1);
    QVERIFY(near(handles->GetPlace(1, true), seen(1.2, 1.2)));
    drag(*handles->GetPlace(1, true), seen(0.0, 0.0)); // the top of the ball
    const look::LightChoice spot = look::ParseLight(this->GetLights()[1]);
    QVERIFY2(std::hypot(spot.FocalPoint[0], spot.FocalPoint[1] - 1.4, spot.FocalPoint[2]) < 0.03,
      this->GetLights()[1].c_str());
    QVERIFY(
      std::hypot(spot.Position[0] - 2.0, spot.Position[1] - 5.0, spot.Position[2] - 1.0) < 0.03);
    QCOMPARE(spot.ConeAngle, 30.0);
    drag(*handles->GetPlace(2, false), seen(2.0, -2.0));
    place = look::ParseLight(this->GetLights()[2]).Position;
    QVERIFY(std::hypot(place[0] - 2.0, place[1] - 2.0, place[2] + 2.0) < 0.03);
    QCOMPARE(this->Window->GetViewSettings().Get("--camera"), camera);
    this->Compare("dragged");
    for (int i = 0; i < 4; ++i)
    {
      QVERIFY(this->GetLights() != before);
      this->Window->GetDocument()->Undo();
    }
    QVERIFY(this->GetLights() == before);
    // Beside a handle the mouse turns the picture.
    drag(seen(-2.0, -2.0), seen(-1.0, -2.0));
    QVERIFY(this->Window->GetViewSettings().Get("--camera") != camera);
  }

  // The edited spot's cone: seen along its axis, a circle as far from the light as its target.
  void cone()
  {
    this->Open(
      { this->WriteScene(), "--light", "point:1,2,0", "--light", "spot:0.5,4,-0.5,0.5,0,-0.5,30",
        "--camera", "0,12,0.001,0,0,0,0,0,-1", "--parallel-scale", "3" });
    viewer::LightHandles* handles = this->Window->GetLightHandles();
    this->Window->findChild<QDockWidget*>("light")->raise();
    QTRY_VERIFY_WITH_TIMEOUT(handles->isVisible(), 20000);
    this->Select(0);
    QVERIFY(handles->GetCone().empty());
    this->Select(1);
    const double unit = 6.0 / handles->height();
    const QPointF middle(0.5 * handles->width() + 0.5 / unit, 0.5 * handles->height() - 0.5 / unit);
    int around = 0;
    int inwards = 0;
    for (const QLineF& line : handles->GetCone())
    {
      const double ends[] = { QLineF(middle, line.p1()).length(),
        QLineF(middle, line.p2()).length() };
      QVERIFY2(std::abs(ends[1] * unit - 2.0) < 0.01, qPrintable(QString::number(ends[1] * unit)));
      std::abs(ends[0] - ends[1]) < 1.0 ? ++around : ++inwards;
    }
    QVERIFY(around > 20 && inwards == 8);
  }

  // Undoing and redoing name the light and what changes of it.
  void namesOfSteps()
  {
    this->Open({ this->WriteScene(), "--light", "spot:0,3,2,0,0,0,30,name=key" });
    const auto undone = [this] { return this->Window->findChild<QAction*>("undo")->text(); };
    this->Type("intensity", 0.5);
    QCOMPARE(undone(), QString("&Undo: intensity of key"));
    this->Type("cone", 20.0);
    QCOMPARE(undone(), QString("&Undo: place of key"));
    this->GetButton("add")->menu()->findChild<QAction*>("sun")->trigger();
    QCOMPARE(undone(), QString("&Undo: new light 1"));
    this->GetButton("remove")->click();
    QCOMPARE(undone(), QString("&Undo: removal of light 1"));
    this->Window->GetDocument()->Undo();
    this->Window->GetDocument()->Undo();
    QCOMPARE(undone(), QString("&Undo: place of key"));
    QCOMPARE(this->Window->findChild<QAction*>("redo")->text(), QString("&Redo: new light 1"));
    this->Window->OpenFiles({ QString::fromStdString(this->WriteScene("other.vtp")) });
    this->WaitUntilRead();
    QCOMPARE(undone(), QString("&Undo: opening other.vtp"));
  }

  // The time zone follows the longitude, and the panel says so, until a zone is typed.
  void timeZone()
  {
    this->Open({ this->WriteScene(), "--light", "sun:2026-06-21T12:00Z,48,0" });
    const auto says = [this] { return this->GetGroup()->findChild<QLabel*>("place")->text(); };
    QVERIFY2(says().contains("UTC+0 (from the longitude"), qPrintable(says()));
    this->Type("longitude", 11.6);
    QCOMPARE(this->GetLights()[0], std::string("sun:2026-06-21T12:00+01:00,48,11.6"));
    QVERIFY2(says().contains("UTC+1 (from the longitude"), qPrintable(says()));
    QVERIFY2(!says().contains("In summer"), qPrintable(says())); // where it is day as well
    this->Type("time", 20.5); // sunset is at 21:17 in summer time
    QVERIFY2(says().startsWith("Civil twilight: the sun is 2.") &&
        says().endsWith("In summer time (UTC+2) it is day."),
      qPrintable(says()));
    this->Type("time", 12.0);
    this->Type("timezone", 2.0);
    QCOMPARE(this->GetLights()[0], std::string("sun:2026-06-21T12:00+02:00,48,11.6"));
    QVERIFY2(!says().contains("longitude"), qPrintable(says()));
    for (const char* longitude : { "30", "45" }) // the zone of 30 degrees, and another one
    {
      this->Type("longitude", std::atof(longitude));
      QCOMPARE(this->GetLights()[0], std::string("sun:2026-06-21T12:00+02:00,48,") + longitude);
      QVERIFY2(!says().contains("longitude"), qPrintable(says()));
    }
    // That it was typed belongs to the settings, which undo brings back: 2 is the zone of 30.
    this->Window->GetDocument()->Undo();
    QVERIFY2(!says().contains("longitude"), qPrintable(says()));
    this->Type("longitude", 60.0);
    QCOMPARE(this->GetLights()[0], std::string("sun:2026-06-21T12:00+02:00,48,60"));
    this->Type("longitude", 30.0);
    QVERIFY2(!says().contains("longitude"), qPrintable(says()));
    // So do sessions. A sun that is removed and added again has no typed zone.
    const QString path = QString::fromStdString(this->Path("zone.json"));
    this->Window->SaveSession(path);
    const Words typed = this->GetLights();
    this->GetButton("remove")->click();
    this->Change([&typed](scene::Settings& settings) { settings.SetAll("--light", typed); });
    QVERIFY2(says().contains("longitude"), qPrintable(says()));
    this->Window->GetDocument()->Undo();
    this->Window->GetDocument()->Undo();
    QVERIFY2(!says().contains("longitude"), qPrintable(says()));
    for (int i = 0; i < 6; ++i) // before the zone was typed
    {
      this->Window->GetDocument()->Undo();
    }
    QVERIFY2(says().contains("UTC+1 (from the longitude"), qPrintable(says()));
    this->Window->OpenSession(path);
    this->WaitUntilRead();
    QCOMPARE(this->GetLights(), typed);
    QVERIFY2(!says().contains("longitude"), qPrintable(says()));
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
    const auto find = [this](const char* name) {
      auto* all = this->Window->findChild<QGroupBox*>("environment");
      return all->findChild<QWidget*>(name)->findChild<QDoubleSpinBox*>();
    };
    const auto type = [&find](const char* name, double value) { find(name)->setValue(value); };
    QCOMPARE(find("rotation")->value(), 40.25);
    type("roughness", 0.5);
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
    type("rotation", -30.0);
    QCOMPARE(get("--environment"), this->Path("waves.png") + ",330");
    QCOMPARE(get("--reflectivity"), std::string("0.123456,0.5"));
    this->Window->findChild<QGroupBox*>("environment")
      ->findChild<QCheckBox*>("sky")
      ->setChecked(false);
    QVERIFY(!this->Window->GetDocument()->Get().Has("--skybox"));
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->Compare("environment");
  }
};

RELIEVO_TEST_CASE_APART(testViewerLight)
{
  TestViewerLight tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerLight.moc"
