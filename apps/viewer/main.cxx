// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Failure.h"
#include "MainWindow.h"
#include "Messages.h"
#include "Outputs.h"
#include "PictureView.h"
#include "Settings.h"
#include "StandardError.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QSurfaceFormat>

#include <algorithm>
#include <cstdio>

namespace
{
const char* const Help =
  "relievo-viewer shows what `relievo render` draws, in a window.\n"
  "\n"
  "  relievo-viewer [FILE...] [OPTION...]\n"
  "  relievo-viewer SESSION.json\n"
  "\n"
  "Files and options are those of `relievo render`; see relievo --help. Outputs are not written:\n"
  "save them from the window.\n";

}

int main(int argc, char* argv[])
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (std::find(words.begin(), words.end(), "--help") != words.end() ||
    std::find(words.begin(), words.end(), "-h") != words.end())
  {
    std::fputs(Help, stdout);
    return 0;
  }
  const bool isSession = words.size() == 1 && QFileInfo(argv[1]).suffix().toLower() == "json";
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

  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
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
  if (isSession)
  {
    window.OpenFiles({ argv[1] });
  }
  else if (!words.empty())
  {
    window.Open(settings);
  }
  return QApplication::exec();
}
