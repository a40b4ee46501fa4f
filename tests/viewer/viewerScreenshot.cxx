// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the window as docs/viewer.md shows it:
//   viewerScreenshot OUT.png WxH PANEL WORD...    the words are those of relievo-viewer
#include "Application.h"
#include "MainWindow.h"
#include "Messages.h"
#include "PictureView.h"
#include "Settings.h"

#include <QDockWidget>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTimer>

#include <cstdio>

int main(int argc, char* argv[])
{
  if (argc < 5)
  {
    std::fputs("usage: viewerScreenshot OUT.png WxH PANEL WORD...\n", stderr);
    return 2;
  }
  QSurfaceFormat::setDefaultFormat(viewer::PictureView::GetFormat());
  const QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  int ours = 1;
  viewer::Application application(ours, argv);
  const scene::Messages::Scope scope;
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
  QObject::connect(&window, &viewer::MainWindow::ready, &window, [&window, argv] {
    window.GetView()->GetPicture().Grab();
    QTimer::singleShot(2000, &window, [&window, argv] {
      window.GetView()->GetPicture().Grab();
      window.grab().save(argv[1]);
      std::puts(window.GetTrouble().toUtf8().constData());
      QApplication::quit();
    });
  });
  window.Open(viewer::Document::FromWords({ argv + 4, argv + argc }));
  return QApplication::exec();
}
