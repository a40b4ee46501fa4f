// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the window as docs/viewer.md shows it:
//   viewerScreenshot OUT.png WxH PANEL WORD... [then STEP...]
// The words are those of relievo-viewer; a step is the name of an action that is triggered, such as
// "dark", of a button that is clicked, or a file that is opened next.
#include "Application.h"
#include "MainWindow.h"
#include "Messages.h"
#include "PictureView.h"
#include "Settings.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
constexpr int Pause = 2000; // milliseconds, for a step to be seen

// The remaining steps, one after the other, and then the picture.
void Go(viewer::MainWindow& window, std::vector<std::string> steps, const char* place)
{
  if (!window.GetView()->IsEmpty())
  {
    window.GetView()->GetPicture().Grab();
  }
  if (steps.empty())
  {
    QWidget* top = QApplication::activeModalWidget();
    (top ? top : &window)->grab().save(place);
    std::puts(window.GetTrouble().toUtf8().constData());
    QApplication::quit();
    return;
  }
  QTimer::singleShot(
    Pause, &window, [&window, rest = std::vector(steps.begin() + 1, steps.end()), place] {
      Go(window, rest, place);
    });
  const QString step = QString::fromStdString(steps.front());
  if (auto* action = window.findChild<QAction*>(step))
  {
    action->trigger();
  }
  else if (auto* button = window.findChild<QAbstractButton*>(step))
  {
    button->click();
  }
  else
  {
    window.OpenFiles({ step });
  }
}
}

int main(int argc, char* argv[])
{
  if (argc < 5)
  {
    std::fputs("usage: viewerScreenshot OUT.png WxH PANEL WORD... [then STEP...]\n", stderr);
    return 2;
  }
  QSurfaceFormat::setDefaultFormat(viewer::PictureView::GetFormat());
  const QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  int ours = 1;
  viewer::Application application(ours, argv);
  const reading::Messages::Scope scope;
  viewer::MainWindow window;
  const QStringList size = QString(argv[2]).split('x');
  window.resize(size.value(0).toInt(), size.value(1).toInt());
  window.show();
  for (QDockWidget* dock : window.findChildren<QDockWidget*>())
  {
    if (dock->objectName() == argv[3])
    {
      dock->raise();
    }
  }
  const std::vector<std::string> given(argv + 4, argv + argc);
  const auto then = std::find(given.begin(), given.end(), "then");
  const std::vector<std::string> steps(then == given.end() ? then : then + 1, given.end());
  bool begun = false;
  QObject::connect(&window, &viewer::MainWindow::ready, &window, [&] {
    if (!begun)
    {
      begun = true;
      QTimer::singleShot(Pause, &window, [&] { Go(window, steps, argv[1]); });
    }
  });
  window.Open(viewer::Document::FromWords({ given.begin(), then }));
  return QApplication::exec();
}
