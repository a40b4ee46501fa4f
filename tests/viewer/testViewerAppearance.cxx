// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A screen with two pixels for each of the desktop's, and dark controls.
#include "TestCase.h"
#include "ViewerTest.h"

#include "ColorButton.h"

#include "vtkRenderWindow.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QTableWidget>
#include <QToolBar>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace testViewerAppearance
{
namespace
{
// WCAG 2.1: relative luminance, and the contrast of two.
double GetLuminance(const QColor& color)
{
  const auto linear = [](double value) {
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
    0.0722 * linear(color.blueF());
}

double GetContrast(const QColor& a, const QColor& b)
{
  const double first = GetLuminance(a) + 0.05;
  const double second = GetLuminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

// The lightest and the darkest painted colour.
double GetPaintedContrast(QWidget* widget)
{
  const QImage image = widget->grab().toImage();
  QColor least(Qt::white), most(Qt::black);
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      const QColor color = image.pixelColor(x, y);
      least = GetLuminance(color) < GetLuminance(least) ? color : least;
      most = GetLuminance(color) > GetLuminance(most) ? color : most;
    }
  }
  return GetContrast(least, most);
}
}

class TestViewerAppearance : public viewerTest::ViewerTest
{
  Q_OBJECT

private Q_SLOTS:
  // The picture has the screen's pixels; the command, the probe and --size count them.
  void pixels()
  {
    this->Open({ this->WriteScene(), "--camera", "0,0.8,5,0,0.8,0,0,1,0", "--shadows", "map" });
    viewer::PictureView* view = this->Window->GetView();
    QCOMPARE(view->devicePixelRatioF(), 2.0);
    const int* size = view->renderWindow()->GetSize();
    QCOMPARE(size[0], 2 * view->width());
    QCOMPARE(size[1], 2 * view->height());
    QCOMPARE(this->Grab()->GetDimensions()[0], size[0]);
    this->Compare("two pixels for one");
    this->Window->findChild<QDockWidget*>("layers")->raise();
    auto* probing = this->Window->findChild<QAbstractButton*>("probing");
    auto* table = this->Window->findChild<QTableWidget*>("values");
    QVERIFY(probing && table);
    probing->setChecked(true);
    this->SendMouse(QEvent::MouseMove, view->rect().center(), Qt::NoButton);
    QTRY_VERIFY_WITH_TIMEOUT(
      table->rowCount() > 0 && table->item(0, 1)->text().startsWith("4.4"), 20000);
    // Past the ball, which is 0.6 of 2.68 high: 0.22 of the height above the middle.
    this->SendMouse(QEvent::MouseMove,
      QPoint(view->width() / 2, static_cast<int>(view->height() * 0.26)), Qt::NoButton);
    QTRY_COMPARE_WITH_TIMEOUT(table->item(0, 1)->text(), QString("background"), 20000);
    this->Open({ this->WriteScene(), "--size", "560x400" });
    QCOMPARE(this->Grab()->GetDimensions()[0], 560);
    QCOMPARE(this->Grab()->GetDimensions()[1], 400);
  }

  void fullScreen()
  {
    this->Open({ this->WriteScene() });
    auto* full = this->Window->findChild<QAction*>("fullScreen");
    QCOMPARE(full->shortcut(), QKeySequence(Qt::Key_F11));
    full->trigger();
    QVERIFY(this->Window->isFullScreen());
    this->Compare("the whole screen");
    full->trigger();
    QVERIFY(!this->Window->isFullScreen());
  }

  // A reason is read in full; a swatch shows the default.
  void notes()
  {
    this->Open({ this->WriteScene(), "--lamps", this->WritePoints(), "--stage",
      "antialias:samples=8", "--stage", "display:layer=depth", "--stage", "light_depth" });
    this->Window->findChild<QDockWidget*>("light")->raise();
    this->Grab();
    int seen = 0;
    const auto findCut = [this, &seen]() {
      seen = 0;
      QStringList cut;
      for (const QLabel* label : this->Window->findChildren<QLabel*>("reason"))
      {
        const bool shown = !label->isHidden();
        seen += shown ? 1 : 0;
        if (shown && label->height() < label->heightForWidth(label->width()))
        {
          cut << QString("%1 in %2: %3")
                   .arg(label->heightForWidth(label->width()))
                   .arg(label->height())
                   .arg(label->text());
        }
      }
      return cut;
    };
    QTRY_COMPARE_WITH_TIMEOUT(findCut(), QStringList(), 20000); // once the rows are laid out
    QVERIFY(seen > 0);
    for (const QLabel* label : this->Window->findChildren<QLabel*>("reason"))
    {
      QVERIFY2(label->isHidden() ||
          (!label->text().contains("no output") && !label->text().contains("Enabled")),
        qPrintable(label->text()));
    }
    for (const char* word : { "Way", "Floats", "Casting" })
    {
      for (const QLabel* label : this->Window->findChildren<QLabel*>())
      {
        QVERIFY2(label->text() != word, word);
      }
    }
    seen = 0;
    for (const auto* button : this->Window->findChildren<viewer::ColorButton*>())
    {
      ++seen;
      QVERIFY(button->GetColor().isValid());
    }
    QVERIFY(seen > 0);
  }

  // Words and signs can be read, the picture is the same, and the choice lasts.
  void dark()
  {
    this->Open({ this->WriteScene(), "--lamps", this->WritePoints(), "--shadows", "map" });
    const vtkSmartPointer<vtkImageData> before = this->Grab();
    const QString style = QApplication::style()->objectName();
    const QColor desktop = QApplication::palette().color(QPalette::Window);
    this->Window->findChild<QAction*>("dark")->trigger();
    QVERIFY(QApplication::palette().color(QPalette::Window).lightness() < 80);
    QCOMPARE(CountDifferent(before, this->Grab()), 0);
    auto* play = this->Window->findChild<QToolBar*>("time");
    play->setVisible(true);
    play->actions().first()->setEnabled(true); // nothing moves here
    QVERIFY(GetPaintedContrast(play->widgetForAction(play->actions().first())) > 4.5);
    int seen = 0;
    for (const char* name : { "report", "layers", "look", "light", "scene" })
    {
      auto* dock = this->Window->findChild<QDockWidget*>(name);
      dock->raise();
      int shown = 0;
      const auto findUnreadable = [&]() {
        shown = 0;
        QStringList unreadable;
        for (QWidget* widget : dock->findChildren<QWidget*>())
        {
          const auto* label = qobject_cast<QLabel*>(widget);
          const bool words = label ? label->text().contains(QRegularExpression("\\w"))
                                   : widget->inherits("QAbstractButton");
          if (words && widget->isEnabled() && !widget->visibleRegion().isEmpty())
          {
            ++shown;
            const double contrast = GetPaintedContrast(widget);
            if (!(contrast > 4.5))
            {
              unreadable << QString("%1: %2 %3 has a contrast of %4")
                              .arg(name, widget->metaObject()->className(), widget->objectName())
                              .arg(contrast);
            }
          }
        }
        return unreadable;
      };
      QTRY_VERIFY_WITH_TIMEOUT(findUnreadable().isEmpty() && shown > 0, 20000);
      QCOMPARE(findUnreadable(), QStringList());
      seen += shown;
      this->Window->grab().save(QString("dark-%1.png").arg(name)); // to be looked at
    }
    QVERIFY2(seen > 20, qPrintable(QString::number(seen)));
    this->Open({ this->WriteScene() });
    QVERIFY(this->Window->findChild<QAction*>("dark")->isChecked());
    QVERIFY(this->Window->palette().color(QPalette::Window).lightness() < 80);
    this->Window->findChild<QAction*>("light")->trigger();
    QVERIFY(this->Window->palette().color(QPalette::Window).lightness() > 200);
    this->Window->findChild<QAction*>("desktop")->trigger();
    QCOMPARE(QApplication::style()->objectName(), style);
    QCOMPARE(QApplication::palette().color(QPalette::Window), desktop);
  }
};

RELIEVO_TEST_CASE_APART(testViewerAppearance)
{
  qputenv("QT_SCALE_FACTOR", "2");
  TestViewerAppearance tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerAppearance.moc"
