// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Errors are shown prominently, until they are closed or fixed.
#include "TestCase.h"
#include "ViewerTest.h"

#include "Arguments.h"
#include "MessageBar.h"
#include "OptionNames.h"
#include "Options.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QGroupBox>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>
#include <QtTest>

namespace testViewerMessages
{
namespace
{
// The words at each painting of a widget.
class PaintWatcher : public QObject
{
public:
  explicit PaintWatcher(QLabel* words)
    : Words(words)
  {
  }

  bool eventFilter(QObject*, QEvent* event) override
  {
    if (event->type() == QEvent::Paint)
    {
      this->Seen += this->Words->text();
    }
    return false;
  }

  QStringList Seen;

private:
  QLabel* Words;
};
}

class TestViewerMessages : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  // In the middle of a view without a picture.
  QString GetEmptyWords()
  {
    auto* words = this->Window->findChild<QLabel*>("emptyWords");
    return words->isVisible() ? words->text() : QString();
  }

  // Over the picture.
  QString GetMessage()
  {
    auto* bar = this->Window->findChild<viewer::MessageBar*>("messageBar");
    return bar->isVisible() ? bar->GetText() : QString();
  }

  void OpenFile(const std::string& name)
  {
    this->Window->OpenFiles({ QString::fromStdString(this->Path(name)) });
    this->WaitUntilRead();
  }

  void WriteBroken()
  {
    this->WriteText("what.xyz", "no");
    this->WriteText("cut.stl", std::string(80, 'x') + std::string("\x10\0\0\0", 4));
  }

private Q_SLOTS:
  void inAnEmptyView()
  {
    this->WriteBroken();
    for (const char* name : { "missing.off", "what.xyz", "cut.stl" })
    {
      this->Open({ this->Path(name) });
      QVERIFY2(this->GetEmptyWords().contains(name), qPrintable(this->GetEmptyWords()));
      QVERIFY(this->Window->findChild<QPushButton*>("emptyOpen")->isVisible());
      QCOMPARE(this->GetMessage(), QString());
    }
    // A picture takes its place, and the next error is over that.
    this->WriteScene();
    this->OpenFile("scene.vtp");
    QCOMPARE(this->GetEmptyWords(), QString());
    this->OpenFile("what.xyz");
    QVERIFY(this->GetMessage().contains("what.xyz"));
  }

  void droppedOnAnEmptyView()
  {
    this->Window = std::make_unique<viewer::MainWindow>();
    this->Window->show();
    QVERIFY(QTest::qWaitForWindowExposed(this->Window.get()));
    QVERIFY(this->GetEmptyWords().contains("Ctrl+O"));
    this->WriteBroken();
    QMimeData files;
    files.setUrls({ QUrl::fromLocalFile(QString::fromStdString(this->Path("what.xyz"))) });
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &enter);
    QDropEvent drop(QPoint(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &drop);
    this->WaitUntilRead();
    QVERIFY2(this->GetEmptyWords().contains("what.xyz"), qPrintable(this->GetEmptyWords()));
  }

  // A file that cannot be read: edits do not mend that, another file does.
  void overThePicture()
  {
    this->WriteBroken();
    this->Open({ this->WriteScene() });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    this->OpenFile("cut.stl");
    QVERIFY2(this->GetMessage().contains("cut.stl"), qPrintable(this->GetMessage()));
    QCOMPARE(CountDifferent(before, this->Grab()), 0); // which keeps its size
    this->Change([](scene::Settings& settings) { settings.Set("--edges", ""); });
    QVERIFY(this->GetMessage().contains("cut.stl"));
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->WriteScene("next.vtp");
    this->OpenFile("next.vtp");
    QCOMPARE(this->GetMessage(), QString());
    this->OpenFile("what.xyz");
    QVERIFY(!this->GetMessage().isEmpty());
    // Wait messages, and the name of the layer, are below it.
    auto* hint = this->Window->findChild<viewer::MessageBar*>("hint");
    auto* banner = this->Window->findChild<QWidget*>("layerBanner");
    auto* bar = this->Window->findChild<viewer::MessageBar*>("messageBar");
    this->Change(
      [](scene::Settings& settings) { settings.SetParameter("display", "layer", "depth"); });
    this->Grab();
    hint->Show("Click in the picture", viewer::MessageBar::Hint);
    QVERIFY(banner->isVisible());
    QVERIFY(bar->geometry().bottom() < hint->geometry().top());
    QVERIFY(hint->geometry().bottom() < banner->geometry().top());
    hint->hide();
    QVERIFY(bar->geometry().bottom() < banner->geometry().top());
    bar->findChild<QToolButton*>("closeMessage")->click();
    QCOMPARE(this->GetMessage(), QString());
  }

  // Messages name the window's controls, and no option.
  void namesOfControls()
  {
    const auto quoted = [](const char* text) { return QString::fromUtf8(text); };
    QCOMPARE(viewer::NameOptions("a.vti: holds labels; --image volume shows them as a volume"),
      quoted("a.vti: holds labels; \u201cImages: volume\u201d in Scene shows them as a volume"));
    QCOMPARE(viewer::NameOptions("--scalar-bar: no values; give --color-by NAME as well"),
      quoted("\u201cShow a colour bar\u201d in Look: no values; give \u201cColour by\u201d in "
             "Look as well"));
    QCOMPARE(viewer::NameOptions("give --relief relief, or --colormap hot"), // of all values
      quoted("give \u201cRelief method: relief\u201d in Look, or \u201cColour map: hot\u201d in "
             "Look"));
    QCOMPARE(viewer::NameOptions("--exposure is given, --certify 5"),
      quoted("\u201cExposure\u201d in Look is given, --certify 5"));
    this->Open({ this->WriteScene(), "--scalar-bar", "--color-by", "height" });
    int named = 0;
    for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
    {
      const viewer::OptionName name = viewer::FindOptionName(QString::fromStdString(option.Name));
      if (name.Panel.isEmpty())
      {
        continue;
      }
      ++named;
      auto* dock = this->Window->findChild<QDockWidget*>(name.Panel.toLower());
      QVERIFY2(dock && dock->windowTitle() == name.Panel, option.Name.c_str());
      QStringList labels;
      for (const QLabel* label : dock->findChildren<QLabel*>())
      {
        labels += label->text();
      }
      for (const QAbstractButton* button : dock->findChildren<QAbstractButton*>())
      {
        labels += button->text();
      }
      for (const QGroupBox* group : dock->findChildren<QGroupBox*>())
      {
        labels += group->title();
      }
      QVERIFY2(labels.contains(name.Label), option.Name.c_str());
    }
    QVERIFY(named > 35);
  }

  // A setting that is refused is mended by the next one that is not.
  void ofAnEdit()
  {
    this->Open({ this->WriteScene() });
    this->Change([](scene::Settings& settings) { settings.Set("--color-by", "nothing"); });
    QVERIFY2(this->GetMessage().contains("Colour by"), qPrintable(this->GetMessage()));
    this->Window->Say("Copied");
    QVERIFY(!this->GetMessage().isEmpty());
    this->Change([](scene::Settings& settings) { settings.Set("--color-by", "height"); });
    QCOMPARE(this->GetMessage(), QString());
  }

  // Work in the window's own thread is reported meanwhile.
  void environmentIsPrepared()
  {
    this->Open({ this->WriteScene() });
    PaintWatcher watcher(this->Window->findChild<QLabel*>("words"));
    auto* bar = this->Window->findChild<QProgressBar*>("progress");
    bar->installEventFilter(&watcher);
    const QString image = QString::fromStdString(this->WriteImage());
    this->Change(
      [&image](scene::Settings& settings) { settings.Set("--environment", image.toStdString()); });
    QVERIFY2(watcher.Seen.contains("Preparing " + image), qPrintable(watcher.Seen.join(", ")));
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), 20000);
    QCOMPARE(this->Window->findChild<QLabel*>("words")->text(), QString());
    this->Compare("with an environment");
  }

  // Samples that gather are counted, quietly, and no longer when all are there.
  void smoothing()
  {
    this->Open({ this->WriteScene(), "--light", "point:1,3,1.5,size=0.4", "--shadows", "map",
      "--soft-shadows", "4096" });
    auto* words = this->Window->findChild<QLabel*>("smoothing");
    const QRegularExpression form("^Refining: (\\d+) of 4096 samples$");
    QTRY_VERIFY_WITH_TIMEOUT(form.match(words->text()).hasMatch(), 20000);
    const int first = form.match(words->text()).captured(1).toInt();
    QTRY_VERIFY_WITH_TIMEOUT(form.match(words->text()).captured(1).toInt() > first, 20000);
    this->Change(
      [](scene::Settings& settings) { settings.SetParameter("shadows", "soft_samples", "8"); });
    QTRY_COMPARE_WITH_TIMEOUT(words->text(), QString(), 20000);
    this->Compare("all samples");
  }
};

RELIEVO_TEST_CASE_APART(testViewerMessages)
{
  TestViewerMessages tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerMessages.moc"
