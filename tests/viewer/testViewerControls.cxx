// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The time bar, the report, and the values under the mouse of arrays of any name and width.
#include "TestCase.h"
#include "ViewerTest.h"

#include "LayersPanel.h"
#include "OptionEdits.h"
#include "Options.h"
#include "Probe.h"
#include "ReportPanel.h"
#include "StageTable.h"
#include "TimesChart.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QSlider>
#include <QToolBar>
#include <QtTest>

#include <cmath>
#include <map>

namespace testViewerControls
{
class TestViewerControls : public viewerTest::ViewerTest
{
  Q_OBJECT

private Q_SLOTS:
  // The control that a panel adds for an option without one of its own, for every option.
  void controlsOfOptions()
  {
    viewer::Document document;
    int flags = 0, choices = 0, lines = 0;
    for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
    {
      const char* const name = option.Name.c_str();
      QWidget form;
      auto* rows = new QFormLayout(&form);
      viewer::AddOption(&document, rows, option);
      if (auto* box = form.findChild<QCheckBox*>())
      {
        ++flags;
        QVERIFY2(option.IsFlag() && !box->isChecked(), name);
        box->setChecked(true);
        QVERIFY2(document.Get().Has(name) == box->isChecked(), name); // or refused
      }
      else if (auto* words = form.findChild<QComboBox*>())
      {
        ++choices;
        QVERIFY2(words->count() == static_cast<int>(option.Words.size()) + 1, name);
        QVERIFY2(words->currentData().toString().isEmpty(), name);
        words->setCurrentIndex(1);
        QVERIFY2(words->currentData().toString().toStdString() == document.Get().Get(name), name);
      }
      else
      {
        ++lines;
        auto* line = form.findChild<QLineEdit*>();
        QVERIFY2(line && line->placeholderText() == QString::fromStdString(option.Form), name);
        QVERIFY2(line->toolTip() == QString::fromStdString(option.Help), name);
      }
      document.Change([](scene::Settings& settings) { settings = scene::Settings(); });
    }
    QVERIFY(flags > 5 && choices > 10 && lines > 10);
    QWidget form;
    auto* rows = new QFormLayout(&form);
    viewer::AddOption(&document, rows, *scene::GetRenderCommand().Find("--opacity"));
    viewer::AddOption(&document, rows, *scene::GetRenderCommand().Find("--shading"));
    viewer::AddOption(&document, rows, *scene::GetRenderCommand().Find("--edges"));
    auto* line = form.findChild<QLineEdit*>("opacity");
    const auto type = [line](const char* text) {
      line->setText(text);
      Q_EMIT line->editingFinished();
    };
    type("0.5");
    QCOMPARE(document.Get().Get("--opacity"), std::string("0.5"));
    type("7"); // refused
    QCOMPARE(line->text(), QString("0.5"));
    type("");
    QVERIFY(!document.Get().Has("--opacity"));
    auto* shading = form.findChild<QComboBox*>("shading");
    shading->setCurrentText("phong");
    QCOMPARE(document.Get().Get("--shading"), std::string("phong"));
    auto* edges = form.findChild<QCheckBox*>("edges");
    edges->setChecked(true);
    QVERIFY(document.Get().Has("--edges"));
    document.Change([](scene::Settings& settings) { settings = scene::Settings(); });
    QVERIFY(!edges->isChecked() && shading->currentData().toString().isEmpty());
  }

  void timeSlider()
  {
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/glTF2/";
    this->Open({ models + "simple_skin/simple_skin.gltf", "--time", "0" });
    auto* slider = this->Window->findChild<QToolBar*>("time")->findChild<QSlider*>("slider");
    QVERIFY(slider && slider->isVisible());
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const std::array<double, 2> times = this->Window->GetDocument()->GetFacts().Times;
    slider->setValue(slider->maximum() / 4);
    this->WaitUntilRead();
    const double time = this->Window->GetDocument()->Get().Parse().Model.Time.value_or(-1.0);
    QVERIFY2(std::abs(time - (times[0] + 0.25 * (times[1] - times[0]))) < 1e-9,
      qPrintable(QString("%1 of %2 to %3").arg(time).arg(times[0]).arg(times[1])));
    QVERIFY(CountDifferent(before, this->Grab()) > 100);
    this->Compare("at a quarter");
    // Playing is one edit, however long it lasts, after that of the slider.
    QAction* play = this->Window->findChild<QToolBar*>("time")->actions().first();
    viewer::Document* document = this->Window->GetDocument();
    const auto now = [document] { return document->Get().Parse().Model.Time.value_or(-1.0); };
    play->setChecked(true);
    for (int i = 0; i < 3; ++i)
    {
      const double last = now();
      QTRY_VERIFY_WITH_TIMEOUT(now() != last, 20000);
    }
    play->setChecked(false);
    this->WaitUntilRead();
    document->Undo();
    this->WaitUntilRead();
    QCOMPARE(now(), time);
    // A refused setting during playback stops it, and so does a file without animations.
    play->setChecked(true);
    QCOMPARE(play->text(), QString("Pause"));
    QTRY_VERIFY_WITH_TIMEOUT(now() != time, 20000);
    document->Change([](scene::Settings& settings) { settings.Set("--opacity", "7"); });
    QVERIFY(!play->isChecked());
    this->WaitUntilRead();
    slider->setValue(0);
    this->WaitUntilRead();
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
  }

  // The file's numbers stay to be read while it plays.
  void filesWhilePlaying()
  {
    const std::string models = qgetenv("RELIEVO_DATA").toStdString() + "/models/glTF2/";
    this->Open({ models + "simple_skin/simple_skin.gltf", "--time", "0" });
    auto* file = this->Window->findChild<QLabel*>("file");
    QVERIFY(file); // or the model is not there
    QTRY_VERIFY_WITH_TIMEOUT(file->isVisible(), 20000);
    viewer::Document* document = this->Window->GetDocument();
    int frames = 0, blank = 0;
    const QObject here; // for as long
    QObject::connect(document, &viewer::Document::factsChanged, &here, [&] {
      ++frames;
      const auto labels = this->Window->findChildren<QLabel*>("file");
      blank += labels.size() != 1 || !labels[0]->isVisible() || labels[0]->text().isEmpty();
    });
    QAction* play = this->Window->findChild<QToolBar*>("time")->actions().first();
    play->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(frames > 2, 20000);
    play->setChecked(false);
    this->WaitUntilRead();
    QCOMPARE(blank, 0);
    QVERIFY(this->Window->findChild<QLabel*>("file") == file);
  }

  // A report behind another tab is not read: software OpenGL would wait for each command.
  void reportBehind()
  {
    QMainWindow window;
    int reads = 0;
    auto* panel = new viewer::ReportPanel([&reads] {
      ++reads;
      return std::string();
    });
    QDockWidget* docks[] = { new QDockWidget("other", &window),
      new QDockWidget("report", &window) };
    docks[0]->setWidget(new QLabel("other"));
    docks[1]->setWidget(panel);
    for (QDockWidget* dock : docks)
    {
      window.addDockWidget(Qt::RightDockWidgetArea, dock);
    }
    window.tabifyDockWidget(docks[0], docks[1]);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    docks[1]->raise();
    QTRY_VERIFY(!panel->visibleRegion().isEmpty());
    panel->Follow();
    QTRY_VERIFY(reads > 0);
    docks[0]->raise();
    QTRY_VERIFY(panel->visibleRegion().isEmpty());
    reads = 0;
    panel->Follow();
    QTest::qWait(300);
    QCOMPARE(reads, 0);
  }

  // Bars as long as the table's numbers say, in the palette's colour.
  void chart()
  {
    this->Open(
      { this->WriteScene(), "--light", "sun:0.4,1,0.6", "--shadows", "map", "--tone", "reinhard" });
    auto* dock = this->Window->findChild<QDockWidget*>("report");
    auto* chart = this->Window->findChild<relievoQt::TimesChart*>("chart");
    auto* table = dock->findChild<relievoQt::StageTable*>("stages");
    QTest::qWait(300); // nothing is drawn any more
    dock->raise();
    // Frames whose times are not known yet are drawn again by themselves.
    QTRY_VERIFY_WITH_TIMEOUT(chart->GetStages().size() > 1, 20000);
    QVERIFY2(chart->isVisible() && chart->GetStages().size() > 1,
      this->Window->GetView()->GetPicture().GetFrame()->GetFrameReport().c_str());
    const auto reasons = [table] {
      QList<const QLabel*> labels;
      for (const QLabel* label : table->findChildren<QLabel*>())
      {
        if (label->isVisible() && label->objectName().endsWith("_reason"))
        {
          labels.append(label);
        }
      }
      return labels;
    };
    const auto say = [&reasons] {
      QString words;
      for (const QLabel* label : reasons())
      {
        words += label->text() + "\n";
      }
      return words;
    };
    // Until the last picture is in the table.
    QTRY_VERIFY_WITH_TIMEOUT(say().contains("1 light casts") && say().contains("Lamps: "), 20000);
    const QString words = say();
    for (const QLabel* label : reasons())
    {
      QVERIFY(label->width() >= table->width() - 30); // across the table and in full
      QVERIFY(label->height() >= label->heightForWidth(label->width()));
    }
    QVERIFY2(!words.contains("no output") && !words.contains("EnabledOff"), qPrintable(words));
    QVERIFY2(words.contains("switched off") && words.contains("does not need"), qPrintable(words));
    for (const QLabel* label : table->findChildren<QLabel*>())
    {
      QVERIFY(label->text() != "Delegate");
    }
    double longest = 0.0;
    int widest = 0;
    const QVector<relievoQt::FrameReport::Stage>& bars = chart->GetStages();
    for (int i = 0; i < bars.size(); ++i)
    {
      auto* cell = table->findChild<QLabel*>(bars[i].Name + "_ms");
      QVERIFY(cell && cell->isVisible());
      QCOMPARE(cell->text(), relievoQt::FrameReport::FormatMilliseconds(bars[i].Milliseconds));
      longest = std::max(longest, bars[i].Milliseconds);
      widest = std::max(widest, chart->GetPlace(i).width());
    }
    QVERIFY(longest > 0.0 && widest > 20);
    const QImage image = chart->grab().toImage();
    const QRgb color = chart->palette().color(QPalette::Highlight).rgb();
    for (int i = 0; i < bars.size(); ++i)
    {
      const int y = chart->GetPlace(i).center().y();
      int painted = 0;
      for (int x = 0; x < image.width(); ++x)
      {
        painted += image.pixel(x, y) == color;
      }
      QVERIFY(std::abs(painted - widest * bars[i].Milliseconds / longest) <= 1.0);
    }
  }

  // Arrays that share a name, with each other or with a layer, are told apart; ids are in full.
  void sharedNames()
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->WriteScene().c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    const auto add = [](vtkDataSetAttributes* to, const char* name, vtkIdType count, double value) {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->SetNumberOfTuples(count);
      array->Fill(value);
      to->AddArray(array);
    };
    add(data->GetPointData(), "twice", data->GetNumberOfPoints(), 0.25);
    add(data->GetCellData(), "twice", data->GetNumberOfCells(), 12345678.0);
    add(data->GetCellData(), "depth", data->GetNumberOfCells(), 87654321.0);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetDataModeToBinary();
    writer->SetInputData(data);
    writer->SetFileName(this->Path("twice.vtp").c_str());
    writer->Write();
    this->Open({ this->Path("twice.vtp"), "--camera", "0,0.8,5,0,0.8,0,0,1,0" });
    this->Grab();
    auto* layers = this->Window->findChild<QComboBox*>("layer");
    for (const char* name : { "point:twice", "cell:twice", "cell:depth", "depth", "height" })
    {
      QVERIFY2(layers->findData(name) >= 0, name);
    }
    QVERIFY(layers->findData("twice") < 0 && layers->findData("point:depth") < 0);
    const int* size = this->Window->GetView()->renderWindow()->GetSize();
    viewer::Probe probe;
    std::map<std::string, QString> found;
    for (const viewer::ProbeValue& value :
      probe.Read(this->Window->GetView()->GetPicture().GetRenderer(),
        this->Window->GetDocument()->GetFacts().Layers, size[0] / 2, size[1] / 2))
    {
      found[value.Layer] = viewer::WriteValues(value);
    }
    QCOMPARE(found["point:twice"], QString("0.25"));
    QCOMPARE(found["cell:twice"], QString("12345678"));
    QCOMPARE(found["cell:depth"], QString("87654321"));
    QVERIFY(found["depth"].startsWith("4.4"));
    layers->setCurrentIndex(layers->findData("cell:twice"));
    this->Compare("cell:twice");
    QCOMPARE(this->Window->GetTrouble(), QString());
  }

  // An array that is too wide for a layer takes no other value with it.
  void wideArrays()
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->WriteScene().c_str());
    reader->Update();
    vtkNew<vtkDoubleArray> wide;
    wide->SetName("wide");
    wide->SetNumberOfComponents(17);
    wide->SetNumberOfTuples(reader->GetOutput()->GetNumberOfPoints());
    wide->Fill(1.0);
    reader->GetOutput()->GetPointData()->AddArray(wide);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetDataModeToBinary(); // newer expats make Python's VTK refuse appended data
    writer->SetInputData(reader->GetOutput());
    writer->SetFileName(this->Path("wide.vtp").c_str());
    writer->Write();
    this->Open({ this->Path("wide.vtp") });
    this->Grab();
    const viewer::Facts& facts = this->Window->GetDocument()->GetFacts();
    QCOMPARE(facts.Components.at("wide"), 17);
    const int* size = this->Window->GetView()->renderWindow()->GetSize();
    viewer::Probe probe;
    std::set<std::string> found;
    for (const viewer::ProbeValue& value :
      probe.Read(this->Window->GetView()->GetPicture().GetRenderer(), facts.Layers, size[0] / 2,
        size[1] / 2))
    {
      found.insert(value.Layer);
    }
    QVERIFY(found.count("depth") == 1 && found.count("height") == 1 && found.count("wide") == 0);
    this->Grab();
    QCOMPARE(this->Window->GetTrouble(), QString());
  }
};

RELIEVO_TEST_CASE_APART(testViewerControls)
{
  TestViewerControls tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerControls.moc"
