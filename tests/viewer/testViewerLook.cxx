// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours, materials, models with bones and the view angle, by their controls.
#include "TestCase.h"
#include "ViewerTest.h"

#include "FileEdit.h"
#include "OpacityCurve.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>

namespace testViewerLook
{
using scene::Settings;

class TestViewerLook : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  template <typename Widget>
  Widget* Find(const char* group, const char* name)
  {
    auto* found = this->Window->findChild<QGroupBox*>(group)->findChild<QWidget*>(name);
    auto* self = qobject_cast<Widget*>(found);
    return self ? self : found->findChild<Widget*>();
  }

  void Choose(const char* group, const char* name, const QString& data)
  {
    auto* box = this->Find<QComboBox>(group, name);
    QVERIFY2(box->findData(data) >= 0, qPrintable(data));
    box->setCurrentIndex(box->findData(data));
    this->WaitUntilRead();
  }

  void SetFile(const char* name, const std::string& path)
  {
    auto* line = this->Find<QLineEdit>("material", name);
    line->setText(QString::fromStdString(path));
    Q_EMIT line->editingFinished();
    this->WaitUntilRead();
  }

  std::string Get(const char* option) { return this->Window->GetDocument()->Get().Get(option); }

  // The curve's last point, dragged down; the picture follows, and returns.
  void DragCurve()
  {
    auto* curve = this->Find<viewer::OpacityCurve>("volumeLook", "opacityCurve");
    QVERIFY(!curve->isHidden());
    const viewer::OpacityCurve::Points before = curve->GetPoints();
    QCOMPARE(before.size(), std::size_t(4)); // within the values 0 to 2
    const auto shown = this->Grab();
    const auto send = [curve](QEvent::Type type, double value, double opacity) {
      QMouseEvent event(
        type, curve->GetPlace({ value, opacity }), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(curve, &event);
    };
    send(QEvent::MouseButtonPress, before.back()[0], before.back()[1]);
    send(QEvent::MouseMove, before.back()[0], 0.0);
    QCOMPARE(this->Get("--opacity-curve"), std::string());
    send(QEvent::MouseButtonRelease, before.back()[0], 0.0);
    QCOMPARE(this->Get("--opacity-curve"), std::string("0/0,0.25/0,0.5/0.7,2/0"));
    QVERIFY(CountDifferent(this->Grab(), shown) > 150);
    QVERIFY(MostDifferent(this->Grab(), this->RenderCommand()) <= 1);
    send(QEvent::MouseButtonDblClick, 1.5, 0.25);
    QCOMPARE(curve->GetPoints().size(), std::size_t(5));
    auto* found = this->Find<QCheckBox>("volumeLook", "found");
    QVERIFY(!found->isChecked());
    found->setChecked(true);
    QCOMPARE(this->Get("--opacity-curve"), std::string());
    QVERIFY(MostDifferent(this->Grab(), shown) <= 1);
    QTRY_VERIFY_WITH_TIMEOUT(curve->GetPoints() == before, 20000); // follows the picture
    this->Choose("volumeLook", "volumeshadows", "casts");
    QCOMPARE(this->Get("--volume-shadows"), std::string("casts"));
    QVERIFY(MostDifferent(this->Grab(), this->RenderCommand()) <= 1);
  }

private Q_SLOTS:
  void material()
  {
    const std::string image = this->WriteImage();
    this->Open({ this->WriteScene(), "--light", "sun:0.4,1,0.6" });
    const scene::Settings before = this->Window->GetDocument()->Get();
    QVERIFY(!this->Find<QComboBox>("material", "relief")->isEnabled());
    QVERIFY(!this->Find<QComboBox>("material", "texturecoordinates")->isEnabled());
    this->SetFile("normalmap", image);
    this->Choose("material", "texturecoordinates", "sphere");
    QCOMPARE(this->Get("--normal-map"), image);
    this->Compare("normal map");
    this->SetFile("heightmap", image);
    QCOMPARE(this->Get("--height-map"), image);
    QCOMPARE(this->Find<QDoubleSpinBox>("material", "depth")->text(), QString("automatic"));
    this->Find<QDoubleSpinBox>("material", "depth")->setValue(0.1);
    this->WaitUntilRead();
    QCOMPARE(this->Get("--height-map"), image + ",0.1");
    this->Choose("material", "relief", "steep");
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->Compare("height map");
    // Options of maps are removed with them.
    this->SetFile("heightmap", "");
    QCOMPARE(this->Get("--relief"), std::string());
    QCOMPARE(this->Get("--texture-coordinates"), std::string("sphere"));
    this->SetFile("normalmap", "");
    QCOMPARE(this->Window->GetTrouble(), QString());
    QVERIFY(this->Window->GetDocument()->Get() == before);
    this->SetFile("normalmap", this->Path("missing.png"));
    QVERIFY(this->Window->GetTrouble().contains("missing.png"));
    QVERIFY(this->Find<QLineEdit>("material", "normalmap")->text().isEmpty());
  }

  void colors()
  {
    this->Open({ this->WriteScene() });
    this->Choose("colors", "colorby", "height");
    QVERIFY(!this->Find<QComboBox>("colors", "component")->isEnabled());
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    auto* automatic = this->Find<QCheckBox>("colors", "automaticRange");
    auto* most = this->Find<QLineEdit>("colors", "most");
    QVERIFY(automatic->isChecked() && !most->isEnabled());
    automatic->setChecked(false);
    QCOMPARE(this->Get("--range"), std::string("0,1")); // as it was by itself
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    most->setText("2");
    Q_EMIT most->editingFinished();
    QCOMPARE(this->Get("--range"), std::string("0,2"));
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    this->Compare("range");
    most->setText("-3");
    Q_EMIT most->editingFinished();
    QVERIFY(this->Window->GetTrouble().contains("Range"));
    QCOMPARE(most->text(), QString("2"));
    automatic->setChecked(true);
    QVERIFY(!this->Window->GetDocument()->Get().Has("--range"));
    this->Choose("colors", "colorby", "Normals");
    this->Choose("colors", "component", "1");
    QCOMPARE(this->Get("--color-by"), std::string("Normals,1"));
    QCOMPARE(this->Find<QComboBox>("colors", "colorby")->currentText(), QString("Normals"));
    this->Compare("component");
    // Whoever looks for the depth among the arrays gets to the layers.
    auto* by = this->Find<QComboBox>("colors", "colorby");
    QVERIFY(by->itemText(by->count() - 1).startsWith("Depth"));
    auto* layers = this->Window->findChild<QDockWidget*>("layers");
    QTest::keyClick(by, Qt::Key_End); // keys in the closed box stop at the last array
    QCOMPARE(by->currentText(), QString("part"));
    QVERIFY(layers->visibleRegion().isEmpty());
    this->Choose("colors", "colorby", "Normals");
    by->showPopup();
    QVERIFY(by->model()->flags(by->model()->index(by->count() - 1, 0)) & Qt::ItemIsEnabled);
    QTest::keyClick(by->view(), Qt::Key_End);
    QTest::keyClick(by->view(), Qt::Key_Return);
    QCOMPARE(by->currentText(), QString("Normals"));
    QTRY_VERIFY_WITH_TIMEOUT(!layers->visibleRegion().isEmpty(), 20000);
    this->Choose("colors", "component", "");
    QCOMPARE(this->Get("--color-by"), std::string("Normals"));
    auto* map = this->Find<QComboBox>("colors", "colormap");
    const auto type = [map](const char* words) {
      map->lineEdit()->setText(words);
      Q_EMIT map->lineEdit()->editingFinished();
    };
    type("black,#ff8000,white");
    QCOMPARE(this->Get("--colormap"), std::string("black,#ff8000,white"));
    this->Find<QCheckBox>("colors", "reversed")->setChecked(true);
    QCOMPARE(this->Get("--colormap"), std::string("black,#ff8000,white:reversed"));
    this->Compare("own colours");
    type("nonsense");
    QVERIFY(this->Window->GetTrouble().contains("Colour map"));
    QCOMPARE(map->currentText(), QString("black,#ff8000,white"));
    this->Find<QCheckBox>("colors", "reversed")->setChecked(false);
    // The list of an own map: a value is typed, a colour added, one removed.
    this->Find<QToolButton>("colors", "editStops")->setChecked(true);
    auto* stops = this->Window->findChild<QWidget*>("stops");
    const auto setValue = [stops](int row, const char* value) {
      auto* edit = stops->findChildren<QLineEdit*>("value").at(row);
      edit->setText(value);
      Q_EMIT edit->editingFinished();
    };
    this->Choose("colors", "colorby", "height"); // from 0 to 1
    QTRY_COMPARE_WITH_TIMEOUT(
      stops->findChildren<QLineEdit*>("value").at(1)->text(), QString("0.5"), 20000);
    setValue(1, "0.25");
    QCOMPARE(this->Get("--colormap"), std::string("#000000,0.25=#ff8000,#ffffff"));
    stops->findChild<QPushButton*>("addStop")->click();
    QCOMPARE(this->Get("--colormap"), std::string("#000000,0.25=#ff8000,0.625=#ffc080,#ffffff"));
    setValue(3, "nonsense");
    stops->findChildren<QToolButton*>("remove").at(0)->click();
    QCOMPARE(this->Get("--colormap"), std::string("0.25=#ff8000,0.625=#ffc080,#ffffff"));
    this->Compare("own colours at their places");
    // The last value has the focus while a colour goes.
    stops->findChild<QPushButton*>("addStop")->click();
    QTRY_COMPARE_WITH_TIMEOUT(stops->findChildren<QLineEdit*>("value").size(), 4, 20000);
    stops->findChildren<QLineEdit*>("value").at(3)->setFocus();
    stops->findChildren<QToolButton*>("remove").at(1)->click();
    QTRY_COMPARE_WITH_TIMEOUT(stops->findChildren<QLineEdit*>("value").size(), 3, 20000);
    this->Change([](scene::Settings& settings) {
      settings.Set("--colormap", "0.25=#ff8000,0.625=#ffc080,#ffffff");
    });
    QTRY_COMPARE_WITH_TIMEOUT(stops->findChildren<QLineEdit*>("value").size(), 3, 20000);
    // A handle that is dragged.
    auto* strip = stops->findChild<QWidget*>("stopStrip");
    const QPoint handle(5 + static_cast<int>(0.625 * (strip->width() - 11)), 15);
    const auto send = [strip](QEvent::Type kind, const QPoint& at) {
      QMouseEvent event(
        kind, at, strip->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(strip, &event);
    };
    send(QEvent::MouseButtonPress, handle);
    send(QEvent::MouseMove, QPoint(strip->width() - 30, 15));
    send(QEvent::MouseMove, QPoint(strip->width() / 2, 15));
    send(QEvent::MouseButtonRelease, QPoint(strip->width() / 2, 15));
    const QString dragged = QString::fromStdString(this->Get("--colormap"));
    const double place = dragged.section(',', 1).section('=', 0, 0).toDouble();
    QVERIFY2(std::abs(place - 0.5) < 0.01, qPrintable(dragged));
    this->Find<QToolButton>("colors", "editStops")->setChecked(false);
    // Steps, logarithms, a symmetric range, and the visible range.
    type("cool-warm");
    this->Find<QSpinBox>("colors", "steps")->setValue(5);
    QCOMPARE(this->Get("--colormap"), std::string("cool-warm:steps=5"));
    this->Find<QCheckBox>("colors", "symmetric")->setChecked(true);
    QCOMPARE(this->Get("--range"), std::string("symmetric"));
    QTRY_COMPARE_WITH_TIMEOUT(
      this->Find<QLineEdit>("colors", "least")->placeholderText(), QString("-1"), 20000);
    this->Compare("steps around zero");
    this->Find<QCheckBox>("colors", "log")->setChecked(true);
    QVERIFY(this->Window->GetTrouble().contains("logarithms"));
    QVERIFY(!this->Find<QCheckBox>("colors", "log")->isChecked());
    this->Find<QCheckBox>("colors", "symmetric")->setChecked(false);
    this->Find<QCheckBox>("colors", "log")->setChecked(true);
    QCOMPARE(this->Get("--colormap"), std::string("cool-warm:log:steps=5"));
    QVERIFY(!this->Find<QCheckBox>("colors", "symmetric")->isEnabled());
    this->Compare("logarithms");
    this->Find<QCheckBox>("colors", "log")->setChecked(false);
    this->Find<QSpinBox>("colors", "steps")->setValue(1);
    type("viridis");
    QVERIFY(!this->Window->GetDocument()->Get().Has("--colormap"));
    this->Find<QCheckBox>("colors", "solid")->setChecked(true);
    QCOMPARE(this->Get("--color"), std::string("#ffffff"));
    QVERIFY(!this->Window->GetDocument()->Get().Has("--color-by"));
    this->Choose("colors", "colorby", "height");
    QVERIFY(!this->Window->GetDocument()->Get().Has("--color"));
    QCOMPARE(this->Window->GetTrouble(), QString());
  }

  // The front of the ball, from 0.6 before it: 0.16 up and down.
  void seenRange()
  {
    this->Open({ this->WriteScene(), "--color-by", "height", "--size", "300x300", "--camera",
      "0,0.8,1.2,0,0.8,0,0,1,0" });
    this->Grab();
    this->Find<QPushButton>("colors", "fitSeen")->click();
    const QStringList seen = QString::fromStdString(this->Get("--range")).split(',');
    QCOMPARE(seen.size(), 2);
    QVERIFY2(
      std::abs(seen[0].toDouble() - 0.63) < 0.02 && std::abs(seen[1].toDouble() - 0.97) < 0.02,
      qPrintable(seen.join(',')));
    this->Compare("what is seen");
    // A prefix where none is needed
    this->Change([](scene::Settings& settings) {
      settings.Set("--color-by", "point:height");
      settings.Remove("--range");
    });
    this->Grab();
    this->Find<QPushButton>("colors", "fitSeen")->click();
    QCOMPARE(QString::fromStdString(this->Get("--range")).split(','), seen);
  }

  // Arrays of colours have no values for a bar; arrays of points and of cells may share a name.
  void colorsOfArrays()
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->WriteScene().c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    vtkNew<vtkUnsignedCharArray> rgb;
    rgb->SetName("rgb");
    rgb->SetNumberOfComponents(3);
    rgb->SetNumberOfTuples(data->GetNumberOfPoints());
    rgb->Fill(200);
    data->GetPointData()->AddArray(rgb);
    vtkNew<vtkFloatArray> cells;
    cells->SetName("height");
    cells->SetNumberOfTuples(data->GetNumberOfCells());
    cells->Fill(0.25);
    cells->SetTuple1(0, 4.0);
    data->GetCellData()->AddArray(cells);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetDataModeToBinary();
    writer->SetInputData(data);
    writer->SetFileName(this->Path("arrays.vtp").c_str());
    writer->Write();
    this->Open({ this->Path("arrays.vtp") });
    QVERIFY(this->Find<QComboBox>("colors", "colorby")->findData("height") < 0);
    this->Choose("colors", "colorby", "cell:height");
    QCOMPARE(
      this->Find<QComboBox>("colors", "colorby")->currentData().toString(), QString("cell:height"));
    this->Find<QCheckBox>("colors", "automaticRange")->setChecked(false);
    QCOMPARE(this->Get("--range"), std::string("0.25,4"));
    this->Compare("of cells");
    this->Find<QCheckBox>("colors", "automaticRange")->setChecked(true);
    this->Choose("colors", "colorby", "point:height");
    auto* bar = this->Find<QCheckBox>("colors", "scalarbar");
    QVERIFY(bar->isChecked()); // since the first array
    bar->setChecked(false);
    this->Choose("colors", "colorby", "cell:height");
    QVERIFY(!bar->isChecked());
    bar->setChecked(true);
    QVERIFY(this->Window->GetDocument()->Get().Has("--scalar-bar"));
    this->Choose("colors", "colorby", "rgb");
    QCOMPARE(this->Window->GetTrouble(), QString());
    QCOMPARE(this->Get("--color-by"), std::string("rgb"));
    QVERIFY(!bar->isChecked() && !bar->isEnabled());
    this->Choose("colors", "component", "1"); // which is a value
    QVERIFY(bar->isEnabled());
    bar->setChecked(true);
    this->Choose("colors", "component", "");
    QCOMPARE(this->Window->GetTrouble(), QString());
    QVERIFY(!bar->isEnabled());
    this->Compare("colours");
  }

  void models()
  {
    this->Open({ this->WriteScene() });
    auto* group = this->Window->findChild<QGroupBox*>("model");
    QVERIFY(group->isHidden());
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/glTF2/";
    this->Open({ models + "simple_skin/simple_skin.gltf", "--time", "0.5" });
    group = this->Window->findChild<QGroupBox*>("model");
    QVERIFY(!group->isHidden());
    const std::vector<std::string> names = this->Window->GetDocument()->GetFacts().Animations;
    QVERIFY(!names.empty());
    this->Choose("model", "animation", QString::fromStdString(names.front()));
    QCOMPARE(this->Get("--animation"), names.front());
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    this->Find<QCheckBox>("model", "skeleton")->setChecked(true);
    this->WaitUntilRead();
    QVERIFY(CountDifferent(before, this->Grab()) > 10);
    this->Choose("model", "skin", "off");
    this->Find<QCheckBox>("model", "loop")->setChecked(true);
    this->WaitUntilRead();
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->Compare("model");
  }

  // Settings not made here are the preset's.
  // Images with depth and clouds of points, as the command draws them.
  void imagesWithDepth()
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(24, 24, 24);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int i = 0; i < 24 * 24 * 24; ++i)
    {
      const int x = i % 24 - 12;
      const int y = i / 24 % 24 - 12;
      const int z = i / 576 - 12;
      const bool within = x * x + y * y + z * z < 90;
      image->SetScalarComponentFromDouble(x + 12, y + 12, z + 12, 0, !within ? 0 : x < 0 ? 1 : 2);
    }
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(this->Path("image.vti").c_str());
    writer->SetInputData(image);
    QVERIFY(writer->Write());
    // Rays through a volume take long, and each sample of the preset takes them again.
    this->Open({ this->Path("image.vti"), "--preset", "studio", "--soft-shadows", "1", "--stage",
                 "antialias:samples=1" },
      QSize(500, 300));
    auto last = this->Grab();
    for (const char* kind : { "surface", "volume", "box" })
    {
      this->Choose("scene", "image", kind);
      this->WaitUntilRead();
      QCOMPARE(this->Window->GetTrouble(), QString());
      if (kind == std::string("volume")) // whose first samples VTK rounds in their own way
      {
        const vtkSmartPointer<vtkImageData> command = this->RenderCommand();
        const int different = CountDifferent(this->Grab(), command);
        QVERIFY2(different >= 0 && different < 10, qPrintable(QString::number(different)));
        QVERIFY(MostDifferent(this->Grab(), command) <= 1);
        this->DragCurve();
      }
      else
      {
        this->Compare(kind);
      }
      const auto shown = this->Grab();
      const int different = CountDifferent(shown, last);
      QVERIFY2(different > 150,
        qPrintable(QString("%1: %2 of %3 pixels, %4 before")
                     .arg(kind)
                     .arg(different)
                     .arg(shown->GetNumberOfPoints())
                     .arg(last->GetNumberOfPoints())));
      last = shown;
    }
    this->Choose("scene", "image", "");
    this->WaitUntilRead();
    this->Compare("labels");

    this->Open({ this->WritePoints(), "--preset", "studio" });
    this->Compare("points");
    const auto balls = this->Grab();
    this->Find<QDoubleSpinBox>("surfaces", "pointSize")->setValue(1.0);
    this->Compare("single pixels");
    QVERIFY(CountDifferent(this->Grab(), balls) > 20);
  }

  void presetsBackground()
  {
    this->Open({ this->WriteScene(), "--preset", "studio" });
    auto* kind = this->Find<QComboBox>("background", "kind");
    QCOMPARE(kind->currentText(), QString("The preset's"));
    this->Change([](scene::Settings& settings) { settings.Set("--preset", "none"); });
    QCOMPARE(kind->currentText(), QString("VTK's"));
  }

  void viewAngle()
  {
    this->Open({ this->WriteScene() });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    auto* angle = this->Find<QDoubleSpinBox>("camera", "viewangle");
    QCOMPARE(angle->value(), 30.0);
    angle->setValue(60.0);
    QCOMPARE(this->Get("--view-angle"), std::string("60"));
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    this->Compare("view angle");
    angle->setValue(30.0);
    QVERIFY(!this->Window->GetDocument()->Get().Has("--view-angle"));
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
  }
};

RELIEVO_TEST_CASE_APART(testViewerLook)
{
  TestViewerLook tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerLook.moc"
