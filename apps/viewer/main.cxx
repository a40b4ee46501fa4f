// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "MainWindow.h"
#include "Messages.h"
#include "Outputs.h"
#include "PictureView.h"
#include "QtVersions.h"
#include "Settings.h"
#include "StandardError.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
const char* const Help =
  "relievo-viewer shows what `relievo render` draws, in a window.\n"
  "\n"
  "  relievo-viewer [FILE...] [OPTION...]\n"
  "  relievo-viewer SESSION.json\n"
  "\n"
  "Files and options are those of `relievo render`; see relievo --help. Outputs are not written:\n"
  "save them from the window. --once ends the program after its first picture, to be timed.\n";
}

int main(int argc, char* argv[])
{
  std::vector<std::string> words(argv + 1, argv + argc);
  if (std::find(words.begin(), words.end(), "--help") != words.end() ||
    std::find(words.begin(), words.end(), "-h") != words.end())
  {
    std::fputs(Help, stdout);
    return 0;
  }
  const auto timed = std::remove(words.begin(), words.end(), "--once");
  const bool once = timed != words.end();
  words.erase(timed, words.end());
  const bool isSession =
    words.size() == 1 && QFileInfo(QString::fromStdString(words[0])).suffix().toLower() == "json";
  viewer::Settings settings;
  try
  {
    settings = isSession ? settings : viewer::Settings::FromWords(words);
    settings.MakePathsAbsolute(QDir::currentPath().toStdString());
  }
  catch (const cli::WordsError& error)
  {
    std::fprintf(cli::StandardError(), "relievo-viewer: %s\n", error.what());
    return 2;
  }

  QSurfaceFormat::setDefaultFormat(viewer::PictureView::GetFormat());
  viewer::UseHighDpi();
  QCoreApplication::setOrganizationName("Relievo");
  QCoreApplication::setApplicationName("relievo-viewer");
  int ours = 1; // Qt has options of its own, which ours might be taken for
  QApplication application(ours, argv);
  cli::Outputs::RemoveOnSignals();
  cli::Messages::Collect();
  viewer::MainWindow window;
  const QSettings kept;
  window.restoreGeometry(kept.value("geometry").toByteArray());
  window.restoreState(kept.value("state").toByteArray());
  window.show();
  if (once)
  {
    viewer::PictureView* view = window.GetView();
    QObject::connect(view, &viewer::PictureView::drawn, &application, [view] {
      if (!view->GetPicture().IsEmpty())
      {
        QTimer::singleShot(0, qApp, [] { std::_Exit(0); }); // closing the window is not timed
      }
    });
  }
  if (isSession)
  {
    window.OpenFiles({ QString::fromStdString(words[0]) });
  }
  else if (!words.empty())
  {
    window.Open(settings);
  }
  return QApplication::exec();
}
